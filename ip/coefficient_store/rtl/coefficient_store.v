// coefficient_store: the coefficient words of one object, loaded over a bus
//
// parameters: format 24
//             planes 3
// latency:    1 clock
// error:      exact
// source:     architecture, 7
// ports:
//   in  clock           1 unsigned
//   in  write           1 unsigned
//   in  address         8 unsigned
//   in  data           48 unsigned
//   out f1_a           26 two's complement
//   out f1_b           26 two's complement
//   out f1_c           26 two's complement
//   out f2_a2          48 two's complement
//   out f2_b2          48 two's complement
//   out f2_c           48 two's complement
//   out f2_i0          48 two's complement
//   out f2_p0          48 two's complement
//   out f2_f           48 two's complement
//   out gx_a           24 two's complement
//   out gx_b           24 two's complement
//   out gx_c           24 two's complement
//   out gy_a           24 two's complement
//   out gy_b           24 two's complement
//   out gy_c           24 two's complement
//   out gz_a           24 two's complement
//   out gz_b           24 two's complement
//   out gz_c           24 two's complement
//   out kx             16 two's complement
//   out ky             16 two's complement
//   out kz             16 two's complement
//   out box_x0         12 unsigned
//   out box_x1         12 unsigned
//   out box_y0         12 unsigned
//   out box_y1         12 unsigned
//   out object_class    2 unsigned
//   out shift           5 unsigned
//   out plane_0_kind    2 unsigned
//   out plane_1_kind    2 unsigned
//   out plane_2_kind    2 unsigned
//   out plane_0_a      36 two's complement
//   out plane_1_a      36 two's complement
//   out plane_2_a      36 two's complement
//   out plane_0_b      36 two's complement
//   out plane_1_b      36 two's complement
//   out plane_2_b      36 two's complement
//   out plane_0_c      36 two's complement
//   out plane_1_c      36 two's complement
//   out plane_2_c      36 two's complement
//   out plane_0_nx     16 two's complement
//   out plane_1_nx     16 two's complement
//   out plane_2_nx     16 two's complement
//   out plane_0_ny     16 two's complement
//   out plane_1_ny     16 two's complement
//   out plane_2_ny     16 two's complement
//   out plane_0_nz     16 two's complement
//   out plane_1_nz     16 two's complement
//   out plane_2_nz     16 two's complement
//
// Made by: imogene emit coefficient_store --format 24 --planes 3 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module coefficient_store (
    input  wire clock,
    input  wire write,
    input  wire [7:0] address,
    input  wire [47:0] data,
    output wire signed [25:0] f1_a,
    output wire signed [25:0] f1_b,
    output wire signed [25:0] f1_c,
    output wire signed [47:0] f2_a2,
    output wire signed [47:0] f2_b2,
    output wire signed [47:0] f2_c,
    output wire signed [47:0] f2_i0,
    output wire signed [47:0] f2_p0,
    output wire signed [47:0] f2_f,
    output wire signed [23:0] gx_a,
    output wire signed [23:0] gx_b,
    output wire signed [23:0] gx_c,
    output wire signed [23:0] gy_a,
    output wire signed [23:0] gy_b,
    output wire signed [23:0] gy_c,
    output wire signed [23:0] gz_a,
    output wire signed [23:0] gz_b,
    output wire signed [23:0] gz_c,
    output wire signed [15:0] kx,
    output wire signed [15:0] ky,
    output wire signed [15:0] kz,
    output wire [11:0] box_x0,
    output wire [11:0] box_x1,
    output wire [11:0] box_y0,
    output wire [11:0] box_y1,
    output wire [1:0] object_class,
    output wire [4:0] shift,
    output wire [1:0] plane_0_kind,
    output wire [1:0] plane_1_kind,
    output wire [1:0] plane_2_kind,
    output wire signed [35:0] plane_0_a,
    output wire signed [35:0] plane_1_a,
    output wire signed [35:0] plane_2_a,
    output wire signed [35:0] plane_0_b,
    output wire signed [35:0] plane_1_b,
    output wire signed [35:0] plane_2_b,
    output wire signed [35:0] plane_0_c,
    output wire signed [35:0] plane_1_c,
    output wire signed [35:0] plane_2_c,
    output wire signed [15:0] plane_0_nx,
    output wire signed [15:0] plane_1_nx,
    output wire signed [15:0] plane_2_nx,
    output wire signed [15:0] plane_0_ny,
    output wire signed [15:0] plane_1_ny,
    output wire signed [15:0] plane_2_ny,
    output wire signed [15:0] plane_0_nz,
    output wire signed [15:0] plane_1_nz,
    output wire signed [15:0] plane_2_nz
);

    localparam [7:0] at_box_columns = 8'd21;
    localparam [7:0] at_box_lines = 8'd22;
    localparam [7:0] at_control = 8'd23;
    reg signed [25:0] kept_f1_a = 26'sd0;
    reg signed [25:0] kept_f1_b = 26'sd0;
    reg signed [25:0] kept_f1_c = 26'sd0;
    reg signed [47:0] kept_f2_a2 = 48'sd0;
    reg signed [47:0] kept_f2_b2 = 48'sd0;
    reg signed [47:0] kept_f2_c = 48'sd0;
    reg signed [47:0] kept_f2_i0 = 48'sd0;
    reg signed [47:0] kept_f2_p0 = 48'sd0;
    reg signed [47:0] kept_f2_f = 48'sd0;
    reg signed [23:0] kept_gx_a = 24'sd0;
    reg signed [23:0] kept_gx_b = 24'sd0;
    reg signed [23:0] kept_gx_c = 24'sd0;
    reg signed [23:0] kept_gy_a = 24'sd0;
    reg signed [23:0] kept_gy_b = 24'sd0;
    reg signed [23:0] kept_gy_c = 24'sd0;
    reg signed [23:0] kept_gz_a = 24'sd0;
    reg signed [23:0] kept_gz_b = 24'sd0;
    reg signed [23:0] kept_gz_c = 24'sd0;
    reg signed [15:0] kept_kx = 16'sd0;
    reg signed [15:0] kept_ky = 16'sd0;
    reg signed [15:0] kept_kz = 16'sd0;
    reg [11:0] inverted_box_x0 = 12'd0;
    reg [11:0] kept_box_x1 = 12'd0;
    reg [11:0] kept_box_y0 = 12'd0;
    reg [11:0] kept_box_y1 = 12'd0;
    reg [1:0] kept_object_class = 2'd0;
    reg [4:0] kept_shift = 5'd0;
    reg [1:0] kept_plane_kind_0 = 2'd0;
    reg [1:0] kept_plane_kind_1 = 2'd0;
    reg [1:0] kept_plane_kind_2 = 2'd0;
    reg signed [35:0] kept_plane_a_0 = 36'sd0;
    reg signed [35:0] kept_plane_a_1 = 36'sd0;
    reg signed [35:0] kept_plane_a_2 = 36'sd0;
    reg signed [35:0] kept_plane_b_0 = 36'sd0;
    reg signed [35:0] kept_plane_b_1 = 36'sd0;
    reg signed [35:0] kept_plane_b_2 = 36'sd0;
    reg signed [35:0] kept_plane_c_0 = 36'sd0;
    reg signed [35:0] kept_plane_c_1 = 36'sd0;
    reg signed [35:0] kept_plane_c_2 = 36'sd0;
    reg signed [15:0] kept_plane_nx_0 = 16'sd0;
    reg signed [15:0] kept_plane_nx_1 = 16'sd0;
    reg signed [15:0] kept_plane_nx_2 = 16'sd0;
    reg signed [15:0] kept_plane_ny_0 = 16'sd0;
    reg signed [15:0] kept_plane_ny_1 = 16'sd0;
    reg signed [15:0] kept_plane_ny_2 = 16'sd0;
    reg signed [15:0] kept_plane_nz_0 = 16'sd0;
    reg signed [15:0] kept_plane_nz_1 = 16'sd0;
    reg signed [15:0] kept_plane_nz_2 = 16'sd0;

    assign f1_a = kept_f1_a;
    assign f1_b = kept_f1_b;
    assign f1_c = kept_f1_c;
    assign f2_a2 = kept_f2_a2;
    assign f2_b2 = kept_f2_b2;
    assign f2_c = kept_f2_c;
    assign f2_i0 = kept_f2_i0;
    assign f2_p0 = kept_f2_p0;
    assign f2_f = kept_f2_f;
    assign gx_a = kept_gx_a;
    assign gx_b = kept_gx_b;
    assign gx_c = kept_gx_c;
    assign gy_a = kept_gy_a;
    assign gy_b = kept_gy_b;
    assign gy_c = kept_gy_c;
    assign gz_a = kept_gz_a;
    assign gz_b = kept_gz_b;
    assign gz_c = kept_gz_c;
    assign kx = kept_kx;
    assign ky = kept_ky;
    assign kz = kept_kz;
    assign box_x0 = ~inverted_box_x0;
    assign box_x1 = kept_box_x1;
    assign box_y0 = kept_box_y0;
    assign box_y1 = kept_box_y1;
    assign object_class = kept_object_class;
    assign shift = kept_shift;
    assign plane_0_kind = kept_plane_kind_0;
    assign plane_1_kind = kept_plane_kind_1;
    assign plane_2_kind = kept_plane_kind_2;
    assign plane_0_a = kept_plane_a_0;
    assign plane_1_a = kept_plane_a_1;
    assign plane_2_a = kept_plane_a_2;
    assign plane_0_b = kept_plane_b_0;
    assign plane_1_b = kept_plane_b_1;
    assign plane_2_b = kept_plane_b_2;
    assign plane_0_c = kept_plane_c_0;
    assign plane_1_c = kept_plane_c_1;
    assign plane_2_c = kept_plane_c_2;
    assign plane_0_nx = kept_plane_nx_0;
    assign plane_1_nx = kept_plane_nx_1;
    assign plane_2_nx = kept_plane_nx_2;
    assign plane_0_ny = kept_plane_ny_0;
    assign plane_1_ny = kept_plane_ny_1;
    assign plane_2_ny = kept_plane_ny_2;
    assign plane_0_nz = kept_plane_nz_0;
    assign plane_1_nz = kept_plane_nz_1;
    assign plane_2_nz = kept_plane_nz_2;

    always @(posedge clock) begin
        if (write) begin
            if (address == 8'd0) begin
                kept_f1_a <= data[25:0];
            end
            if (address == 8'd1) begin
                kept_f1_b <= data[25:0];
            end
            if (address == 8'd2) begin
                kept_f1_c <= data[25:0];
            end
            if (address == 8'd3) begin
                kept_f2_a2 <= data;
            end
            if (address == 8'd4) begin
                kept_f2_b2 <= data;
            end
            if (address == 8'd5) begin
                kept_f2_c <= data;
            end
            if (address == 8'd6) begin
                kept_f2_i0 <= data;
            end
            if (address == 8'd7) begin
                kept_f2_p0 <= data;
            end
            if (address == 8'd8) begin
                kept_f2_f <= data;
            end
            if (address == 8'd9) begin
                kept_gx_a <= data[23:0];
            end
            if (address == 8'd10) begin
                kept_gx_b <= data[23:0];
            end
            if (address == 8'd11) begin
                kept_gx_c <= data[23:0];
            end
            if (address == 8'd12) begin
                kept_gy_a <= data[23:0];
            end
            if (address == 8'd13) begin
                kept_gy_b <= data[23:0];
            end
            if (address == 8'd14) begin
                kept_gy_c <= data[23:0];
            end
            if (address == 8'd15) begin
                kept_gz_a <= data[23:0];
            end
            if (address == 8'd16) begin
                kept_gz_b <= data[23:0];
            end
            if (address == 8'd17) begin
                kept_gz_c <= data[23:0];
            end
            if (address == 8'd18) begin
                kept_kx <= data[15:0];
            end
            if (address == 8'd19) begin
                kept_ky <= data[15:0];
            end
            if (address == 8'd20) begin
                kept_kz <= data[15:0];
            end
            if (address == at_box_columns) begin
                inverted_box_x0 <= ~data[11:0];
                kept_box_x1 <= data[23:12];
            end
            if (address == at_box_lines) begin
                kept_box_y0 <= data[11:0];
                kept_box_y1 <= data[23:12];
            end
            if (address == at_control) begin
                kept_object_class <= data[1:0];
                kept_shift <= data[6:2];
            end
            if (address == 8'd24) begin
                kept_plane_kind_0 <= data[1:0];
            end
            if (address == 8'd25) begin
                kept_plane_a_0 <= data[35:0];
            end
            if (address == 8'd26) begin
                kept_plane_b_0 <= data[35:0];
            end
            if (address == 8'd27) begin
                kept_plane_c_0 <= data[35:0];
            end
            if (address == 8'd28) begin
                kept_plane_nx_0 <= data[15:0];
            end
            if (address == 8'd29) begin
                kept_plane_ny_0 <= data[15:0];
            end
            if (address == 8'd30) begin
                kept_plane_nz_0 <= data[15:0];
            end
            if (address == 8'd31) begin
                kept_plane_kind_1 <= data[1:0];
            end
            if (address == 8'd32) begin
                kept_plane_a_1 <= data[35:0];
            end
            if (address == 8'd33) begin
                kept_plane_b_1 <= data[35:0];
            end
            if (address == 8'd34) begin
                kept_plane_c_1 <= data[35:0];
            end
            if (address == 8'd35) begin
                kept_plane_nx_1 <= data[15:0];
            end
            if (address == 8'd36) begin
                kept_plane_ny_1 <= data[15:0];
            end
            if (address == 8'd37) begin
                kept_plane_nz_1 <= data[15:0];
            end
            if (address == 8'd38) begin
                kept_plane_kind_2 <= data[1:0];
            end
            if (address == 8'd39) begin
                kept_plane_a_2 <= data[35:0];
            end
            if (address == 8'd40) begin
                kept_plane_b_2 <= data[35:0];
            end
            if (address == 8'd41) begin
                kept_plane_c_2 <= data[35:0];
            end
            if (address == 8'd42) begin
                kept_plane_nx_2 <= data[15:0];
            end
            if (address == 8'd43) begin
                kept_plane_ny_2 <= data[15:0];
            end
            if (address == 8'd44) begin
                kept_plane_nz_2 <= data[15:0];
            end
        end
    end

endmodule
