// word_delay_w24_x1: part of first_generation_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w24_x1 (
    input  wire clock,
    input  wire [23:0] word,
    output wire [23:0] late
);

    reg [23:0] word_at_0 = 24'd0;

    assign late = word_at_0;

    always @(posedge clock) begin
        word_at_0 <= word;
    end

endmodule
