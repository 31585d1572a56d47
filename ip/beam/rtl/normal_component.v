// normal_component: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module normal_component (
    input  wire clock, valid, start, line,
    input  wire signed [23:0] a, b, c,
    input  wire signed [15:0] k, signed_root,
    input  wire is_quadric,
    input  wire signed [15:0] fixed,
    output reg  signed [15:0] result = 16'sd0
);

    wire signed [23:0] g_value, sum;
    reg signed [15:0] k_late = 16'sd0, signed_root_late = 16'sd0;
    wire signed [31:0] kept_change_product;
    reg signed [31:0] kept_change = 32'sd0;

    pe1_w24 g (
        .clock(clock), .valid(valid), .start(start), .line(line), .a(a), .b(b), .c(c), .value(g_value));

    assign kept_change_product = k_late * signed_root_late;
    assign sum = g_value + kept_change[29:6];
    wire unused = &{1'b0, kept_change[5:0], kept_change[31:30], sum[7:0]};

    always @(posedge clock) begin
        k_late <= k;
        signed_root_late <= signed_root;
        kept_change <= kept_change_product;
        result <= is_quadric ? sum[23:8] : fixed;
    end
endmodule
