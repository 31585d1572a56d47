// word_delay_w8: part of overlay; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w8 (
    input  wire clock,
    input  wire [7:0] word,
    output wire [7:0] late
);

    reg [7:0] word_at_0 = 8'd0;
    reg [7:0] word_at_1 = 8'd0;
    reg [7:0] word_at_2 = 8'd0;

    assign late = word_at_2;

    always @(posedge clock) begin
        word_at_0 <= word;
        word_at_1 <= word_at_0;
        word_at_2 <= word_at_1;
    end

endmodule
