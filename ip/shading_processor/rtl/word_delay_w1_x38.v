// word_delay_w1_x38: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w1_x38 (
    input  wire clock,
    input  wire word,
    output wire late
);

    reg word_at_0 = 1'd0;
    reg word_at_1 = 1'd0;
    reg word_at_2 = 1'd0;
    reg word_at_3 = 1'd0;
    reg word_at_4 = 1'd0;
    reg word_at_5 = 1'd0;
    reg word_at_6 = 1'd0;
    reg word_at_7 = 1'd0;
    reg word_at_8 = 1'd0;
    reg word_at_9 = 1'd0;
    reg word_at_10 = 1'd0;
    reg word_at_11 = 1'd0;
    reg word_at_12 = 1'd0;
    reg word_at_13 = 1'd0;
    reg word_at_14 = 1'd0;
    reg word_at_15 = 1'd0;
    reg word_at_16 = 1'd0;
    reg word_at_17 = 1'd0;
    reg word_at_18 = 1'd0;
    reg word_at_19 = 1'd0;
    reg word_at_20 = 1'd0;
    reg word_at_21 = 1'd0;
    reg word_at_22 = 1'd0;
    reg word_at_23 = 1'd0;
    reg word_at_24 = 1'd0;
    reg word_at_25 = 1'd0;
    reg word_at_26 = 1'd0;
    reg word_at_27 = 1'd0;
    reg word_at_28 = 1'd0;
    reg word_at_29 = 1'd0;
    reg word_at_30 = 1'd0;
    reg word_at_31 = 1'd0;
    reg word_at_32 = 1'd0;
    reg word_at_33 = 1'd0;
    reg word_at_34 = 1'd0;
    reg word_at_35 = 1'd0;
    reg word_at_36 = 1'd0;
    reg word_at_37 = 1'd0;

    assign late = word_at_37;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
        word_at_3 <= word_at_2;
        word_at_4 <= word_at_3;
        word_at_5 <= word_at_4;
        word_at_6 <= word_at_5;
        word_at_7 <= word_at_6;
        word_at_8 <= word_at_7;
        word_at_9 <= word_at_8;
        word_at_10 <= word_at_9;
        word_at_11 <= word_at_10;
        word_at_12 <= word_at_11;
        word_at_13 <= word_at_12;
        word_at_14 <= word_at_13;
        word_at_15 <= word_at_14;
        word_at_16 <= word_at_15;
        word_at_17 <= word_at_16;
        word_at_18 <= word_at_17;
        word_at_19 <= word_at_18;
        word_at_20 <= word_at_19;
        word_at_21 <= word_at_20;
        word_at_22 <= word_at_21;
        word_at_23 <= word_at_22;
        word_at_24 <= word_at_23;
        word_at_25 <= word_at_24;
        word_at_26 <= word_at_25;
        word_at_27 <= word_at_26;
        word_at_28 <= word_at_27;
        word_at_29 <= word_at_28;
        word_at_30 <= word_at_29;
        word_at_31 <= word_at_30;
        word_at_32 <= word_at_31;
        word_at_33 <= word_at_32;
        word_at_34 <= word_at_33;
        word_at_35 <= word_at_34;
        word_at_36 <= word_at_35;
        word_at_37 <= word_at_36;
    end

endmodule
