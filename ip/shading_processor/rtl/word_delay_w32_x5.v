// word_delay_w32_x5: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w32_x5 (
    input  wire clock,
    input  wire [31:0] word,
    output wire [31:0] late
);

    reg [31:0] word_at_0 = 32'd0;
    reg [31:0] word_at_1 = 32'd0;
    reg [31:0] word_at_2 = 32'd0;
    reg [31:0] word_at_3 = 32'd0;
    reg [31:0] word_at_4 = 32'd0;

    assign late = word_at_4;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
        word_at_3 <= word_at_2;
        word_at_4 <= word_at_3;
    end

endmodule
