// overlay: a plane of one bit per pixel over a picture
//
// parameters: format 24
// latency:    4 clocks
// error:      exact
// source:     Chaillou 1991, IV.4.7.1
// ports:
//   in  clock           1 unsigned
//   in  write           1 unsigned
//   in  write_address  10 unsigned
//   in  write_data     32 unsigned
//   in  enable          1 unsigned
//   in  colour         24 unsigned
//   in  width          12 unsigned
//   in  valid           1 unsigned
//   in  x              12 unsigned
//   in  y              12 unsigned
//   in  r               8 unsigned
//   in  g               8 unsigned
//   in  b               8 unsigned
//   out out_valid       1 unsigned
//   out out_r           8 unsigned
//   out out_g           8 unsigned
//   out out_b           8 unsigned
//
// Made by: imogene emit overlay --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module overlay (
    input  wire clock,
    input  wire write,
    input  wire [9:0] write_address,
    input  wire [31:0] write_data,
    input  wire enable,
    input  wire [23:0] colour,
    input  wire [11:0] width,
    input  wire valid,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire [7:0] r,
    input  wire [7:0] g,
    input  wire [7:0] b,
    output wire out_valid,
    output wire [7:0] out_r,
    output wire [7:0] out_g,
    output wire [7:0] out_b
);

    wire [31:0] shifted;
    wire covered;
    wire [23:0] read_place_place;
    wire [9:0] plane_read_address;
    wire [31:0] plane_read_data;
    wire late_valid_late;
    wire [7:0] late_r_late;
    wire [7:0] late_g_late;
    wire [7:0] late_b_late;
    reg [4:0] bit_place = 5'd0;
    reg kept_valid = 1'd0;
    reg [7:0] kept_r = 8'd0;
    reg [7:0] kept_g = 8'd0;
    reg [7:0] kept_b = 8'd0;

    pixel_place read_place (
        .clock(clock),
        .x(x),
        .y(y),
        .width(width),
        .place(read_place_place)
    );

    block_memory plane (
        .clock(clock),
        .write(write),
        .write_address(write_address),
        .write_data(write_data),
        .read_address(plane_read_address),
        .read_data(plane_read_data)
    );

    word_delay_w1 late_valid (
        .clock(clock),
        .word(valid),
        .late(late_valid_late)
    );

    word_delay_w8 late_r (
        .clock(clock),
        .word(r),
        .late(late_r_late)
    );

    word_delay_w8 late_g (
        .clock(clock),
        .word(g),
        .late(late_g_late)
    );

    word_delay_w8 late_b (
        .clock(clock),
        .word(b),
        .late(late_b_late)
    );

    assign shifted = plane_read_data >> bit_place;
    assign covered = enable & shifted[0];
    assign plane_read_address = read_place_place[14:5];
    assign out_valid = kept_valid;
    assign out_r = kept_r;
    assign out_g = kept_g;
    assign out_b = kept_b;

    wire unused_bits = &{1'b0, shifted[31:1], read_place_place[23:15]};

    always @(posedge clock) begin
        bit_place <= read_place_place[4:0];
        kept_valid <= late_valid_late;
        kept_r <= late_r_late;
        kept_g <= late_g_late;
        kept_b <= late_b_late;
        if (covered) begin
            kept_r <= colour[23:16];
            kept_g <= colour[15:8];
            kept_b <= colour[7:0];
        end
    end

endmodule
