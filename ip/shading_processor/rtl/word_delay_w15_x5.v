// word_delay_w15_x5: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w15_x5 (
    input  wire clock,
    input  wire [14:0] word,
    output wire [14:0] late
);

    reg [14:0] word_at_0 = 15'd0;
    reg [14:0] word_at_1 = 15'd0;
    reg [14:0] word_at_2 = 15'd0;
    reg [14:0] word_at_3 = 15'd0;
    reg [14:0] word_at_4 = 15'd0;

    assign late = word_at_4;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
        word_at_3 <= word_at_2;
        word_at_4 <= word_at_3;
    end

endmodule
