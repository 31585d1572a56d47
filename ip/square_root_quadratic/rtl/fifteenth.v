// fifteenth: part of square_root_quadratic; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module fifteenth (
    input  wire [35:0] value,
    output wire [24:0] quotient
);

    localparam [47:0] one = 48'd1;
    localparam [7:0] by_4 = 8'd4;
    localparam [7:0] by_8 = 8'd8;
    localparam [7:0] by_16 = 8'd16;
    localparam [7:0] by_24 = 8'd24;
    wire [47:0] wide;
    wire [47:0] high;
    wire [15:0] low_bits;
    wire [47:0] low;
    wire [47:0] parts;
    wire [47:0] more;
    wire [47:0] more_4;
    wire [47:0] ones_2;
    wire [47:0] ones_2_8;
    wire [47:0] ones_2_16;
    wire [47:0] ones_4;
    wire [47:0] ones_6;
    wire [47:0] low_quotient;
    wire [47:0] high_4;
    wire [47:0] high_2;
    wire [47:0] high_2_8;
    wire [47:0] high_quotient;
    wire [47:0] sum;

    assign wide = {12'd0, value};
    assign high = wide >> by_16;
    assign low_bits = wide[15:0];
    assign low = {32'd0, low_bits};
    assign parts = high + low;
    assign more = parts + one;
    assign more_4 = more << by_4;
    assign ones_2 = more + more_4;
    assign ones_2_8 = ones_2 << by_8;
    assign ones_2_16 = ones_2 << by_16;
    assign ones_4 = ones_2 + ones_2_8;
    assign ones_6 = ones_4 + ones_2_16;
    assign low_quotient = ones_6 >> by_24;
    assign high_4 = high << by_4;
    assign high_2 = high + high_4;
    assign high_2_8 = high_2 << by_8;
    assign high_quotient = high_2 + high_2_8;
    assign sum = high_quotient + low_quotient;
    assign quotient = sum[24:0];

    wire unused_bits = &{1'b0, sum[47:25]};

endmodule
