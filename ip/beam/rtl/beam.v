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

    wire raster_valid, raster_start, raster_line, unused_raster_last;
    wire [11:0] raster_x, raster_y;
    reg [1:0] valid_late = 2'd0;
    wire [3:0] stores_write, processors_out_valid;
    wire [103:0] stores_f1_a, stores_f1_b, stores_f1_c;
    wire [191:0] stores_f2_a2, stores_f2_b2, stores_f2_c, stores_f2_i0, stores_f2_p0, stores_f2_f;
    wire [95:0] stores_gx_a, stores_gx_b, stores_gx_c, stores_gy_a, stores_gy_b, stores_gy_c, stores_gz_a,
        stores_gz_b, stores_gz_c, processors_zf, processors_zb;
    wire [63:0] stores_kx, stores_ky, stores_kz, stores_plane_0_nx, stores_plane_0_ny, stores_plane_0_nz,
        stores_plane_1_nx, stores_plane_1_ny, stores_plane_1_nz, stores_plane_2_nx, stores_plane_2_ny,
        stores_plane_2_nz, processors_nx, processors_ny, processors_nz;
    wire [47:0] stores_box_x0, stores_box_x1, stores_box_y0, stores_box_y1;
    wire [19:0] stores_shift;
    wire [7:0] stores_object_class, stores_plane_0_kind, stores_plane_1_kind, stores_plane_2_kind;
    wire [143:0] stores_plane_0_a, stores_plane_0_b, stores_plane_0_c, stores_plane_1_a, stores_plane_1_b,
        stores_plane_1_c, stores_plane_2_a, stores_plane_2_b, stores_plane_2_c;
    wire [15:0] processors_number;
    genvar k;

    raster_control raster (
        .clock(clock), .go(go), .width(width), .height(height), .valid(raster_valid), .start(raster_start),
        .line(raster_line), .x(raster_x), .y(raster_y), .last(unused_raster_last));

    assign stores_write = {load_valid & (load_object == 8'd3), load_valid & (load_object == 8'd2),
        load_valid & (load_object == 8'd1), load_valid & (load_object == 8'd0)};
    for (k = 0; k < 4; k = k + 1) begin : stores
        coefficient_store store (
            .clock(clock), .write(stores_write[k]), .address(load_address), .data(load_data),
            .f1_a(stores_f1_a[26 * k +: 26]), .f1_b(stores_f1_b[26 * k +: 26]), .f1_c(stores_f1_c[26 * k +: 26]),
            .f2_a2(stores_f2_a2[48 * k +: 48]), .f2_b2(stores_f2_b2[48 * k +: 48]), .f2_c(stores_f2_c[48 * k +: 48]),
            .f2_i0(stores_f2_i0[48 * k +: 48]), .f2_p0(stores_f2_p0[48 * k +: 48]), .f2_f(stores_f2_f[48 * k +: 48]),
            .gx_a(stores_gx_a[24 * k +: 24]), .gx_b(stores_gx_b[24 * k +: 24]), .gx_c(stores_gx_c[24 * k +: 24]),
            .gy_a(stores_gy_a[24 * k +: 24]), .gy_b(stores_gy_b[24 * k +: 24]), .gy_c(stores_gy_c[24 * k +: 24]),
            .gz_a(stores_gz_a[24 * k +: 24]), .gz_b(stores_gz_b[24 * k +: 24]), .gz_c(stores_gz_c[24 * k +: 24]),
            .kx(stores_kx[16 * k +: 16]), .ky(stores_ky[16 * k +: 16]), .kz(stores_kz[16 * k +: 16]),
            .box_x0(stores_box_x0[12 * k +: 12]), .box_x1(stores_box_x1[12 * k +: 12]),
            .box_y0(stores_box_y0[12 * k +: 12]), .box_y1(stores_box_y1[12 * k +: 12]),
            .shift(stores_shift[5 * k +: 5]), .object_class(stores_object_class[2 * k +: 2]),
            .plane_0_kind(stores_plane_0_kind[2 * k +: 2]), .plane_0_a(stores_plane_0_a[36 * k +: 36]),
            .plane_0_b(stores_plane_0_b[36 * k +: 36]), .plane_0_c(stores_plane_0_c[36 * k +: 36]),
            .plane_0_nx(stores_plane_0_nx[16 * k +: 16]), .plane_0_ny(stores_plane_0_ny[16 * k +: 16]),
            .plane_0_nz(stores_plane_0_nz[16 * k +: 16]), .plane_1_kind(stores_plane_1_kind[2 * k +: 2]),
            .plane_1_a(stores_plane_1_a[36 * k +: 36]), .plane_1_b(stores_plane_1_b[36 * k +: 36]),
            .plane_1_c(stores_plane_1_c[36 * k +: 36]), .plane_1_nx(stores_plane_1_nx[16 * k +: 16]),
            .plane_1_ny(stores_plane_1_ny[16 * k +: 16]), .plane_1_nz(stores_plane_1_nz[16 * k +: 16]),
            .plane_2_kind(stores_plane_2_kind[2 * k +: 2]), .plane_2_a(stores_plane_2_a[36 * k +: 36]),
            .plane_2_b(stores_plane_2_b[36 * k +: 36]), .plane_2_c(stores_plane_2_c[36 * k +: 36]),
            .plane_2_nx(stores_plane_2_nx[16 * k +: 16]), .plane_2_ny(stores_plane_2_ny[16 * k +: 16]),
            .plane_2_nz(stores_plane_2_nz[16 * k +: 16]));
    end

    for (k = 0; k < 4; k = k + 1) begin : processors
        quadric_processor processor (
            .clock(clock), .valid(raster_valid), .start(raster_start), .line(raster_line), .x(raster_x), .y(raster_y),
            .f1_a(stores_f1_a[26 * k +: 26]), .f1_b(stores_f1_b[26 * k +: 26]), .f1_c(stores_f1_c[26 * k +: 26]),
            .f2_a2(stores_f2_a2[48 * k +: 48]), .f2_b2(stores_f2_b2[48 * k +: 48]), .f2_c(stores_f2_c[48 * k +: 48]),
            .f2_i0(stores_f2_i0[48 * k +: 48]), .f2_p0(stores_f2_p0[48 * k +: 48]), .f2_f(stores_f2_f[48 * k +: 48]),
            .gx_a(stores_gx_a[24 * k +: 24]), .gx_b(stores_gx_b[24 * k +: 24]), .gx_c(stores_gx_c[24 * k +: 24]),
            .gy_a(stores_gy_a[24 * k +: 24]), .gy_b(stores_gy_b[24 * k +: 24]), .gy_c(stores_gy_c[24 * k +: 24]),
            .gz_a(stores_gz_a[24 * k +: 24]), .gz_b(stores_gz_b[24 * k +: 24]), .gz_c(stores_gz_c[24 * k +: 24]),
            .kx(stores_kx[16 * k +: 16]), .ky(stores_ky[16 * k +: 16]), .kz(stores_kz[16 * k +: 16]),
            .box_x0(stores_box_x0[12 * k +: 12]), .box_x1(stores_box_x1[12 * k +: 12]),
            .box_y0(stores_box_y0[12 * k +: 12]), .box_y1(stores_box_y1[12 * k +: 12]),
            .shift(stores_shift[5 * k +: 5]), .object_class(stores_object_class[2 * k +: 2]),
            .plane_0_kind(stores_plane_0_kind[2 * k +: 2]), .plane_0_a(stores_plane_0_a[36 * k +: 36]),
            .plane_0_b(stores_plane_0_b[36 * k +: 36]), .plane_0_c(stores_plane_0_c[36 * k +: 36]),
            .plane_0_nx(stores_plane_0_nx[16 * k +: 16]), .plane_0_ny(stores_plane_0_ny[16 * k +: 16]),
            .plane_0_nz(stores_plane_0_nz[16 * k +: 16]), .plane_1_kind(stores_plane_1_kind[2 * k +: 2]),
            .plane_1_a(stores_plane_1_a[36 * k +: 36]), .plane_1_b(stores_plane_1_b[36 * k +: 36]),
            .plane_1_c(stores_plane_1_c[36 * k +: 36]), .plane_1_nx(stores_plane_1_nx[16 * k +: 16]),
            .plane_1_ny(stores_plane_1_ny[16 * k +: 16]), .plane_1_nz(stores_plane_1_nz[16 * k +: 16]),
            .plane_2_kind(stores_plane_2_kind[2 * k +: 2]), .plane_2_a(stores_plane_2_a[36 * k +: 36]),
            .plane_2_b(stores_plane_2_b[36 * k +: 36]), .plane_2_c(stores_plane_2_c[36 * k +: 36]),
            .plane_2_nx(stores_plane_2_nx[16 * k +: 16]), .plane_2_ny(stores_plane_2_ny[16 * k +: 16]),
            .plane_2_nz(stores_plane_2_nz[16 * k +: 16]), .out_valid(processors_out_valid[k]),
            .zf(processors_zf[24 * k +: 24]), .zb(processors_zb[24 * k +: 24]),
            .number(processors_number[4 * k +: 4]), .nx(processors_nx[16 * k +: 16]),
            .ny(processors_ny[16 * k +: 16]), .nz(processors_nz[16 * k +: 16]));
    end

    decider decider (
        .clock(clock), .input_0_depth(processors_zf[23:0]), .input_0_id(8'd0),
        .input_0_number(processors_number[3:0]), .input_0_nx(processors_nx[15:0]), .input_0_ny(processors_ny[15:0]),
        .input_0_nz(processors_nz[15:0]), .input_1_depth(processors_zf[47:24]), .input_1_id(8'd1),
        .input_1_number(processors_number[7:4]), .input_1_nx(processors_nx[31:16]), .input_1_ny(processors_ny[31:16]),
        .input_1_nz(processors_nz[31:16]), .input_2_depth(processors_zf[71:48]), .input_2_id(8'd2),
        .input_2_number(processors_number[11:8]), .input_2_nx(processors_nx[47:32]),
        .input_2_ny(processors_ny[47:32]), .input_2_nz(processors_nz[47:32]), .input_3_depth(processors_zf[95:72]),
        .input_3_id(8'd3), .input_3_number(processors_number[15:12]), .input_3_nx(processors_nx[63:48]),
        .input_3_ny(processors_ny[63:48]), .input_3_nz(processors_nz[63:48]), .depth(depth), .id(id), .number(number),
        .nx(nx), .ny(ny), .nz(nz));

    assign valid = valid_late[1];
    wire unused = &{1'b0, processors_zb[23:0], processors_out_valid[1], processors_zb[47:24], processors_out_valid[2], processors_zb[71:48], processors_out_valid[3], processors_zb[95:72]};

    always @(posedge clock) begin
        valid_late <= {valid_late[0], processors_out_valid[0]};
    end
endmodule
