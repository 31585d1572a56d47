// word_delay_w36_x4: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w36_x4 (
    input  wire clock,
    input  wire [35:0] word,
    output wire [35:0] late
);

    reg [35:0] word_at_0 = 36'd0;
    reg [35:0] word_at_1 = 36'd0;
    reg [35:0] word_at_2 = 36'd0;
    reg [35:0] word_at_3 = 36'd0;

    assign late = word_at_3;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
        word_at_3 <= word_at_2;
    end

endmodule
