// flag_delay_x72: part of first_generation_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module flag_delay_x72 (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    output wire late_valid,
    output wire late_start,
    output wire late_line
);

    reg valid_at_0 = 1'd0;
    reg valid_at_1 = 1'd0;
    reg valid_at_2 = 1'd0;
    reg valid_at_3 = 1'd0;
    reg valid_at_4 = 1'd0;
    reg valid_at_5 = 1'd0;
    reg valid_at_6 = 1'd0;
    reg valid_at_7 = 1'd0;
    reg valid_at_8 = 1'd0;
    reg valid_at_9 = 1'd0;
    reg valid_at_10 = 1'd0;
    reg valid_at_11 = 1'd0;
    reg valid_at_12 = 1'd0;
    reg valid_at_13 = 1'd0;
    reg valid_at_14 = 1'd0;
    reg valid_at_15 = 1'd0;
    reg valid_at_16 = 1'd0;
    reg valid_at_17 = 1'd0;
    reg valid_at_18 = 1'd0;
    reg valid_at_19 = 1'd0;
    reg valid_at_20 = 1'd0;
    reg valid_at_21 = 1'd0;
    reg valid_at_22 = 1'd0;
    reg valid_at_23 = 1'd0;
    reg start_at_0 = 1'd0;
    reg start_at_1 = 1'd0;
    reg start_at_2 = 1'd0;
    reg start_at_3 = 1'd0;
    reg start_at_4 = 1'd0;
    reg start_at_5 = 1'd0;
    reg start_at_6 = 1'd0;
    reg start_at_7 = 1'd0;
    reg start_at_8 = 1'd0;
    reg start_at_9 = 1'd0;
    reg start_at_10 = 1'd0;
    reg start_at_11 = 1'd0;
    reg start_at_12 = 1'd0;
    reg start_at_13 = 1'd0;
    reg start_at_14 = 1'd0;
    reg start_at_15 = 1'd0;
    reg start_at_16 = 1'd0;
    reg start_at_17 = 1'd0;
    reg start_at_18 = 1'd0;
    reg start_at_19 = 1'd0;
    reg start_at_20 = 1'd0;
    reg start_at_21 = 1'd0;
    reg start_at_22 = 1'd0;
    reg start_at_23 = 1'd0;
    reg line_at_0 = 1'd0;
    reg line_at_1 = 1'd0;
    reg line_at_2 = 1'd0;
    reg line_at_3 = 1'd0;
    reg line_at_4 = 1'd0;
    reg line_at_5 = 1'd0;
    reg line_at_6 = 1'd0;
    reg line_at_7 = 1'd0;
    reg line_at_8 = 1'd0;
    reg line_at_9 = 1'd0;
    reg line_at_10 = 1'd0;
    reg line_at_11 = 1'd0;
    reg line_at_12 = 1'd0;
    reg line_at_13 = 1'd0;
    reg line_at_14 = 1'd0;
    reg line_at_15 = 1'd0;
    reg line_at_16 = 1'd0;
    reg line_at_17 = 1'd0;
    reg line_at_18 = 1'd0;
    reg line_at_19 = 1'd0;
    reg line_at_20 = 1'd0;
    reg line_at_21 = 1'd0;
    reg line_at_22 = 1'd0;
    reg line_at_23 = 1'd0;

    assign late_valid = valid_at_23;
    assign late_start = start_at_23;
    assign late_line = line_at_23;

    always @(posedge clock) begin
        valid_at_0 <= valid;
        start_at_0 <= start;
        line_at_0 <= line;
        valid_at_1 <= valid_at_0;
        start_at_1 <= start_at_0;
        line_at_1 <= line_at_0;
        valid_at_2 <= valid_at_1;
        start_at_2 <= start_at_1;
        line_at_2 <= line_at_1;
        valid_at_3 <= valid_at_2;
        start_at_3 <= start_at_2;
        line_at_3 <= line_at_2;
        valid_at_4 <= valid_at_3;
        start_at_4 <= start_at_3;
        line_at_4 <= line_at_3;
        valid_at_5 <= valid_at_4;
        start_at_5 <= start_at_4;
        line_at_5 <= line_at_4;
        valid_at_6 <= valid_at_5;
        start_at_6 <= start_at_5;
        line_at_6 <= line_at_5;
        valid_at_7 <= valid_at_6;
        start_at_7 <= start_at_6;
        line_at_7 <= line_at_6;
        valid_at_8 <= valid_at_7;
        start_at_8 <= start_at_7;
        line_at_8 <= line_at_7;
        valid_at_9 <= valid_at_8;
        start_at_9 <= start_at_8;
        line_at_9 <= line_at_8;
        valid_at_10 <= valid_at_9;
        start_at_10 <= start_at_9;
        line_at_10 <= line_at_9;
        valid_at_11 <= valid_at_10;
        start_at_11 <= start_at_10;
        line_at_11 <= line_at_10;
        valid_at_12 <= valid_at_11;
        start_at_12 <= start_at_11;
        line_at_12 <= line_at_11;
        valid_at_13 <= valid_at_12;
        start_at_13 <= start_at_12;
        line_at_13 <= line_at_12;
        valid_at_14 <= valid_at_13;
        start_at_14 <= start_at_13;
        line_at_14 <= line_at_13;
        valid_at_15 <= valid_at_14;
        start_at_15 <= start_at_14;
        line_at_15 <= line_at_14;
        valid_at_16 <= valid_at_15;
        start_at_16 <= start_at_15;
        line_at_16 <= line_at_15;
        valid_at_17 <= valid_at_16;
        start_at_17 <= start_at_16;
        line_at_17 <= line_at_16;
        valid_at_18 <= valid_at_17;
        start_at_18 <= start_at_17;
        line_at_18 <= line_at_17;
        valid_at_19 <= valid_at_18;
        start_at_19 <= start_at_18;
        line_at_19 <= line_at_18;
        valid_at_20 <= valid_at_19;
        start_at_20 <= start_at_19;
        line_at_20 <= line_at_19;
        valid_at_21 <= valid_at_20;
        start_at_21 <= start_at_20;
        line_at_21 <= line_at_20;
        valid_at_22 <= valid_at_21;
        start_at_22 <= start_at_21;
        line_at_22 <= line_at_21;
        valid_at_23 <= valid_at_22;
        start_at_23 <= start_at_22;
        line_at_23 <= line_at_22;
    end

endmodule
