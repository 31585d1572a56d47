// word_delay_w8_x18: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w8_x18 (
    input  wire clock,
    input  wire [7:0] word,
    output wire [7:0] late
);

    reg [7:0] word_at_0 = 8'd0;
    reg [7:0] word_at_1 = 8'd0;
    reg [7:0] word_at_2 = 8'd0;
    reg [7:0] word_at_3 = 8'd0;
    reg [7:0] word_at_4 = 8'd0;
    reg [7:0] word_at_5 = 8'd0;
    reg [7:0] word_at_6 = 8'd0;
    reg [7:0] word_at_7 = 8'd0;
    reg [7:0] word_at_8 = 8'd0;
    reg [7:0] word_at_9 = 8'd0;
    reg [7:0] word_at_10 = 8'd0;
    reg [7:0] word_at_11 = 8'd0;
    reg [7:0] word_at_12 = 8'd0;
    reg [7:0] word_at_13 = 8'd0;
    reg [7:0] word_at_14 = 8'd0;
    reg [7:0] word_at_15 = 8'd0;
    reg [7:0] word_at_16 = 8'd0;
    reg [7:0] word_at_17 = 8'd0;

    assign late = word_at_17;

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
    end

endmodule
