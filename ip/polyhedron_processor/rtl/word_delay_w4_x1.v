// word_delay_w4_x1: part of polyhedron_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w4_x1 (
    input  wire clock,
    input  wire [3:0] word,
    output wire [3:0] late
);

    reg [3:0] word_at_0 = 4'd0;

    assign late = word_at_0;

    always @(posedge clock) begin
        word_at_0 <= word;
    end

endmodule
