// word_delay_w16_x13: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w16_x13 (
    input  wire clock,
    input  wire [15:0] word,
    output wire [15:0] late
);

    reg [15:0] word_at_0 = 16'd0;
    reg [15:0] word_at_1 = 16'd0;
    reg [15:0] word_at_2 = 16'd0;
    reg [15:0] word_at_3 = 16'd0;
    reg [15:0] word_at_4 = 16'd0;
    reg [15:0] word_at_5 = 16'd0;
    reg [15:0] word_at_6 = 16'd0;
    reg [15:0] word_at_7 = 16'd0;
    reg [15:0] word_at_8 = 16'd0;
    reg [15:0] word_at_9 = 16'd0;
    reg [15:0] word_at_10 = 16'd0;
    reg [15:0] word_at_11 = 16'd0;
    reg [15:0] word_at_12 = 16'd0;

    assign late = word_at_12;

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
    end

endmodule
