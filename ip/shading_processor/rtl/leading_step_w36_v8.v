// leading_step_w36_v8: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module leading_step_w36_v8 (
    input  wire [35:0] number,
    input  wire [5:0] count,
    output wire [35:0] shifted,
    output wire [5:0] late_count
);

    localparam [35:0] mask = 36'd68451041280;
    localparam [35:0] zero = 36'd0;
    localparam [5:0] places = 6'd8;
    wire [35:0] first_bits;

    assign first_bits = number & mask;
    assign shifted = (first_bits == zero) ? number << places : number;
    assign late_count = (first_bits == zero) ? count | places : count;

endmodule
