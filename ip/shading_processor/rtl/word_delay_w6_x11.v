// word_delay_w6_x11: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w6_x11 (
    input  wire clock,
    input  wire [5:0] word,
    output wire [5:0] late
);

    reg [5:0] word_at_0 = 6'd0;
    reg [5:0] word_at_1 = 6'd0;
    reg [5:0] word_at_2 = 6'd0;
    reg [5:0] word_at_3 = 6'd0;
    reg [5:0] word_at_4 = 6'd0;
    reg [5:0] word_at_5 = 6'd0;
    reg [5:0] word_at_6 = 6'd0;
    reg [5:0] word_at_7 = 6'd0;
    reg [5:0] word_at_8 = 6'd0;
    reg [5:0] word_at_9 = 6'd0;
    reg [5:0] word_at_10 = 6'd0;

    assign late = word_at_10;

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
    end

endmodule
