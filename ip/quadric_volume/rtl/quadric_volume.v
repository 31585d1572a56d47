// quadric_volume: is the visible point in a shadow or light volume of a quadric and planes
//
// parameters: format 24
//             planes 4
//             rows per stage 1
// latency:    28 clocks
// error:      exact in its integer words; against real numbers: the rounding of the words, each once
// source:     Nyiri 1994, 3.2.1 and 4.1.3
// ports:
//   in  clock           1 unsigned
//   in  valid           1 unsigned
//   in  start           1 unsigned
//   in  line            1 unsigned
//   in  x              12 unsigned
//   in  y              12 unsigned
//   in  depth          24 two's complement
//   in  f1_a           26 two's complement
//   in  f1_b           26 two's complement
//   in  f1_c           26 two's complement
//   in  f2_a2          48 two's complement
//   in  f2_b2          48 two's complement
//   in  f2_c           48 two's complement
//   in  f2_i0          48 two's complement
//   in  f2_p0          48 two's complement
//   in  f2_f           48 two's complement
//   in  box_x0         12 unsigned
//   in  box_x1         12 unsigned
//   in  box_y0         12 unsigned
//   in  box_y1         12 unsigned
//   in  object_class    2 unsigned
//   in  depth_shift     4 unsigned
//   in  margin         24 unsigned
//   in  plane_0_kind    2 unsigned
//   in  plane_1_kind    2 unsigned
//   in  plane_2_kind    2 unsigned
//   in  plane_3_kind    2 unsigned
//   in  plane_0_a      36 two's complement
//   in  plane_1_a      36 two's complement
//   in  plane_2_a      36 two's complement
//   in  plane_3_a      36 two's complement
//   in  plane_0_b      36 two's complement
//   in  plane_1_b      36 two's complement
//   in  plane_2_b      36 two's complement
//   in  plane_3_b      36 two's complement
//   in  plane_0_c      36 two's complement
//   in  plane_1_c      36 two's complement
//   in  plane_2_c      36 two's complement
//   in  plane_3_c      36 two's complement
//   out out_valid       1 unsigned
//   out is_inside       1 unsigned
//
// Made by: imogene emit quadric_volume --format 24 --planes 4 --rows-per-stage 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module quadric_volume (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire signed [23:0] depth,
    input  wire signed [25:0] f1_a,
    input  wire signed [25:0] f1_b,
    input  wire signed [25:0] f1_c,
    input  wire signed [47:0] f2_a2,
    input  wire signed [47:0] f2_b2,
    input  wire signed [47:0] f2_c,
    input  wire signed [47:0] f2_i0,
    input  wire signed [47:0] f2_p0,
    input  wire signed [47:0] f2_f,
    input  wire [11:0] box_x0,
    input  wire [11:0] box_x1,
    input  wire [11:0] box_y0,
    input  wire [11:0] box_y1,
    input  wire [1:0] object_class,
    input  wire [3:0] depth_shift,
    input  wire [23:0] margin,
    input  wire [1:0] plane_0_kind,
    input  wire [1:0] plane_1_kind,
    input  wire [1:0] plane_2_kind,
    input  wire [1:0] plane_3_kind,
    input  wire signed [35:0] plane_0_a,
    input  wire signed [35:0] plane_1_a,
    input  wire signed [35:0] plane_2_a,
    input  wire signed [35:0] plane_3_a,
    input  wire signed [35:0] plane_0_b,
    input  wire signed [35:0] plane_1_b,
    input  wire signed [35:0] plane_2_b,
    input  wire signed [35:0] plane_3_b,
    input  wire signed [35:0] plane_0_c,
    input  wire signed [35:0] plane_1_c,
    input  wire signed [35:0] plane_2_c,
    input  wire signed [35:0] plane_3_c,
    output wire out_valid,
    output wire is_inside
);

    wire in_all;
    wire screen_box_in_box;
    wire in_box_late;
    wire signed [25:0] quadric_near_sum;
    wire signed [25:0] quadric_far_sum;
    wire [23:0] unused_quadric_root;
    wire quadric_is_inside;
    wire quadric_late_valid;
    wire quadric_late_start;
    wire quadric_late_line;
    wire quadric_test_holds;
    wire plane_flags_late_valid;
    wire plane_flags_late_start;
    wire plane_flags_late_line;
    wire signed [23:0] point_z;
    wire signed [25:0] point_entered;
    wire point_is_surface;
    wire signed [25:0] coarse_point_z;
    wire signed [25:0] coarse_point_entered;
    wire signed [35:0] planes_0_value;
    wire signed [35:0] planes_1_value;
    wire signed [35:0] planes_2_value;
    wire signed [35:0] planes_3_value;
    wire tests_0_holds;
    wire tests_1_holds;
    wire tests_2_holds;
    wire tests_3_holds;
    wire valid_delay_late;
    reg kept = 1'd0;

    screen_box screen_box (
        .x(x),
        .y(y),
        .box_x0(box_x0),
        .box_x1(box_x1),
        .box_y0(box_y0),
        .box_y1(box_y1),
        .in_box(screen_box_in_box)
    );

    word_delay_x27 in_box (
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
        .root(unused_quadric_root),
        .is_inside(quadric_is_inside),
        .late_valid(quadric_late_valid),
        .late_start(quadric_late_start),
        .late_line(quadric_late_line)
    );

    quadric_test quadric_test (
        .clock(clock),
        .object_class(object_class),
        .near_sum(quadric_near_sum),
        .far_sum(quadric_far_sum),
        .is_inside(quadric_is_inside),
        .z(coarse_point_z),
        .entered(coarse_point_entered),
        .holds(quadric_test_holds)
    );

    flag_delay_x3 plane_flags (
        .clock(clock),
        .valid(quadric_late_valid),
        .start(quadric_late_start),
        .line(quadric_late_line),
        .late_valid(plane_flags_late_valid),
        .late_start(plane_flags_late_start),
        .late_line(plane_flags_late_line)
    );

    visible_point point (
        .clock(clock),
        .depth(depth),
        .margin(margin),
        .z(point_z),
        .entered(point_entered),
        .is_surface(point_is_surface)
    );

    coarse_point coarse_point (
        .clock(clock),
        .depth(depth),
        .margin(margin),
        .depth_shift(depth_shift),
        .z(coarse_point_z),
        .entered(coarse_point_entered)
    );

    pe1_w36 planes_0 (
        .clock(clock),
        .valid(plane_flags_late_valid),
        .start(plane_flags_late_start),
        .line(plane_flags_late_line),
        .a(plane_0_a),
        .b(plane_0_b),
        .c(plane_0_c),
        .value(planes_0_value)
    );

    pe1_w36 planes_1 (
        .clock(clock),
        .valid(plane_flags_late_valid),
        .start(plane_flags_late_start),
        .line(plane_flags_late_line),
        .a(plane_1_a),
        .b(plane_1_b),
        .c(plane_1_c),
        .value(planes_1_value)
    );

    pe1_w36 planes_2 (
        .clock(clock),
        .valid(plane_flags_late_valid),
        .start(plane_flags_late_start),
        .line(plane_flags_late_line),
        .a(plane_2_a),
        .b(plane_2_b),
        .c(plane_2_c),
        .value(planes_2_value)
    );

    pe1_w36 planes_3 (
        .clock(clock),
        .valid(plane_flags_late_valid),
        .start(plane_flags_late_start),
        .line(plane_flags_late_line),
        .a(plane_3_a),
        .b(plane_3_b),
        .c(plane_3_c),
        .value(planes_3_value)
    );

    half_space_test tests_0 (
        .clock(clock),
        .kind(plane_0_kind),
        .zp(planes_0_value),
        .z(point_z),
        .entered(point_entered),
        .holds(tests_0_holds)
    );

    half_space_test tests_1 (
        .clock(clock),
        .kind(plane_1_kind),
        .zp(planes_1_value),
        .z(point_z),
        .entered(point_entered),
        .holds(tests_1_holds)
    );

    half_space_test tests_2 (
        .clock(clock),
        .kind(plane_2_kind),
        .zp(planes_2_value),
        .z(point_z),
        .entered(point_entered),
        .holds(tests_2_holds)
    );

    half_space_test tests_3 (
        .clock(clock),
        .kind(plane_3_kind),
        .zp(planes_3_value),
        .z(point_z),
        .entered(point_entered),
        .holds(tests_3_holds)
    );

    word_delay_x28 valid_delay (
        .clock(clock),
        .word(valid),
        .late(valid_delay_late)
    );

    assign in_all = ~tests_3_holds ? 1'd0 :
        ~tests_2_holds ? 1'd0 :
        ~tests_1_holds ? 1'd0 :
        ~tests_0_holds ? 1'd0 : (in_box_late & point_is_surface) & quadric_test_holds;
    assign out_valid = valid_delay_late;
    assign is_inside = kept;

    always @(posedge clock) begin
        kept <= in_all;
    end

endmodule
