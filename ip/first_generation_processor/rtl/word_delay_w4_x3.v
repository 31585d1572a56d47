// word_delay_w4_x3: part of first_generation_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w4_x3 (
    input  wire clock,
    input  wire [3:0] word,
    output wire [3:0] late
);

    reg [3:0] word_at_0 = 4'd0;
    reg [3:0] word_at_1 = 4'd0;
    reg [3:0] word_at_2 = 4'd0;

    assign late = word_at_2;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
    end

endmodule
