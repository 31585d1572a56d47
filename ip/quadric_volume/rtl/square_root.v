// square_root: part of quadric_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [23:0] root,
    output wire [24:0] remainder
);

    localparam [23:0] no_digits = 24'd0;
    localparam [24:0] no_remainder = 25'd0;
    localparam [25:0] first_live = 26'd1;
    wire [47:0] stages_0_next_pairs;
    wire [23:0] stages_0_next_root;
    wire [24:0] stages_0_next_remainder;
    wire [25:0] stages_0_next_live;
    wire [47:0] stages_1_next_pairs;
    wire [23:0] stages_1_next_root;
    wire [24:0] stages_1_next_remainder;
    wire [25:0] stages_1_next_live;
    wire [47:0] stages_2_next_pairs;
    wire [23:0] stages_2_next_root;
    wire [24:0] stages_2_next_remainder;
    wire [25:0] stages_2_next_live;
    wire [47:0] stages_3_next_pairs;
    wire [23:0] stages_3_next_root;
    wire [24:0] stages_3_next_remainder;
    wire [25:0] stages_3_next_live;
    wire [47:0] stages_4_next_pairs;
    wire [23:0] stages_4_next_root;
    wire [24:0] stages_4_next_remainder;
    wire [25:0] stages_4_next_live;
    wire [47:0] stages_5_next_pairs;
    wire [23:0] stages_5_next_root;
    wire [24:0] stages_5_next_remainder;
    wire [25:0] stages_5_next_live;
    wire [47:0] stages_6_next_pairs;
    wire [23:0] stages_6_next_root;
    wire [24:0] stages_6_next_remainder;
    wire [25:0] stages_6_next_live;
    wire [47:0] stages_7_next_pairs;
    wire [23:0] stages_7_next_root;
    wire [24:0] stages_7_next_remainder;
    wire [25:0] stages_7_next_live;
    wire [47:0] stages_8_next_pairs;
    wire [23:0] stages_8_next_root;
    wire [24:0] stages_8_next_remainder;
    wire [25:0] stages_8_next_live;
    wire [47:0] stages_9_next_pairs;
    wire [23:0] stages_9_next_root;
    wire [24:0] stages_9_next_remainder;
    wire [25:0] stages_9_next_live;
    wire [47:0] stages_10_next_pairs;
    wire [23:0] stages_10_next_root;
    wire [24:0] stages_10_next_remainder;
    wire [25:0] stages_10_next_live;
    wire [47:0] stages_11_next_pairs;
    wire [23:0] stages_11_next_root;
    wire [24:0] stages_11_next_remainder;
    wire [25:0] stages_11_next_live;
    wire [47:0] stages_12_next_pairs;
    wire [23:0] stages_12_next_root;
    wire [24:0] stages_12_next_remainder;
    wire [25:0] stages_12_next_live;
    wire [47:0] stages_13_next_pairs;
    wire [23:0] stages_13_next_root;
    wire [24:0] stages_13_next_remainder;
    wire [25:0] stages_13_next_live;
    wire [47:0] stages_14_next_pairs;
    wire [23:0] stages_14_next_root;
    wire [24:0] stages_14_next_remainder;
    wire [25:0] stages_14_next_live;
    wire [47:0] stages_15_next_pairs;
    wire [23:0] stages_15_next_root;
    wire [24:0] stages_15_next_remainder;
    wire [25:0] stages_15_next_live;
    wire [47:0] stages_16_next_pairs;
    wire [23:0] stages_16_next_root;
    wire [24:0] stages_16_next_remainder;
    wire [25:0] stages_16_next_live;
    wire [47:0] stages_17_next_pairs;
    wire [23:0] stages_17_next_root;
    wire [24:0] stages_17_next_remainder;
    wire [25:0] stages_17_next_live;
    wire [47:0] stages_18_next_pairs;
    wire [23:0] stages_18_next_root;
    wire [24:0] stages_18_next_remainder;
    wire [25:0] stages_18_next_live;
    wire [47:0] stages_19_next_pairs;
    wire [23:0] stages_19_next_root;
    wire [24:0] stages_19_next_remainder;
    wire [25:0] stages_19_next_live;
    wire [47:0] stages_20_next_pairs;
    wire [23:0] stages_20_next_root;
    wire [24:0] stages_20_next_remainder;
    wire [25:0] stages_20_next_live;
    wire [47:0] stages_21_next_pairs;
    wire [23:0] stages_21_next_root;
    wire [24:0] stages_21_next_remainder;
    wire [25:0] stages_21_next_live;
    wire [47:0] stages_22_next_pairs;
    wire [23:0] stages_22_next_root;
    wire [24:0] stages_22_next_remainder;
    wire [25:0] stages_22_next_live;
    wire [47:0] unused_stages_23_next_pairs;
    wire [23:0] stages_23_next_root;
    wire [24:0] stages_23_next_remainder;
    wire [25:0] unused_stages_23_next_live;

    square_root_stage stages_0 (
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

    square_root_stage stages_1 (
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

    square_root_stage stages_2 (
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

    square_root_stage stages_3 (
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

    square_root_stage stages_4 (
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

    square_root_stage stages_5 (
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

    square_root_stage stages_6 (
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

    square_root_stage stages_7 (
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

    square_root_stage stages_8 (
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

    square_root_stage stages_9 (
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

    square_root_stage stages_10 (
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

    square_root_stage stages_11 (
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

    square_root_stage stages_12 (
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

    square_root_stage stages_13 (
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

    square_root_stage stages_14 (
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

    square_root_stage stages_15 (
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

    square_root_stage stages_16 (
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

    square_root_stage stages_17 (
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

    square_root_stage stages_18 (
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

    square_root_stage stages_19 (
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

    square_root_stage stages_20 (
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

    square_root_stage stages_21 (
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

    square_root_stage stages_22 (
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

    square_root_stage stages_23 (
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

    assign root = stages_23_next_root;
    assign remainder = stages_23_next_remainder;

endmodule
