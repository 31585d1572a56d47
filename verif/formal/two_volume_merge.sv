// Merge of the two halves of an object: the half with the nearer front goes on whole, half A when both fronts are equal.

module two_volume_merge_properties #(parameter W = 24) (
    input wire clock,
    input wire signed [W-1:0] zf_a,
    input wire [3:0] nf_a,
    input wire signed [W-1:0] zb_a,
    input wire [3:0] nb_a,
    input wire signed [W-1:0] zf_b,
    input wire [3:0] nf_b,
    input wire signed [W-1:0] zb_b,
    input wire [3:0] nb_b,
    input wire signed [W-1:0] zf,
    input wire [3:0] nf,
    input wire signed [W-1:0] zb,
    input wire [3:0] nb
);
    // The ports two clocks ago: latency 2.
    reg [1:0] clocks = 0;
    wire started = clocks == 2;
    reg [2*W+7:0] late_a, late_b, half_a, half_b;
    wire signed [W-1:0] front_a = half_a[2*W+7:W+8], front_b = half_b[2*W+7:W+8];

    always @(posedge clock) begin
        if (!started) clocks <= clocks + 1;
        late_a <= {zf_a, nf_a, zb_a, nb_a};
        late_b <= {zf_b, nf_b, zb_b, nb_b};
        half_a <= late_a;
        half_b <= late_b;
    end

    wire [2*W+7:0] merged = {zf, nf, zb, nb};

    always @* begin
        if (started) begin
            assert (zf <= front_a && zf <= front_b);
            assert (merged == half_a || merged == half_b);
            if (front_a == front_b) assert (merged == half_a);
        end
    end
endmodule

bind two_volume_merge two_volume_merge_properties #(.W(`W)) properties (
    .clock(clock), .zf_a(zf_a), .nf_a(nf_a), .zb_a(zb_a), .nb_a(nb_a),
    .zf_b(zf_b), .nf_b(nf_b), .zb_b(zb_b), .nb_b(nb_b), .zf(zf), .nf(nf), .zb(zb), .nb(nb)
);
