// programmable_pe: value(x, y) of second degree, or four of first degree with the decision on their signs, by additions alone
//
// parameters: format 24
// latency:    1 clock
// error:      exact modulo the width of the value; whoever makes the coefficients proves that the true value fits
// source:     Chaillou 1991, IV.1.7
// ports:
//   in  clock           1 unsigned
//   in  valid           1 unsigned
//   in  start           1 unsigned
//   in  line            1 unsigned
//   in  split           1 unsigned
//   in  used            4 unsigned
//   in  a2             48 two's complement
//   in  b2             48 two's complement
//   in  c              48 two's complement
//   in  i0             48 two's complement
//   in  p0             48 two's complement
//   in  f              48 two's complement
//   out value          48 two's complement
//   out lane_0         24 two's complement
//   out lane_1         24 two's complement
//   out lane_2         24 two's complement
//   out lane_3         24 two's complement
//   out is_inside       1 unsigned
//
// Made by: imogene emit programmable_pe --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module programmable_pe (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire split,
    input  wire [3:0] used,
    input  wire signed [47:0] a2,
    input  wire signed [47:0] b2,
    input  wire signed [47:0] c,
    input  wire signed [47:0] i0,
    input  wire signed [47:0] p0,
    input  wire signed [47:0] f,
    output wire signed [47:0] value,
    output wire signed [23:0] lane_0,
    output wire signed [23:0] lane_1,
    output wire signed [23:0] lane_2,
    output wire signed [23:0] lane_3,
    output wire is_inside
);

    wire first;
    wire [47:0] value_step;
    wire [47:0] line_begin;
    wire [47:0] line_begin_step;
    wire [47:0] first_begin_step;
    wire lane_0_out;
    wire lane_1_out;
    wire lane_2_out;
    wire lane_3_out;
    wire value_out;
    wire [47:0] next_pixel_sum;
    wire [47:0] next_pixel_step_sum;
    wire [47:0] next_line_sum;
    wire [47:0] next_line_step_sum;
    wire [47:0] next_first_step_sum;
    reg [47:0] kept_a2 = 48'd0;
    reg [47:0] kept_b2 = 48'd0;
    reg [47:0] kept_c = 48'd0;
    reg [47:0] line_value = 48'd0;
    reg [47:0] line_step = 48'd0;
    reg [47:0] first_step = 48'd0;
    reg [47:0] pixel_step = 48'd0;
    reg [47:0] pixel_value = 48'd0;
    reg kept_split = 1'd0;
    reg [3:0] kept_used = 4'd0;
    reg kept_inside = 1'd0;

    split_adder next_pixel (
        .a(pixel_value),
        .b(value_step),
        .split(kept_split),
        .sum(next_pixel_sum)
    );

    split_adder next_pixel_step (
        .a(pixel_step),
        .b(kept_a2),
        .split(kept_split),
        .sum(next_pixel_step_sum)
    );

    split_adder next_line (
        .a(line_value),
        .b(line_step),
        .split(kept_split),
        .sum(next_line_sum)
    );

    split_adder next_line_step (
        .a(line_step),
        .b(kept_b2),
        .split(kept_split),
        .sum(next_line_step_sum)
    );

    split_adder next_first_step (
        .a(first_step),
        .b(kept_c),
        .split(kept_split),
        .sum(next_first_step_sum)
    );

    assign first = start | line;
    assign value_step = kept_split ? kept_b2 : pixel_step;
    assign line_begin = start ? f : next_line_sum;
    assign line_begin_step = start ? i0 :
        kept_split ? line_step : next_line_step_sum;
    assign first_begin_step = start ? p0 : next_first_step_sum;
    assign lane_0_out = pixel_value[23] & kept_used[0];
    assign lane_1_out = pixel_value[47] & kept_used[1];
    assign lane_2_out = pixel_step[23] & kept_used[2];
    assign lane_3_out = pixel_step[47] & kept_used[3];
    assign value_out = pixel_value[47];
    assign value = pixel_value;
    assign lane_0 = pixel_value[23:0];
    assign lane_1 = pixel_value[47:24];
    assign lane_2 = pixel_step[23:0];
    assign lane_3 = pixel_step[47:24];
    assign is_inside = kept_inside;

    always @(posedge clock) begin
        if (valid) begin
            if (start) begin
                kept_a2 <= a2;
                kept_b2 <= b2;
                kept_c <= c;
                kept_split <= split;
                kept_used <= used;
            end
            if (first) begin
                line_value <= line_begin;
                pixel_value <= line_begin;
                line_step <= line_begin_step;
                first_step <= first_begin_step;
                pixel_step <= first_begin_step;
            end else begin
                pixel_value <= next_pixel_sum;
                pixel_step <= next_pixel_step_sum;
            end
        end
        if (kept_split) begin
            kept_inside <= ~(((lane_0_out | lane_1_out) | lane_2_out) | lane_3_out);
        end else begin
            kept_inside <= ~value_out;
        end
    end

endmodule
