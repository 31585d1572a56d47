// leading_step_w24_v16: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module leading_step_w24_v16 (
    input  wire [23:0] number,
    input  wire [5:0] count,
    output wire [23:0] shifted,
    output wire [5:0] late_count
);

    localparam [23:0] mask = 24'd8388608;
    localparam [23:0] zero = 24'd0;
    localparam [5:0] places = 6'd1;
    wire [23:0] first_bits;

    assign first_bits = number & mask;
    assign shifted = (first_bits == zero) ? number << places : number;
    assign late_count = (first_bits == zero) ? count | places : count;

endmodule
