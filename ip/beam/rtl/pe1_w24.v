// pe1_w24: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module pe1_w24 (
    input  wire clock, valid, start, line,
    input  wire signed [23:0] a, b, c,
    output wire signed [23:0] value
);

    wire first;
    reg signed [23:0] next_line = 24'sd0, pixel_value = 24'sd0;
    wire signed [23:0] line_begin, next_pixel;

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
