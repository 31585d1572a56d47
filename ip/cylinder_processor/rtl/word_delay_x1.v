// word_delay_x1: part of cylinder_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_x1 (
    input  wire clock,
    input  wire word,
    output wire late
);

    reg word_at_0 = 1'd0;

    assign late = word_at_0;

    always @(posedge clock) begin
        word_at_0 <= word;
    end

endmodule
