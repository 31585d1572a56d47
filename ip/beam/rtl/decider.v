// decider: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module decider (
    input  wire clock,
    input  wire signed [23:0] input_0_depth,
    input  wire [7:0] input_0_id,
    input  wire [3:0] input_0_number,
    input  wire signed [15:0] input_0_nx, input_0_ny, input_0_nz,
    input  wire signed [23:0] input_1_depth,
    input  wire [7:0] input_1_id,
    input  wire [3:0] input_1_number,
    input  wire signed [15:0] input_1_nx, input_1_ny, input_1_nz,
    input  wire signed [23:0] input_2_depth,
    input  wire [7:0] input_2_id,
    input  wire [3:0] input_2_number,
    input  wire signed [15:0] input_2_nx, input_2_ny, input_2_nz,
    input  wire signed [23:0] input_3_depth,
    input  wire [7:0] input_3_id,
    input  wire [3:0] input_3_number,
    input  wire signed [15:0] input_3_nx, input_3_ny, input_3_nz,
    output wire signed [23:0] depth,
    output wire [7:0] id,
    output wire [3:0] number,
    output wire signed [15:0] nx, ny, nz
);

    wire signed [23:0] nodes_0_depth, nodes_1_depth;
    wire [7:0] nodes_0_id, nodes_1_id;
    wire [3:0] nodes_0_number, nodes_1_number;
    wire signed [15:0] nodes_0_nx, nodes_0_ny, nodes_0_nz, nodes_1_nx, nodes_1_ny, nodes_1_nz;

    visibility_node nodes_0 (
        .clock(clock), .a_depth(input_0_depth), .a_id(input_0_id), .a_number(input_0_number), .a_nx(input_0_nx),
        .a_ny(input_0_ny), .a_nz(input_0_nz), .b_depth(input_1_depth), .b_id(input_1_id), .b_number(input_1_number),
        .b_nx(input_1_nx), .b_ny(input_1_ny), .b_nz(input_1_nz), .depth(nodes_0_depth), .id(nodes_0_id),
        .number(nodes_0_number), .nx(nodes_0_nx), .ny(nodes_0_ny), .nz(nodes_0_nz));

    visibility_node nodes_1 (
        .clock(clock), .a_depth(input_2_depth), .a_id(input_2_id), .a_number(input_2_number), .a_nx(input_2_nx),
        .a_ny(input_2_ny), .a_nz(input_2_nz), .b_depth(input_3_depth), .b_id(input_3_id), .b_number(input_3_number),
        .b_nx(input_3_nx), .b_ny(input_3_ny), .b_nz(input_3_nz), .depth(nodes_1_depth), .id(nodes_1_id),
        .number(nodes_1_number), .nx(nodes_1_nx), .ny(nodes_1_ny), .nz(nodes_1_nz));

    visibility_node nodes_2 (
        .clock(clock), .a_depth(nodes_0_depth), .a_id(nodes_0_id), .a_number(nodes_0_number), .a_nx(nodes_0_nx),
        .a_ny(nodes_0_ny), .a_nz(nodes_0_nz), .b_depth(nodes_1_depth), .b_id(nodes_1_id), .b_number(nodes_1_number),
        .b_nx(nodes_1_nx), .b_ny(nodes_1_ny), .b_nz(nodes_1_nz), .depth(depth), .id(id), .number(number), .nx(nx),
        .ny(ny), .nz(nz));
endmodule
