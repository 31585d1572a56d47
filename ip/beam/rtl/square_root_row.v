// square_root_row: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_row (
    input  wire [47:0] pairs,
    input  wire [23:0] root,
    input  wire [24:0] remainder,
    input  wire [25:0] live,
    output wire [47:0] next_pairs,
    output wire [23:0] next_root,
    output wire [24:0] next_remainder
);

    wire [25:0] divisor, dividend, trial, sign, kept;
    wire [1:0] pair;
    wire negative;
    wire [23:0] next_root_joined;

    assign divisor = {root, 2'd1};
    assign pair = pairs[47:46];
    assign dividend = {remainder[23:0], pair};
    assign trial = dividend - divisor;
    assign sign = live + 26'd1;
    assign negative = (trial & sign) != 26'd0;
    assign kept = (negative ? dividend : trial) & live;
    assign next_root_joined = {root[22:0], 1'd0};
    assign next_pairs = {pairs[45:0], 2'd0};
    assign next_root = negative ? next_root_joined : (next_root_joined | 24'd1);
    assign next_remainder = kept[24:0];
    wire unused = &{1'b0, remainder[24], kept[25]};
endmodule
