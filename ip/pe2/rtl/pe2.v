// pe2: value(x, y) = a x^2 + b y^2 + c xy + d x + e y + f by additions alone, one pixel per clock
//
// parameters: format 24
// latency:    1 clock
// error:      exact modulo the width of the value; whoever makes the coefficients proves that the true value fits
// source:     Nyiri 1994, 2.3.2 and B.2.1
// ports:
//   in  clock           1 unsigned
//   in  valid           1 unsigned
//   in  start           1 unsigned
//   in  line            1 unsigned
//   in  a2             48 two's complement
//   in  b2             48 two's complement
//   in  c              48 two's complement
//   in  i0             48 two's complement
//   in  p0             48 two's complement
//   in  f              48 two's complement
//   out value          48 two's complement
//
// Made by: imogene emit pe2 --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module pe2 (
    input  wire clock, valid, start, line,
    input  wire signed [47:0] a2, b2, c, i0, p0, f,
    output wire signed [47:0] value
);

    wire first;
    reg signed [47:0] next_line = 48'sd0, next_line_step = 48'sd0, next_first_step = 48'sd0, pixel_step = 48'sd0,
        pixel_value = 48'sd0;
    wire signed [47:0] line_begin, line_step, first_step, next_pixel, next_step;

    assign first = start | line;
    assign line_begin = start ? f : next_line;
    assign line_step = start ? i0 : next_line_step;
    assign first_step = start ? p0 : next_first_step;
    assign next_pixel = pixel_value + pixel_step;
    assign next_step = pixel_step + a2;
    assign value = pixel_value;

    always @(posedge clock) begin
        if (valid) begin
            pixel_step <= first ? first_step : next_step;
            pixel_value <= first ? line_begin : next_pixel;
            if (first) begin
                next_line <= line_begin + line_step;
                next_line_step <= line_step + b2;
                next_first_step <= first_step + c;
            end
        end
    end
endmodule
