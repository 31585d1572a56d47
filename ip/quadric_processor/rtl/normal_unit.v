// normal_unit: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module normal_unit (
    input  wire clock, valid, start, line,
    input  wire [3:0] number,
    input  wire absent,
    input  wire [14:0] scaled_root,
    input  wire signed [23:0] gx_a, gx_b, gx_c, gy_a, gy_b, gy_c, gz_a, gz_b, gz_c,
    input  wire signed [15:0] kx, ky, kz, plane_0_nx, plane_0_ny, plane_0_nz, plane_1_nx, plane_1_ny, plane_1_nz,
        plane_2_nx, plane_2_ny, plane_2_nz,
    output wire signed [15:0] nx, ny, nz
);

    reg [1:0] valid_late = 2'd0, start_late = 2'd0, line_late = 2'd0, is_quadric_kept = 2'd0;
    wire signed [15:0] scaled_root_2;
    wire test_5, test_4, test_3, test_2, test, is_quadric;
    reg signed [15:0] signed_root = 16'sd0, constant_nx_late_1 = 16'sd0, constant_ny_late_1 = 16'sd0,
        constant_nz_late_1 = 16'sd0, fixed_nx_late_1 = 16'sd0, fixed_nx_late_2 = 16'sd0, fixed_ny_late_1 = 16'sd0,
        fixed_ny_late_2 = 16'sd0, fixed_nz_late_1 = 16'sd0, fixed_nz_late_2 = 16'sd0;
    reg is_absent = 1'd0, is_root = 1'd0;

    normal_component component_x (
        .clock(clock), .valid(valid_late[1]), .start(start_late[1]), .line(line_late[1]), .a(gx_a), .b(gx_b),
        .c(gx_c), .k(kx), .signed_root(signed_root), .is_quadric(is_quadric), .fixed(fixed_nx_late_2), .result(nx));

    normal_component component_y (
        .clock(clock), .valid(valid_late[1]), .start(start_late[1]), .line(line_late[1]), .a(gy_a), .b(gy_b),
        .c(gy_c), .k(ky), .signed_root(signed_root), .is_quadric(is_quadric), .fixed(fixed_ny_late_2), .result(ny));

    normal_component component_z (
        .clock(clock), .valid(valid_late[1]), .start(start_late[1]), .line(line_late[1]), .a(gz_a), .b(gz_b),
        .c(gz_c), .k(kz), .signed_root(signed_root), .is_quadric(is_quadric), .fixed(fixed_nz_late_2), .result(nz));

    assign scaled_root_2 = {1'd0, scaled_root};
    assign test_5 = number == 4'd0;
    assign test_4 = number == 4'd2;
    assign test_3 = number == 4'd3;
    assign test_2 = number == 4'd4;
    assign test = number == 4'd15;
    assign is_quadric = is_quadric_kept[1];

    always @(posedge clock) begin
        valid_late <= {valid_late[0], valid};
        start_late <= {start_late[0], start};
        line_late <= {line_late[0], line};
        signed_root <= test_5 ? (16'sd0 - scaled_root_2) : scaled_root_2;
        is_absent <= absent;
        is_root <= test_5 | (number == 4'd1);
        constant_nx_late_1 <= test ? 16'sd0 : test_2 ? plane_2_nx : test_3 ? plane_1_nx : test_4 ? plane_0_nx : 16'sd0;
        constant_ny_late_1 <= test ? 16'sd0 : test_2 ? plane_2_ny : test_3 ? plane_1_ny : test_4 ? plane_0_ny : 16'sd0;
        constant_nz_late_1 <= test ? -16'sd32767 : test_2 ? plane_2_nz : test_3 ? plane_1_nz : test_4 ? plane_0_nz : 16'sd0;
        fixed_nx_late_1 <= is_absent ? 16'sd0 : constant_nx_late_1;
        fixed_nx_late_2 <= fixed_nx_late_1;
        fixed_ny_late_1 <= is_absent ? 16'sd0 : constant_ny_late_1;
        fixed_ny_late_2 <= fixed_ny_late_1;
        fixed_nz_late_1 <= is_absent ? 16'sd0 : constant_nz_late_1;
        fixed_nz_late_2 <= fixed_nz_late_1;
        is_quadric_kept <= {is_quadric_kept[0], is_root & ~is_absent};
    end
endmodule
