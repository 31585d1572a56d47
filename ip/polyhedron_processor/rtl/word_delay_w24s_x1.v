// word_delay_w24s_x1: part of polyhedron_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module word_delay_w24s_x1 (
    input  wire clock,
    input  wire signed [23:0] word,
    output wire signed [23:0] late
);

    reg signed [23:0] word_at_0 = 24'sd0;

    assign late = word_at_0;

    always @(posedge clock) begin
        word_at_0 <= word;
    end

endmodule
