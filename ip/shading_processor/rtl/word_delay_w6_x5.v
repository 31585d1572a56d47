// word_delay_w6_x5: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w6_x5 (
    input  wire clock,
    input  wire [5:0] word,
    output wire [5:0] late
);

    reg [5:0] word_at_0 = 6'd0;
    reg [5:0] word_at_1 = 6'd0;
    reg [5:0] word_at_2 = 6'd0;
    reg [5:0] word_at_3 = 6'd0;
    reg [5:0] word_at_4 = 6'd0;

    assign late = word_at_4;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
        word_at_3 <= word_at_2;
        word_at_4 <= word_at_3;
    end

endmodule
