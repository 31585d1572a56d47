// first_generation_processor: depth, face and normal of a quadric between two parallel planes, found by contours on the screen
//
// parameters: format 24
//             rows per stage 1
// latency:    30 clocks
// error:      exact in its integer words; against real numbers: the rounding of the words, each once
// source:     Nyiri 1994, 2.4.1
// ports:
//   in  clock           1 unsigned
//   in  valid           1 unsigned
//   in  start           1 unsigned
//   in  line            1 unsigned
//   in  x              12 unsigned
//   in  y              12 unsigned
//   in  f1_a           26 two's complement
//   in  f1_b           26 two's complement
//   in  f1_c           26 two's complement
//   in  f2_a2          48 two's complement
//   in  f2_b2          48 two's complement
//   in  f2_c           48 two's complement
//   in  f2_i0          48 two's complement
//   in  f2_p0          48 two's complement
//   in  f2_f           48 two's complement
//   in  gx_a           24 two's complement
//   in  gx_b           24 two's complement
//   in  gx_c           24 two's complement
//   in  gy_a           24 two's complement
//   in  gy_b           24 two's complement
//   in  gy_c           24 two's complement
//   in  gz_a           24 two's complement
//   in  gz_b           24 two's complement
//   in  gz_c           24 two's complement
//   in  kx             16 two's complement
//   in  ky             16 two's complement
//   in  kz             16 two's complement
//   in  box_x0         12 unsigned
//   in  box_x1         12 unsigned
//   in  box_y0         12 unsigned
//   in  box_y1         12 unsigned
//   in  shift           5 unsigned
//   in  surface         1 unsigned
//   in  depth_0_a      36 two's complement
//   in  depth_1_a      36 two's complement
//   in  depth_0_b      36 two's complement
//   in  depth_1_b      36 two's complement
//   in  depth_0_c      36 two's complement
//   in  depth_1_c      36 two's complement
//   in  conic_0_a2     48 two's complement
//   in  conic_1_a2     48 two's complement
//   in  conic_0_b2     48 two's complement
//   in  conic_1_b2     48 two's complement
//   in  conic_0_c      48 two's complement
//   in  conic_1_c      48 two's complement
//   in  conic_0_i0     48 two's complement
//   in  conic_1_i0     48 two's complement
//   in  conic_0_p0     48 two's complement
//   in  conic_1_p0     48 two's complement
//   in  conic_0_f      48 two's complement
//   in  conic_1_f      48 two's complement
//   in  polar_0_a      36 two's complement
//   in  polar_1_a      36 two's complement
//   in  polar_0_b      36 two's complement
//   in  polar_1_b      36 two's complement
//   in  polar_0_c      36 two's complement
//   in  polar_1_c      36 two's complement
//   in  plane_0_nx     16 two's complement
//   in  plane_1_nx     16 two's complement
//   in  plane_0_ny     16 two's complement
//   in  plane_1_ny     16 two's complement
//   in  plane_0_nz     16 two's complement
//   in  plane_1_nz     16 two's complement
//   out out_valid       1 unsigned
//   out zf             24 two's complement
//   out zb             24 two's complement
//   out number          4 unsigned
//   out nx             16 two's complement
//   out ny             16 two's complement
//   out nz             16 two's complement
//
// Made by: imogene emit first_generation_processor --format 24 --rows-per-stage 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module first_generation_processor (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire signed [25:0] f1_a,
    input  wire signed [25:0] f1_b,
    input  wire signed [25:0] f1_c,
    input  wire signed [47:0] f2_a2,
    input  wire signed [47:0] f2_b2,
    input  wire signed [47:0] f2_c,
    input  wire signed [47:0] f2_i0,
    input  wire signed [47:0] f2_p0,
    input  wire signed [47:0] f2_f,
    input  wire signed [23:0] gx_a,
    input  wire signed [23:0] gx_b,
    input  wire signed [23:0] gx_c,
    input  wire signed [23:0] gy_a,
    input  wire signed [23:0] gy_b,
    input  wire signed [23:0] gy_c,
    input  wire signed [23:0] gz_a,
    input  wire signed [23:0] gz_b,
    input  wire signed [23:0] gz_c,
    input  wire signed [15:0] kx,
    input  wire signed [15:0] ky,
    input  wire signed [15:0] kz,
    input  wire [11:0] box_x0,
    input  wire [11:0] box_x1,
    input  wire [11:0] box_y0,
    input  wire [11:0] box_y1,
    input  wire [4:0] shift,
    input  wire surface,
    input  wire signed [35:0] depth_0_a,
    input  wire signed [35:0] depth_1_a,
    input  wire signed [35:0] depth_0_b,
    input  wire signed [35:0] depth_1_b,
    input  wire signed [35:0] depth_0_c,
    input  wire signed [35:0] depth_1_c,
    input  wire signed [47:0] conic_0_a2,
    input  wire signed [47:0] conic_1_a2,
    input  wire signed [47:0] conic_0_b2,
    input  wire signed [47:0] conic_1_b2,
    input  wire signed [47:0] conic_0_c,
    input  wire signed [47:0] conic_1_c,
    input  wire signed [47:0] conic_0_i0,
    input  wire signed [47:0] conic_1_i0,
    input  wire signed [47:0] conic_0_p0,
    input  wire signed [47:0] conic_1_p0,
    input  wire signed [47:0] conic_0_f,
    input  wire signed [47:0] conic_1_f,
    input  wire signed [35:0] polar_0_a,
    input  wire signed [35:0] polar_1_a,
    input  wire signed [35:0] polar_0_b,
    input  wire signed [35:0] polar_1_b,
    input  wire signed [35:0] polar_0_c,
    input  wire signed [35:0] polar_1_c,
    input  wire signed [15:0] plane_0_nx,
    input  wire signed [15:0] plane_1_nx,
    input  wire signed [15:0] plane_0_ny,
    input  wire signed [15:0] plane_1_ny,
    input  wire signed [15:0] plane_0_nz,
    input  wire signed [15:0] plane_1_nz,
    output wire out_valid,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    localparam signed [23:0] absent = 24'sd8388607;
    wire screen_box_in_box;
    wire in_box_late;
    wire signed [25:0] quadric_near_sum;
    wire signed [25:0] quadric_far_sum;
    wire [23:0] quadric_root;
    wire quadric_is_inside;
    wire quadric_late_valid;
    wire quadric_late_start;
    wire quadric_late_line;
    wire signed [23:0] depths_0_depth;
    wire signed [23:0] depths_1_depth;
    wire signed [47:0] conics_0_value;
    wire signed [47:0] conics_1_value;
    wire signed [35:0] polars_0_value;
    wire signed [35:0] polars_1_value;
    wire choice_is_there;
    wire choice_middle_kept;
    wire signed [23:0] choice_zf;
    wire signed [23:0] choice_zb;
    wire [3:0] choice_number;
    wire normal_flags_late_valid;
    wire normal_flags_late_start;
    wire normal_flags_late_line;
    wire [23:0] root_delay_late;
    wire normal_absent;
    wire signed [15:0] normal_nx;
    wire signed [15:0] normal_ny;
    wire signed [15:0] normal_nz;
    wire valid_delay_late;
    wire signed [23:0] zf_delay_late;
    wire signed [23:0] zb_delay_late;
    wire [3:0] number_delay_late;
    reg front_inside = 1'd0;
    reg back_inside = 1'd0;
    reg front_middle = 1'd0;
    reg back_middle = 1'd0;

    screen_box screen_box (
        .x(x),
        .y(y),
        .box_x0(box_x0),
        .box_x1(box_x1),
        .box_y0(box_y0),
        .box_y1(box_y1),
        .in_box(screen_box_in_box)
    );

    word_delay_w1_x26 in_box (
        .clock(clock),
        .word(screen_box_in_box),
        .late(in_box_late)
    );

    quadric_pe quadric (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .f1_a(f1_a),
        .f1_b(f1_b),
        .f1_c(f1_c),
        .f2_a2(f2_a2),
        .f2_b2(f2_b2),
        .f2_c(f2_c),
        .f2_i0(f2_i0),
        .f2_p0(f2_p0),
        .f2_f(f2_f),
        .near_sum(quadric_near_sum),
        .far_sum(quadric_far_sum),
        .root(quadric_root),
        .is_inside(quadric_is_inside),
        .late_valid(quadric_late_valid),
        .late_start(quadric_late_start),
        .late_line(quadric_late_line)
    );

    plane_depth depths_0 (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .a(depth_0_a),
        .b(depth_0_b),
        .c(depth_0_c),
        .depth(depths_0_depth)
    );

    plane_depth depths_1 (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .a(depth_1_a),
        .b(depth_1_b),
        .c(depth_1_c),
        .depth(depths_1_depth)
    );

    pe2 conics_0 (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .a2(conic_0_a2),
        .b2(conic_0_b2),
        .c(conic_0_c),
        .p0(conic_0_p0),
        .i0(conic_0_i0),
        .f(conic_0_f),
        .value(conics_0_value)
    );

    pe2 conics_1 (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .a2(conic_1_a2),
        .b2(conic_1_b2),
        .c(conic_1_c),
        .p0(conic_1_p0),
        .i0(conic_1_i0),
        .f(conic_1_f),
        .value(conics_1_value)
    );

    pe1_w36 polars_0 (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .a(polar_0_a),
        .b(polar_0_b),
        .c(polar_0_c),
        .value(polars_0_value)
    );

    pe1_w36 polars_1 (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .a(polar_1_a),
        .b(polar_1_b),
        .c(polar_1_c),
        .value(polars_1_value)
    );

    contour_choice choice (
        .clock(clock),
        .surface(surface),
        .near_sum(quadric_near_sum),
        .far_sum(quadric_far_sum),
        .is_there(choice_is_there),
        .front_zp(depths_0_depth),
        .back_zp(depths_1_depth),
        .front_inside(front_inside),
        .back_inside(back_inside),
        .middle_kept(choice_middle_kept),
        .zf(choice_zf),
        .zb(choice_zb),
        .number(choice_number)
    );

    flag_delay_x9 normal_flags (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .late_valid(normal_flags_late_valid),
        .late_start(normal_flags_late_start),
        .late_line(normal_flags_late_line)
    );

    word_delay_w24_x1 root_delay (
        .clock(clock),
        .word(quadric_root),
        .late(root_delay_late)
    );

    normal_unit normal (
        .clock(clock),
        .valid(normal_flags_late_valid),
        .start(normal_flags_late_start),
        .line(normal_flags_late_line),
        .number(choice_number),
        .absent(normal_absent),
        .root(root_delay_late),
        .shift(shift),
        .gx_a(gx_a),
        .gx_b(gx_b),
        .gx_c(gx_c),
        .gy_a(gy_a),
        .gy_b(gy_b),
        .gy_c(gy_c),
        .gz_a(gz_a),
        .gz_b(gz_b),
        .gz_c(gz_c),
        .kx(kx),
        .ky(ky),
        .kz(kz),
        .plane_0_nx(plane_0_nx),
        .plane_1_nx(plane_1_nx),
        .plane_0_ny(plane_0_ny),
        .plane_1_ny(plane_1_ny),
        .plane_0_nz(plane_0_nz),
        .plane_1_nz(plane_1_nz),
        .nx(normal_nx),
        .ny(normal_ny),
        .nz(normal_nz)
    );

    word_delay_w1_x3 valid_delay (
        .clock(clock),
        .word(normal_flags_late_valid),
        .late(valid_delay_late)
    );

    word_delay_w24s_x3 zf_delay (
        .clock(clock),
        .word(choice_zf),
        .late(zf_delay_late)
    );

    word_delay_w24s_x3 zb_delay (
        .clock(clock),
        .word(choice_zb),
        .late(zb_delay_late)
    );

    word_delay_w4_x3 number_delay (
        .clock(clock),
        .word(choice_number),
        .late(number_delay_late)
    );

    assign choice_is_there = quadric_is_inside & in_box_late;
    assign choice_middle_kept = front_middle & back_middle;
    assign normal_absent = choice_zf == absent;
    assign out_valid = valid_delay_late;
    assign zf = zf_delay_late;
    assign zb = zb_delay_late;
    assign number = number_delay_late;
    assign nx = normal_nx;
    assign ny = normal_ny;
    assign nz = normal_nz;

    wire unused_bits = &{1'b0, conics_0_value[46:0], conics_1_value[46:0], polars_0_value[34:0], polars_1_value[34:0]};

    always @(posedge clock) begin
        front_inside <= ~conics_0_value[47];
        back_inside <= ~conics_1_value[47];
        front_middle <= ~polars_0_value[35];
        back_middle <= ~polars_1_value[35];
    end

endmodule
