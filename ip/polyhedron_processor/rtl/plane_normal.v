// plane_normal: part of polyhedron_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module plane_normal (
    input  wire clock,
    input  wire [3:0] number,
    input  wire signed [15:0] end_nz,
    input  wire signed [15:0] plane_0_nx,
    input  wire signed [15:0] plane_1_nx,
    input  wire signed [15:0] plane_2_nx,
    input  wire signed [15:0] plane_3_nx,
    input  wire signed [15:0] plane_4_nx,
    input  wire signed [15:0] plane_5_nx,
    input  wire signed [15:0] plane_0_ny,
    input  wire signed [15:0] plane_1_ny,
    input  wire signed [15:0] plane_2_ny,
    input  wire signed [15:0] plane_3_ny,
    input  wire signed [15:0] plane_4_ny,
    input  wire signed [15:0] plane_5_ny,
    input  wire signed [15:0] plane_0_nz,
    input  wire signed [15:0] plane_1_nz,
    input  wire signed [15:0] plane_2_nz,
    input  wire signed [15:0] plane_3_nz,
    input  wire signed [15:0] plane_4_nz,
    input  wire signed [15:0] plane_5_nz,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    localparam signed [15:0] zero = 16'sd0;
    localparam [3:0] cap = 4'd15;
    reg signed [15:0] kept_nx = 16'sd0;
    reg signed [15:0] kept_ny = 16'sd0;
    reg signed [15:0] kept_nz = 16'sd0;

    assign nx = kept_nx;
    assign ny = kept_ny;
    assign nz = kept_nz;

    always @(posedge clock) begin
        kept_nx <= zero;
        kept_ny <= zero;
        kept_nz <= zero;
        if (number == cap) begin
            kept_nz <= end_nz;
        end
        if (number == 4'd2) begin
            kept_nx <= plane_0_nx;
            kept_ny <= plane_0_ny;
            kept_nz <= plane_0_nz;
        end
        if (number == 4'd3) begin
            kept_nx <= plane_1_nx;
            kept_ny <= plane_1_ny;
            kept_nz <= plane_1_nz;
        end
        if (number == 4'd4) begin
            kept_nx <= plane_2_nx;
            kept_ny <= plane_2_ny;
            kept_nz <= plane_2_nz;
        end
        if (number == 4'd5) begin
            kept_nx <= plane_3_nx;
            kept_ny <= plane_3_ny;
            kept_nz <= plane_3_nz;
        end
        if (number == 4'd6) begin
            kept_nx <= plane_4_nx;
            kept_ny <= plane_4_ny;
            kept_nz <= plane_4_nz;
        end
        if (number == 4'd7) begin
            kept_nx <= plane_5_nx;
            kept_ny <= plane_5_ny;
            kept_nz <= plane_5_nz;
        end
    end

endmodule
