// normal_component: part of patch_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module normal_component (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire signed [23:0] a,
    input  wire signed [23:0] b,
    input  wire signed [23:0] c,
    input  wire signed [15:0] k,
    input  wire signed [15:0] scaled_root,
    input  wire is_near,
    input  wire is_quadric,
    input  wire signed [15:0] fixed,
    output wire signed [15:0] result
);

    wire signed [31:0] product;
    wire signed [31:0] opposite;
    wire signed [23:0] change;
    wire signed [23:0] sum;
    wire signed [23:0] g_value;
    reg signed [31:0] kept_change = 32'sd0;
    reg signed [15:0] kept_component = 16'sd0;

    pe1_w24 g (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(a),
        .b(b),
        .c(c),
        .value(g_value)
    );

    assign product = k * scaled_root;
    assign opposite = -product;
    assign change = kept_change[29:6];
    assign sum = g_value + change;
    assign result = kept_component;

    wire unused_bits = &{1'b0, sum[7:0], kept_change[31:30], kept_change[5:0]};

    always @(posedge clock) begin
        if (is_near) begin
            kept_change <= opposite;
        end else begin
            kept_change <= product;
        end
        if (is_quadric) begin
            kept_component <= sum[23:8];
        end else begin
            kept_component <= fixed;
        end
    end

endmodule
