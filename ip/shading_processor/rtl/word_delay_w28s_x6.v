// word_delay_w28s_x6: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w28s_x6 (
    input  wire clock,
    input  wire signed [27:0] word,
    output wire signed [27:0] late
);

    reg signed [27:0] word_at_0 = 28'sd0;
    reg signed [27:0] word_at_1 = 28'sd0;
    reg signed [27:0] word_at_2 = 28'sd0;
    reg signed [27:0] word_at_3 = 28'sd0;
    reg signed [27:0] word_at_4 = 28'sd0;
    reg signed [27:0] word_at_5 = 28'sd0;

    assign late = word_at_5;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
        word_at_3 <= word_at_2;
        word_at_4 <= word_at_3;
        word_at_5 <= word_at_4;
    end

endmodule
