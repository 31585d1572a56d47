// facet_processor: depth and interpolated normal of a flat facet of three or four sides
//
// parameters: format 24
//             sides 3
// latency:    2 clocks
// error:      exact in its integer words; against real numbers: the rounding of the words, each once
// source:     Chaillou 1991, IV.2.2
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
//   in  side_0_a       36 two's complement
//   in  side_1_a       36 two's complement
//   in  side_2_a       36 two's complement
//   in  side_0_b       36 two's complement
//   in  side_1_b       36 two's complement
//   in  side_2_b       36 two's complement
//   in  side_0_c       36 two's complement
//   in  side_1_c       36 two's complement
//   in  side_2_c       36 two's complement
//   in  depth_a        36 two's complement
//   in  depth_b        36 two's complement
//   in  depth_c        36 two's complement
//   in  nx_a           24 two's complement
//   in  nx_b           24 two's complement
//   in  nx_c           24 two's complement
//   in  ny_a           24 two's complement
//   in  ny_b           24 two's complement
//   in  ny_c           24 two's complement
//   in  nz_a           24 two's complement
//   in  nz_b           24 two's complement
//   in  nz_c           24 two's complement
//   out out_valid       1 unsigned
//   out zf             24 two's complement
//   out zb             24 two's complement
//   out number          4 unsigned
//   out nx             16 two's complement
//   out ny             16 two's complement
//   out nz             16 two's complement
//
// Made by: imogene emit facet_processor --format 24 --sides 3 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module facet_processor (
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
    input  wire signed [35:0] side_0_a,
    input  wire signed [35:0] side_1_a,
    input  wire signed [35:0] side_2_a,
    input  wire signed [35:0] side_0_b,
    input  wire signed [35:0] side_1_b,
    input  wire signed [35:0] side_2_b,
    input  wire signed [35:0] side_0_c,
    input  wire signed [35:0] side_1_c,
    input  wire signed [35:0] side_2_c,
    input  wire signed [35:0] depth_a,
    input  wire signed [35:0] depth_b,
    input  wire signed [35:0] depth_c,
    input  wire signed [23:0] nx_a,
    input  wire signed [23:0] nx_b,
    input  wire signed [23:0] nx_c,
    input  wire signed [23:0] ny_a,
    input  wire signed [23:0] ny_b,
    input  wire signed [23:0] ny_c,
    input  wire signed [23:0] nz_a,
    input  wire signed [23:0] nz_b,
    input  wire signed [23:0] nz_c,
    output wire out_valid,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    localparam [3:0] facet = 4'd2;
    localparam [3:0] no_face = 4'd0;
    localparam signed [15:0] no_normal = 16'sd0;
    wire is_there;
    wire screen_box_in_box;
    wire in_box_late;
    wire signed [35:0] sides_0_value;
    wire signed [35:0] sides_1_value;
    wire signed [35:0] sides_2_value;
    wire signed [35:0] depth_value;
    wire signed [23:0] normal_x_value;
    wire signed [23:0] normal_y_value;
    wire signed [23:0] normal_z_value;
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

    pe1_w36 sides_0 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(side_0_a),
        .b(side_0_b),
        .c(side_0_c),
        .value(sides_0_value)
    );

    pe1_w36 sides_1 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(side_1_a),
        .b(side_1_b),
        .c(side_1_c),
        .value(sides_1_value)
    );

    pe1_w36 sides_2 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(side_2_a),
        .b(side_2_b),
        .c(side_2_c),
        .value(sides_2_value)
    );

    pe1_w36 depth (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(depth_a),
        .b(depth_b),
        .c(depth_c),
        .value(depth_value)
    );

    pe1_w24 normal_x (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(nx_a),
        .b(nx_b),
        .c(nx_c),
        .value(normal_x_value)
    );

    pe1_w24 normal_y (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(ny_a),
        .b(ny_b),
        .c(ny_c),
        .value(normal_y_value)
    );

    pe1_w24 normal_z (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(nz_a),
        .b(nz_b),
        .c(nz_c),
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

    assign is_there = sides_2_value[35] ? 1'd0 :
        sides_1_value[35] ? 1'd0 :
        sides_0_value[35] ? 1'd0 : in_box_late;
    assign face_z = depth_value[35:10];
    assign out_valid = valid_delay_late;
    assign zf = kept_depth;
    assign zb = kept_depth;
    assign number = kept_number;
    assign nx = kept_nx;
    assign ny = kept_ny;
    assign nz = kept_nz;

    wire unused_bits = &{1'b0, sides_0_value[34:0], sides_1_value[34:0], sides_2_value[34:0], depth_value[9:0], normal_x_value[7:0], normal_y_value[7:0], normal_z_value[7:0]};

    always @(posedge clock) begin
        kept_depth <= face_depth;
        kept_number <= no_face;
        kept_nx <= no_normal;
        kept_ny <= no_normal;
        kept_nz <= no_normal;
        if (face_is_present) begin
            kept_number <= facet;
            kept_nx <= normal_x_value[23:8];
            kept_ny <= normal_y_value[23:8];
            kept_nz <= normal_z_value[23:8];
        end
    end

endmodule
