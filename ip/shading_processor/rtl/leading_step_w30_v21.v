// leading_step_w30_v21: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module leading_step_w30_v21 (
    input  wire [29:0] number,
    input  wire [5:0] count,
    output wire [29:0] shifted,
    output wire [5:0] late_count
);

    localparam [29:0] mask = 30'd536870912;
    localparam [29:0] zero = 30'd0;
    localparam [5:0] places = 6'd1;
    wire [29:0] first_bits;

    assign first_bits = number & mask;
    assign shifted = (first_bits == zero) ? number << places : number;
    assign late_count = (first_bits == zero) ? count | places : count;

endmodule
