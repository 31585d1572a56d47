// pe1_w26: part of first_generation_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module pe1_w26 (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire signed [25:0] a,
    input  wire signed [25:0] b,
    input  wire signed [25:0] c,
    output wire signed [25:0] value
);

    wire first;
    wire signed [25:0] next_line;
    wire signed [25:0] line_begin;
    wire signed [25:0] next_pixel;
    reg signed [25:0] kept_a = 26'sd0;
    reg signed [25:0] kept_b = 26'sd0;
    reg signed [25:0] line_value = 26'sd0;
    reg signed [25:0] pixel_value = 26'sd0;

    assign first = start | line;
    assign next_line = line_value + kept_b;
    assign line_begin = start ? c : next_line;
    assign next_pixel = pixel_value + kept_a;
    assign value = pixel_value;

    always @(posedge clock) begin
        if (valid) begin
            if (start) begin
                kept_a <= a;
                kept_b <= b;
            end
            if (first) begin
                line_value <= line_begin;
                pixel_value <= line_begin;
            end else begin
                pixel_value <= next_pixel;
            end
        end
    end

endmodule
