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
    // The ports one clock ago: latency 1.
    reg started = 0;
    reg signed [W-1:0] front_a, front_b;
    reg [2*W+7:0] half_a, half_b;

    always @(posedge clock) begin
        started <= 1;
        front_a <= zf_a;
        front_b <= zf_b;
        half_a <= {zf_a, nf_a, zb_a, nb_a};
        half_b <= {zf_b, nf_b, zb_b, nb_b};
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
