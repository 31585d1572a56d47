// word_delay_w1: part of overlay; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w1 (
    input  wire clock,
    input  wire word,
    output wire late
);

    reg word_at_0 = 1'd0;
    reg word_at_1 = 1'd0;
    reg word_at_2 = 1'd0;

    assign late = word_at_2;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
    end

endmodule
