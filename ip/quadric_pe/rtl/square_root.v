// square_root: part of quadric_pe; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [23:0] root,
    output wire [24:0] remainder
);

    wire [47:0] stages_pairs [0:24];
    wire [23:0] stages_root [0:24];
    wire [24:0] stages_remainder [0:24];
    wire [623:0] stages_live;
    genvar k;

    assign stages_pairs[0] = radicand;
    assign stages_root[0] = 24'd0;
    assign stages_remainder[0] = 25'd0;
    assign stages_live = {26'h1ffffff, 26'hffffff, 26'h7fffff, 26'h3fffff, 26'h1fffff, 26'hfffff, 26'h7ffff,
        26'h3ffff, 26'h1ffff, 26'd65535, 26'd32767, 26'd16383, 26'd8191, 26'd4095, 26'd2047, 26'd1023, 26'd511,
        26'd255, 26'd127, 26'd63, 26'd31, 26'd15, 26'd7, 26'd3};
    for (k = 0; k < 24; k = k + 1) begin : stages
        square_root_stage stage (
            .clock(clock), .pairs(stages_pairs[k]), .root(stages_root[k]), .remainder(stages_remainder[k]),
            .live(stages_live[26 * k +: 26]), .next_pairs(stages_pairs[k + 1]), .next_root(stages_root[k + 1]),
            .next_remainder(stages_remainder[k + 1]));
    end

    assign root = stages_root[24];
    assign remainder = stages_remainder[24];
    wire unused = &{1'b0, stages_pairs[24]};
endmodule
