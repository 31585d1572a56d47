// pe2: part of patch_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module pe2 (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire signed [47:0] a2,
    input  wire signed [47:0] b2,
    input  wire signed [47:0] c,
    input  wire signed [47:0] p0,
    input  wire signed [47:0] i0,
    input  wire signed [47:0] f,
    output wire signed [47:0] value
);

    wire first;
    wire signed [47:0] next_pixel;
    wire signed [47:0] next_pixel_step;
    wire signed [47:0] next_line;
    wire signed [47:0] next_line_step;
    wire signed [47:0] next_first_step;
    wire signed [47:0] line_begin;
    wire signed [47:0] line_begin_step;
    wire signed [47:0] first_begin_step;
    reg signed [47:0] kept_a2 = 48'sd0;
    reg signed [47:0] kept_b2 = 48'sd0;
    reg signed [47:0] kept_c = 48'sd0;
    reg signed [47:0] line_value = 48'sd0;
    reg signed [47:0] line_step = 48'sd0;
    reg signed [47:0] first_step = 48'sd0;
    reg signed [47:0] pixel_step = 48'sd0;
    reg signed [47:0] pixel_value = 48'sd0;

    assign first = start | line;
    assign next_pixel = pixel_value + pixel_step;
    assign next_pixel_step = pixel_step + kept_a2;
    assign next_line = line_value + line_step;
    assign next_line_step = line_step + kept_b2;
    assign next_first_step = first_step + kept_c;
    assign line_begin = start ? f : next_line;
    assign line_begin_step = start ? i0 : next_line_step;
    assign first_begin_step = start ? p0 : next_first_step;
    assign value = pixel_value;

    always @(posedge clock) begin
        if (valid) begin
            if (start) begin
                kept_a2 <= a2;
                kept_b2 <= b2;
                kept_c <= c;
            end
            if (first) begin
                line_value <= line_begin;
                pixel_value <= line_begin;
                line_step <= line_begin_step;
                first_step <= first_begin_step;
                pixel_step <= first_begin_step;
            end else begin
                pixel_value <= next_pixel;
                pixel_step <= next_pixel_step;
            end
        end
    end

endmodule
