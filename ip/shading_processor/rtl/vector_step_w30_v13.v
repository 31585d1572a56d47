// vector_step_w30_v13: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module vector_step_w30_v13 (
    input  wire [29:0] x,
    input  wire [29:0] y,
    input  wire [29:0] z,
    input  wire [29:0] magnitude,
    input  wire [5:0] count,
    output wire [29:0] late_x,
    output wire [29:0] late_y,
    output wire [29:0] late_z,
    output wire [29:0] late_magnitude,
    output wire [5:0] late_count
);

    localparam [29:0] mask = 30'd402653184;
    localparam [29:0] zero = 30'd0;
    localparam [5:0] places = 6'd2;
    wire [29:0] first_bits;

    assign first_bits = magnitude & mask;
    assign late_x = (first_bits == zero) ? x << places : x;
    assign late_y = (first_bits == zero) ? y << places : y;
    assign late_z = (first_bits == zero) ? z << places : z;
    assign late_magnitude = (first_bits == zero) ? magnitude << places : magnitude;
    assign late_count = (first_bits == zero) ? count | places : count;

endmodule
