// vector_step_w18_v2: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module vector_step_w18_v2 (
    input  wire [17:0] x,
    input  wire [17:0] y,
    input  wire [17:0] z,
    input  wire [17:0] magnitude,
    input  wire [5:0] count,
    output wire [17:0] late_x,
    output wire [17:0] late_y,
    output wire [17:0] late_z,
    output wire [17:0] late_magnitude,
    output wire [5:0] late_count
);

    localparam [17:0] mask = 18'd130560;
    localparam [17:0] zero = 18'd0;
    localparam [5:0] places = 6'd8;
    wire [17:0] first_bits;

    assign first_bits = magnitude & mask;
    assign late_x = (first_bits == zero) ? x << places : x;
    assign late_y = (first_bits == zero) ? y << places : y;
    assign late_z = (first_bits == zero) ? z << places : z;
    assign late_magnitude = (first_bits == zero) ? magnitude << places : magnitude;
    assign late_count = (first_bits == zero) ? count | places : count;

endmodule
