// square_root: root = floor(sqrt(radicand)) and remainder = radicand - root^2, one result per clock
//
// parameters: format 24
//             rows per stage 1
// latency:    24 clocks
// error:      exact
// source:     Nyiri 1994, 2.3.3
// ports:
//   in  clock           1 unsigned
//   in  radicand       48 unsigned
//   out root           24 unsigned
//   out remainder      25 unsigned
//
// Made by: imogene emit square_root --format 24 --rows-per-stage 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [23:0] root,
    output wire [24:0] remainder
);

    wire [1199:0] stages_pairs;
    wire [599:0] stages_root;
    wire [624:0] stages_remainder;
    wire [623:0] stages_live;
    genvar k;

    assign stages_pairs[47:0] = radicand;
    assign stages_root[23:0] = 24'd0;
    assign stages_remainder[24:0] = 25'd0;
    assign stages_live = {26'h1ffffff, 26'hffffff, 26'h7fffff, 26'h3fffff, 26'h1fffff, 26'hfffff, 26'h7ffff,
        26'h3ffff, 26'h1ffff, 26'd65535, 26'd32767, 26'd16383, 26'd8191, 26'd4095, 26'd2047, 26'd1023, 26'd511,
        26'd255, 26'd127, 26'd63, 26'd31, 26'd15, 26'd7, 26'd3};
    for (k = 0; k < 24; k = k + 1) begin : stages
        square_root_stage stage (
            .clock(clock), .pairs(stages_pairs[48 * k +: 48]), .root(stages_root[24 * k +: 24]),
            .remainder(stages_remainder[25 * k +: 25]), .live(stages_live[26 * k +: 26]),
            .next_pairs(stages_pairs[48 * (k + 1) +: 48]), .next_root(stages_root[24 * (k + 1) +: 24]),
            .next_remainder(stages_remainder[25 * (k + 1) +: 25]));
    end

    assign root = stages_root[599:576];
    assign remainder = stages_remainder[624:600];
    wire unused = &{1'b0, stages_pairs[1199:1152]};
endmodule
