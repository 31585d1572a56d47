// normal_unit: part of first_generation_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module normal_unit (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire [3:0] number,
    input  wire absent,
    input  wire [23:0] root,
    input  wire [4:0] shift,
    input  wire signed [23:0] gx_a,
    input  wire signed [23:0] gx_b,
    input  wire signed [23:0] gx_c,
    input  wire signed [23:0] gy_a,
    input  wire signed [23:0] gy_b,
    input  wire signed [23:0] gy_c,
    input  wire signed [23:0] gz_a,
    input  wire signed [23:0] gz_b,
    input  wire signed [23:0] gz_c,
    input  wire signed [15:0] kx,
    input  wire signed [15:0] ky,
    input  wire signed [15:0] kz,
    input  wire signed [15:0] plane_0_nx,
    input  wire signed [15:0] plane_1_nx,
    input  wire signed [15:0] plane_0_ny,
    input  wire signed [15:0] plane_1_ny,
    input  wire signed [15:0] plane_0_nz,
    input  wire signed [15:0] plane_1_nz,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    localparam [3:0] near_root = 4'd0;
    localparam [3:0] far_root = 4'd1;
    localparam [3:0] cap = 4'd15;
    localparam signed [15:0] zero = 16'sd0;
    localparam signed [15:0] to_viewer = -16'sd32767;
    wire [23:0] shifted_root;
    wire [14:0] low_root;
    wire [15:0] wide_root;
    wire number_is_near;
    wire number_is_far;
    wire number_is_cap;
    wire flags_late_valid;
    wire flags_late_start;
    wire flags_late_line;
    wire signed [15:0] component_x_result;
    wire signed [15:0] component_y_result;
    wire signed [15:0] component_z_result;
    reg signed [15:0] scaled_root = 16'sd0;
    reg is_near = 1'd0;
    reg is_quadric = 1'd0;
    reg signed [15:0] constant_x = 16'sd0;
    reg signed [15:0] constant_y = 16'sd0;
    reg signed [15:0] constant_z = 16'sd0;
    reg late_is_quadric = 1'd0;
    reg signed [15:0] late_constant_x = 16'sd0;
    reg signed [15:0] late_constant_y = 16'sd0;
    reg signed [15:0] late_constant_z = 16'sd0;

    flag_delay_x3 flags (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .late_valid(flags_late_valid),
        .late_start(flags_late_start),
        .late_line(flags_late_line)
    );

    normal_component component_x (
        .clock(clock),
        .valid(flags_late_valid),
        .start(flags_late_start),
        .line(flags_late_line),
        .a(gx_a),
        .b(gx_b),
        .c(gx_c),
        .k(kx),
        .scaled_root(scaled_root),
        .is_near(is_near),
        .is_quadric(late_is_quadric),
        .fixed(late_constant_x),
        .result(component_x_result)
    );

    normal_component component_y (
        .clock(clock),
        .valid(flags_late_valid),
        .start(flags_late_start),
        .line(flags_late_line),
        .a(gy_a),
        .b(gy_b),
        .c(gy_c),
        .k(ky),
        .scaled_root(scaled_root),
        .is_near(is_near),
        .is_quadric(late_is_quadric),
        .fixed(late_constant_y),
        .result(component_y_result)
    );

    normal_component component_z (
        .clock(clock),
        .valid(flags_late_valid),
        .start(flags_late_start),
        .line(flags_late_line),
        .a(gz_a),
        .b(gz_b),
        .c(gz_c),
        .k(kz),
        .scaled_root(scaled_root),
        .is_near(is_near),
        .is_quadric(late_is_quadric),
        .fixed(late_constant_z),
        .result(component_z_result)
    );

    assign shifted_root = root >> shift;
    assign low_root = shifted_root[14:0];
    assign wide_root = {1'd0, low_root};
    assign number_is_near = number == near_root;
    assign number_is_far = number == far_root;
    assign number_is_cap = number == cap;
    assign nx = component_x_result;
    assign ny = component_y_result;
    assign nz = component_z_result;

    wire unused_bits = &{1'b0, shifted_root[23:15]};

    always @(posedge clock) begin
        scaled_root <= wide_root;
        is_near <= number_is_near;
        is_quadric <= (number_is_near | number_is_far) & ~absent;
        constant_x <= zero;
        constant_y <= zero;
        constant_z <= zero;
        if (~absent) begin
            if (number_is_cap) begin
                constant_z <= to_viewer;
            end
            if (number == 4'd2) begin
                constant_x <= plane_0_nx;
                constant_y <= plane_0_ny;
                constant_z <= plane_0_nz;
            end
            if (number == 4'd3) begin
                constant_x <= plane_1_nx;
                constant_y <= plane_1_ny;
                constant_z <= plane_1_nz;
            end
        end
        late_is_quadric <= is_quadric;
        late_constant_x <= constant_x;
        late_constant_y <= constant_y;
        late_constant_z <= constant_z;
    end

endmodule
