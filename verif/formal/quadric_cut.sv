// What is seen of a quadric between two limits: the first depth that the object holds and the limits keep, and the end
// of that piece.
//
// `z` is any depth from ZLOW to before ZMAX. A solid object holds z if it lies between its roots (side), outside them (front), or
// always (prism); a patch shows the roots themselves.

module quadric_cut_properties #(parameter W = 24, parameter S = 26) (
    input wire clock,
    input wire signed [S-1:0] near_sum, far_sum,
    input wire is_inside, in_box,
    input wire [1:0] object_class,
    input wire signed [W-1:0] front,
    input wire [3:0] front_number,
    input wire signed [W-1:0] back,
    input wire [3:0] back_number,
    input wire removed,
    input wire signed [W-1:0] zf, zb,
    input wire [3:0] number
);
    localparam [1:0] SIDE = 2'd0, FRONT = 2'd1, PATCH = 2'd2;
    localparam signed [W-1:0] ZMAX = {1'b0, {(W-1){1'b1}}};
    localparam signed [W-1:0] ZLOW = {1'b1, {(W-2){1'b0}}, 1'b1};

    (* anyconst *) wire signed [W-1:0] z;

    // The roots five clocks ago, the limits three: latency 5, of limits that come two clocks later.
    localparam P = 2 * S + 4;
    localparam L = 2 * W + 5;
    reg [2:0] clocks = 0;
    wire started = clocks == 5;
    reg [P-1:0] roots_1, roots_2, roots_3, roots_4, roots_5;
    reg [L-1:0] limits_1, limits_2, limits_3;
    wire signed [S-1:0] near, far;
    wire inside, boxed, nothing;
    wire [1:0] class_;
    wire signed [W-1:0] first, last;
    wire [3:0] front_face;
    assign {near, far, inside, boxed, class_} = roots_5;
    assign {first, front_face, last, nothing} = limits_3;

    always @(posedge clock) begin
        if (!started) clocks <= clocks + 1;
        roots_1 <= {near_sum, far_sum, is_inside, in_box, object_class};
        roots_2 <= roots_1;
        roots_3 <= roots_2;
        roots_4 <= roots_3;
        roots_5 <= roots_4;
        limits_1 <= {front, front_number, back, removed};
        limits_2 <= limits_1;
        limits_3 <= limits_2;
    end

    function holds(input signed [W-1:0] depth);
        holds = boxed && !nothing && first <= depth && depth <= last && (
            class_ == SIDE ? inside && near <= depth && depth <= far
            : class_ == FRONT ? !inside || depth <= near || depth >= far
            : class_ == PATCH ? inside && (depth == near || depth == far)
            : inside);
    endfunction

    wire absent = zf == ZMAX;
    wire signed [W-1:0] behind = zb + 1;

    always @* begin
        assume (near_sum <= far_sum);
        assume (z >= ZLOW && z < ZMAX);
        // Those of planes.
        assume (front_number >= 2 && front_number < 15);
        if (started) begin
            assert (ZLOW <= zf && zf <= zb);
            // The front is held, and nothing before it.
            assert (absent || holds(zf));
            assert (!holds(z) || zf <= z);
            // From the front to the back all is held of a solid, and what is behind the back is not of the same piece.
            if (class_ != PATCH && zf <= z && z <= zb) assert (holds(z));
            if (class_ != PATCH && !absent && zb < ZMAX - 1) assert (!holds(behind) || (class_ == FRONT && zb == near));
            if (class_ == PATCH) assert (absent ? zb == ZMAX : holds(zb));
            if (class_ == PATCH && holds(z)) assert (z <= zb);
            // A number says what the face lies on; a root keeps its own where a plane meets it.
            if (absent) assert (number == 0 || (number == front_face && first == ZMAX));
            else begin
                assert (number != 0 || (zf == near && (class_ == SIDE || class_ == PATCH)));
                assert (number != 1 || (zf == far && (class_ == FRONT || class_ == PATCH)));
                assert (number != 15 || zf == ZLOW);
                assert (number <= 1 || number == 15 || (number == front_face && zf == first));
                if (zf == near && (class_ == SIDE || class_ == PATCH)) assert (number == 0);
                if (zf == far && zf > near && (class_ == FRONT ? inside : class_ == PATCH)) assert (number == 1);
            end
        end
    end
endmodule

bind quadric_cut quadric_cut_properties #(.W(`W), .S(`S)) properties (
    .clock(clock), .near_sum(near_sum), .far_sum(far_sum), .is_inside(is_inside), .in_box(in_box),
    .object_class(object_class), .front(front), .front_number(front_number), .back(back), .back_number(back_number),
    .removed(removed), .zf(zf), .zb(zb), .number(number)
);
