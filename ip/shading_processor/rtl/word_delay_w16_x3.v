// word_delay_w16_x3: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w16_x3 (
    input  wire clock,
    input  wire [15:0] word,
    output wire [15:0] late
);

    reg [15:0] word_at_0 = 16'd0;
    reg [15:0] word_at_1 = 16'd0;
    reg [15:0] word_at_2 = 16'd0;

    assign late = word_at_2;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
    end

endmodule
