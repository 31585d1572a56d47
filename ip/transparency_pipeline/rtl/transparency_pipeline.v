// transparency_pipeline: the colours of transparent objects blended over that of a pixel, farthest first
//
// parameters: format 24
//             layers 2
// latency:    4 clocks
// error:      bound: half a step of a component for each of 2 layers
// source:     Chaillou 1991, IV.3.3
// ports:
//   in  clock           1 unsigned
//   in  pixel_depth    24 two's complement
//   in  pixel_red       8 unsigned
//   in  pixel_green     8 unsigned
//   in  pixel_blue      8 unsigned
//   in  layer_0_depth  24 two's complement
//   in  layer_1_depth  24 two's complement
//   in  layer_0_red     8 unsigned
//   in  layer_1_red     8 unsigned
//   in  layer_0_green   8 unsigned
//   in  layer_1_green   8 unsigned
//   in  layer_0_blue    8 unsigned
//   in  layer_1_blue    8 unsigned
//   in  layer_0_weight  8 unsigned
//   in  layer_1_weight  8 unsigned
//   out depth          24 two's complement
//   out red             8 unsigned
//   out green           8 unsigned
//   out blue            8 unsigned
//
// Made by: imogene emit transparency_pipeline --format 24 --layers 2 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module transparency_pipeline (
    input  wire clock,
    input  wire signed [23:0] pixel_depth,
    input  wire [7:0] pixel_red,
    input  wire [7:0] pixel_green,
    input  wire [7:0] pixel_blue,
    input  wire signed [23:0] layer_0_depth,
    input  wire signed [23:0] layer_1_depth,
    input  wire [7:0] layer_0_red,
    input  wire [7:0] layer_1_red,
    input  wire [7:0] layer_0_green,
    input  wire [7:0] layer_1_green,
    input  wire [7:0] layer_0_blue,
    input  wire [7:0] layer_1_blue,
    input  wire [7:0] layer_0_weight,
    input  wire [7:0] layer_1_weight,
    output wire signed [23:0] depth,
    output wire [7:0] red,
    output wire [7:0] green,
    output wire [7:0] blue
);

    wire signed [23:0] stages_0_depth;
    wire [7:0] stages_0_red;
    wire [7:0] stages_0_green;
    wire [7:0] stages_0_blue;
    wire signed [23:0] stages_1_depth;
    wire [7:0] stages_1_red;
    wire [7:0] stages_1_green;
    wire [7:0] stages_1_blue;

    transparency_stage stages_0 (
        .clock(clock),
        .pixel_depth(pixel_depth),
        .pixel_red(pixel_red),
        .pixel_green(pixel_green),
        .pixel_blue(pixel_blue),
        .layer_depth(layer_0_depth),
        .layer_red(layer_0_red),
        .layer_green(layer_0_green),
        .layer_blue(layer_0_blue),
        .layer_weight(layer_0_weight),
        .depth(stages_0_depth),
        .red(stages_0_red),
        .green(stages_0_green),
        .blue(stages_0_blue)
    );

    transparency_stage stages_1 (
        .clock(clock),
        .pixel_depth(stages_0_depth),
        .pixel_red(stages_0_red),
        .pixel_green(stages_0_green),
        .pixel_blue(stages_0_blue),
        .layer_depth(layer_1_depth),
        .layer_red(layer_1_red),
        .layer_green(layer_1_green),
        .layer_blue(layer_1_blue),
        .layer_weight(layer_1_weight),
        .depth(stages_1_depth),
        .red(stages_1_red),
        .green(stages_1_green),
        .blue(stages_1_blue)
    );

    assign depth = stages_1_depth;
    assign red = stages_1_red;
    assign green = stages_1_green;
    assign blue = stages_1_blue;

endmodule
