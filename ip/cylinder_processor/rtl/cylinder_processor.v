// cylinder_processor: depth and normal of a cylinder with exact outline and a parabolic body
//
// parameters: format 24
// latency:    3 clocks
// error:      exact in its integer words; against a cylinder: outline and front disc exact, depth of the body that of
//             the sphere processor over the part of the axis in the screen plane
// source:     Chaillou 1991, IV.2.5
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
//   in  side_3_a       36 two's complement
//   in  side_0_b       36 two's complement
//   in  side_1_b       36 two's complement
//   in  side_2_b       36 two's complement
//   in  side_3_b       36 two's complement
//   in  side_0_c       36 two's complement
//   in  side_1_c       36 two's complement
//   in  side_2_c       36 two's complement
//   in  side_3_c       36 two's complement
//   in  disc_0_a2      48 two's complement
//   in  disc_1_a2      48 two's complement
//   in  disc_0_b2      48 two's complement
//   in  disc_1_b2      48 two's complement
//   in  disc_0_c       48 two's complement
//   in  disc_1_c       48 two's complement
//   in  disc_0_i0      48 two's complement
//   in  disc_1_i0      48 two's complement
//   in  disc_0_p0      48 two's complement
//   in  disc_1_p0      48 two's complement
//   in  disc_0_f       48 two's complement
//   in  disc_1_f       48 two's complement
//   in  body_a2        48 two's complement
//   in  body_b2        48 two's complement
//   in  body_c         48 two's complement
//   in  body_i0        48 two's complement
//   in  body_p0        48 two's complement
//   in  body_f         48 two's complement
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
//   in  lid_a          36 two's complement
//   in  lid_b          36 two's complement
//   in  lid_c          36 two's complement
//   in  lid_nx         16 two's complement
//   in  lid_ny         16 two's complement
//   in  lid_nz         16 two's complement
//   out out_valid       1 unsigned
//   out zf             24 two's complement
//   out zb             24 two's complement
//   out number          4 unsigned
//   out nx             16 two's complement
//   out ny             16 two's complement
//   out nz             16 two's complement
//
// Made by: imogene emit cylinder_processor --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module cylinder_processor (
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
    input  wire signed [35:0] side_3_a,
    input  wire signed [35:0] side_0_b,
    input  wire signed [35:0] side_1_b,
    input  wire signed [35:0] side_2_b,
    input  wire signed [35:0] side_3_b,
    input  wire signed [35:0] side_0_c,
    input  wire signed [35:0] side_1_c,
    input  wire signed [35:0] side_2_c,
    input  wire signed [35:0] side_3_c,
    input  wire signed [47:0] disc_0_a2,
    input  wire signed [47:0] disc_1_a2,
    input  wire signed [47:0] disc_0_b2,
    input  wire signed [47:0] disc_1_b2,
    input  wire signed [47:0] disc_0_c,
    input  wire signed [47:0] disc_1_c,
    input  wire signed [47:0] disc_0_i0,
    input  wire signed [47:0] disc_1_i0,
    input  wire signed [47:0] disc_0_p0,
    input  wire signed [47:0] disc_1_p0,
    input  wire signed [47:0] disc_0_f,
    input  wire signed [47:0] disc_1_f,
    input  wire signed [47:0] body_a2,
    input  wire signed [47:0] body_b2,
    input  wire signed [47:0] body_c,
    input  wire signed [47:0] body_i0,
    input  wire signed [47:0] body_p0,
    input  wire signed [47:0] body_f,
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
    input  wire signed [35:0] lid_a,
    input  wire signed [35:0] lid_b,
    input  wire signed [35:0] lid_c,
    input  wire signed [15:0] lid_nx,
    input  wire signed [15:0] lid_ny,
    input  wire signed [15:0] lid_nz,
    output wire out_valid,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    localparam [3:0] body_face = 4'd0;
    localparam [3:0] lid_face = 4'd2;
    localparam signed [15:0] no_normal = 16'sd0;
    wire between;
    wire in_front;
    wire in_back;
    wire screen_box_in_box;
    wire in_box_late;
    wire signed [35:0] sides_0_value;
    wire signed [35:0] sides_1_value;
    wire signed [35:0] sides_2_value;
    wire signed [35:0] sides_3_value;
    wire signed [47:0] discs_0_value;
    wire signed [47:0] discs_1_value;
    wire signed [47:0] body_depth_value;
    wire signed [47:0] normal_x_value;
    wire signed [47:0] normal_y_value;
    wire signed [47:0] normal_z_value;
    wire signed [35:0] lid_value;
    wire face_is_present;
    wire signed [23:0] face_depth;
    wire valid_delay_late;
    reg kept_there = 1'd0;
    reg signed [25:0] kept_z = 26'sd0;
    reg [3:0] part = 4'd0;
    reg signed [15:0] part_nx = 16'sd0;
    reg signed [15:0] part_ny = 16'sd0;
    reg signed [15:0] part_nz = 16'sd0;
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

    pe1 sides_0 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(side_0_a),
        .b(side_0_b),
        .c(side_0_c),
        .value(sides_0_value)
    );

    pe1 sides_1 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(side_1_a),
        .b(side_1_b),
        .c(side_1_c),
        .value(sides_1_value)
    );

    pe1 sides_2 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(side_2_a),
        .b(side_2_b),
        .c(side_2_c),
        .value(sides_2_value)
    );

    pe1 sides_3 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(side_3_a),
        .b(side_3_b),
        .c(side_3_c),
        .value(sides_3_value)
    );

    pe2 discs_0 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(disc_0_a2),
        .b2(disc_0_b2),
        .c(disc_0_c),
        .p0(disc_0_p0),
        .i0(disc_0_i0),
        .f(disc_0_f),
        .value(discs_0_value)
    );

    pe2 discs_1 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(disc_1_a2),
        .b2(disc_1_b2),
        .c(disc_1_c),
        .p0(disc_1_p0),
        .i0(disc_1_i0),
        .f(disc_1_f),
        .value(discs_1_value)
    );

    pe2 body_depth (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(body_a2),
        .b2(body_b2),
        .c(body_c),
        .p0(body_p0),
        .i0(body_i0),
        .f(body_f),
        .value(body_depth_value)
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

    pe1 lid (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(lid_a),
        .b(lid_b),
        .c(lid_c),
        .value(lid_value)
    );

    one_face face (
        .z(kept_z),
        .is_there(kept_there),
        .is_present(face_is_present),
        .depth(face_depth)
    );

    word_delay_x3 valid_delay (
        .clock(clock),
        .word(valid),
        .late(valid_delay_late)
    );

    assign between = sides_3_value[35] ? 1'd0 :
        sides_2_value[35] ? 1'd0 :
        sides_1_value[35] ? 1'd0 :
        sides_0_value[35] ? 1'd0 : 1'd1;
    assign in_front = ~discs_0_value[47];
    assign in_back = ~discs_1_value[47];
    assign out_valid = valid_delay_late;
    assign zf = kept_depth;
    assign zb = kept_depth;
    assign number = kept_number;
    assign nx = kept_nx;
    assign ny = kept_ny;
    assign nz = kept_nz;

    wire unused_bits = &{1'b0, sides_0_value[34:0], sides_1_value[34:0], sides_2_value[34:0], sides_3_value[34:0], discs_0_value[46:0], discs_1_value[46:0], body_depth_value[21:0], normal_x_value[31:0], normal_y_value[31:0], normal_z_value[31:0], lid_value[9:0]};

    always @(posedge clock) begin
        kept_there <= in_box_late & ((in_front | between) | in_back);
        if (in_front) begin
            kept_z <= lid_value[35:10];
            part <= lid_face;
            part_nx <= lid_nx;
            part_ny <= lid_ny;
            part_nz <= lid_nz;
        end else begin
            kept_z <= body_depth_value[47:22];
            part <= body_face;
            part_nx <= normal_x_value[47:32];
            part_ny <= normal_y_value[47:32];
            part_nz <= normal_z_value[47:32];
        end
        kept_depth <= face_depth;
        kept_number <= body_face;
        kept_nx <= no_normal;
        kept_ny <= no_normal;
        kept_nz <= no_normal;
        if (face_is_present) begin
            kept_number <= part;
            kept_nx <= part_nx;
            kept_ny <= part_ny;
            kept_nz <= part_nz;
        end
    end

endmodule
