// word_delay_w24_x2: part of frame_store; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w24_x2 (
    input  wire clock,
    input  wire [23:0] word,
    output wire [23:0] late
);

    reg [23:0] word_at_0 = 24'd0;
    reg [23:0] word_at_1 = 24'd0;

    assign late = word_at_1;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
    end

endmodule
