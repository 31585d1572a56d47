// quadric_processor: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module quadric_processor (
    input  wire clock, valid, start, line,
    input  wire [11:0] x, y,
    input  wire signed [25:0] f1_a, f1_b, f1_c,
    input  wire signed [47:0] f2_a2, f2_b2, f2_c, f2_i0, f2_p0, f2_f,
    input  wire signed [23:0] gx_a, gx_b, gx_c, gy_a, gy_b, gy_c, gz_a, gz_b, gz_c,
    input  wire signed [15:0] kx, ky, kz,
    input  wire [11:0] box_x0, box_x1, box_y0, box_y1,
    input  wire [4:0] shift,
    input  wire [1:0] object_class, plane_0_kind,
    input  wire signed [35:0] plane_0_a, plane_0_b, plane_0_c,
    input  wire signed [15:0] plane_0_nx, plane_0_ny, plane_0_nz,
    input  wire [1:0] plane_1_kind,
    input  wire signed [35:0] plane_1_a, plane_1_b, plane_1_c,
    input  wire signed [15:0] plane_1_nx, plane_1_ny, plane_1_nz,
    input  wire [1:0] plane_2_kind,
    input  wire signed [35:0] plane_2_a, plane_2_b, plane_2_c,
    input  wire signed [15:0] plane_2_nx, plane_2_ny, plane_2_nz,
    output wire out_valid,
    output wire signed [23:0] zf, zb,
    output wire [3:0] number,
    output wire signed [15:0] nx, ny, nz
);

    wire signed [25:0] quadric_near_sum, quadric_far_sum;
    wire [23:0] quadric_root, cut_a_zf [0:3], cut_a_zb [0:3], cut_b_zf [0:3], cut_b_zb [0:3];
    wire quadric_is_inside, quadric_late_valid, quadric_late_start, quadric_late_line, in_box, surface;
    reg [25:0] in_box_late = 26'd0;
    wire signed [23:0] interval_zf_a, interval_zb_a, interval_zf_b, interval_zb_b, planes_0_depth, planes_1_depth,
        planes_2_depth, merge_zf, merge_zb;
    wire [3:0] interval_nf_a, interval_nb_a, interval_nf_b, interval_nb_b, merge_nf, unused_merge_nb, cut_a_nf [0:3],
        cut_a_nb [0:3], cut_b_nf [0:3], cut_b_nb [0:3];
    reg valid_late_1 = 1'd0, start_late_1 = 1'd0, line_late_1 = 1'd0;
    reg [1:0] valid_late = 2'd0, start_late = 2'd0, line_late = 2'd0, valid_late_2 = 2'd0, start_late_2 = 2'd0,
        line_late_2 = 2'd0, valid_late_3 = 2'd0, start_late_3 = 2'd0, line_late_3 = 2'd0;
    reg [23:0] root_late_1 = 24'd0, root_late_2 = 24'd0, root_late_3 = 24'd0, root_late_4 = 24'd0,
        root_late_5 = 24'd0, root_late_6 = 24'd0, root_late_7 = 24'd0, root_late_8 = 24'd0, root_late_9 = 24'd0,
        root_late_10 = 24'd0, root_late_11 = 24'd0;
    reg [5:0] valid_late_4 = 6'd0, start_late_4 = 6'd0, line_late_4 = 6'd0;
    reg [3:0] out_valid_late = 4'd0, number_late_1 = 4'd0, number_late_2 = 4'd0, number_late_3 = 4'd0,
        number_late_4 = 4'd0;
    reg signed [23:0] zf_late_1 = 24'sd0, zf_late_2 = 24'sd0, zf_late_3 = 24'sd0, zf_late_4 = 24'sd0,
        zb_late_1 = 24'sd0, zb_late_2 = 24'sd0, zb_late_3 = 24'sd0, zb_late_4 = 24'sd0;
    wire [5:0] cut_a_kind, cut_b_kind;
    wire [11:0] cut_a_number, cut_b_number;
    wire [71:0] cut_a_zp, cut_b_zp;
    genvar k;

    quadric_pe quadric (
        .clock(clock), .valid(valid), .start(start), .line(line), .f1_a(f1_a), .f1_b(f1_b), .f1_c(f1_c),
        .f2_a2(f2_a2), .f2_b2(f2_b2), .f2_c(f2_c), .f2_i0(f2_i0), .f2_p0(f2_p0), .f2_f(f2_f),
        .near_sum(quadric_near_sum), .far_sum(quadric_far_sum), .root(quadric_root), .is_inside(quadric_is_inside),
        .late_valid(quadric_late_valid), .late_start(quadric_late_start), .late_line(quadric_late_line));

    depth_interval interval (
        .clock(clock), .near_sum(quadric_near_sum), .far_sum(quadric_far_sum), .is_inside(quadric_is_inside),
        .in_box(in_box_late[25]), .object_class(object_class), .zf_a(interval_zf_a), .nf_a(interval_nf_a),
        .zb_a(interval_zb_a), .nb_a(interval_nb_a), .zf_b(interval_zf_b), .nf_b(interval_nf_b), .zb_b(interval_zb_b),
        .nb_b(interval_nb_b));

    plane_depth planes_0 (
        .clock(clock), .valid(valid_late[1]), .start(start_late[1]), .line(line_late[1]), .a(plane_0_a),
        .b(plane_0_b), .c(plane_0_c), .depth(planes_0_depth));

    plane_depth planes_1 (
        .clock(clock), .valid(valid_late_2[1]), .start(start_late_2[1]), .line(line_late_2[1]), .a(plane_1_a),
        .b(plane_1_b), .c(plane_1_c), .depth(planes_1_depth));

    plane_depth planes_2 (
        .clock(clock), .valid(valid_late_3[1]), .start(start_late_3[1]), .line(line_late_3[1]), .a(plane_2_a),
        .b(plane_2_b), .c(plane_2_c), .depth(planes_2_depth));

    assign cut_a_kind = {plane_2_kind, plane_1_kind, plane_0_kind};
    assign cut_a_number = {4'd4, 4'd3, 4'd2};
    assign cut_a_zp = {planes_2_depth, planes_1_depth, planes_0_depth};
    assign cut_a_zf[0] = interval_zf_a;
    assign cut_a_nf[0] = interval_nf_a;
    assign cut_a_zb[0] = interval_zb_a;
    assign cut_a_nb[0] = interval_nb_a;
    for (k = 0; k < 3; k = k + 1) begin : cut_a
        cut_plane one (
            .clock(clock), .kind(cut_a_kind[2 * k +: 2]), .surface(surface), .number(cut_a_number[4 * k +: 4]),
            .zp(cut_a_zp[24 * k +: 24]), .zf(cut_a_zf[k]), .nf(cut_a_nf[k]), .zb(cut_a_zb[k]), .nb(cut_a_nb[k]),
            .cut_zf(cut_a_zf[k + 1]), .cut_nf(cut_a_nf[k + 1]), .cut_zb(cut_a_zb[k + 1]), .cut_nb(cut_a_nb[k + 1]));
    end

    assign cut_b_kind = {plane_2_kind, plane_1_kind, plane_0_kind};
    assign cut_b_number = {4'd4, 4'd3, 4'd2};
    assign cut_b_zp = {planes_2_depth, planes_1_depth, planes_0_depth};
    assign cut_b_zf[0] = interval_zf_b;
    assign cut_b_nf[0] = interval_nf_b;
    assign cut_b_zb[0] = interval_zb_b;
    assign cut_b_nb[0] = interval_nb_b;
    for (k = 0; k < 3; k = k + 1) begin : cut_b
        cut_plane one (
            .clock(clock), .kind(cut_b_kind[2 * k +: 2]), .surface(surface), .number(cut_b_number[4 * k +: 4]),
            .zp(cut_b_zp[24 * k +: 24]), .zf(cut_b_zf[k]), .nf(cut_b_nf[k]), .zb(cut_b_zb[k]), .nb(cut_b_nb[k]),
            .cut_zf(cut_b_zf[k + 1]), .cut_nf(cut_b_nf[k + 1]), .cut_zb(cut_b_zb[k + 1]), .cut_nb(cut_b_nb[k + 1]));
    end

    two_volume_merge merge (
        .clock(clock), .zf_a(cut_a_zf[3]), .nf_a(cut_a_nf[3]), .zb_a(cut_a_zb[3]), .nb_a(cut_a_nb[3]),
        .zf_b(cut_b_zf[3]), .nf_b(cut_b_nf[3]), .zb_b(cut_b_zb[3]), .nb_b(cut_b_nb[3]), .zf(merge_zf), .nf(merge_nf),
        .zb(merge_zb), .nb(unused_merge_nb));

    normal_unit normal (
        .clock(clock), .valid(valid_late_4[5]), .start(start_late_4[5]), .line(line_late_4[5]), .number(merge_nf),
        .absent(merge_zf == 24'sd8388607), .root(root_late_11), .shift(shift), .gx_a(gx_a), .gx_b(gx_b), .gx_c(gx_c),
        .gy_a(gy_a), .gy_b(gy_b), .gy_c(gy_c), .gz_a(gz_a), .gz_b(gz_b), .gz_c(gz_c), .kx(kx), .ky(ky), .kz(kz),
        .plane_0_nx(plane_0_nx), .plane_0_ny(plane_0_ny), .plane_0_nz(plane_0_nz), .plane_1_nx(plane_1_nx),
        .plane_1_ny(plane_1_ny), .plane_1_nz(plane_1_nz), .plane_2_nx(plane_2_nx), .plane_2_ny(plane_2_ny),
        .plane_2_nz(plane_2_nz), .nx(nx), .ny(ny), .nz(nz));

    assign in_box = (((x >= box_x0) & (box_x1 >= x)) & (y >= box_y0)) & (box_y1 >= y);
    assign surface = object_class == 2'd2;
    assign out_valid = out_valid_late[3];
    assign zf = zf_late_4;
    assign zb = zb_late_4;
    assign number = number_late_4;

    always @(posedge clock) begin
        in_box_late <= {in_box_late[24:0], in_box};
        valid_late_1 <= quadric_late_valid;
        start_late_1 <= quadric_late_start;
        line_late_1 <= quadric_late_line;
        valid_late <= {valid_late[0], valid_late_1};
        start_late <= {start_late[0], start_late_1};
        line_late <= {line_late[0], line_late_1};
        valid_late_2 <= {valid_late_2[0], valid_late[1]};
        start_late_2 <= {start_late_2[0], start_late[1]};
        line_late_2 <= {line_late_2[0], line_late[1]};
        valid_late_3 <= {valid_late_3[0], valid_late_2[1]};
        start_late_3 <= {start_late_3[0], start_late_2[1]};
        line_late_3 <= {line_late_3[0], line_late_2[1]};
        root_late_1 <= quadric_root;
        root_late_2 <= root_late_1;
        root_late_3 <= root_late_2;
        root_late_4 <= root_late_3;
        root_late_5 <= root_late_4;
        root_late_6 <= root_late_5;
        root_late_7 <= root_late_6;
        root_late_8 <= root_late_7;
        root_late_9 <= root_late_8;
        root_late_10 <= root_late_9;
        root_late_11 <= root_late_10;
        valid_late_4 <= {valid_late_4[4:0], valid_late_3[1]};
        start_late_4 <= {start_late_4[4:0], start_late_3[1]};
        line_late_4 <= {line_late_4[4:0], line_late_3[1]};
        out_valid_late <= {out_valid_late[2:0], valid_late_4[5]};
        zf_late_1 <= merge_zf;
        zf_late_2 <= zf_late_1;
        zf_late_3 <= zf_late_2;
        zf_late_4 <= zf_late_3;
        zb_late_1 <= merge_zb;
        zb_late_2 <= zb_late_1;
        zb_late_3 <= zb_late_2;
        zb_late_4 <= zb_late_3;
        number_late_1 <= merge_nf;
        number_late_2 <= number_late_1;
        number_late_3 <= number_late_2;
        number_late_4 <= number_late_3;
    end
endmodule
