// plane_depth: the depth of a plane, clamped to the depth word
//
// parameters: format 24
// latency:    2 clocks
// error:      exact after clamping; whoever makes the coefficients proves that the plane fits its words
// source:     Nyiri 1994, 2.4.2
// ports:
//   in  clock           1 unsigned
//   in  valid           1 unsigned
//   in  start           1 unsigned
//   in  line            1 unsigned
//   in  a              36 two's complement
//   in  b              36 two's complement
//   in  c              36 two's complement
//   out depth          24 two's complement
//
// Made by: imogene emit plane_depth --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module plane_depth (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire signed [35:0] a,
    input  wire signed [35:0] b,
    input  wire signed [35:0] c,
    output wire signed [23:0] depth
);

    localparam signed [35:0] largest = 36'sd8388607;
    localparam signed [35:0] smallest = -36'sd8388608;
    localparam signed [23:0] farthest = 24'sd8388607;
    localparam signed [23:0] nearest = 24'sh800000;
    wire above;
    wire below;
    wire signed [35:0] plane_value;
    reg signed [23:0] clamped = 24'sd0;

    pe1 plane (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(a),
        .b(b),
        .c(c),
        .value(plane_value)
    );

    assign above = plane_value > largest;
    assign below = plane_value < smallest;
    assign depth = clamped;

    always @(posedge clock) begin
        if (above) begin
            clamped <= farthest;
        end else if (below) begin
            clamped <= nearest;
        end else begin
            clamped <= plane_value[23:0];
        end
    end

endmodule
