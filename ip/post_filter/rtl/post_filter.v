// post_filter: a picture smoothed by a 2 x 2 box or a 3 x 3 binomial
//
// parameters: format 24
// latency:    3 clocks
// error:      exact
// source:     Chaillou 1991, IV.4.3
// ports:
//   in  clock           1 unsigned
//   in  kernel          2 unsigned
//   in  valid           1 unsigned
//   in  x              12 unsigned
//   in  y              12 unsigned
//   in  line_end        1 unsigned
//   in  last            1 unsigned
//   in  r               8 unsigned
//   in  g               8 unsigned
//   in  b               8 unsigned
//   out out_valid       1 unsigned
//   out out_x          12 unsigned
//   out out_y          12 unsigned
//   out out_line_end    1 unsigned
//   out out_last        1 unsigned
//   out out_r           8 unsigned
//   out out_g           8 unsigned
//   out out_b           8 unsigned
//
// Made by: imogene emit post_filter --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module post_filter (
    input  wire clock,
    input  wire [1:0] kernel,
    input  wire valid,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire line_end,
    input  wire last,
    input  wire [7:0] r,
    input  wire [7:0] g,
    input  wire [7:0] b,
    output wire out_valid,
    output wire [11:0] out_x,
    output wire [11:0] out_y,
    output wire out_line_end,
    output wire out_last,
    output wire [7:0] out_r,
    output wire [7:0] out_g,
    output wire [7:0] out_b
);

    localparam [11:0] zero = 12'd0;
    localparam [11:0] one = 12'd1;
    localparam [11:0] half = 12'd8;
    localparam [5:0] line_place = 6'd24;
    wire at_origin;
    wire [1:0] now_kernel;
    wire flush_ends;
    wire [11:0] now_x;
    wire [11:0] now_y;
    wire now_ends;
    wire [23:0] wide_r;
    wire [23:0] wide_g;
    wire [23:0] wide_b;
    wire [23:0] high_r;
    wire [23:0] high_g;
    wire [23:0] one_up;
    wire [23:0] two_up;
    wire [47:0] wide_new;
    wire [47:0] wide_old;
    wire [47:0] high_old;
    wire [23:0] above;
    wire [23:0] below;
    wire [7:0] above_0_part;
    wire [7:0] above_1_part;
    wire [7:0] above_2_part;
    wire [7:0] here_0_part;
    wire [7:0] here_1_part;
    wire [7:0] here_2_part;
    wire [7:0] below_0_part;
    wire [7:0] below_1_part;
    wire [7:0] below_2_part;
    wire is_left;
    wire leaves;
    wire [11:0] rounded_0;
    wire [11:0] rounded_1;
    wire [11:0] rounded_2;
    wire store_write;
    wire [10:0] store_write_address;
    wire [47:0] store_write_data;
    wire [10:0] store_read_address;
    wire [47:0] store_read_data;
    wire [9:0] vertical_0_sum;
    wire [9:0] vertical_1_sum;
    wire [9:0] vertical_2_sum;
    wire [9:0] horizontal_0_earlier;
    wire [9:0] horizontal_0_later;
    wire [11:0] horizontal_0_sum;
    wire [9:0] horizontal_1_earlier;
    wire [9:0] horizontal_1_later;
    wire [11:0] horizontal_1_sum;
    wire [9:0] horizontal_2_earlier;
    wire [9:0] horizontal_2_later;
    wire [11:0] horizontal_2_sum;
    reg [1:0] kept_kernel = 2'd0;
    reg waits = 1'd0;
    reg flushes = 1'd0;
    reg [11:0] flush_x = 12'd0;
    reg [11:0] flush_y = 12'd0;
    reg [11:0] right = 12'd0;
    reg step_1 = 1'd0;
    reg flush_1 = 1'd0;
    reg ends_1 = 1'd0;
    reg [11:0] x_1 = 12'd0;
    reg [11:0] y_1 = 12'd0;
    reg [1:0] kernel_1 = 2'd0;
    reg [23:0] colour_1 = 24'd0;
    reg step_2 = 1'd0;
    reg ends_2 = 1'd0;
    reg last_2 = 1'd0;
    reg [11:0] x_2 = 12'd0;
    reg [11:0] y_2 = 12'd0;
    reg [1:0] kernel_2 = 2'd0;
    reg [9:0] column_2_0 = 10'd0;
    reg [9:0] column_2_1 = 10'd0;
    reg [9:0] column_2_2 = 10'd0;
    reg ends_3 = 1'd0;
    reg last_3 = 1'd0;
    reg left_3 = 1'd0;
    reg [11:0] x_3 = 12'd0;
    reg [11:0] y_3 = 12'd0;
    reg [1:0] kernel_3 = 2'd0;
    reg [9:0] column_3_0 = 10'd0;
    reg [9:0] column_3_1 = 10'd0;
    reg [9:0] column_3_2 = 10'd0;
    reg [9:0] before_3_0 = 10'd0;
    reg [9:0] before_3_1 = 10'd0;
    reg [9:0] before_3_2 = 10'd0;
    reg valid_4 = 1'd0;
    reg ends_4 = 1'd0;
    reg last_4 = 1'd0;
    reg [11:0] x_4 = 12'd0;
    reg [11:0] y_4 = 12'd0;
    reg [7:0] colour_4_0 = 8'd0;
    reg [7:0] colour_4_1 = 8'd0;
    reg [7:0] colour_4_2 = 8'd0;

    block_memory store (
        .clock(clock),
        .write(store_write),
        .write_address(store_write_address),
        .write_data(store_write_data),
        .read_address(store_read_address),
        .read_data(store_read_data)
    );

    three_taps_w10 vertical_0 (
        .earlier(above_0_part),
        .here(here_0_part),
        .later(below_0_part),
        .kernel(kernel_1),
        .sum(vertical_0_sum)
    );

    three_taps_w10 vertical_1 (
        .earlier(above_1_part),
        .here(here_1_part),
        .later(below_1_part),
        .kernel(kernel_1),
        .sum(vertical_1_sum)
    );

    three_taps_w10 vertical_2 (
        .earlier(above_2_part),
        .here(here_2_part),
        .later(below_2_part),
        .kernel(kernel_1),
        .sum(vertical_2_sum)
    );

    three_taps_w12 horizontal_0 (
        .earlier(horizontal_0_earlier),
        .here(column_3_0),
        .later(horizontal_0_later),
        .kernel(kernel_3),
        .sum(horizontal_0_sum)
    );

    three_taps_w12 horizontal_1 (
        .earlier(horizontal_1_earlier),
        .here(column_3_1),
        .later(horizontal_1_later),
        .kernel(kernel_3),
        .sum(horizontal_1_sum)
    );

    three_taps_w12 horizontal_2 (
        .earlier(horizontal_2_earlier),
        .here(column_3_2),
        .later(horizontal_2_later),
        .kernel(kernel_3),
        .sum(horizontal_2_sum)
    );

    assign at_origin = (x == zero) & (y == zero);
    assign now_kernel = (valid & at_origin) ? kernel : kept_kernel;
    assign flush_ends = flush_x == right;
    assign now_x = flushes ? flush_x : x;
    assign now_y = flushes ? flush_y : y;
    assign now_ends = flushes ? flush_ends : line_end;
    assign wide_r = {16'd0, r};
    assign wide_g = {16'd0, g};
    assign wide_b = {16'd0, b};
    assign high_r = wide_r << 5'd16;
    assign high_g = wide_g << 5'd8;
    assign one_up = store_read_data[23:0];
    assign two_up = store_read_data[47:24];
    assign wide_new = {24'd0, colour_1};
    assign wide_old = {24'd0, one_up};
    assign high_old = wide_old << line_place;
    assign above = (y_1 == one) ? one_up : two_up;
    assign below = flush_1 ? one_up : colour_1;
    assign above_0_part = above[23:16];
    assign above_1_part = above[15:8];
    assign above_2_part = above[7:0];
    assign here_0_part = one_up[23:16];
    assign here_1_part = one_up[15:8];
    assign here_2_part = one_up[7:0];
    assign below_0_part = below[23:16];
    assign below_1_part = below[15:8];
    assign below_2_part = below[7:0];
    assign is_left = x_2 == zero;
    assign leaves = ends_3 | (step_2 & ~is_left);
    assign rounded_0 = horizontal_0_sum + half;
    assign rounded_1 = horizontal_1_sum + half;
    assign rounded_2 = horizontal_2_sum + half;
    assign store_write = step_1 & ~flush_1;
    assign store_write_address = x_1[10:0];
    assign store_write_data = high_old | wide_new;
    assign store_read_address = now_x[10:0];
    assign horizontal_0_earlier = left_3 ? column_3_0 : before_3_0;
    assign horizontal_0_later = ends_3 ? column_3_0 : column_2_0;
    assign horizontal_1_earlier = left_3 ? column_3_1 : before_3_1;
    assign horizontal_1_later = ends_3 ? column_3_1 : column_2_1;
    assign horizontal_2_earlier = left_3 ? column_3_2 : before_3_2;
    assign horizontal_2_later = ends_3 ? column_3_2 : column_2_2;
    assign out_valid = valid_4;
    assign out_x = x_4;
    assign out_y = y_4;
    assign out_line_end = ends_4;
    assign out_last = last_4;
    assign out_r = colour_4_0;
    assign out_g = colour_4_1;
    assign out_b = colour_4_2;

    wire unused_bits = &{1'b0, rounded_0[3:0], rounded_1[3:0], rounded_2[3:0]};

    always @(posedge clock) begin
        kept_kernel <= now_kernel;
        waits <= valid & last;
        if (valid & last) begin
            right <= x;
            flush_y <= y + one;
        end
        if (waits) begin
            flushes <= 1'd1;
            flush_x <= zero;
        end else if (flushes) begin
            flushes <= ~flush_ends;
            flush_x <= flush_x + one;
        end
        step_1 <= valid | flushes;
        flush_1 <= flushes;
        ends_1 <= now_ends;
        x_1 <= now_x;
        y_1 <= now_y;
        kernel_1 <= now_kernel;
        colour_1 <= (high_r | high_g) | wide_b;
        step_2 <= step_1 & (y_1 != zero);
        ends_2 <= ends_1;
        last_2 <= flush_1;
        x_2 <= x_1;
        y_2 <= y_1 - one;
        kernel_2 <= kernel_1;
        ends_3 <= step_2 & ends_2;
        if (step_2) begin
            last_3 <= last_2;
            left_3 <= is_left;
            x_3 <= x_2;
            y_3 <= y_2;
            kernel_3 <= kernel_2;
        end
        valid_4 <= leaves;
        ends_4 <= ends_3;
        last_4 <= ends_3 & last_3;
        x_4 <= x_3;
        y_4 <= y_3;
        column_2_0 <= vertical_0_sum;
        if (step_2) begin
            column_3_0 <= column_2_0;
            before_3_0 <= column_3_0;
        end
        colour_4_0 <= rounded_0[11:4];
        column_2_1 <= vertical_1_sum;
        if (step_2) begin
            column_3_1 <= column_2_1;
            before_3_1 <= column_3_1;
        end
        colour_4_1 <= rounded_1[11:4];
        column_2_2 <= vertical_2_sum;
        if (step_2) begin
            column_3_2 <= column_2_2;
            before_3_2 <= column_3_2;
        end
        colour_4_2 <= rounded_2[11:4];
    end

endmodule
