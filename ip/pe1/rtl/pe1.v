// pe1: value(x, y) = a x + b y + c by additions alone, one pixel per clock
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
//   in  a              26 two's complement
//   in  b              26 two's complement
//   in  c              26 two's complement
//   out value          26 two's complement
//
// Made by: imogene emit pe1 --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module pe1 (
    input  wire clock, valid, start, line,
    input  wire signed [25:0] a, b, c,
    output wire signed [25:0] value
);

    wire first;
    reg signed [25:0] next_line = 26'sd0, pixel_value = 26'sd0;
    wire signed [25:0] line_begin, next_pixel;

    assign first = start | line;
    assign line_begin = start ? c : next_line;
    assign next_pixel = pixel_value + a;
    assign value = pixel_value;

    always @(posedge clock) begin
        if (valid) begin
            pixel_value <= first ? line_begin : next_pixel;
            if (first) next_line <= line_begin + b;
        end
    end
endmodule
