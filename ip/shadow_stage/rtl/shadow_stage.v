// shadow_stage: which light sources reach the visible point, from the answers of the shadow and light volumes
//
// parameters: format 24
//             objects 4
// latency:    1 clock
// error:      exact
// source:     Chaillou 1991, IV.3.4; Nyiri 1994, 4.1.3
// ports:
//   in  clock           1 unsigned
//   in  flags_in       16 unsigned
//   in  volume_0_inside  1 unsigned
//   in  volume_1_inside  1 unsigned
//   in  volume_2_inside  1 unsigned
//   in  volume_3_inside  1 unsigned
//   in  volume_0_kind   1 unsigned
//   in  volume_1_kind   1 unsigned
//   in  volume_2_kind   1 unsigned
//   in  volume_3_kind   1 unsigned
//   in  volume_0_source  4 unsigned
//   in  volume_1_source  4 unsigned
//   in  volume_2_source  4 unsigned
//   in  volume_3_source  4 unsigned
//   in  volume_0_enabled  1 unsigned
//   in  volume_1_enabled  1 unsigned
//   in  volume_2_enabled  1 unsigned
//   in  volume_3_enabled  1 unsigned
//   out flags          16 unsigned
//
// Made by: imogene emit shadow_stage --format 24 --objects 4 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module shadow_stage (
    input  wire clock,
    input  wire [15:0] flags_in,
    input  wire volume_0_inside,
    input  wire volume_1_inside,
    input  wire volume_2_inside,
    input  wire volume_3_inside,
    input  wire volume_0_kind,
    input  wire volume_1_kind,
    input  wire volume_2_kind,
    input  wire volume_3_kind,
    input  wire [3:0] volume_0_source,
    input  wire [3:0] volume_1_source,
    input  wire [3:0] volume_2_source,
    input  wire [3:0] volume_3_source,
    input  wire volume_0_enabled,
    input  wire volume_1_enabled,
    input  wire volume_2_enabled,
    input  wire volume_3_enabled,
    output wire [15:0] flags
);

    localparam [15:0] one = 16'd1;
    localparam [15:0] unchanged = 16'd65535;
    wire takes_0_away;
    wire takes_1_away;
    wire takes_2_away;
    wire takes_3_away;
    wire [15:0] mask_0;
    wire [15:0] mask_1;
    wire [15:0] mask_2;
    wire [15:0] mask_3;
    wire [15:0] branch_0;
    wire [15:0] branch_1;
    wire [15:0] branch_2;
    wire [15:0] branch_3;
    wire [15:0] joined_0;
    wire [15:0] joined_1;
    wire [15:0] joined_2;
    wire [15:0] joined_3;
    reg [15:0] kept_0 = 16'd0;

    assign takes_0_away = volume_0_enabled & (volume_0_inside ^ volume_0_kind);
    assign takes_1_away = volume_1_enabled & (volume_1_inside ^ volume_1_kind);
    assign takes_2_away = volume_2_enabled & (volume_2_inside ^ volume_2_kind);
    assign takes_3_away = volume_3_enabled & (volume_3_inside ^ volume_3_kind);
    assign mask_0 = one << volume_0_source;
    assign mask_1 = one << volume_1_source;
    assign mask_2 = one << volume_2_source;
    assign mask_3 = one << volume_3_source;
    assign branch_0 = takes_0_away ? ~mask_0 : unchanged;
    assign branch_1 = takes_1_away ? ~mask_1 : unchanged;
    assign branch_2 = takes_2_away ? ~mask_2 : unchanged;
    assign branch_3 = takes_3_away ? ~mask_3 : unchanged;
    assign joined_0 = flags_in & branch_0;
    assign joined_1 = joined_0 & branch_1;
    assign joined_2 = joined_1 & branch_2;
    assign joined_3 = joined_2 & branch_3;
    assign flags = kept_0;

    always @(posedge clock) begin
        kept_0 <= joined_3;
    end

endmodule
