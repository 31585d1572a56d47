// pe2: part of quadric_processor; see there.
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
