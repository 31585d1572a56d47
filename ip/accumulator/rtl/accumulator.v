// accumulator: the mean of 4 or 16 passes over a picture
//
// parameters: format 24
// latency:    3 clocks
// error:      exact
// source:     Chaillou 1991, III.1.5 and IV.4.7.2
// ports:
//   in  clock           1 unsigned
//   in  fine            1 unsigned
//   in  valid           1 unsigned
//   in  address        12 unsigned
//   in  first_pass      1 unsigned
//   in  last_pass       1 unsigned
//   in  r               8 unsigned
//   in  g               8 unsigned
//   in  b               8 unsigned
//   out out_valid       1 unsigned
//   out out_address    12 unsigned
//   out out_r           8 unsigned
//   out out_g           8 unsigned
//   out out_b           8 unsigned
//
// Made by: imogene emit accumulator --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module accumulator (
    input  wire clock,
    input  wire fine,
    input  wire valid,
    input  wire [11:0] address,
    input  wire first_pass,
    input  wire last_pass,
    input  wire [7:0] r,
    input  wire [7:0] g,
    input  wire [7:0] b,
    output wire out_valid,
    output wire [11:0] out_address,
    output wire [7:0] out_r,
    output wire [7:0] out_g,
    output wire [7:0] out_b
);

    localparam [5:0] green_place = 6'd12;
    localparam [5:0] red_place = 6'd24;
    wire [35:0] wide_red;
    wire [35:0] wide_green;
    wire [35:0] wide_blue;
    wire [35:0] high_red;
    wire [35:0] high_green;
    wire [35:0] store_write_data;
    wire [35:0] store_read_data;
    wire [11:0] red_earlier;
    wire [11:0] red_sum;
    wire [7:0] red_mean;
    wire [11:0] green_earlier;
    wire [11:0] green_sum;
    wire [7:0] green_mean;
    wire [11:0] blue_earlier;
    wire [11:0] blue_sum;
    wire [7:0] blue_mean;
    reg kept_fine = 1'd0;
    reg kept_valid = 1'd0;
    reg kept_first = 1'd0;
    reg kept_last = 1'd0;
    reg [11:0] kept_address = 12'd0;
    reg [7:0] kept_r = 8'd0;
    reg [7:0] kept_g = 8'd0;
    reg [7:0] kept_b = 8'd0;
    reg [35:0] earlier = 36'd0;
    reg held_fine = 1'd0;
    reg held_valid = 1'd0;
    reg held_first = 1'd0;
    reg held_last = 1'd0;
    reg [11:0] held_address = 12'd0;
    reg [7:0] held_r = 8'd0;
    reg [7:0] held_g = 8'd0;
    reg [7:0] held_b = 8'd0;
    reg [7:0] mean_r = 8'd0;
    reg [7:0] mean_g = 8'd0;
    reg [7:0] mean_b = 8'd0;
    reg late_valid = 1'd0;
    reg [11:0] late_address = 12'd0;

    block_memory store (
        .clock(clock),
        .write(held_valid),
        .write_address(held_address),
        .write_data(store_write_data),
        .read_address(address),
        .read_data(store_read_data)
    );

    pass_sum red (
        .value(held_r),
        .earlier(red_earlier),
        .first(held_first),
        .fine(held_fine),
        .sum(red_sum),
        .mean(red_mean)
    );

    pass_sum green (
        .value(held_g),
        .earlier(green_earlier),
        .first(held_first),
        .fine(held_fine),
        .sum(green_sum),
        .mean(green_mean)
    );

    pass_sum blue (
        .value(held_b),
        .earlier(blue_earlier),
        .first(held_first),
        .fine(held_fine),
        .sum(blue_sum),
        .mean(blue_mean)
    );

    assign wide_red = {24'd0, red_sum};
    assign wide_green = {24'd0, green_sum};
    assign wide_blue = {24'd0, blue_sum};
    assign high_red = wide_red << red_place;
    assign high_green = wide_green << green_place;
    assign store_write_data = (high_red | high_green) | wide_blue;
    assign red_earlier = earlier[35:24];
    assign green_earlier = earlier[23:12];
    assign blue_earlier = earlier[11:0];
    assign out_valid = late_valid;
    assign out_address = late_address;
    assign out_r = mean_r;
    assign out_g = mean_g;
    assign out_b = mean_b;

    always @(posedge clock) begin
        kept_fine <= fine;
        kept_valid <= valid;
        kept_first <= first_pass;
        kept_last <= last_pass;
        kept_address <= address;
        kept_r <= r;
        kept_g <= g;
        kept_b <= b;
        earlier <= store_read_data;
        held_fine <= kept_fine;
        held_valid <= kept_valid;
        held_first <= kept_first;
        held_last <= kept_last;
        held_address <= kept_address;
        held_r <= kept_r;
        held_g <= kept_g;
        held_b <= kept_b;
        mean_r <= red_mean;
        mean_g <= green_mean;
        mean_b <= blue_mean;
        late_valid <= held_valid & held_last;
        late_address <= held_address;
    end

endmodule
