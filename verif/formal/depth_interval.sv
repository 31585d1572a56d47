// Depth interval of a pixel: both halves ordered or absent for every class, and exactly the table of the architecture.
//
// `z` is any depth from ZLOW to before ZMAX. A solid object holds z if it lies between its roots (side), outside them (front), or
// always (prism); a patch shows the roots themselves.

module depth_interval_properties #(parameter W = 24, parameter S = 26) (
    input wire clock,
    input wire signed [S-1:0] near_sum,
    input wire signed [S-1:0] far_sum,
    input wire is_inside,
    input wire in_box,
    input wire [1:0] object_class,
    input wire signed [W-1:0] zf_a,
    input wire [3:0] nf_a,
    input wire signed [W-1:0] zb_a,
    input wire [3:0] nb_a,
    input wire signed [W-1:0] zf_b,
    input wire [3:0] nf_b,
    input wire signed [W-1:0] zb_b,
    input wire [3:0] nb_b
);
    localparam [1:0] SIDE = 2'd0, FRONT = 2'd1, PATCH = 2'd2;
    localparam signed [W-1:0] ZMAX = {1'b0, {(W-1){1'b1}}};
    localparam signed [W-1:0] ZLOW = {1'b1, {(W-2){1'b0}}, 1'b1};

    (* anyconst *) wire signed [W-1:0] z;

    // The ports three clocks ago: latency 3.
    localparam P = 2 * S + 4;
    reg [1:0] clocks = 0;
    wire started = clocks == 3;
    reg [P-1:0] late_1, late_2, late_3;
    wire signed [S-1:0] near, far;
    wire inside, boxed;
    wire [1:0] class_;
    assign {near, far, inside, boxed, class_} = late_3;

    always @(posedge clock) begin
        if (!started) clocks <= clocks + 1;
        late_1 <= {near_sum, far_sum, is_inside, in_box, object_class};
        late_2 <= late_1;
        late_3 <= late_2;
    end

    wire absent_a = zf_a == ZMAX && zb_a == ZMAX && nf_a == 0 && nb_a == 0;
    wire absent_b = zf_b == ZMAX && zb_b == ZMAX && nf_b == 0 && nb_b == 0;
    wire solid = (zf_a <= z && z <= zb_a) || (zf_b <= z && z <= zb_b);
    wire faces = z == zf_a || z == zb_a || z == zf_b || z == zb_b;
    wire expected = boxed && (
        class_ == SIDE ? inside && near <= z && z <= far
        : class_ == FRONT ? !inside || z <= near || z >= far
        : class_ == PATCH ? inside && (z == near || z == far)
        : inside);

    always @* begin
        assume (near_sum <= far_sum);
        assume (z >= ZLOW && z < ZMAX);
        if (started) begin
            assert (zf_a <= zb_a && zf_b <= zb_b);
            assert (zf_a >= ZLOW && zf_b >= ZLOW);
            assert ((absent_a || zf_a < ZMAX) && (absent_b || zf_b < ZMAX));
            assert (boxed || (absent_a && absent_b));
            assert (class_ == FRONT || absent_b);
            assert ((class_ == PATCH ? faces : solid) == expected);
            // A face at a root carries its number, a face at an end of the line of sight the cap's.
            assert (nf_a == 0 || nf_a == 15 || (class_ == PATCH && nf_a == 1 && zf_a == far));
            assert (nf_a != 0 || absent_a || zf_a == near);
            assert (nf_a != 15 || zf_a == ZLOW);
            assert (nb_a == 0 || nb_a == 1 || (nb_a == 15 && zb_a == ZMAX));
            assert (nb_a != 1 || zb_a == far || (zb_a == ZMAX && far >= ZMAX));
            assert (absent_b || (zb_b == ZMAX && nb_b == 15));
            assert (absent_b || (nf_b == 1 ? zf_b == far : nf_b == 15 && zf_b == ZLOW));
        end
    end
endmodule

bind depth_interval depth_interval_properties #(.W(`W), .S(`S)) properties (
    .clock(clock), .near_sum(near_sum), .far_sum(far_sum), .is_inside(is_inside), .in_box(in_box),
    .object_class(object_class), .zf_a(zf_a), .nf_a(nf_a), .zb_a(zb_a), .nb_a(nb_a),
    .zf_b(zf_b), .nf_b(nf_b), .zb_b(zb_b), .nb_b(nb_b)
);
