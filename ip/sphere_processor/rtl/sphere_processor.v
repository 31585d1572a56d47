// sphere_processor: depth and normal of a sphere with exact outline and a paraboloid for the depth
//
// parameters: format 24
// latency:    4 clocks
// error:      exact in its integer words; against a sphere of radius R: outline exact, depth +29.5 % of R at the
//             outline, -4.5 % at most inside, 5.1 % RMS
// source:     Chaillou 1991, IV.2.4
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
//   in  outline_a2     48 two's complement
//   in  outline_b2     48 two's complement
//   in  outline_c      48 two's complement
//   in  outline_i0     48 two's complement
//   in  outline_p0     48 two's complement
//   in  outline_f      48 two's complement
//   in  front_a2       48 two's complement
//   in  front_b2       48 two's complement
//   in  front_c        48 two's complement
//   in  front_i0       48 two's complement
//   in  front_p0       48 two's complement
//   in  front_f        48 two's complement
//   in  depth_sum      26 two's complement
//   in  nx_a           24 two's complement
//   in  nx_b           24 two's complement
//   in  nx_c           24 two's complement
//   in  ny_a           24 two's complement
//   in  ny_b           24 two's complement
//   in  ny_c           24 two's complement
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
// Made by: imogene emit sphere_processor --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module sphere_processor (
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
    input  wire signed [47:0] outline_a2,
    input  wire signed [47:0] outline_b2,
    input  wire signed [47:0] outline_c,
    input  wire signed [47:0] outline_i0,
    input  wire signed [47:0] outline_p0,
    input  wire signed [47:0] outline_f,
    input  wire signed [47:0] front_a2,
    input  wire signed [47:0] front_b2,
    input  wire signed [47:0] front_c,
    input  wire signed [47:0] front_i0,
    input  wire signed [47:0] front_p0,
    input  wire signed [47:0] front_f,
    input  wire signed [25:0] depth_sum,
    input  wire signed [23:0] nx_a,
    input  wire signed [23:0] nx_b,
    input  wire signed [23:0] nx_c,
    input  wire signed [23:0] ny_a,
    input  wire signed [23:0] ny_b,
    input  wire signed [23:0] ny_c,
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

    localparam [3:0] cap = 4'd15;
    localparam signed [15:0] no_normal = 16'sd0;
    localparam signed [15:0] to_viewer = -16'sd32767;
    wire signed [25:0] near_depth;
    wire screen_box_in_box;
    wire in_box_late;
    wire signed [47:0] outline_value;
    wire signed [47:0] front_value;
    wire interval_is_present;
    wire signed [23:0] interval_zf;
    wire signed [23:0] interval_zb;
    wire [3:0] interval_number;
    wire normal_flags_late_valid;
    wire normal_flags_late_start;
    wire normal_flags_late_line;
    wire signed [23:0] normal_x_value;
    wire signed [23:0] normal_y_value;
    wire signed [47:0] normal_z_value;
    wire valid_delay_late;
    reg signed [25:0] kept_near = 26'sd0;
    reg signed [25:0] kept_far = 26'sd0;
    reg kept_there = 1'd0;
    reg signed [23:0] late_zf = 24'sd0;
    reg signed [23:0] late_zb = 24'sd0;
    reg [3:0] late_number = 4'd0;
    reg late_present = 1'd0;
    reg signed [23:0] kept_zf = 24'sd0;
    reg signed [23:0] kept_zb = 24'sd0;
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

    pe2 outline (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(outline_a2),
        .b2(outline_b2),
        .c(outline_c),
        .p0(outline_p0),
        .i0(outline_i0),
        .f(outline_f),
        .value(outline_value)
    );

    pe2 front (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(front_a2),
        .b2(front_b2),
        .c(front_c),
        .p0(front_p0),
        .i0(front_i0),
        .f(front_f),
        .value(front_value)
    );

    side_interval interval (
        .near_sum(kept_near),
        .far_sum(kept_far),
        .is_there(kept_there),
        .is_present(interval_is_present),
        .zf(interval_zf),
        .zb(interval_zb),
        .number(interval_number)
    );

    flag_delay normal_flags (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .late_valid(normal_flags_late_valid),
        .late_start(normal_flags_late_start),
        .late_line(normal_flags_late_line)
    );

    pe1 normal_x (
        .clock(clock),
        .valid(normal_flags_late_valid),
        .start(normal_flags_late_start),
        .line(normal_flags_late_line),
        .a(nx_a),
        .b(nx_b),
        .c(nx_c),
        .value(normal_x_value)
    );

    pe1 normal_y (
        .clock(clock),
        .valid(normal_flags_late_valid),
        .start(normal_flags_late_start),
        .line(normal_flags_late_line),
        .a(ny_a),
        .b(ny_b),
        .c(ny_c),
        .value(normal_y_value)
    );

    pe2 normal_z (
        .clock(clock),
        .valid(normal_flags_late_valid),
        .start(normal_flags_late_start),
        .line(normal_flags_late_line),
        .a2(nz_a2),
        .b2(nz_b2),
        .c(nz_c),
        .p0(nz_p0),
        .i0(nz_i0),
        .f(nz_f),
        .value(normal_z_value)
    );

    word_delay_x4 valid_delay (
        .clock(clock),
        .word(valid),
        .late(valid_delay_late)
    );

    assign near_depth = front_value[47:22];
    assign out_valid = valid_delay_late;
    assign zf = kept_zf;
    assign zb = kept_zb;
    assign number = kept_number;
    assign nx = kept_nx;
    assign ny = kept_ny;
    assign nz = kept_nz;

    wire unused_bits = &{1'b0, outline_value[46:0], front_value[21:0], normal_x_value[7:0], normal_y_value[7:0], normal_z_value[31:0]};

    always @(posedge clock) begin
        kept_near <= near_depth;
        kept_far <= depth_sum - near_depth;
        kept_there <= in_box_late & ~outline_value[47];
        late_zf <= interval_zf;
        late_zb <= interval_zb;
        late_number <= interval_number;
        late_present <= interval_is_present;
        kept_zf <= late_zf;
        kept_zb <= late_zb;
        kept_number <= late_number;
        kept_nx <= no_normal;
        kept_ny <= no_normal;
        kept_nz <= no_normal;
        if (late_present) begin
            kept_nx <= normal_x_value[23:8];
            kept_ny <= normal_y_value[23:8];
            kept_nz <= normal_z_value[47:32];
            if (late_number == cap) begin
                kept_nx <= no_normal;
                kept_ny <= no_normal;
                kept_nz <= to_viewer;
            end
        end
    end

endmodule
