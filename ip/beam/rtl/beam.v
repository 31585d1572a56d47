// beam: the visible surface of many quadric objects, pixel by pixel
//
// parameters: format 24
//             planes 3
//             rows per stage 1
//             objects 4
// latency:    38 clocks
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
    input  wire clock, go,
    input  wire [11:0] width, height,
    input  wire load_valid,
    input  wire [7:0] load_object, load_address,
    input  wire [47:0] load_data,
    output wire valid,
    output wire signed [23:0] depth,
    output wire [7:0] id,
    output wire [3:0] number,
    output wire signed [15:0] nx, ny, nz
);

    wire raster_valid, raster_start, raster_line, unused_raster_last, processors_out_valid [0:3];
    wire [11:0] raster_x, raster_y, stores_box_x0 [0:3], stores_box_x1 [0:3], stores_box_y0 [0:3],
        stores_box_y1 [0:3];
    reg [1:0] valid_late = 2'd0;
    wire [3:0] stores_write, processors_number [0:3];
    wire [25:0] stores_f1_a [0:3], stores_f1_b [0:3], stores_f1_c [0:3];
    wire [47:0] stores_f2_a2 [0:3], stores_f2_b2 [0:3], stores_f2_c [0:3], stores_f2_i0 [0:3], stores_f2_p0 [0:3],
        stores_f2_f [0:3];
    wire [23:0] stores_gx_a [0:3], stores_gx_b [0:3], stores_gx_c [0:3], stores_gy_a [0:3], stores_gy_b [0:3],
        stores_gy_c [0:3], stores_gz_a [0:3], stores_gz_b [0:3], stores_gz_c [0:3], processors_zf [0:3],
        processors_zb [0:3];
    wire [15:0] stores_kx [0:3], stores_ky [0:3], stores_kz [0:3], stores_plane_0_nx [0:3], stores_plane_0_ny [0:3],
        stores_plane_0_nz [0:3], stores_plane_1_nx [0:3], stores_plane_1_ny [0:3], stores_plane_1_nz [0:3],
        stores_plane_2_nx [0:3], stores_plane_2_ny [0:3], stores_plane_2_nz [0:3], processors_nx [0:3],
        processors_ny [0:3], processors_nz [0:3];
    wire [4:0] stores_shift [0:3];
    wire [1:0] stores_object_class [0:3], stores_plane_0_kind [0:3], stores_plane_1_kind [0:3],
        stores_plane_2_kind [0:3];
    wire [35:0] stores_plane_0_a [0:3], stores_plane_0_b [0:3], stores_plane_0_c [0:3], stores_plane_1_a [0:3],
        stores_plane_1_b [0:3], stores_plane_1_c [0:3], stores_plane_2_a [0:3], stores_plane_2_b [0:3],
        stores_plane_2_c [0:3];
    genvar k;

    raster_control raster (
        .clock(clock), .go(go), .width(width), .height(height), .valid(raster_valid), .start(raster_start),
        .line(raster_line), .x(raster_x), .y(raster_y), .last(unused_raster_last));

    assign stores_write = {load_valid & (load_object == 8'd3), load_valid & (load_object == 8'd2),
        load_valid & (load_object == 8'd1), load_valid & (load_object == 8'd0)};
    for (k = 0; k < 4; k = k + 1) begin : stores
        coefficient_store store (
            .clock(clock), .write(stores_write[k]), .address(load_address), .data(load_data), .f1_a(stores_f1_a[k]),
            .f1_b(stores_f1_b[k]), .f1_c(stores_f1_c[k]), .f2_a2(stores_f2_a2[k]), .f2_b2(stores_f2_b2[k]),
            .f2_c(stores_f2_c[k]), .f2_i0(stores_f2_i0[k]), .f2_p0(stores_f2_p0[k]), .f2_f(stores_f2_f[k]),
            .gx_a(stores_gx_a[k]), .gx_b(stores_gx_b[k]), .gx_c(stores_gx_c[k]), .gy_a(stores_gy_a[k]),
            .gy_b(stores_gy_b[k]), .gy_c(stores_gy_c[k]), .gz_a(stores_gz_a[k]), .gz_b(stores_gz_b[k]),
            .gz_c(stores_gz_c[k]), .kx(stores_kx[k]), .ky(stores_ky[k]), .kz(stores_kz[k]), .box_x0(stores_box_x0[k]),
            .box_x1(stores_box_x1[k]), .box_y0(stores_box_y0[k]), .box_y1(stores_box_y1[k]), .shift(stores_shift[k]),
            .object_class(stores_object_class[k]), .plane_0_kind(stores_plane_0_kind[k]),
            .plane_0_a(stores_plane_0_a[k]), .plane_0_b(stores_plane_0_b[k]), .plane_0_c(stores_plane_0_c[k]),
            .plane_0_nx(stores_plane_0_nx[k]), .plane_0_ny(stores_plane_0_ny[k]), .plane_0_nz(stores_plane_0_nz[k]),
            .plane_1_kind(stores_plane_1_kind[k]), .plane_1_a(stores_plane_1_a[k]), .plane_1_b(stores_plane_1_b[k]),
            .plane_1_c(stores_plane_1_c[k]), .plane_1_nx(stores_plane_1_nx[k]), .plane_1_ny(stores_plane_1_ny[k]),
            .plane_1_nz(stores_plane_1_nz[k]), .plane_2_kind(stores_plane_2_kind[k]), .plane_2_a(stores_plane_2_a[k]),
            .plane_2_b(stores_plane_2_b[k]), .plane_2_c(stores_plane_2_c[k]), .plane_2_nx(stores_plane_2_nx[k]),
            .plane_2_ny(stores_plane_2_ny[k]), .plane_2_nz(stores_plane_2_nz[k]));
    end

    for (k = 0; k < 4; k = k + 1) begin : processors
        quadric_processor processor (
            .clock(clock), .valid(raster_valid), .start(raster_start), .line(raster_line), .x(raster_x), .y(raster_y),
            .f1_a(stores_f1_a[k]), .f1_b(stores_f1_b[k]), .f1_c(stores_f1_c[k]), .f2_a2(stores_f2_a2[k]),
            .f2_b2(stores_f2_b2[k]), .f2_c(stores_f2_c[k]), .f2_i0(stores_f2_i0[k]), .f2_p0(stores_f2_p0[k]),
            .f2_f(stores_f2_f[k]), .gx_a(stores_gx_a[k]), .gx_b(stores_gx_b[k]), .gx_c(stores_gx_c[k]),
            .gy_a(stores_gy_a[k]), .gy_b(stores_gy_b[k]), .gy_c(stores_gy_c[k]), .gz_a(stores_gz_a[k]),
            .gz_b(stores_gz_b[k]), .gz_c(stores_gz_c[k]), .kx(stores_kx[k]), .ky(stores_ky[k]), .kz(stores_kz[k]),
            .box_x0(stores_box_x0[k]), .box_x1(stores_box_x1[k]), .box_y0(stores_box_y0[k]),
            .box_y1(stores_box_y1[k]), .shift(stores_shift[k]), .object_class(stores_object_class[k]),
            .plane_0_kind(stores_plane_0_kind[k]), .plane_0_a(stores_plane_0_a[k]), .plane_0_b(stores_plane_0_b[k]),
            .plane_0_c(stores_plane_0_c[k]), .plane_0_nx(stores_plane_0_nx[k]), .plane_0_ny(stores_plane_0_ny[k]),
            .plane_0_nz(stores_plane_0_nz[k]), .plane_1_kind(stores_plane_1_kind[k]), .plane_1_a(stores_plane_1_a[k]),
            .plane_1_b(stores_plane_1_b[k]), .plane_1_c(stores_plane_1_c[k]), .plane_1_nx(stores_plane_1_nx[k]),
            .plane_1_ny(stores_plane_1_ny[k]), .plane_1_nz(stores_plane_1_nz[k]),
            .plane_2_kind(stores_plane_2_kind[k]), .plane_2_a(stores_plane_2_a[k]), .plane_2_b(stores_plane_2_b[k]),
            .plane_2_c(stores_plane_2_c[k]), .plane_2_nx(stores_plane_2_nx[k]), .plane_2_ny(stores_plane_2_ny[k]),
            .plane_2_nz(stores_plane_2_nz[k]), .out_valid(processors_out_valid[k]), .zf(processors_zf[k]),
            .zb(processors_zb[k]), .number(processors_number[k]), .nx(processors_nx[k]), .ny(processors_ny[k]),
            .nz(processors_nz[k]));
    end

    decider decider (
        .clock(clock), .input_0_depth(processors_zf[0]), .input_0_id(8'd0), .input_0_number(processors_number[0]),
        .input_0_nx(processors_nx[0]), .input_0_ny(processors_ny[0]), .input_0_nz(processors_nz[0]),
        .input_1_depth(processors_zf[1]), .input_1_id(8'd1), .input_1_number(processors_number[1]),
        .input_1_nx(processors_nx[1]), .input_1_ny(processors_ny[1]), .input_1_nz(processors_nz[1]),
        .input_2_depth(processors_zf[2]), .input_2_id(8'd2), .input_2_number(processors_number[2]),
        .input_2_nx(processors_nx[2]), .input_2_ny(processors_ny[2]), .input_2_nz(processors_nz[2]),
        .input_3_depth(processors_zf[3]), .input_3_id(8'd3), .input_3_number(processors_number[3]),
        .input_3_nx(processors_nx[3]), .input_3_ny(processors_ny[3]), .input_3_nz(processors_nz[3]), .depth(depth),
        .id(id), .number(number), .nx(nx), .ny(ny), .nz(nz));

    assign valid = valid_late[1];
    wire unused = &{1'b0, processors_zb[0], processors_out_valid[1], processors_zb[1], processors_out_valid[2], processors_zb[2], processors_out_valid[3], processors_zb[3]};

    always @(posedge clock) begin
        valid_late <= {valid_late[0], processors_out_valid[0]};
    end
endmodule
