// card_decider: the nearest of the objects of many cards: a chain on each card, a tree between the cards
//
// parameters: format 24
//             objects 4
//             cards 2
// latency:    5 clocks
// error:      exact
// source:     Chaillou 1991, IV.3.6
// ports:
//   in  clock           1 unsigned
//   in  input_0_depth  24 two's complement
//   in  input_1_depth  24 two's complement
//   in  input_2_depth  24 two's complement
//   in  input_3_depth  24 two's complement
//   in  input_4_depth  24 two's complement
//   in  input_5_depth  24 two's complement
//   in  input_6_depth  24 two's complement
//   in  input_7_depth  24 two's complement
//   in  input_0_id      8 unsigned
//   in  input_1_id      8 unsigned
//   in  input_2_id      8 unsigned
//   in  input_3_id      8 unsigned
//   in  input_4_id      8 unsigned
//   in  input_5_id      8 unsigned
//   in  input_6_id      8 unsigned
//   in  input_7_id      8 unsigned
//   in  input_0_number  4 unsigned
//   in  input_1_number  4 unsigned
//   in  input_2_number  4 unsigned
//   in  input_3_number  4 unsigned
//   in  input_4_number  4 unsigned
//   in  input_5_number  4 unsigned
//   in  input_6_number  4 unsigned
//   in  input_7_number  4 unsigned
//   in  input_0_nx     16 two's complement
//   in  input_1_nx     16 two's complement
//   in  input_2_nx     16 two's complement
//   in  input_3_nx     16 two's complement
//   in  input_4_nx     16 two's complement
//   in  input_5_nx     16 two's complement
//   in  input_6_nx     16 two's complement
//   in  input_7_nx     16 two's complement
//   in  input_0_ny     16 two's complement
//   in  input_1_ny     16 two's complement
//   in  input_2_ny     16 two's complement
//   in  input_3_ny     16 two's complement
//   in  input_4_ny     16 two's complement
//   in  input_5_ny     16 two's complement
//   in  input_6_ny     16 two's complement
//   in  input_7_ny     16 two's complement
//   in  input_0_nz     16 two's complement
//   in  input_1_nz     16 two's complement
//   in  input_2_nz     16 two's complement
//   in  input_3_nz     16 two's complement
//   in  input_4_nz     16 two's complement
//   in  input_5_nz     16 two's complement
//   in  input_6_nz     16 two's complement
//   in  input_7_nz     16 two's complement
//   out depth          24 two's complement
//   out id              8 unsigned
//   out number          4 unsigned
//   out nx             16 two's complement
//   out ny             16 two's complement
//   out nz             16 two's complement
//
// Made by: imogene emit card_decider --format 24 --objects 4 --cards 2 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module card_decider (
    input  wire clock,
    input  wire signed [23:0] input_0_depth,
    input  wire signed [23:0] input_1_depth,
    input  wire signed [23:0] input_2_depth,
    input  wire signed [23:0] input_3_depth,
    input  wire signed [23:0] input_4_depth,
    input  wire signed [23:0] input_5_depth,
    input  wire signed [23:0] input_6_depth,
    input  wire signed [23:0] input_7_depth,
    input  wire [7:0] input_0_id,
    input  wire [7:0] input_1_id,
    input  wire [7:0] input_2_id,
    input  wire [7:0] input_3_id,
    input  wire [7:0] input_4_id,
    input  wire [7:0] input_5_id,
    input  wire [7:0] input_6_id,
    input  wire [7:0] input_7_id,
    input  wire [3:0] input_0_number,
    input  wire [3:0] input_1_number,
    input  wire [3:0] input_2_number,
    input  wire [3:0] input_3_number,
    input  wire [3:0] input_4_number,
    input  wire [3:0] input_5_number,
    input  wire [3:0] input_6_number,
    input  wire [3:0] input_7_number,
    input  wire signed [15:0] input_0_nx,
    input  wire signed [15:0] input_1_nx,
    input  wire signed [15:0] input_2_nx,
    input  wire signed [15:0] input_3_nx,
    input  wire signed [15:0] input_4_nx,
    input  wire signed [15:0] input_5_nx,
    input  wire signed [15:0] input_6_nx,
    input  wire signed [15:0] input_7_nx,
    input  wire signed [15:0] input_0_ny,
    input  wire signed [15:0] input_1_ny,
    input  wire signed [15:0] input_2_ny,
    input  wire signed [15:0] input_3_ny,
    input  wire signed [15:0] input_4_ny,
    input  wire signed [15:0] input_5_ny,
    input  wire signed [15:0] input_6_ny,
    input  wire signed [15:0] input_7_ny,
    input  wire signed [15:0] input_0_nz,
    input  wire signed [15:0] input_1_nz,
    input  wire signed [15:0] input_2_nz,
    input  wire signed [15:0] input_3_nz,
    input  wire signed [15:0] input_4_nz,
    input  wire signed [15:0] input_5_nz,
    input  wire signed [15:0] input_6_nz,
    input  wire signed [15:0] input_7_nz,
    output wire signed [23:0] depth,
    output wire [7:0] id,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    wire signed [23:0] chains_0_depth;
    wire [7:0] chains_0_id;
    wire [3:0] chains_0_number;
    wire signed [15:0] chains_0_nx;
    wire signed [15:0] chains_0_ny;
    wire signed [15:0] chains_0_nz;
    wire signed [23:0] chains_1_depth;
    wire [7:0] chains_1_id;
    wire [3:0] chains_1_number;
    wire signed [15:0] chains_1_nx;
    wire signed [15:0] chains_1_ny;
    wire signed [15:0] chains_1_nz;
    wire signed [23:0] decider_depth;
    wire [7:0] decider_id;
    wire [3:0] decider_number;
    wire signed [15:0] decider_nx;
    wire signed [15:0] decider_ny;
    wire signed [15:0] decider_nz;

    visibility_chain chains_0 (
        .clock(clock),
        .input_0_depth(input_0_depth),
        .input_1_depth(input_1_depth),
        .input_2_depth(input_2_depth),
        .input_3_depth(input_3_depth),
        .input_0_id(input_0_id),
        .input_1_id(input_1_id),
        .input_2_id(input_2_id),
        .input_3_id(input_3_id),
        .input_0_number(input_0_number),
        .input_1_number(input_1_number),
        .input_2_number(input_2_number),
        .input_3_number(input_3_number),
        .input_0_nx(input_0_nx),
        .input_1_nx(input_1_nx),
        .input_2_nx(input_2_nx),
        .input_3_nx(input_3_nx),
        .input_0_ny(input_0_ny),
        .input_1_ny(input_1_ny),
        .input_2_ny(input_2_ny),
        .input_3_ny(input_3_ny),
        .input_0_nz(input_0_nz),
        .input_1_nz(input_1_nz),
        .input_2_nz(input_2_nz),
        .input_3_nz(input_3_nz),
        .depth(chains_0_depth),
        .id(chains_0_id),
        .number(chains_0_number),
        .nx(chains_0_nx),
        .ny(chains_0_ny),
        .nz(chains_0_nz)
    );

    visibility_chain chains_1 (
        .clock(clock),
        .input_0_depth(input_4_depth),
        .input_1_depth(input_5_depth),
        .input_2_depth(input_6_depth),
        .input_3_depth(input_7_depth),
        .input_0_id(input_4_id),
        .input_1_id(input_5_id),
        .input_2_id(input_6_id),
        .input_3_id(input_7_id),
        .input_0_number(input_4_number),
        .input_1_number(input_5_number),
        .input_2_number(input_6_number),
        .input_3_number(input_7_number),
        .input_0_nx(input_4_nx),
        .input_1_nx(input_5_nx),
        .input_2_nx(input_6_nx),
        .input_3_nx(input_7_nx),
        .input_0_ny(input_4_ny),
        .input_1_ny(input_5_ny),
        .input_2_ny(input_6_ny),
        .input_3_ny(input_7_ny),
        .input_0_nz(input_4_nz),
        .input_1_nz(input_5_nz),
        .input_2_nz(input_6_nz),
        .input_3_nz(input_7_nz),
        .depth(chains_1_depth),
        .id(chains_1_id),
        .number(chains_1_number),
        .nx(chains_1_nx),
        .ny(chains_1_ny),
        .nz(chains_1_nz)
    );

    decider decider (
        .clock(clock),
        .input_0_depth(chains_0_depth),
        .input_1_depth(chains_1_depth),
        .input_0_id(chains_0_id),
        .input_1_id(chains_1_id),
        .input_0_number(chains_0_number),
        .input_1_number(chains_1_number),
        .input_0_nx(chains_0_nx),
        .input_1_nx(chains_1_nx),
        .input_0_ny(chains_0_ny),
        .input_1_ny(chains_1_ny),
        .input_0_nz(chains_0_nz),
        .input_1_nz(chains_1_nz),
        .depth(decider_depth),
        .id(decider_id),
        .number(decider_number),
        .nx(decider_nx),
        .ny(decider_ny),
        .nz(decider_nz)
    );

    assign depth = decider_depth;
    assign id = decider_id;
    assign number = decider_number;
    assign nx = decider_nx;
    assign ny = decider_ny;
    assign nz = decider_nz;

endmodule
