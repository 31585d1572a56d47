// leading_step_w32_v5: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module leading_step_w32_v5 (
    input  wire [31:0] number,
    input  wire [5:0] count,
    output wire [31:0] shifted,
    output wire [5:0] late_count
);

    localparam [31:0] mask = 32'd2147483648;
    localparam [31:0] zero = 32'd0;
    localparam [5:0] places = 6'd1;
    wire [31:0] first_bits;

    assign first_bits = number & mask;
    assign shifted = (first_bits == zero) ? number << places : number;
    assign late_count = (first_bits == zero) ? count | places : count;

endmodule
