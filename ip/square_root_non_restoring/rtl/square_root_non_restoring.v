// square_root_non_restoring: root = floor(sqrt(radicand)) and remainder = radicand - root^2, one result per clock
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
// Made by: imogene emit square_root_non_restoring --format 24 --rows-per-stage 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_non_restoring (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [23:0] root,
    output wire [24:0] remainder
);

    localparam [23:0] no_digits = 24'd0;
    localparam [25:0] no_remainder = 26'd0;
    localparam [25:0] first_live = 26'd3;
    localparam [1:0] by_one = 2'd1;
    localparam [25:0] digit = 26'd1;
    wire [25:0] wide_root;
    wire [25:0] doubled_root;
    wire [25:0] restoring;
    wire [25:0] restored;
    wire [47:0] stages_0_next_pairs;
    wire [23:0] stages_0_next_root;
    wire [25:0] stages_0_next_remainder;
    wire [25:0] stages_0_next_live;
    wire [47:0] stages_1_next_pairs;
    wire [23:0] stages_1_next_root;
    wire [25:0] stages_1_next_remainder;
    wire [25:0] stages_1_next_live;
    wire [47:0] stages_2_next_pairs;
    wire [23:0] stages_2_next_root;
    wire [25:0] stages_2_next_remainder;
    wire [25:0] stages_2_next_live;
    wire [47:0] stages_3_next_pairs;
    wire [23:0] stages_3_next_root;
    wire [25:0] stages_3_next_remainder;
    wire [25:0] stages_3_next_live;
    wire [47:0] stages_4_next_pairs;
    wire [23:0] stages_4_next_root;
    wire [25:0] stages_4_next_remainder;
    wire [25:0] stages_4_next_live;
    wire [47:0] stages_5_next_pairs;
    wire [23:0] stages_5_next_root;
    wire [25:0] stages_5_next_remainder;
    wire [25:0] stages_5_next_live;
    wire [47:0] stages_6_next_pairs;
    wire [23:0] stages_6_next_root;
    wire [25:0] stages_6_next_remainder;
    wire [25:0] stages_6_next_live;
    wire [47:0] stages_7_next_pairs;
    wire [23:0] stages_7_next_root;
    wire [25:0] stages_7_next_remainder;
    wire [25:0] stages_7_next_live;
    wire [47:0] stages_8_next_pairs;
    wire [23:0] stages_8_next_root;
    wire [25:0] stages_8_next_remainder;
    wire [25:0] stages_8_next_live;
    wire [47:0] stages_9_next_pairs;
    wire [23:0] stages_9_next_root;
    wire [25:0] stages_9_next_remainder;
    wire [25:0] stages_9_next_live;
    wire [47:0] stages_10_next_pairs;
    wire [23:0] stages_10_next_root;
    wire [25:0] stages_10_next_remainder;
    wire [25:0] stages_10_next_live;
    wire [47:0] stages_11_next_pairs;
    wire [23:0] stages_11_next_root;
    wire [25:0] stages_11_next_remainder;
    wire [25:0] stages_11_next_live;
    wire [47:0] stages_12_next_pairs;
    wire [23:0] stages_12_next_root;
    wire [25:0] stages_12_next_remainder;
    wire [25:0] stages_12_next_live;
    wire [47:0] stages_13_next_pairs;
    wire [23:0] stages_13_next_root;
    wire [25:0] stages_13_next_remainder;
    wire [25:0] stages_13_next_live;
    wire [47:0] stages_14_next_pairs;
    wire [23:0] stages_14_next_root;
    wire [25:0] stages_14_next_remainder;
    wire [25:0] stages_14_next_live;
    wire [47:0] stages_15_next_pairs;
    wire [23:0] stages_15_next_root;
    wire [25:0] stages_15_next_remainder;
    wire [25:0] stages_15_next_live;
    wire [47:0] stages_16_next_pairs;
    wire [23:0] stages_16_next_root;
    wire [25:0] stages_16_next_remainder;
    wire [25:0] stages_16_next_live;
    wire [47:0] stages_17_next_pairs;
    wire [23:0] stages_17_next_root;
    wire [25:0] stages_17_next_remainder;
    wire [25:0] stages_17_next_live;
    wire [47:0] stages_18_next_pairs;
    wire [23:0] stages_18_next_root;
    wire [25:0] stages_18_next_remainder;
    wire [25:0] stages_18_next_live;
    wire [47:0] stages_19_next_pairs;
    wire [23:0] stages_19_next_root;
    wire [25:0] stages_19_next_remainder;
    wire [25:0] stages_19_next_live;
    wire [47:0] stages_20_next_pairs;
    wire [23:0] stages_20_next_root;
    wire [25:0] stages_20_next_remainder;
    wire [25:0] stages_20_next_live;
    wire [47:0] stages_21_next_pairs;
    wire [23:0] stages_21_next_root;
    wire [25:0] stages_21_next_remainder;
    wire [25:0] stages_21_next_live;
    wire [47:0] stages_22_next_pairs;
    wire [23:0] stages_22_next_root;
    wire [25:0] stages_22_next_remainder;
    wire [25:0] stages_22_next_live;
    wire [47:0] unused_stages_23_next_pairs;
    wire [23:0] stages_23_next_root;
    wire [25:0] stages_23_next_remainder;
    wire [25:0] unused_stages_23_next_live;

    non_restoring_stage stages_0 (
        .clock(clock),
        .pairs(radicand),
        .root(no_digits),
        .remainder(no_remainder),
        .live(first_live),
        .next_pairs(stages_0_next_pairs),
        .next_root(stages_0_next_root),
        .next_remainder(stages_0_next_remainder),
        .next_live(stages_0_next_live)
    );

    non_restoring_stage stages_1 (
        .clock(clock),
        .pairs(stages_0_next_pairs),
        .root(stages_0_next_root),
        .remainder(stages_0_next_remainder),
        .live(stages_0_next_live),
        .next_pairs(stages_1_next_pairs),
        .next_root(stages_1_next_root),
        .next_remainder(stages_1_next_remainder),
        .next_live(stages_1_next_live)
    );

    non_restoring_stage stages_2 (
        .clock(clock),
        .pairs(stages_1_next_pairs),
        .root(stages_1_next_root),
        .remainder(stages_1_next_remainder),
        .live(stages_1_next_live),
        .next_pairs(stages_2_next_pairs),
        .next_root(stages_2_next_root),
        .next_remainder(stages_2_next_remainder),
        .next_live(stages_2_next_live)
    );

    non_restoring_stage stages_3 (
        .clock(clock),
        .pairs(stages_2_next_pairs),
        .root(stages_2_next_root),
        .remainder(stages_2_next_remainder),
        .live(stages_2_next_live),
        .next_pairs(stages_3_next_pairs),
        .next_root(stages_3_next_root),
        .next_remainder(stages_3_next_remainder),
        .next_live(stages_3_next_live)
    );

    non_restoring_stage stages_4 (
        .clock(clock),
        .pairs(stages_3_next_pairs),
        .root(stages_3_next_root),
        .remainder(stages_3_next_remainder),
        .live(stages_3_next_live),
        .next_pairs(stages_4_next_pairs),
        .next_root(stages_4_next_root),
        .next_remainder(stages_4_next_remainder),
        .next_live(stages_4_next_live)
    );

    non_restoring_stage stages_5 (
        .clock(clock),
        .pairs(stages_4_next_pairs),
        .root(stages_4_next_root),
        .remainder(stages_4_next_remainder),
        .live(stages_4_next_live),
        .next_pairs(stages_5_next_pairs),
        .next_root(stages_5_next_root),
        .next_remainder(stages_5_next_remainder),
        .next_live(stages_5_next_live)
    );

    non_restoring_stage stages_6 (
        .clock(clock),
        .pairs(stages_5_next_pairs),
        .root(stages_5_next_root),
        .remainder(stages_5_next_remainder),
        .live(stages_5_next_live),
        .next_pairs(stages_6_next_pairs),
        .next_root(stages_6_next_root),
        .next_remainder(stages_6_next_remainder),
        .next_live(stages_6_next_live)
    );

    non_restoring_stage stages_7 (
        .clock(clock),
        .pairs(stages_6_next_pairs),
        .root(stages_6_next_root),
        .remainder(stages_6_next_remainder),
        .live(stages_6_next_live),
        .next_pairs(stages_7_next_pairs),
        .next_root(stages_7_next_root),
        .next_remainder(stages_7_next_remainder),
        .next_live(stages_7_next_live)
    );

    non_restoring_stage stages_8 (
        .clock(clock),
        .pairs(stages_7_next_pairs),
        .root(stages_7_next_root),
        .remainder(stages_7_next_remainder),
        .live(stages_7_next_live),
        .next_pairs(stages_8_next_pairs),
        .next_root(stages_8_next_root),
        .next_remainder(stages_8_next_remainder),
        .next_live(stages_8_next_live)
    );

    non_restoring_stage stages_9 (
        .clock(clock),
        .pairs(stages_8_next_pairs),
        .root(stages_8_next_root),
        .remainder(stages_8_next_remainder),
        .live(stages_8_next_live),
        .next_pairs(stages_9_next_pairs),
        .next_root(stages_9_next_root),
        .next_remainder(stages_9_next_remainder),
        .next_live(stages_9_next_live)
    );

    non_restoring_stage stages_10 (
        .clock(clock),
        .pairs(stages_9_next_pairs),
        .root(stages_9_next_root),
        .remainder(stages_9_next_remainder),
        .live(stages_9_next_live),
        .next_pairs(stages_10_next_pairs),
        .next_root(stages_10_next_root),
        .next_remainder(stages_10_next_remainder),
        .next_live(stages_10_next_live)
    );

    non_restoring_stage stages_11 (
        .clock(clock),
        .pairs(stages_10_next_pairs),
        .root(stages_10_next_root),
        .remainder(stages_10_next_remainder),
        .live(stages_10_next_live),
        .next_pairs(stages_11_next_pairs),
        .next_root(stages_11_next_root),
        .next_remainder(stages_11_next_remainder),
        .next_live(stages_11_next_live)
    );

    non_restoring_stage stages_12 (
        .clock(clock),
        .pairs(stages_11_next_pairs),
        .root(stages_11_next_root),
        .remainder(stages_11_next_remainder),
        .live(stages_11_next_live),
        .next_pairs(stages_12_next_pairs),
        .next_root(stages_12_next_root),
        .next_remainder(stages_12_next_remainder),
        .next_live(stages_12_next_live)
    );

    non_restoring_stage stages_13 (
        .clock(clock),
        .pairs(stages_12_next_pairs),
        .root(stages_12_next_root),
        .remainder(stages_12_next_remainder),
        .live(stages_12_next_live),
        .next_pairs(stages_13_next_pairs),
        .next_root(stages_13_next_root),
        .next_remainder(stages_13_next_remainder),
        .next_live(stages_13_next_live)
    );

    non_restoring_stage stages_14 (
        .clock(clock),
        .pairs(stages_13_next_pairs),
        .root(stages_13_next_root),
        .remainder(stages_13_next_remainder),
        .live(stages_13_next_live),
        .next_pairs(stages_14_next_pairs),
        .next_root(stages_14_next_root),
        .next_remainder(stages_14_next_remainder),
        .next_live(stages_14_next_live)
    );

    non_restoring_stage stages_15 (
        .clock(clock),
        .pairs(stages_14_next_pairs),
        .root(stages_14_next_root),
        .remainder(stages_14_next_remainder),
        .live(stages_14_next_live),
        .next_pairs(stages_15_next_pairs),
        .next_root(stages_15_next_root),
        .next_remainder(stages_15_next_remainder),
        .next_live(stages_15_next_live)
    );

    non_restoring_stage stages_16 (
        .clock(clock),
        .pairs(stages_15_next_pairs),
        .root(stages_15_next_root),
        .remainder(stages_15_next_remainder),
        .live(stages_15_next_live),
        .next_pairs(stages_16_next_pairs),
        .next_root(stages_16_next_root),
        .next_remainder(stages_16_next_remainder),
        .next_live(stages_16_next_live)
    );

    non_restoring_stage stages_17 (
        .clock(clock),
        .pairs(stages_16_next_pairs),
        .root(stages_16_next_root),
        .remainder(stages_16_next_remainder),
        .live(stages_16_next_live),
        .next_pairs(stages_17_next_pairs),
        .next_root(stages_17_next_root),
        .next_remainder(stages_17_next_remainder),
        .next_live(stages_17_next_live)
    );

    non_restoring_stage stages_18 (
        .clock(clock),
        .pairs(stages_17_next_pairs),
        .root(stages_17_next_root),
        .remainder(stages_17_next_remainder),
        .live(stages_17_next_live),
        .next_pairs(stages_18_next_pairs),
        .next_root(stages_18_next_root),
        .next_remainder(stages_18_next_remainder),
        .next_live(stages_18_next_live)
    );

    non_restoring_stage stages_19 (
        .clock(clock),
        .pairs(stages_18_next_pairs),
        .root(stages_18_next_root),
        .remainder(stages_18_next_remainder),
        .live(stages_18_next_live),
        .next_pairs(stages_19_next_pairs),
        .next_root(stages_19_next_root),
        .next_remainder(stages_19_next_remainder),
        .next_live(stages_19_next_live)
    );

    non_restoring_stage stages_20 (
        .clock(clock),
        .pairs(stages_19_next_pairs),
        .root(stages_19_next_root),
        .remainder(stages_19_next_remainder),
        .live(stages_19_next_live),
        .next_pairs(stages_20_next_pairs),
        .next_root(stages_20_next_root),
        .next_remainder(stages_20_next_remainder),
        .next_live(stages_20_next_live)
    );

    non_restoring_stage stages_21 (
        .clock(clock),
        .pairs(stages_20_next_pairs),
        .root(stages_20_next_root),
        .remainder(stages_20_next_remainder),
        .live(stages_20_next_live),
        .next_pairs(stages_21_next_pairs),
        .next_root(stages_21_next_root),
        .next_remainder(stages_21_next_remainder),
        .next_live(stages_21_next_live)
    );

    non_restoring_stage stages_22 (
        .clock(clock),
        .pairs(stages_21_next_pairs),
        .root(stages_21_next_root),
        .remainder(stages_21_next_remainder),
        .live(stages_21_next_live),
        .next_pairs(stages_22_next_pairs),
        .next_root(stages_22_next_root),
        .next_remainder(stages_22_next_remainder),
        .next_live(stages_22_next_live)
    );

    non_restoring_stage stages_23 (
        .clock(clock),
        .pairs(stages_22_next_pairs),
        .root(stages_22_next_root),
        .remainder(stages_22_next_remainder),
        .live(stages_22_next_live),
        .next_pairs(unused_stages_23_next_pairs),
        .next_root(stages_23_next_root),
        .next_remainder(stages_23_next_remainder),
        .next_live(unused_stages_23_next_live)
    );

    assign wide_root = {2'd0, stages_23_next_root};
    assign doubled_root = wide_root << by_one;
    assign restoring = doubled_root | digit;
    assign restored = stages_23_next_remainder + restoring;
    assign root = stages_23_next_root;
    assign remainder = stages_23_next_remainder[25] ? restored[24:0] : stages_23_next_remainder[24:0];

    wire unused_bits = &{1'b0, restored[25]};

endmodule
