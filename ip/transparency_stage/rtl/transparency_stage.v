// transparency_stage: the colour of a transparent object blended over that of a pixel, if it is nearer
//
// parameters: format 24
// latency:    2 clocks
// error:      bound: half a step of a component
// source:     Chaillou 1991, IV.3.3
// ports:
//   in  clock           1 unsigned
//   in  pixel_depth    24 two's complement
//   in  pixel_red       8 unsigned
//   in  pixel_green     8 unsigned
//   in  pixel_blue      8 unsigned
//   in  layer_depth    24 two's complement
//   in  layer_red       8 unsigned
//   in  layer_green     8 unsigned
//   in  layer_blue      8 unsigned
//   in  layer_weight    8 unsigned
//   out depth          24 two's complement
//   out red             8 unsigned
//   out green           8 unsigned
//   out blue            8 unsigned
//
// Made by: imogene emit transparency_stage --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module transparency_stage (
    input  wire clock,
    input  wire signed [23:0] pixel_depth,
    input  wire [7:0] pixel_red,
    input  wire [7:0] pixel_green,
    input  wire [7:0] pixel_blue,
    input  wire signed [23:0] layer_depth,
    input  wire [7:0] layer_red,
    input  wire [7:0] layer_green,
    input  wire [7:0] layer_blue,
    input  wire [7:0] layer_weight,
    output wire signed [23:0] depth,
    output wire [7:0] red,
    output wire [7:0] green,
    output wire [7:0] blue
);

    wire is_nearer;
    wire [7:0] blend_red_blend;
    wire [7:0] blend_green_blend;
    wire [7:0] blend_blue_blend;
    reg signed [23:0] kept_depth = 24'sd0;
    reg signed [23:0] late_depth = 24'sd0;

    colour_blend blend_red (
        .clock(clock),
        .front(layer_red),
        .behind(pixel_red),
        .weight(layer_weight),
        .is_seen(is_nearer),
        .blend(blend_red_blend)
    );

    colour_blend blend_green (
        .clock(clock),
        .front(layer_green),
        .behind(pixel_green),
        .weight(layer_weight),
        .is_seen(is_nearer),
        .blend(blend_green_blend)
    );

    colour_blend blend_blue (
        .clock(clock),
        .front(layer_blue),
        .behind(pixel_blue),
        .weight(layer_weight),
        .is_seen(is_nearer),
        .blend(blend_blue_blend)
    );

    assign is_nearer = layer_depth < pixel_depth;
    assign depth = late_depth;
    assign red = blend_red_blend;
    assign green = blend_green_blend;
    assign blue = blend_blue_blend;

    always @(posedge clock) begin
        kept_depth <= pixel_depth;
        late_depth <= kept_depth;
    end

endmodule
