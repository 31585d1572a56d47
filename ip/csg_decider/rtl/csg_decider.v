// csg_decider: the visible face of a union of products: convex objects intersected, others taken away
//
// parameters: format 24
//             products 2
//             intersected 2
//             subtracted 2
// latency:    5 clocks
// error:      exact
// source:     Chaillou 1991, III.1.1.4 and IV.3.5
// ports:
//   in  clock           1 unsigned
//   in  intersected_0_zf 24 two's complement
//   in  intersected_1_zf 24 two's complement
//   in  intersected_2_zf 24 two's complement
//   in  intersected_3_zf 24 two's complement
//   in  intersected_0_zb 24 two's complement
//   in  intersected_1_zb 24 two's complement
//   in  intersected_2_zb 24 two's complement
//   in  intersected_3_zb 24 two's complement
//   in  intersected_0_id  8 unsigned
//   in  intersected_1_id  8 unsigned
//   in  intersected_2_id  8 unsigned
//   in  intersected_3_id  8 unsigned
//   in  intersected_0_number  4 unsigned
//   in  intersected_1_number  4 unsigned
//   in  intersected_2_number  4 unsigned
//   in  intersected_3_number  4 unsigned
//   in  subtracted_0_zf 24 two's complement
//   in  subtracted_1_zf 24 two's complement
//   in  subtracted_2_zf 24 two's complement
//   in  subtracted_3_zf 24 two's complement
//   in  subtracted_0_zb 24 two's complement
//   in  subtracted_1_zb 24 two's complement
//   in  subtracted_2_zb 24 two's complement
//   in  subtracted_3_zb 24 two's complement
//   in  subtracted_0_id  8 unsigned
//   in  subtracted_1_id  8 unsigned
//   in  subtracted_2_id  8 unsigned
//   in  subtracted_3_id  8 unsigned
//   in  subtracted_0_number  4 unsigned
//   in  subtracted_1_number  4 unsigned
//   in  subtracted_2_number  4 unsigned
//   in  subtracted_3_number  4 unsigned
//   out depth          24 two's complement
//   out id              8 unsigned
//   out number          4 unsigned
//   out is_back         1 unsigned
//
// Made by: imogene emit csg_decider --format 24 --products 2 --intersected 2 --subtracted 2 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module csg_decider (
    input  wire clock,
    input  wire signed [23:0] intersected_0_zf,
    input  wire signed [23:0] intersected_1_zf,
    input  wire signed [23:0] intersected_2_zf,
    input  wire signed [23:0] intersected_3_zf,
    input  wire signed [23:0] intersected_0_zb,
    input  wire signed [23:0] intersected_1_zb,
    input  wire signed [23:0] intersected_2_zb,
    input  wire signed [23:0] intersected_3_zb,
    input  wire [7:0] intersected_0_id,
    input  wire [7:0] intersected_1_id,
    input  wire [7:0] intersected_2_id,
    input  wire [7:0] intersected_3_id,
    input  wire [3:0] intersected_0_number,
    input  wire [3:0] intersected_1_number,
    input  wire [3:0] intersected_2_number,
    input  wire [3:0] intersected_3_number,
    input  wire signed [23:0] subtracted_0_zf,
    input  wire signed [23:0] subtracted_1_zf,
    input  wire signed [23:0] subtracted_2_zf,
    input  wire signed [23:0] subtracted_3_zf,
    input  wire signed [23:0] subtracted_0_zb,
    input  wire signed [23:0] subtracted_1_zb,
    input  wire signed [23:0] subtracted_2_zb,
    input  wire signed [23:0] subtracted_3_zb,
    input  wire [7:0] subtracted_0_id,
    input  wire [7:0] subtracted_1_id,
    input  wire [7:0] subtracted_2_id,
    input  wire [7:0] subtracted_3_id,
    input  wire [3:0] subtracted_0_number,
    input  wire [3:0] subtracted_1_number,
    input  wire [3:0] subtracted_2_number,
    input  wire [3:0] subtracted_3_number,
    output wire signed [23:0] depth,
    output wire [7:0] id,
    output wire [3:0] number,
    output wire is_back
);

    wire [12:0] fronts_0_face;
    wire [12:0] fronts_1_face;
    wire [12:0] fronts_2_face;
    wire [12:0] fronts_3_face;
    wire [12:0] backs_0_face;
    wire [12:0] backs_1_face;
    wire [12:0] backs_2_face;
    wire [12:0] backs_3_face;
    wire signed [23:0] products_0_candidate_0_depth;
    wire signed [23:0] products_0_candidate_1_depth;
    wire signed [23:0] products_0_candidate_2_depth;
    wire [12:0] products_0_candidate_0_face;
    wire [12:0] products_0_candidate_1_face;
    wire [12:0] products_0_candidate_2_face;
    wire signed [23:0] products_1_candidate_0_depth;
    wire signed [23:0] products_1_candidate_1_depth;
    wire signed [23:0] products_1_candidate_2_depth;
    wire [12:0] products_1_candidate_0_face;
    wire [12:0] products_1_candidate_1_face;
    wire [12:0] products_1_candidate_2_face;
    wire signed [23:0] nodes_0_depth;
    wire [12:0] nodes_0_face;
    wire signed [23:0] nodes_1_depth;
    wire [12:0] nodes_1_face;
    wire signed [23:0] nodes_2_depth;
    wire [12:0] nodes_2_face;
    wire signed [23:0] nodes_3_depth;
    wire [12:0] nodes_3_face;
    wire signed [23:0] nodes_4_depth;
    wire [12:0] nodes_4_face;
    wire signed [23:0] registers_0_depth;
    wire [12:0] registers_0_face;

    face_word fronts_0 (
        .id(intersected_0_id),
        .number(intersected_0_number),
        .is_back(1'd0),
        .face(fronts_0_face)
    );

    face_word fronts_1 (
        .id(intersected_1_id),
        .number(intersected_1_number),
        .is_back(1'd0),
        .face(fronts_1_face)
    );

    face_word fronts_2 (
        .id(intersected_2_id),
        .number(intersected_2_number),
        .is_back(1'd0),
        .face(fronts_2_face)
    );

    face_word fronts_3 (
        .id(intersected_3_id),
        .number(intersected_3_number),
        .is_back(1'd0),
        .face(fronts_3_face)
    );

    face_word backs_0 (
        .id(subtracted_0_id),
        .number(subtracted_0_number),
        .is_back(1'd1),
        .face(backs_0_face)
    );

    face_word backs_1 (
        .id(subtracted_1_id),
        .number(subtracted_1_number),
        .is_back(1'd1),
        .face(backs_1_face)
    );

    face_word backs_2 (
        .id(subtracted_2_id),
        .number(subtracted_2_number),
        .is_back(1'd1),
        .face(backs_2_face)
    );

    face_word backs_3 (
        .id(subtracted_3_id),
        .number(subtracted_3_number),
        .is_back(1'd1),
        .face(backs_3_face)
    );

    csg_product products_0 (
        .clock(clock),
        .intersected_0_zf(intersected_0_zf),
        .intersected_1_zf(intersected_1_zf),
        .intersected_0_zb(intersected_0_zb),
        .intersected_1_zb(intersected_1_zb),
        .intersected_0_face(fronts_0_face),
        .intersected_1_face(fronts_1_face),
        .subtracted_0_zf(subtracted_0_zf),
        .subtracted_1_zf(subtracted_1_zf),
        .subtracted_0_zb(subtracted_0_zb),
        .subtracted_1_zb(subtracted_1_zb),
        .subtracted_0_face(backs_0_face),
        .subtracted_1_face(backs_1_face),
        .candidate_0_depth(products_0_candidate_0_depth),
        .candidate_1_depth(products_0_candidate_1_depth),
        .candidate_2_depth(products_0_candidate_2_depth),
        .candidate_0_face(products_0_candidate_0_face),
        .candidate_1_face(products_0_candidate_1_face),
        .candidate_2_face(products_0_candidate_2_face)
    );

    csg_product products_1 (
        .clock(clock),
        .intersected_0_zf(intersected_2_zf),
        .intersected_1_zf(intersected_3_zf),
        .intersected_0_zb(intersected_2_zb),
        .intersected_1_zb(intersected_3_zb),
        .intersected_0_face(fronts_2_face),
        .intersected_1_face(fronts_3_face),
        .subtracted_0_zf(subtracted_2_zf),
        .subtracted_1_zf(subtracted_3_zf),
        .subtracted_0_zb(subtracted_2_zb),
        .subtracted_1_zb(subtracted_3_zb),
        .subtracted_0_face(backs_2_face),
        .subtracted_1_face(backs_3_face),
        .candidate_0_depth(products_1_candidate_0_depth),
        .candidate_1_depth(products_1_candidate_1_depth),
        .candidate_2_depth(products_1_candidate_2_depth),
        .candidate_0_face(products_1_candidate_0_face),
        .candidate_1_face(products_1_candidate_1_face),
        .candidate_2_face(products_1_candidate_2_face)
    );

    nearer_face nodes_0 (
        .clock(clock),
        .a_depth(products_0_candidate_0_depth),
        .a_face(products_0_candidate_0_face),
        .b_depth(products_0_candidate_1_depth),
        .b_face(products_0_candidate_1_face),
        .depth(nodes_0_depth),
        .face(nodes_0_face)
    );

    nearer_face nodes_1 (
        .clock(clock),
        .a_depth(products_0_candidate_2_depth),
        .a_face(products_0_candidate_2_face),
        .b_depth(products_1_candidate_0_depth),
        .b_face(products_1_candidate_0_face),
        .depth(nodes_1_depth),
        .face(nodes_1_face)
    );

    nearer_face nodes_2 (
        .clock(clock),
        .a_depth(products_1_candidate_1_depth),
        .a_face(products_1_candidate_1_face),
        .b_depth(products_1_candidate_2_depth),
        .b_face(products_1_candidate_2_face),
        .depth(nodes_2_depth),
        .face(nodes_2_face)
    );

    nearer_face nodes_3 (
        .clock(clock),
        .a_depth(nodes_0_depth),
        .a_face(nodes_0_face),
        .b_depth(nodes_1_depth),
        .b_face(nodes_1_face),
        .depth(nodes_3_depth),
        .face(nodes_3_face)
    );

    nearer_face nodes_4 (
        .clock(clock),
        .a_depth(nodes_3_depth),
        .a_face(nodes_3_face),
        .b_depth(registers_0_depth),
        .b_face(registers_0_face),
        .depth(nodes_4_depth),
        .face(nodes_4_face)
    );

    face_register registers_0 (
        .clock(clock),
        .a_depth(nodes_2_depth),
        .a_face(nodes_2_face),
        .depth(registers_0_depth),
        .face(registers_0_face)
    );

    assign depth = nodes_4_depth;
    assign id = nodes_4_face[11:4];
    assign number = nodes_4_face[3:0];
    assign is_back = nodes_4_face[12];

endmodule
