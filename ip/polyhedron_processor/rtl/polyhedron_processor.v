// polyhedron_processor: front and back depth, faces and normals of a convex solid of planes
//
// parameters: format 24
//             planes 6
// latency:    7 clocks
// error:      exact in its integer words; against real numbers: the rounding of the words, each once
// source:     Nyiri 1994, annex A; Chaillou 1991, IV.2.3
// ports:
//   in  clock           1 unsigned
//   in  valid           1 unsigned
//   in  start           1 unsigned
//   in  line            1 unsigned
//   in  x              12 unsigned
//   in  y              12 unsigned
//   in  box_x0         12 unsigned
//   in  box_x1         12 unsigned
//   in  box_y0         12 unsigned
//   in  box_y1         12 unsigned
//   in  plane_0_kind    2 unsigned
//   in  plane_1_kind    2 unsigned
//   in  plane_2_kind    2 unsigned
//   in  plane_3_kind    2 unsigned
//   in  plane_4_kind    2 unsigned
//   in  plane_5_kind    2 unsigned
//   in  plane_0_a      36 two's complement
//   in  plane_1_a      36 two's complement
//   in  plane_2_a      36 two's complement
//   in  plane_3_a      36 two's complement
//   in  plane_4_a      36 two's complement
//   in  plane_5_a      36 two's complement
//   in  plane_0_b      36 two's complement
//   in  plane_1_b      36 two's complement
//   in  plane_2_b      36 two's complement
//   in  plane_3_b      36 two's complement
//   in  plane_4_b      36 two's complement
//   in  plane_5_b      36 two's complement
//   in  plane_0_c      36 two's complement
//   in  plane_1_c      36 two's complement
//   in  plane_2_c      36 two's complement
//   in  plane_3_c      36 two's complement
//   in  plane_4_c      36 two's complement
//   in  plane_5_c      36 two's complement
//   in  plane_0_nx     16 two's complement
//   in  plane_1_nx     16 two's complement
//   in  plane_2_nx     16 two's complement
//   in  plane_3_nx     16 two's complement
//   in  plane_4_nx     16 two's complement
//   in  plane_5_nx     16 two's complement
//   in  plane_0_ny     16 two's complement
//   in  plane_1_ny     16 two's complement
//   in  plane_2_ny     16 two's complement
//   in  plane_3_ny     16 two's complement
//   in  plane_4_ny     16 two's complement
//   in  plane_5_ny     16 two's complement
//   in  plane_0_nz     16 two's complement
//   in  plane_1_nz     16 two's complement
//   in  plane_2_nz     16 two's complement
//   in  plane_3_nz     16 two's complement
//   in  plane_4_nz     16 two's complement
//   in  plane_5_nz     16 two's complement
//   out out_valid       1 unsigned
//   out zf             24 two's complement
//   out zb             24 two's complement
//   out number          4 unsigned
//   out nx             16 two's complement
//   out ny             16 two's complement
//   out nz             16 two's complement
//   out back_number     4 unsigned
//   out back_nx        16 two's complement
//   out back_ny        16 two's complement
//   out back_nz        16 two's complement
//
// Made by: imogene emit polyhedron_processor --format 24 --planes 6 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module polyhedron_processor (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire [11:0] box_x0,
    input  wire [11:0] box_x1,
    input  wire [11:0] box_y0,
    input  wire [11:0] box_y1,
    input  wire [1:0] plane_0_kind,
    input  wire [1:0] plane_1_kind,
    input  wire [1:0] plane_2_kind,
    input  wire [1:0] plane_3_kind,
    input  wire [1:0] plane_4_kind,
    input  wire [1:0] plane_5_kind,
    input  wire signed [35:0] plane_0_a,
    input  wire signed [35:0] plane_1_a,
    input  wire signed [35:0] plane_2_a,
    input  wire signed [35:0] plane_3_a,
    input  wire signed [35:0] plane_4_a,
    input  wire signed [35:0] plane_5_a,
    input  wire signed [35:0] plane_0_b,
    input  wire signed [35:0] plane_1_b,
    input  wire signed [35:0] plane_2_b,
    input  wire signed [35:0] plane_3_b,
    input  wire signed [35:0] plane_4_b,
    input  wire signed [35:0] plane_5_b,
    input  wire signed [35:0] plane_0_c,
    input  wire signed [35:0] plane_1_c,
    input  wire signed [35:0] plane_2_c,
    input  wire signed [35:0] plane_3_c,
    input  wire signed [35:0] plane_4_c,
    input  wire signed [35:0] plane_5_c,
    input  wire signed [15:0] plane_0_nx,
    input  wire signed [15:0] plane_1_nx,
    input  wire signed [15:0] plane_2_nx,
    input  wire signed [15:0] plane_3_nx,
    input  wire signed [15:0] plane_4_nx,
    input  wire signed [15:0] plane_5_nx,
    input  wire signed [15:0] plane_0_ny,
    input  wire signed [15:0] plane_1_ny,
    input  wire signed [15:0] plane_2_ny,
    input  wire signed [15:0] plane_3_ny,
    input  wire signed [15:0] plane_4_ny,
    input  wire signed [15:0] plane_5_ny,
    input  wire signed [15:0] plane_0_nz,
    input  wire signed [15:0] plane_1_nz,
    input  wire signed [15:0] plane_2_nz,
    input  wire signed [15:0] plane_3_nz,
    input  wire signed [15:0] plane_4_nz,
    input  wire signed [15:0] plane_5_nz,
    output wire out_valid,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz,
    output wire [3:0] back_number,
    output wire signed [15:0] back_nx,
    output wire signed [15:0] back_ny,
    output wire signed [15:0] back_nz
);

    localparam signed [15:0] near_end_nz = -16'sd32767;
    localparam signed [15:0] far_end_nz = 16'sd32767;
    wire screen_box_in_box;
    wire in_box_late;
    wire signed [23:0] planes_0_depth;
    wire signed [23:0] planes_1_depth;
    wire signed [23:0] planes_2_depth;
    wire signed [23:0] planes_3_depth;
    wire signed [23:0] planes_4_depth;
    wire signed [23:0] planes_5_depth;
    wire signed [23:0] half_spaces_zf;
    wire [3:0] half_spaces_nf;
    wire signed [23:0] half_spaces_zb;
    wire [3:0] half_spaces_nb;
    wire signed [15:0] front_normal_nx;
    wire signed [15:0] front_normal_ny;
    wire signed [15:0] front_normal_nz;
    wire signed [15:0] back_normal_nx;
    wire signed [15:0] back_normal_ny;
    wire signed [15:0] back_normal_nz;
    wire valid_delay_late;
    wire signed [23:0] zf_delay_late;
    wire signed [23:0] zb_delay_late;
    wire [3:0] number_delay_late;
    wire [3:0] back_number_delay_late;

    screen_box screen_box (
        .x(x),
        .y(y),
        .box_x0(box_x0),
        .box_x1(box_x1),
        .box_y0(box_y0),
        .box_y1(box_y1),
        .in_box(screen_box_in_box)
    );

    word_delay_w1_x5 in_box (
        .clock(clock),
        .word(screen_box_in_box),
        .late(in_box_late)
    );

    plane_depth planes_0 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(plane_0_a),
        .b(plane_0_b),
        .c(plane_0_c),
        .depth(planes_0_depth)
    );

    plane_depth planes_1 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(plane_1_a),
        .b(plane_1_b),
        .c(plane_1_c),
        .depth(planes_1_depth)
    );

    plane_depth planes_2 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(plane_2_a),
        .b(plane_2_b),
        .c(plane_2_c),
        .depth(planes_2_depth)
    );

    plane_depth planes_3 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(plane_3_a),
        .b(plane_3_b),
        .c(plane_3_c),
        .depth(planes_3_depth)
    );

    plane_depth planes_4 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(plane_4_a),
        .b(plane_4_b),
        .c(plane_4_c),
        .depth(planes_4_depth)
    );

    plane_depth planes_5 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(plane_5_a),
        .b(plane_5_b),
        .c(plane_5_c),
        .depth(planes_5_depth)
    );

    half_spaces half_spaces (
        .clock(clock),
        .plane_0_kind(plane_0_kind),
        .plane_1_kind(plane_1_kind),
        .plane_2_kind(plane_2_kind),
        .plane_3_kind(plane_3_kind),
        .plane_4_kind(plane_4_kind),
        .plane_5_kind(plane_5_kind),
        .plane_0_zp(planes_0_depth),
        .plane_1_zp(planes_1_depth),
        .plane_2_zp(planes_2_depth),
        .plane_3_zp(planes_3_depth),
        .plane_4_zp(planes_4_depth),
        .plane_5_zp(planes_5_depth),
        .is_there(in_box_late),
        .zf(half_spaces_zf),
        .nf(half_spaces_nf),
        .zb(half_spaces_zb),
        .nb(half_spaces_nb)
    );

    plane_normal front_normal (
        .clock(clock),
        .number(half_spaces_nf),
        .end_nz(near_end_nz),
        .plane_0_nx(plane_0_nx),
        .plane_1_nx(plane_1_nx),
        .plane_2_nx(plane_2_nx),
        .plane_3_nx(plane_3_nx),
        .plane_4_nx(plane_4_nx),
        .plane_5_nx(plane_5_nx),
        .plane_0_ny(plane_0_ny),
        .plane_1_ny(plane_1_ny),
        .plane_2_ny(plane_2_ny),
        .plane_3_ny(plane_3_ny),
        .plane_4_ny(plane_4_ny),
        .plane_5_ny(plane_5_ny),
        .plane_0_nz(plane_0_nz),
        .plane_1_nz(plane_1_nz),
        .plane_2_nz(plane_2_nz),
        .plane_3_nz(plane_3_nz),
        .plane_4_nz(plane_4_nz),
        .plane_5_nz(plane_5_nz),
        .nx(front_normal_nx),
        .ny(front_normal_ny),
        .nz(front_normal_nz)
    );

    plane_normal back_normal (
        .clock(clock),
        .number(half_spaces_nb),
        .end_nz(far_end_nz),
        .plane_0_nx(plane_0_nx),
        .plane_1_nx(plane_1_nx),
        .plane_2_nx(plane_2_nx),
        .plane_3_nx(plane_3_nx),
        .plane_4_nx(plane_4_nx),
        .plane_5_nx(plane_5_nx),
        .plane_0_ny(plane_0_ny),
        .plane_1_ny(plane_1_ny),
        .plane_2_ny(plane_2_ny),
        .plane_3_ny(plane_3_ny),
        .plane_4_ny(plane_4_ny),
        .plane_5_ny(plane_5_ny),
        .plane_0_nz(plane_0_nz),
        .plane_1_nz(plane_1_nz),
        .plane_2_nz(plane_2_nz),
        .plane_3_nz(plane_3_nz),
        .plane_4_nz(plane_4_nz),
        .plane_5_nz(plane_5_nz),
        .nx(back_normal_nx),
        .ny(back_normal_ny),
        .nz(back_normal_nz)
    );

    word_delay_w1_x7 valid_delay (
        .clock(clock),
        .word(valid),
        .late(valid_delay_late)
    );

    word_delay_w24s_x1 zf_delay (
        .clock(clock),
        .word(half_spaces_zf),
        .late(zf_delay_late)
    );

    word_delay_w24s_x1 zb_delay (
        .clock(clock),
        .word(half_spaces_zb),
        .late(zb_delay_late)
    );

    word_delay_w4_x1 number_delay (
        .clock(clock),
        .word(half_spaces_nf),
        .late(number_delay_late)
    );

    word_delay_w4_x1 back_number_delay (
        .clock(clock),
        .word(half_spaces_nb),
        .late(back_number_delay_late)
    );

    assign out_valid = valid_delay_late;
    assign zf = zf_delay_late;
    assign zb = zb_delay_late;
    assign number = number_delay_late;
    assign nx = front_normal_nx;
    assign ny = front_normal_ny;
    assign nz = front_normal_nz;
    assign back_number = back_number_delay_late;
    assign back_nx = back_normal_nx;
    assign back_ny = back_normal_ny;
    assign back_nz = back_normal_nz;

endmodule
