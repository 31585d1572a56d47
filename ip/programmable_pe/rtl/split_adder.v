// split_adder: part of programmable_pe; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module split_adder (
    input  wire [47:0] a,
    input  wire [47:0] b,
    input  wire split,
    output wire [47:0] sum
);

    localparam [7:0] half = 8'd24;
    localparam [23:0] one = 24'd1;
    wire [23:0] a_low;
    wire [23:0] b_low;
    wire [23:0] a_high;
    wire [23:0] b_high;
    wire [23:0] high;
    wire [24:0] a_low_wide;
    wire [24:0] b_low_wide;
    wire [24:0] low;
    wire carry;
    wire [47:0] high_part;
    wire [47:0] low_part;
    wire [23:0] low_sum;
    wire [23:0] term_1;

    assign term_1 = a_high + b_high;
    assign a_low = a[23:0];
    assign b_low = b[23:0];
    assign a_high = a[47:24];
    assign b_high = b[47:24];
    assign high = carry ? term_1 + one : a_high + b_high;
    assign a_low_wide = {1'd0, a_low};
    assign b_low_wide = {1'd0, b_low};
    assign low = a_low_wide + b_low_wide;
    assign carry = low[24] & ~split;
    assign high_part = {24'd0, high};
    assign low_part = {24'd0, low_sum};
    assign low_sum = low[23:0];
    assign sum = (high_part << half) | low_part;

endmodule
