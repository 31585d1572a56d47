// Visibility node: the input with the smaller depth goes on whole; at equal depth the smaller id, whatever the order of the inputs.

module visibility_node_properties #(parameter W = 24) (
    input wire clock,
    input wire signed [W-1:0] a_depth,
    input wire [7:0] a_id,
    input wire [51:0] a_rest,
    input wire signed [W-1:0] b_depth,
    input wire [7:0] b_id,
    input wire [51:0] b_rest,
    input wire signed [W-1:0] depth,
    input wire [7:0] id,
    input wire [51:0] rest
);
    // The ports one clock ago: latency 1.
    reg started = 0;
    reg signed [W-1:0] old_a_depth, old_b_depth;
    reg [7:0] old_a_id, old_b_id;
    reg [51:0] old_a_rest, old_b_rest;

    always @(posedge clock) begin
        started <= 1;
        old_a_depth <= a_depth;
        old_a_id <= a_id;
        old_a_rest <= a_rest;
        old_b_depth <= b_depth;
        old_b_id <= b_id;
        old_b_rest <= b_rest;
    end

    // One key, compared as an unsigned number: depth with its sign turned over, then id.
    wire [W+7:0] key = {~depth[W-1], depth[W-2:0], id};
    wire [W+7:0] key_a = {~old_a_depth[W-1], old_a_depth[W-2:0], old_a_id};
    wire [W+7:0] key_b = {~old_b_depth[W-1], old_b_depth[W-2:0], old_b_id};

    always @* begin
        if (started) begin
            assert (key <= key_a && key <= key_b);
            assert ((key == key_a && rest == old_a_rest) || (key == key_b && rest == old_b_rest));
        end
    end
endmodule

bind visibility_node visibility_node_properties #(.W(`W)) properties (
    .clock(clock), .a_depth(a_depth), .a_id(a_id), .a_rest({a_number, a_nx, a_ny, a_nz}),
    .b_depth(b_depth), .b_id(b_id), .b_rest({b_number, b_nx, b_ny, b_nz}),
    .depth(depth), .id(id), .rest({number, nx, ny, nz})
);
