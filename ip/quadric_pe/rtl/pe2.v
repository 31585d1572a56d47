// pe2: part of quadric_pe; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module pe2 (
    input  wire clock, valid, start, line,
    input  wire signed [47:0] a2, b2, c, i0, p0, f,
    output wire signed [47:0] value
);

    wire first;
    reg signed [47:0] line_value = 48'sd0, line_step = 48'sd0, first_step = 48'sd0, pixel_step = 48'sd0,
        pixel_value = 48'sd0;
    wire signed [47:0] next_pixel, next_step, line_begin, line_begin_step, first_begin_step;

    assign first = start | line;
    assign next_pixel = pixel_value + pixel_step;
    assign next_step = pixel_step + a2;
    assign line_begin = start ? f : (line_value + line_step);
    assign line_begin_step = start ? i0 : (line_step + b2);
    assign first_begin_step = start ? p0 : (first_step + c);
    assign value = pixel_value;

    always @(posedge clock) begin
        if (valid) begin
            pixel_step <= first ? first_begin_step : next_step;
            pixel_value <= first ? line_begin : next_pixel;
            if (first) begin
                line_value <= line_begin;
                line_step <= line_begin_step;
                first_step <= first_begin_step;
            end
        end
    end
endmodule
