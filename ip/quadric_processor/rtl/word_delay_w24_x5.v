// word_delay_w24_x5: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w24_x5 (
    input  wire clock,
    input  wire [23:0] word,
    output wire [23:0] late
);

    reg [23:0] word_at_0 = 24'd0;
    reg [23:0] word_at_1 = 24'd0;
    reg [23:0] word_at_2 = 24'd0;
    reg [23:0] word_at_3 = 24'd0;
    reg [23:0] word_at_4 = 24'd0;

    assign late = word_at_4;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
        word_at_3 <= word_at_2;
        word_at_4 <= word_at_3;
    end

endmodule
