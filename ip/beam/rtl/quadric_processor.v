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
    wire [23:0] quadric_root, shifted_root;
    wire quadric_is_inside, quadric_early_valid, quadric_early_start, quadric_early_line, in_box, planes_0_removed,
        planes_1_removed, planes_2_removed, nodes_0_removed, registers_0_removed, nodes_1_removed;
    reg [25:0] in_box_late = 26'd0;
    wire signed [23:0] planes_0_front, planes_0_back, planes_1_front, planes_1_back, planes_2_front, planes_2_back,
        nodes_0_front, nodes_0_back, registers_0_front, registers_0_back, nodes_1_front, nodes_1_back, cut_zf, cut_zb;
    wire [3:0] nodes_0_front_number, nodes_0_back_number, registers_0_front_number, registers_0_back_number,
        nodes_1_front_number, nodes_1_back_number, cut_number;
    reg [7:0] valid_late = 8'd0, start_late = 8'd0, line_late = 8'd0;
    reg [14:0] scaled_root_1 = 15'd0, scaled_root_2 = 15'd0, scaled_root_3 = 15'd0, scaled_root_4 = 15'd0,
        scaled_root_5 = 15'd0;
    reg [3:0] out_valid_late = 4'd0, number_late_1 = 4'd0, number_late_2 = 4'd0, number_late_3 = 4'd0,
        number_late_4 = 4'd0;
    reg signed [23:0] zf_late_1 = 24'sd0, zf_late_2 = 24'sd0, zf_late_3 = 24'sd0, zf_late_4 = 24'sd0,
        zb_late_1 = 24'sd0, zb_late_2 = 24'sd0, zb_late_3 = 24'sd0, zb_late_4 = 24'sd0;

    quadric_pe quadric (
        .clock(clock), .valid(valid), .start(start), .line(line), .f1_a(f1_a), .f1_b(f1_b), .f1_c(f1_c),
        .f2_a2(f2_a2), .f2_b2(f2_b2), .f2_c(f2_c), .f2_i0(f2_i0), .f2_p0(f2_p0), .f2_f(f2_f),
        .near_sum(quadric_near_sum), .far_sum(quadric_far_sum), .root(quadric_root), .is_inside(quadric_is_inside),
        .early_valid(quadric_early_valid), .early_start(quadric_early_start), .early_line(quadric_early_line));

    plane_limits planes_0 (
        .clock(clock), .valid(quadric_early_valid), .start(quadric_early_start), .line(quadric_early_line),
        .kind(plane_0_kind), .a(plane_0_a), .b(plane_0_b), .c(plane_0_c), .front(planes_0_front),
        .back(planes_0_back), .removed(planes_0_removed));

    plane_limits planes_1 (
        .clock(clock), .valid(quadric_early_valid), .start(quadric_early_start), .line(quadric_early_line),
        .kind(plane_1_kind), .a(plane_1_a), .b(plane_1_b), .c(plane_1_c), .front(planes_1_front),
        .back(planes_1_back), .removed(planes_1_removed));

    plane_limits planes_2 (
        .clock(clock), .valid(quadric_early_valid), .start(quadric_early_start), .line(quadric_early_line),
        .kind(plane_2_kind), .a(plane_2_a), .b(plane_2_b), .c(plane_2_c), .front(planes_2_front),
        .back(planes_2_back), .removed(planes_2_removed));

    half_space_node nodes_0 (
        .clock(clock), .a_front(planes_0_front), .a_front_number(4'd2), .a_back(planes_0_back), .a_back_number(4'd2),
        .a_removed(planes_0_removed), .b_front(planes_1_front), .b_front_number(4'd3), .b_back(planes_1_back),
        .b_back_number(4'd3), .b_removed(planes_1_removed), .front(nodes_0_front),
        .front_number(nodes_0_front_number), .back(nodes_0_back), .back_number(nodes_0_back_number),
        .removed(nodes_0_removed));

    half_space_register registers_0 (
        .clock(clock), .a_front(planes_2_front), .a_front_number(4'd4), .a_back(planes_2_back), .a_back_number(4'd4),
        .a_removed(planes_2_removed), .front(registers_0_front), .front_number(registers_0_front_number),
        .back(registers_0_back), .back_number(registers_0_back_number), .removed(registers_0_removed));

    half_space_node nodes_1 (
        .clock(clock), .a_front(nodes_0_front), .a_front_number(nodes_0_front_number), .a_back(nodes_0_back),
        .a_back_number(nodes_0_back_number), .a_removed(nodes_0_removed), .b_front(registers_0_front),
        .b_front_number(registers_0_front_number), .b_back(registers_0_back), .b_back_number(registers_0_back_number),
        .b_removed(registers_0_removed), .front(nodes_1_front), .front_number(nodes_1_front_number),
        .back(nodes_1_back), .back_number(nodes_1_back_number), .removed(nodes_1_removed));

    quadric_cut cut (
        .clock(clock), .near_sum(quadric_near_sum), .far_sum(quadric_far_sum), .is_inside(quadric_is_inside),
        .in_box(in_box_late[25]), .object_class(object_class), .front(nodes_1_front),
        .front_number(nodes_1_front_number), .back(nodes_1_back), .back_number(nodes_1_back_number),
        .removed(nodes_1_removed), .zf(cut_zf), .zb(cut_zb), .number(cut_number));

    normal_unit normal (
        .clock(clock), .valid(valid_late[7]), .start(start_late[7]), .line(line_late[7]), .number(cut_number),
        .absent(cut_zf == 24'sd8388607), .scaled_root(scaled_root_5), .gx_a(gx_a), .gx_b(gx_b), .gx_c(gx_c),
        .gy_a(gy_a), .gy_b(gy_b), .gy_c(gy_c), .gz_a(gz_a), .gz_b(gz_b), .gz_c(gz_c), .kx(kx), .ky(ky), .kz(kz),
        .plane_0_nx(plane_0_nx), .plane_0_ny(plane_0_ny), .plane_0_nz(plane_0_nz), .plane_1_nx(plane_1_nx),
        .plane_1_ny(plane_1_ny), .plane_1_nz(plane_1_nz), .plane_2_nx(plane_2_nx), .plane_2_ny(plane_2_ny),
        .plane_2_nz(plane_2_nz), .nx(nx), .ny(ny), .nz(nz));

    assign in_box = (((x >= box_x0) & (box_x1 >= x)) & (y >= box_y0)) & (box_y1 >= y);
    assign shifted_root = quadric_root >> shift;
    assign out_valid = out_valid_late[3];
    assign zf = zf_late_4;
    assign zb = zb_late_4;
    assign number = number_late_4;
    wire unused = &{1'b0, shifted_root[23:15]};

    always @(posedge clock) begin
        in_box_late <= {in_box_late[24:0], in_box};
        valid_late <= {valid_late[6:0], quadric_early_valid};
        start_late <= {start_late[6:0], quadric_early_start};
        line_late <= {line_late[6:0], quadric_early_line};
        scaled_root_1 <= shifted_root[14:0];
        scaled_root_2 <= scaled_root_1;
        scaled_root_3 <= scaled_root_2;
        scaled_root_4 <= scaled_root_3;
        scaled_root_5 <= scaled_root_4;
        out_valid_late <= {out_valid_late[2:0], valid_late[7]};
        zf_late_1 <= cut_zf;
        zf_late_2 <= zf_late_1;
        zf_late_3 <= zf_late_2;
        zf_late_4 <= zf_late_3;
        zb_late_1 <= cut_zb;
        zb_late_2 <= zb_late_1;
        zb_late_3 <= zb_late_2;
        zb_late_4 <= zb_late_3;
        number_late_1 <= cut_number;
        number_late_2 <= number_late_1;
        number_late_3 <= number_late_2;
        number_late_4 <= number_late_3;
    end
endmodule
