// non_restoring_row: part of square_root_non_restoring; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module non_restoring_row (
    input  wire [47:0] pairs,
    input  wire [23:0] root,
    input  wire [25:0] remainder,
    input  wire [25:0] live,
    output wire [47:0] next_pairs,
    output wire [23:0] next_root,
    output wire [25:0] next_remainder,
    output wire [25:0] next_live
);

    localparam [25:0] none = 26'd0;
    localparam [1:0] by_one = 2'd1;
    localparam [1:0] by_two = 2'd2;
    localparam [23:0] digit = 24'd1;
    localparam [25:0] wide_digit = 26'd1;
    localparam [25:0] low_digits = 26'd3;
    wire [25:0] shifted_remainder;
    wire [1:0] top_pair;
    wire [25:0] pair;
    wire [25:0] dividend;
    wire [25:0] wide_root;
    wire [25:0] shifted_root;
    wire [25:0] addend;
    wire [25:0] sum;
    wire [25:0] shifted_live;
    wire [25:0] grown_live;
    wire [25:0] halved_live;
    wire [25:0] sign;
    wire [25:0] remainder_sign;
    wire [25:0] next_sign;
    wire [25:0] sum_sign;
    wire [23:0] doubled_root;

    assign shifted_remainder = remainder << by_two;
    assign top_pair = pairs[47:46];
    assign pair = {24'd0, top_pair};
    assign dividend = shifted_remainder | pair;
    assign wide_root = {2'd0, root};
    assign shifted_root = wide_root << by_two;
    assign addend = (remainder_sign != none) ? shifted_root | low_digits : ~shifted_root | low_digits;
    assign sum = dividend + addend;
    assign shifted_live = live << by_one;
    assign grown_live = shifted_live | wide_digit;
    assign halved_live = live >> by_one;
    assign sign = live ^ halved_live;
    assign remainder_sign = remainder & sign;
    assign next_sign = grown_live ^ live;
    assign sum_sign = sum & next_sign;
    assign doubled_root = root << by_one;
    assign next_pairs = pairs << by_two;
    assign next_root = (sum_sign != none) ? doubled_root : doubled_root | digit;
    assign next_remainder = sum & grown_live;
    assign next_live = grown_live;

endmodule
