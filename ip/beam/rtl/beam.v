// beam: the visible surface of many quadric objects, pixel by pixel
//
// parameters: format 24
//             planes 3
//             rows per stage 1
//             objects 4
// latency:    37 clocks
// error:      exact in its integer words; imogene check SCENE bounds what the rounding of a scene to those words costs
// source:     architecture, 7
// ports:
//   in  clock           1 unsigned
//   in  go              1 unsigned
//   in  width          12 unsigned
//   in  height         12 unsigned
//   in  load_valid      1 unsigned
//   in  load_object     8 unsigned
//   in  load_address    8 unsigned
//   in  load_data      48 unsigned
//   out valid           1 unsigned
//   out depth          24 two's complement
//   out id              8 unsigned
//   out number          4 unsigned
//   out nx             16 two's complement
//   out ny             16 two's complement
//   out nz             16 two's complement
//
// Made by: imogene emit beam --format 24 --planes 3 --rows-per-stage 1 --objects 4 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module beam (
    input  wire clock,
    input  wire go,
    input  wire [11:0] width,
    input  wire [11:0] height,
    input  wire load_valid,
    input  wire [7:0] load_object,
    input  wire [7:0] load_address,
    input  wire [47:0] load_data,
    output wire valid,
    output wire signed [23:0] depth,
    output wire [7:0] id,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    wire raster_valid;
    wire raster_start;
    wire raster_line;
    wire [11:0] raster_x;
    wire [11:0] raster_y;
    wire unused_raster_last;
    wire stores_0_write;
    wire signed [25:0] stores_0_f1_a;
    wire signed [25:0] stores_0_f1_b;
    wire signed [25:0] stores_0_f1_c;
    wire signed [47:0] stores_0_f2_a2;
    wire signed [47:0] stores_0_f2_b2;
    wire signed [47:0] stores_0_f2_c;
    wire signed [47:0] stores_0_f2_i0;
    wire signed [47:0] stores_0_f2_p0;
    wire signed [47:0] stores_0_f2_f;
    wire signed [23:0] stores_0_gx_a;
    wire signed [23:0] stores_0_gx_b;
    wire signed [23:0] stores_0_gx_c;
    wire signed [23:0] stores_0_gy_a;
    wire signed [23:0] stores_0_gy_b;
    wire signed [23:0] stores_0_gy_c;
    wire signed [23:0] stores_0_gz_a;
    wire signed [23:0] stores_0_gz_b;
    wire signed [23:0] stores_0_gz_c;
    wire signed [15:0] stores_0_kx;
    wire signed [15:0] stores_0_ky;
    wire signed [15:0] stores_0_kz;
    wire [11:0] stores_0_box_x0;
    wire [11:0] stores_0_box_x1;
    wire [11:0] stores_0_box_y0;
    wire [11:0] stores_0_box_y1;
    wire [1:0] stores_0_object_class;
    wire [4:0] stores_0_shift;
    wire [1:0] stores_0_plane_0_kind;
    wire [1:0] stores_0_plane_1_kind;
    wire [1:0] stores_0_plane_2_kind;
    wire signed [35:0] stores_0_plane_0_a;
    wire signed [35:0] stores_0_plane_1_a;
    wire signed [35:0] stores_0_plane_2_a;
    wire signed [35:0] stores_0_plane_0_b;
    wire signed [35:0] stores_0_plane_1_b;
    wire signed [35:0] stores_0_plane_2_b;
    wire signed [35:0] stores_0_plane_0_c;
    wire signed [35:0] stores_0_plane_1_c;
    wire signed [35:0] stores_0_plane_2_c;
    wire signed [15:0] stores_0_plane_0_nx;
    wire signed [15:0] stores_0_plane_1_nx;
    wire signed [15:0] stores_0_plane_2_nx;
    wire signed [15:0] stores_0_plane_0_ny;
    wire signed [15:0] stores_0_plane_1_ny;
    wire signed [15:0] stores_0_plane_2_ny;
    wire signed [15:0] stores_0_plane_0_nz;
    wire signed [15:0] stores_0_plane_1_nz;
    wire signed [15:0] stores_0_plane_2_nz;
    wire stores_1_write;
    wire signed [25:0] stores_1_f1_a;
    wire signed [25:0] stores_1_f1_b;
    wire signed [25:0] stores_1_f1_c;
    wire signed [47:0] stores_1_f2_a2;
    wire signed [47:0] stores_1_f2_b2;
    wire signed [47:0] stores_1_f2_c;
    wire signed [47:0] stores_1_f2_i0;
    wire signed [47:0] stores_1_f2_p0;
    wire signed [47:0] stores_1_f2_f;
    wire signed [23:0] stores_1_gx_a;
    wire signed [23:0] stores_1_gx_b;
    wire signed [23:0] stores_1_gx_c;
    wire signed [23:0] stores_1_gy_a;
    wire signed [23:0] stores_1_gy_b;
    wire signed [23:0] stores_1_gy_c;
    wire signed [23:0] stores_1_gz_a;
    wire signed [23:0] stores_1_gz_b;
    wire signed [23:0] stores_1_gz_c;
    wire signed [15:0] stores_1_kx;
    wire signed [15:0] stores_1_ky;
    wire signed [15:0] stores_1_kz;
    wire [11:0] stores_1_box_x0;
    wire [11:0] stores_1_box_x1;
    wire [11:0] stores_1_box_y0;
    wire [11:0] stores_1_box_y1;
    wire [1:0] stores_1_object_class;
    wire [4:0] stores_1_shift;
    wire [1:0] stores_1_plane_0_kind;
    wire [1:0] stores_1_plane_1_kind;
    wire [1:0] stores_1_plane_2_kind;
    wire signed [35:0] stores_1_plane_0_a;
    wire signed [35:0] stores_1_plane_1_a;
    wire signed [35:0] stores_1_plane_2_a;
    wire signed [35:0] stores_1_plane_0_b;
    wire signed [35:0] stores_1_plane_1_b;
    wire signed [35:0] stores_1_plane_2_b;
    wire signed [35:0] stores_1_plane_0_c;
    wire signed [35:0] stores_1_plane_1_c;
    wire signed [35:0] stores_1_plane_2_c;
    wire signed [15:0] stores_1_plane_0_nx;
    wire signed [15:0] stores_1_plane_1_nx;
    wire signed [15:0] stores_1_plane_2_nx;
    wire signed [15:0] stores_1_plane_0_ny;
    wire signed [15:0] stores_1_plane_1_ny;
    wire signed [15:0] stores_1_plane_2_ny;
    wire signed [15:0] stores_1_plane_0_nz;
    wire signed [15:0] stores_1_plane_1_nz;
    wire signed [15:0] stores_1_plane_2_nz;
    wire stores_2_write;
    wire signed [25:0] stores_2_f1_a;
    wire signed [25:0] stores_2_f1_b;
    wire signed [25:0] stores_2_f1_c;
    wire signed [47:0] stores_2_f2_a2;
    wire signed [47:0] stores_2_f2_b2;
    wire signed [47:0] stores_2_f2_c;
    wire signed [47:0] stores_2_f2_i0;
    wire signed [47:0] stores_2_f2_p0;
    wire signed [47:0] stores_2_f2_f;
    wire signed [23:0] stores_2_gx_a;
    wire signed [23:0] stores_2_gx_b;
    wire signed [23:0] stores_2_gx_c;
    wire signed [23:0] stores_2_gy_a;
    wire signed [23:0] stores_2_gy_b;
    wire signed [23:0] stores_2_gy_c;
    wire signed [23:0] stores_2_gz_a;
    wire signed [23:0] stores_2_gz_b;
    wire signed [23:0] stores_2_gz_c;
    wire signed [15:0] stores_2_kx;
    wire signed [15:0] stores_2_ky;
    wire signed [15:0] stores_2_kz;
    wire [11:0] stores_2_box_x0;
    wire [11:0] stores_2_box_x1;
    wire [11:0] stores_2_box_y0;
    wire [11:0] stores_2_box_y1;
    wire [1:0] stores_2_object_class;
    wire [4:0] stores_2_shift;
    wire [1:0] stores_2_plane_0_kind;
    wire [1:0] stores_2_plane_1_kind;
    wire [1:0] stores_2_plane_2_kind;
    wire signed [35:0] stores_2_plane_0_a;
    wire signed [35:0] stores_2_plane_1_a;
    wire signed [35:0] stores_2_plane_2_a;
    wire signed [35:0] stores_2_plane_0_b;
    wire signed [35:0] stores_2_plane_1_b;
    wire signed [35:0] stores_2_plane_2_b;
    wire signed [35:0] stores_2_plane_0_c;
    wire signed [35:0] stores_2_plane_1_c;
    wire signed [35:0] stores_2_plane_2_c;
    wire signed [15:0] stores_2_plane_0_nx;
    wire signed [15:0] stores_2_plane_1_nx;
    wire signed [15:0] stores_2_plane_2_nx;
    wire signed [15:0] stores_2_plane_0_ny;
    wire signed [15:0] stores_2_plane_1_ny;
    wire signed [15:0] stores_2_plane_2_ny;
    wire signed [15:0] stores_2_plane_0_nz;
    wire signed [15:0] stores_2_plane_1_nz;
    wire signed [15:0] stores_2_plane_2_nz;
    wire stores_3_write;
    wire signed [25:0] stores_3_f1_a;
    wire signed [25:0] stores_3_f1_b;
    wire signed [25:0] stores_3_f1_c;
    wire signed [47:0] stores_3_f2_a2;
    wire signed [47:0] stores_3_f2_b2;
    wire signed [47:0] stores_3_f2_c;
    wire signed [47:0] stores_3_f2_i0;
    wire signed [47:0] stores_3_f2_p0;
    wire signed [47:0] stores_3_f2_f;
    wire signed [23:0] stores_3_gx_a;
    wire signed [23:0] stores_3_gx_b;
    wire signed [23:0] stores_3_gx_c;
    wire signed [23:0] stores_3_gy_a;
    wire signed [23:0] stores_3_gy_b;
    wire signed [23:0] stores_3_gy_c;
    wire signed [23:0] stores_3_gz_a;
    wire signed [23:0] stores_3_gz_b;
    wire signed [23:0] stores_3_gz_c;
    wire signed [15:0] stores_3_kx;
    wire signed [15:0] stores_3_ky;
    wire signed [15:0] stores_3_kz;
    wire [11:0] stores_3_box_x0;
    wire [11:0] stores_3_box_x1;
    wire [11:0] stores_3_box_y0;
    wire [11:0] stores_3_box_y1;
    wire [1:0] stores_3_object_class;
    wire [4:0] stores_3_shift;
    wire [1:0] stores_3_plane_0_kind;
    wire [1:0] stores_3_plane_1_kind;
    wire [1:0] stores_3_plane_2_kind;
    wire signed [35:0] stores_3_plane_0_a;
    wire signed [35:0] stores_3_plane_1_a;
    wire signed [35:0] stores_3_plane_2_a;
    wire signed [35:0] stores_3_plane_0_b;
    wire signed [35:0] stores_3_plane_1_b;
    wire signed [35:0] stores_3_plane_2_b;
    wire signed [35:0] stores_3_plane_0_c;
    wire signed [35:0] stores_3_plane_1_c;
    wire signed [35:0] stores_3_plane_2_c;
    wire signed [15:0] stores_3_plane_0_nx;
    wire signed [15:0] stores_3_plane_1_nx;
    wire signed [15:0] stores_3_plane_2_nx;
    wire signed [15:0] stores_3_plane_0_ny;
    wire signed [15:0] stores_3_plane_1_ny;
    wire signed [15:0] stores_3_plane_2_ny;
    wire signed [15:0] stores_3_plane_0_nz;
    wire signed [15:0] stores_3_plane_1_nz;
    wire signed [15:0] stores_3_plane_2_nz;
    wire processors_0_out_valid;
    wire signed [23:0] processors_0_zf;
    wire signed [23:0] unused_processors_0_zb;
    wire [3:0] processors_0_number;
    wire signed [15:0] processors_0_nx;
    wire signed [15:0] processors_0_ny;
    wire signed [15:0] processors_0_nz;
    wire unused_processors_1_out_valid;
    wire signed [23:0] processors_1_zf;
    wire signed [23:0] unused_processors_1_zb;
    wire [3:0] processors_1_number;
    wire signed [15:0] processors_1_nx;
    wire signed [15:0] processors_1_ny;
    wire signed [15:0] processors_1_nz;
    wire unused_processors_2_out_valid;
    wire signed [23:0] processors_2_zf;
    wire signed [23:0] unused_processors_2_zb;
    wire [3:0] processors_2_number;
    wire signed [15:0] processors_2_nx;
    wire signed [15:0] processors_2_ny;
    wire signed [15:0] processors_2_nz;
    wire unused_processors_3_out_valid;
    wire signed [23:0] processors_3_zf;
    wire signed [23:0] unused_processors_3_zb;
    wire [3:0] processors_3_number;
    wire signed [15:0] processors_3_nx;
    wire signed [15:0] processors_3_ny;
    wire signed [15:0] processors_3_nz;
    wire signed [23:0] decider_depth;
    wire [7:0] decider_id;
    wire [3:0] decider_number;
    wire signed [15:0] decider_nx;
    wire signed [15:0] decider_ny;
    wire signed [15:0] decider_nz;
    wire valid_delay_late;

    raster_control raster (
        .clock(clock),
        .go(go),
        .width(width),
        .height(height),
        .valid(raster_valid),
        .start(raster_start),
        .line(raster_line),
        .x(raster_x),
        .y(raster_y),
        .last(unused_raster_last)
    );

    coefficient_store stores_0 (
        .clock(clock),
        .write(stores_0_write),
        .address(load_address),
        .data(load_data),
        .f1_a(stores_0_f1_a),
        .f1_b(stores_0_f1_b),
        .f1_c(stores_0_f1_c),
        .f2_a2(stores_0_f2_a2),
        .f2_b2(stores_0_f2_b2),
        .f2_c(stores_0_f2_c),
        .f2_i0(stores_0_f2_i0),
        .f2_p0(stores_0_f2_p0),
        .f2_f(stores_0_f2_f),
        .gx_a(stores_0_gx_a),
        .gx_b(stores_0_gx_b),
        .gx_c(stores_0_gx_c),
        .gy_a(stores_0_gy_a),
        .gy_b(stores_0_gy_b),
        .gy_c(stores_0_gy_c),
        .gz_a(stores_0_gz_a),
        .gz_b(stores_0_gz_b),
        .gz_c(stores_0_gz_c),
        .kx(stores_0_kx),
        .ky(stores_0_ky),
        .kz(stores_0_kz),
        .box_x0(stores_0_box_x0),
        .box_x1(stores_0_box_x1),
        .box_y0(stores_0_box_y0),
        .box_y1(stores_0_box_y1),
        .object_class(stores_0_object_class),
        .shift(stores_0_shift),
        .plane_0_kind(stores_0_plane_0_kind),
        .plane_1_kind(stores_0_plane_1_kind),
        .plane_2_kind(stores_0_plane_2_kind),
        .plane_0_a(stores_0_plane_0_a),
        .plane_1_a(stores_0_plane_1_a),
        .plane_2_a(stores_0_plane_2_a),
        .plane_0_b(stores_0_plane_0_b),
        .plane_1_b(stores_0_plane_1_b),
        .plane_2_b(stores_0_plane_2_b),
        .plane_0_c(stores_0_plane_0_c),
        .plane_1_c(stores_0_plane_1_c),
        .plane_2_c(stores_0_plane_2_c),
        .plane_0_nx(stores_0_plane_0_nx),
        .plane_1_nx(stores_0_plane_1_nx),
        .plane_2_nx(stores_0_plane_2_nx),
        .plane_0_ny(stores_0_plane_0_ny),
        .plane_1_ny(stores_0_plane_1_ny),
        .plane_2_ny(stores_0_plane_2_ny),
        .plane_0_nz(stores_0_plane_0_nz),
        .plane_1_nz(stores_0_plane_1_nz),
        .plane_2_nz(stores_0_plane_2_nz)
    );

    coefficient_store stores_1 (
        .clock(clock),
        .write(stores_1_write),
        .address(load_address),
        .data(load_data),
        .f1_a(stores_1_f1_a),
        .f1_b(stores_1_f1_b),
        .f1_c(stores_1_f1_c),
        .f2_a2(stores_1_f2_a2),
        .f2_b2(stores_1_f2_b2),
        .f2_c(stores_1_f2_c),
        .f2_i0(stores_1_f2_i0),
        .f2_p0(stores_1_f2_p0),
        .f2_f(stores_1_f2_f),
        .gx_a(stores_1_gx_a),
        .gx_b(stores_1_gx_b),
        .gx_c(stores_1_gx_c),
        .gy_a(stores_1_gy_a),
        .gy_b(stores_1_gy_b),
        .gy_c(stores_1_gy_c),
        .gz_a(stores_1_gz_a),
        .gz_b(stores_1_gz_b),
        .gz_c(stores_1_gz_c),
        .kx(stores_1_kx),
        .ky(stores_1_ky),
        .kz(stores_1_kz),
        .box_x0(stores_1_box_x0),
        .box_x1(stores_1_box_x1),
        .box_y0(stores_1_box_y0),
        .box_y1(stores_1_box_y1),
        .object_class(stores_1_object_class),
        .shift(stores_1_shift),
        .plane_0_kind(stores_1_plane_0_kind),
        .plane_1_kind(stores_1_plane_1_kind),
        .plane_2_kind(stores_1_plane_2_kind),
        .plane_0_a(stores_1_plane_0_a),
        .plane_1_a(stores_1_plane_1_a),
        .plane_2_a(stores_1_plane_2_a),
        .plane_0_b(stores_1_plane_0_b),
        .plane_1_b(stores_1_plane_1_b),
        .plane_2_b(stores_1_plane_2_b),
        .plane_0_c(stores_1_plane_0_c),
        .plane_1_c(stores_1_plane_1_c),
        .plane_2_c(stores_1_plane_2_c),
        .plane_0_nx(stores_1_plane_0_nx),
        .plane_1_nx(stores_1_plane_1_nx),
        .plane_2_nx(stores_1_plane_2_nx),
        .plane_0_ny(stores_1_plane_0_ny),
        .plane_1_ny(stores_1_plane_1_ny),
        .plane_2_ny(stores_1_plane_2_ny),
        .plane_0_nz(stores_1_plane_0_nz),
        .plane_1_nz(stores_1_plane_1_nz),
        .plane_2_nz(stores_1_plane_2_nz)
    );

    coefficient_store stores_2 (
        .clock(clock),
        .write(stores_2_write),
        .address(load_address),
        .data(load_data),
        .f1_a(stores_2_f1_a),
        .f1_b(stores_2_f1_b),
        .f1_c(stores_2_f1_c),
        .f2_a2(stores_2_f2_a2),
        .f2_b2(stores_2_f2_b2),
        .f2_c(stores_2_f2_c),
        .f2_i0(stores_2_f2_i0),
        .f2_p0(stores_2_f2_p0),
        .f2_f(stores_2_f2_f),
        .gx_a(stores_2_gx_a),
        .gx_b(stores_2_gx_b),
        .gx_c(stores_2_gx_c),
        .gy_a(stores_2_gy_a),
        .gy_b(stores_2_gy_b),
        .gy_c(stores_2_gy_c),
        .gz_a(stores_2_gz_a),
        .gz_b(stores_2_gz_b),
        .gz_c(stores_2_gz_c),
        .kx(stores_2_kx),
        .ky(stores_2_ky),
        .kz(stores_2_kz),
        .box_x0(stores_2_box_x0),
        .box_x1(stores_2_box_x1),
        .box_y0(stores_2_box_y0),
        .box_y1(stores_2_box_y1),
        .object_class(stores_2_object_class),
        .shift(stores_2_shift),
        .plane_0_kind(stores_2_plane_0_kind),
        .plane_1_kind(stores_2_plane_1_kind),
        .plane_2_kind(stores_2_plane_2_kind),
        .plane_0_a(stores_2_plane_0_a),
        .plane_1_a(stores_2_plane_1_a),
        .plane_2_a(stores_2_plane_2_a),
        .plane_0_b(stores_2_plane_0_b),
        .plane_1_b(stores_2_plane_1_b),
        .plane_2_b(stores_2_plane_2_b),
        .plane_0_c(stores_2_plane_0_c),
        .plane_1_c(stores_2_plane_1_c),
        .plane_2_c(stores_2_plane_2_c),
        .plane_0_nx(stores_2_plane_0_nx),
        .plane_1_nx(stores_2_plane_1_nx),
        .plane_2_nx(stores_2_plane_2_nx),
        .plane_0_ny(stores_2_plane_0_ny),
        .plane_1_ny(stores_2_plane_1_ny),
        .plane_2_ny(stores_2_plane_2_ny),
        .plane_0_nz(stores_2_plane_0_nz),
        .plane_1_nz(stores_2_plane_1_nz),
        .plane_2_nz(stores_2_plane_2_nz)
    );

    coefficient_store stores_3 (
        .clock(clock),
        .write(stores_3_write),
        .address(load_address),
        .data(load_data),
        .f1_a(stores_3_f1_a),
        .f1_b(stores_3_f1_b),
        .f1_c(stores_3_f1_c),
        .f2_a2(stores_3_f2_a2),
        .f2_b2(stores_3_f2_b2),
        .f2_c(stores_3_f2_c),
        .f2_i0(stores_3_f2_i0),
        .f2_p0(stores_3_f2_p0),
        .f2_f(stores_3_f2_f),
        .gx_a(stores_3_gx_a),
        .gx_b(stores_3_gx_b),
        .gx_c(stores_3_gx_c),
        .gy_a(stores_3_gy_a),
        .gy_b(stores_3_gy_b),
        .gy_c(stores_3_gy_c),
        .gz_a(stores_3_gz_a),
        .gz_b(stores_3_gz_b),
        .gz_c(stores_3_gz_c),
        .kx(stores_3_kx),
        .ky(stores_3_ky),
        .kz(stores_3_kz),
        .box_x0(stores_3_box_x0),
        .box_x1(stores_3_box_x1),
        .box_y0(stores_3_box_y0),
        .box_y1(stores_3_box_y1),
        .object_class(stores_3_object_class),
        .shift(stores_3_shift),
        .plane_0_kind(stores_3_plane_0_kind),
        .plane_1_kind(stores_3_plane_1_kind),
        .plane_2_kind(stores_3_plane_2_kind),
        .plane_0_a(stores_3_plane_0_a),
        .plane_1_a(stores_3_plane_1_a),
        .plane_2_a(stores_3_plane_2_a),
        .plane_0_b(stores_3_plane_0_b),
        .plane_1_b(stores_3_plane_1_b),
        .plane_2_b(stores_3_plane_2_b),
        .plane_0_c(stores_3_plane_0_c),
        .plane_1_c(stores_3_plane_1_c),
        .plane_2_c(stores_3_plane_2_c),
        .plane_0_nx(stores_3_plane_0_nx),
        .plane_1_nx(stores_3_plane_1_nx),
        .plane_2_nx(stores_3_plane_2_nx),
        .plane_0_ny(stores_3_plane_0_ny),
        .plane_1_ny(stores_3_plane_1_ny),
        .plane_2_ny(stores_3_plane_2_ny),
        .plane_0_nz(stores_3_plane_0_nz),
        .plane_1_nz(stores_3_plane_1_nz),
        .plane_2_nz(stores_3_plane_2_nz)
    );

    quadric_processor processors_0 (
        .clock(clock),
        .valid(raster_valid),
        .start(raster_start),
        .line(raster_line),
        .x(raster_x),
        .y(raster_y),
        .f1_a(stores_0_f1_a),
        .f1_b(stores_0_f1_b),
        .f1_c(stores_0_f1_c),
        .f2_a2(stores_0_f2_a2),
        .f2_b2(stores_0_f2_b2),
        .f2_c(stores_0_f2_c),
        .f2_i0(stores_0_f2_i0),
        .f2_p0(stores_0_f2_p0),
        .f2_f(stores_0_f2_f),
        .gx_a(stores_0_gx_a),
        .gx_b(stores_0_gx_b),
        .gx_c(stores_0_gx_c),
        .gy_a(stores_0_gy_a),
        .gy_b(stores_0_gy_b),
        .gy_c(stores_0_gy_c),
        .gz_a(stores_0_gz_a),
        .gz_b(stores_0_gz_b),
        .gz_c(stores_0_gz_c),
        .kx(stores_0_kx),
        .ky(stores_0_ky),
        .kz(stores_0_kz),
        .box_x0(stores_0_box_x0),
        .box_x1(stores_0_box_x1),
        .box_y0(stores_0_box_y0),
        .box_y1(stores_0_box_y1),
        .object_class(stores_0_object_class),
        .shift(stores_0_shift),
        .plane_0_kind(stores_0_plane_0_kind),
        .plane_1_kind(stores_0_plane_1_kind),
        .plane_2_kind(stores_0_plane_2_kind),
        .plane_0_a(stores_0_plane_0_a),
        .plane_1_a(stores_0_plane_1_a),
        .plane_2_a(stores_0_plane_2_a),
        .plane_0_b(stores_0_plane_0_b),
        .plane_1_b(stores_0_plane_1_b),
        .plane_2_b(stores_0_plane_2_b),
        .plane_0_c(stores_0_plane_0_c),
        .plane_1_c(stores_0_plane_1_c),
        .plane_2_c(stores_0_plane_2_c),
        .plane_0_nx(stores_0_plane_0_nx),
        .plane_1_nx(stores_0_plane_1_nx),
        .plane_2_nx(stores_0_plane_2_nx),
        .plane_0_ny(stores_0_plane_0_ny),
        .plane_1_ny(stores_0_plane_1_ny),
        .plane_2_ny(stores_0_plane_2_ny),
        .plane_0_nz(stores_0_plane_0_nz),
        .plane_1_nz(stores_0_plane_1_nz),
        .plane_2_nz(stores_0_plane_2_nz),
        .out_valid(processors_0_out_valid),
        .zf(processors_0_zf),
        .zb(unused_processors_0_zb),
        .number(processors_0_number),
        .nx(processors_0_nx),
        .ny(processors_0_ny),
        .nz(processors_0_nz)
    );

    quadric_processor processors_1 (
        .clock(clock),
        .valid(raster_valid),
        .start(raster_start),
        .line(raster_line),
        .x(raster_x),
        .y(raster_y),
        .f1_a(stores_1_f1_a),
        .f1_b(stores_1_f1_b),
        .f1_c(stores_1_f1_c),
        .f2_a2(stores_1_f2_a2),
        .f2_b2(stores_1_f2_b2),
        .f2_c(stores_1_f2_c),
        .f2_i0(stores_1_f2_i0),
        .f2_p0(stores_1_f2_p0),
        .f2_f(stores_1_f2_f),
        .gx_a(stores_1_gx_a),
        .gx_b(stores_1_gx_b),
        .gx_c(stores_1_gx_c),
        .gy_a(stores_1_gy_a),
        .gy_b(stores_1_gy_b),
        .gy_c(stores_1_gy_c),
        .gz_a(stores_1_gz_a),
        .gz_b(stores_1_gz_b),
        .gz_c(stores_1_gz_c),
        .kx(stores_1_kx),
        .ky(stores_1_ky),
        .kz(stores_1_kz),
        .box_x0(stores_1_box_x0),
        .box_x1(stores_1_box_x1),
        .box_y0(stores_1_box_y0),
        .box_y1(stores_1_box_y1),
        .object_class(stores_1_object_class),
        .shift(stores_1_shift),
        .plane_0_kind(stores_1_plane_0_kind),
        .plane_1_kind(stores_1_plane_1_kind),
        .plane_2_kind(stores_1_plane_2_kind),
        .plane_0_a(stores_1_plane_0_a),
        .plane_1_a(stores_1_plane_1_a),
        .plane_2_a(stores_1_plane_2_a),
        .plane_0_b(stores_1_plane_0_b),
        .plane_1_b(stores_1_plane_1_b),
        .plane_2_b(stores_1_plane_2_b),
        .plane_0_c(stores_1_plane_0_c),
        .plane_1_c(stores_1_plane_1_c),
        .plane_2_c(stores_1_plane_2_c),
        .plane_0_nx(stores_1_plane_0_nx),
        .plane_1_nx(stores_1_plane_1_nx),
        .plane_2_nx(stores_1_plane_2_nx),
        .plane_0_ny(stores_1_plane_0_ny),
        .plane_1_ny(stores_1_plane_1_ny),
        .plane_2_ny(stores_1_plane_2_ny),
        .plane_0_nz(stores_1_plane_0_nz),
        .plane_1_nz(stores_1_plane_1_nz),
        .plane_2_nz(stores_1_plane_2_nz),
        .out_valid(unused_processors_1_out_valid),
        .zf(processors_1_zf),
        .zb(unused_processors_1_zb),
        .number(processors_1_number),
        .nx(processors_1_nx),
        .ny(processors_1_ny),
        .nz(processors_1_nz)
    );

    quadric_processor processors_2 (
        .clock(clock),
        .valid(raster_valid),
        .start(raster_start),
        .line(raster_line),
        .x(raster_x),
        .y(raster_y),
        .f1_a(stores_2_f1_a),
        .f1_b(stores_2_f1_b),
        .f1_c(stores_2_f1_c),
        .f2_a2(stores_2_f2_a2),
        .f2_b2(stores_2_f2_b2),
        .f2_c(stores_2_f2_c),
        .f2_i0(stores_2_f2_i0),
        .f2_p0(stores_2_f2_p0),
        .f2_f(stores_2_f2_f),
        .gx_a(stores_2_gx_a),
        .gx_b(stores_2_gx_b),
        .gx_c(stores_2_gx_c),
        .gy_a(stores_2_gy_a),
        .gy_b(stores_2_gy_b),
        .gy_c(stores_2_gy_c),
        .gz_a(stores_2_gz_a),
        .gz_b(stores_2_gz_b),
        .gz_c(stores_2_gz_c),
        .kx(stores_2_kx),
        .ky(stores_2_ky),
        .kz(stores_2_kz),
        .box_x0(stores_2_box_x0),
        .box_x1(stores_2_box_x1),
        .box_y0(stores_2_box_y0),
        .box_y1(stores_2_box_y1),
        .object_class(stores_2_object_class),
        .shift(stores_2_shift),
        .plane_0_kind(stores_2_plane_0_kind),
        .plane_1_kind(stores_2_plane_1_kind),
        .plane_2_kind(stores_2_plane_2_kind),
        .plane_0_a(stores_2_plane_0_a),
        .plane_1_a(stores_2_plane_1_a),
        .plane_2_a(stores_2_plane_2_a),
        .plane_0_b(stores_2_plane_0_b),
        .plane_1_b(stores_2_plane_1_b),
        .plane_2_b(stores_2_plane_2_b),
        .plane_0_c(stores_2_plane_0_c),
        .plane_1_c(stores_2_plane_1_c),
        .plane_2_c(stores_2_plane_2_c),
        .plane_0_nx(stores_2_plane_0_nx),
        .plane_1_nx(stores_2_plane_1_nx),
        .plane_2_nx(stores_2_plane_2_nx),
        .plane_0_ny(stores_2_plane_0_ny),
        .plane_1_ny(stores_2_plane_1_ny),
        .plane_2_ny(stores_2_plane_2_ny),
        .plane_0_nz(stores_2_plane_0_nz),
        .plane_1_nz(stores_2_plane_1_nz),
        .plane_2_nz(stores_2_plane_2_nz),
        .out_valid(unused_processors_2_out_valid),
        .zf(processors_2_zf),
        .zb(unused_processors_2_zb),
        .number(processors_2_number),
        .nx(processors_2_nx),
        .ny(processors_2_ny),
        .nz(processors_2_nz)
    );

    quadric_processor processors_3 (
        .clock(clock),
        .valid(raster_valid),
        .start(raster_start),
        .line(raster_line),
        .x(raster_x),
        .y(raster_y),
        .f1_a(stores_3_f1_a),
        .f1_b(stores_3_f1_b),
        .f1_c(stores_3_f1_c),
        .f2_a2(stores_3_f2_a2),
        .f2_b2(stores_3_f2_b2),
        .f2_c(stores_3_f2_c),
        .f2_i0(stores_3_f2_i0),
        .f2_p0(stores_3_f2_p0),
        .f2_f(stores_3_f2_f),
        .gx_a(stores_3_gx_a),
        .gx_b(stores_3_gx_b),
        .gx_c(stores_3_gx_c),
        .gy_a(stores_3_gy_a),
        .gy_b(stores_3_gy_b),
        .gy_c(stores_3_gy_c),
        .gz_a(stores_3_gz_a),
        .gz_b(stores_3_gz_b),
        .gz_c(stores_3_gz_c),
        .kx(stores_3_kx),
        .ky(stores_3_ky),
        .kz(stores_3_kz),
        .box_x0(stores_3_box_x0),
        .box_x1(stores_3_box_x1),
        .box_y0(stores_3_box_y0),
        .box_y1(stores_3_box_y1),
        .object_class(stores_3_object_class),
        .shift(stores_3_shift),
        .plane_0_kind(stores_3_plane_0_kind),
        .plane_1_kind(stores_3_plane_1_kind),
        .plane_2_kind(stores_3_plane_2_kind),
        .plane_0_a(stores_3_plane_0_a),
        .plane_1_a(stores_3_plane_1_a),
        .plane_2_a(stores_3_plane_2_a),
        .plane_0_b(stores_3_plane_0_b),
        .plane_1_b(stores_3_plane_1_b),
        .plane_2_b(stores_3_plane_2_b),
        .plane_0_c(stores_3_plane_0_c),
        .plane_1_c(stores_3_plane_1_c),
        .plane_2_c(stores_3_plane_2_c),
        .plane_0_nx(stores_3_plane_0_nx),
        .plane_1_nx(stores_3_plane_1_nx),
        .plane_2_nx(stores_3_plane_2_nx),
        .plane_0_ny(stores_3_plane_0_ny),
        .plane_1_ny(stores_3_plane_1_ny),
        .plane_2_ny(stores_3_plane_2_ny),
        .plane_0_nz(stores_3_plane_0_nz),
        .plane_1_nz(stores_3_plane_1_nz),
        .plane_2_nz(stores_3_plane_2_nz),
        .out_valid(unused_processors_3_out_valid),
        .zf(processors_3_zf),
        .zb(unused_processors_3_zb),
        .number(processors_3_number),
        .nx(processors_3_nx),
        .ny(processors_3_ny),
        .nz(processors_3_nz)
    );

    decider decider (
        .clock(clock),
        .input_0_depth(processors_0_zf),
        .input_1_depth(processors_1_zf),
        .input_2_depth(processors_2_zf),
        .input_3_depth(processors_3_zf),
        .input_0_id(8'd0),
        .input_1_id(8'd1),
        .input_2_id(8'd2),
        .input_3_id(8'd3),
        .input_0_number(processors_0_number),
        .input_1_number(processors_1_number),
        .input_2_number(processors_2_number),
        .input_3_number(processors_3_number),
        .input_0_nx(processors_0_nx),
        .input_1_nx(processors_1_nx),
        .input_2_nx(processors_2_nx),
        .input_3_nx(processors_3_nx),
        .input_0_ny(processors_0_ny),
        .input_1_ny(processors_1_ny),
        .input_2_ny(processors_2_ny),
        .input_3_ny(processors_3_ny),
        .input_0_nz(processors_0_nz),
        .input_1_nz(processors_1_nz),
        .input_2_nz(processors_2_nz),
        .input_3_nz(processors_3_nz),
        .depth(decider_depth),
        .id(decider_id),
        .number(decider_number),
        .nx(decider_nx),
        .ny(decider_ny),
        .nz(decider_nz)
    );

    word_delay_w1_x2 valid_delay (
        .clock(clock),
        .word(processors_0_out_valid),
        .late(valid_delay_late)
    );

    assign stores_0_write = load_valid & (load_object == 8'd0);
    assign stores_1_write = load_valid & (load_object == 8'd1);
    assign stores_2_write = load_valid & (load_object == 8'd2);
    assign stores_3_write = load_valid & (load_object == 8'd3);
    assign valid = valid_delay_late;
    assign depth = decider_depth;
    assign id = decider_id;
    assign number = decider_number;
    assign nx = decider_nx;
    assign ny = decider_ny;
    assign nz = decider_nz;

endmodule
