// word_delay_w24s_x3: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w24s_x3 (
    input  wire clock,
    input  wire signed [23:0] word,
    output wire signed [23:0] late
);

    reg signed [23:0] word_at_0 = 24'sd0;
    reg signed [23:0] word_at_1 = 24'sd0;
    reg signed [23:0] word_at_2 = 24'sd0;

    assign late = word_at_2;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
    end

endmodule
