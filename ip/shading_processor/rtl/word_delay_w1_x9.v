// word_delay_w1_x9: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w1_x9 (
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

    assign late = word_at_8;

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
    end

endmodule
