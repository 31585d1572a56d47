// curved_facet_processor: depth and normal of a facet with sides, depth and normal of second degree
//
// parameters: format 24
//             sides 3
// latency:    2 clocks
// error:      exact in its integer words; against real numbers: the rounding of the words, each once
// source:     Chaillou 1991, IV.2.6.1
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
//   in  side_0_a2      48 two's complement
//   in  side_1_a2      48 two's complement
//   in  side_2_a2      48 two's complement
//   in  side_0_b2      48 two's complement
//   in  side_1_b2      48 two's complement
//   in  side_2_b2      48 two's complement
//   in  side_0_c       48 two's complement
//   in  side_1_c       48 two's complement
//   in  side_2_c       48 two's complement
//   in  side_0_i0      48 two's complement
//   in  side_1_i0      48 two's complement
//   in  side_2_i0      48 two's complement
//   in  side_0_p0      48 two's complement
//   in  side_1_p0      48 two's complement
//   in  side_2_p0      48 two's complement
//   in  side_0_f       48 two's complement
//   in  side_1_f       48 two's complement
//   in  side_2_f       48 two's complement
//   in  depth_a2       48 two's complement
//   in  depth_b2       48 two's complement
//   in  depth_c        48 two's complement
//   in  depth_i0       48 two's complement
//   in  depth_p0       48 two's complement
//   in  depth_f        48 two's complement
//   in  nx_a2          48 two's complement
//   in  nx_b2          48 two's complement
//   in  nx_c           48 two's complement
//   in  nx_i0          48 two's complement
//   in  nx_p0          48 two's complement
//   in  nx_f           48 two's complement
//   in  ny_a2          48 two's complement
//   in  ny_b2          48 two's complement
//   in  ny_c           48 two's complement
//   in  ny_i0          48 two's complement
//   in  ny_p0          48 two's complement
//   in  ny_f           48 two's complement
//   in  nz_a2          48 two's complement
//   in  nz_b2          48 two's complement
//   in  nz_c           48 two's complement
//   in  nz_i0          48 two's complement
//   in  nz_p0          48 two's complement
//   in  nz_f           48 two's complement
//   out out_valid       1 unsigned
//   out zf             24 two's complement
//   out zb             24 two's complement
//   out number          4 unsigned
//   out nx             16 two's complement
//   out ny             16 two's complement
//   out nz             16 two's complement
//
// Made by: imogene emit curved_facet_processor --format 24 --sides 3 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module curved_facet_processor (
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
    input  wire signed [47:0] side_0_a2,
    input  wire signed [47:0] side_1_a2,
    input  wire signed [47:0] side_2_a2,
    input  wire signed [47:0] side_0_b2,
    input  wire signed [47:0] side_1_b2,
    input  wire signed [47:0] side_2_b2,
    input  wire signed [47:0] side_0_c,
    input  wire signed [47:0] side_1_c,
    input  wire signed [47:0] side_2_c,
    input  wire signed [47:0] side_0_i0,
    input  wire signed [47:0] side_1_i0,
    input  wire signed [47:0] side_2_i0,
    input  wire signed [47:0] side_0_p0,
    input  wire signed [47:0] side_1_p0,
    input  wire signed [47:0] side_2_p0,
    input  wire signed [47:0] side_0_f,
    input  wire signed [47:0] side_1_f,
    input  wire signed [47:0] side_2_f,
    input  wire signed [47:0] depth_a2,
    input  wire signed [47:0] depth_b2,
    input  wire signed [47:0] depth_c,
    input  wire signed [47:0] depth_i0,
    input  wire signed [47:0] depth_p0,
    input  wire signed [47:0] depth_f,
    input  wire signed [47:0] nx_a2,
    input  wire signed [47:0] nx_b2,
    input  wire signed [47:0] nx_c,
    input  wire signed [47:0] nx_i0,
    input  wire signed [47:0] nx_p0,
    input  wire signed [47:0] nx_f,
    input  wire signed [47:0] ny_a2,
    input  wire signed [47:0] ny_b2,
    input  wire signed [47:0] ny_c,
    input  wire signed [47:0] ny_i0,
    input  wire signed [47:0] ny_p0,
    input  wire signed [47:0] ny_f,
    input  wire signed [47:0] nz_a2,
    input  wire signed [47:0] nz_b2,
    input  wire signed [47:0] nz_c,
    input  wire signed [47:0] nz_i0,
    input  wire signed [47:0] nz_p0,
    input  wire signed [47:0] nz_f,
    output wire out_valid,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    localparam [3:0] facet = 4'd0;
    localparam signed [15:0] no_normal = 16'sd0;
    wire is_there;
    wire screen_box_in_box;
    wire in_box_late;
    wire signed [47:0] sides_0_value;
    wire signed [47:0] sides_1_value;
    wire signed [47:0] sides_2_value;
    wire signed [47:0] depth_value;
    wire signed [47:0] normal_x_value;
    wire signed [47:0] normal_y_value;
    wire signed [47:0] normal_z_value;
    wire signed [25:0] face_z;
    wire face_is_present;
    wire signed [23:0] face_depth;
    wire valid_delay_late;
    reg signed [23:0] kept_depth = 24'sd0;
    reg [3:0] kept_number = 4'd0;
    reg signed [15:0] kept_nx = 16'sd0;
    reg signed [15:0] kept_ny = 16'sd0;
    reg signed [15:0] kept_nz = 16'sd0;

    screen_box screen_box (
        .x(x),
        .y(y),
        .box_x0(box_x0),
        .box_x1(box_x1),
        .box_y0(box_y0),
        .box_y1(box_y1),
        .in_box(screen_box_in_box)
    );

    word_delay_x1 in_box (
        .clock(clock),
        .word(screen_box_in_box),
        .late(in_box_late)
    );

    pe2 sides_0 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(side_0_a2),
        .b2(side_0_b2),
        .c(side_0_c),
        .p0(side_0_p0),
        .i0(side_0_i0),
        .f(side_0_f),
        .value(sides_0_value)
    );

    pe2 sides_1 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(side_1_a2),
        .b2(side_1_b2),
        .c(side_1_c),
        .p0(side_1_p0),
        .i0(side_1_i0),
        .f(side_1_f),
        .value(sides_1_value)
    );

    pe2 sides_2 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(side_2_a2),
        .b2(side_2_b2),
        .c(side_2_c),
        .p0(side_2_p0),
        .i0(side_2_i0),
        .f(side_2_f),
        .value(sides_2_value)
    );

    pe2 depth (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(depth_a2),
        .b2(depth_b2),
        .c(depth_c),
        .p0(depth_p0),
        .i0(depth_i0),
        .f(depth_f),
        .value(depth_value)
    );

    pe2 normal_x (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(nx_a2),
        .b2(nx_b2),
        .c(nx_c),
        .p0(nx_p0),
        .i0(nx_i0),
        .f(nx_f),
        .value(normal_x_value)
    );

    pe2 normal_y (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(ny_a2),
        .b2(ny_b2),
        .c(ny_c),
        .p0(ny_p0),
        .i0(ny_i0),
        .f(ny_f),
        .value(normal_y_value)
    );

    pe2 normal_z (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(nz_a2),
        .b2(nz_b2),
        .c(nz_c),
        .p0(nz_p0),
        .i0(nz_i0),
        .f(nz_f),
        .value(normal_z_value)
    );

    one_face face (
        .z(face_z),
        .is_there(is_there),
        .is_present(face_is_present),
        .depth(face_depth)
    );

    word_delay_x2 valid_delay (
        .clock(clock),
        .word(valid),
        .late(valid_delay_late)
    );

    assign is_there = sides_2_value[47] ? 1'd0 :
        sides_1_value[47] ? 1'd0 :
        sides_0_value[47] ? 1'd0 : in_box_late;
    assign face_z = depth_value[47:22];
    assign out_valid = valid_delay_late;
    assign zf = kept_depth;
    assign zb = kept_depth;
    assign number = kept_number;
    assign nx = kept_nx;
    assign ny = kept_ny;
    assign nz = kept_nz;

    wire unused_bits = &{1'b0, sides_0_value[46:0], sides_1_value[46:0], sides_2_value[46:0], depth_value[21:0], normal_x_value[31:0], normal_y_value[31:0], normal_z_value[31:0]};

    always @(posedge clock) begin
        kept_depth <= face_depth;
        kept_number <= facet;
        kept_nx <= no_normal;
        kept_ny <= no_normal;
        kept_nz <= no_normal;
        if (face_is_present) begin
            kept_nx <= normal_x_value[47:32];
            kept_ny <= normal_y_value[47:32];
            kept_nz <= normal_z_value[47:32];
        end
    end

endmodule
