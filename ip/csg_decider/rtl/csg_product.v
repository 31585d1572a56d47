// csg_product: part of csg_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module csg_product (
    input  wire clock,
    input  wire signed [23:0] intersected_0_zf,
    input  wire signed [23:0] intersected_1_zf,
    input  wire signed [23:0] intersected_0_zb,
    input  wire signed [23:0] intersected_1_zb,
    input  wire [12:0] intersected_0_face,
    input  wire [12:0] intersected_1_face,
    input  wire signed [23:0] subtracted_0_zf,
    input  wire signed [23:0] subtracted_1_zf,
    input  wire signed [23:0] subtracted_0_zb,
    input  wire signed [23:0] subtracted_1_zb,
    input  wire [12:0] subtracted_0_face,
    input  wire [12:0] subtracted_1_face,
    output wire signed [23:0] candidate_0_depth,
    output wire signed [23:0] candidate_1_depth,
    output wire signed [23:0] candidate_2_depth,
    output wire [12:0] candidate_0_face,
    output wire [12:0] candidate_1_face,
    output wire [12:0] candidate_2_face
);

    localparam signed [23:0] far = 24'sd8388607;
    localparam [12:0] no_face = 13'd0;
    wire front_is_seen;
    wire is_0_within;
    wire is_1_within;
    wire signed [23:0] nodes_0_zf;
    wire signed [23:0] nodes_0_zb;
    wire [12:0] nodes_0_face;
    wire front_cover_is_sheet;
    wire front_cover_is_covered;
    wire covers_0_is_covered;
    wire covers_1_is_covered;
    reg signed [23:0] kept_depth_0 = 24'sd0;
    reg signed [23:0] kept_depth_1 = 24'sd0;
    reg signed [23:0] kept_depth_2 = 24'sd0;
    reg [12:0] kept_face_0 = 13'd0;
    reg [12:0] kept_face_1 = 13'd0;
    reg [12:0] kept_face_2 = 13'd0;

    overlap nodes_0 (
        .clock(clock),
        .a_zf(intersected_0_zf),
        .a_zb(intersected_0_zb),
        .a_face(intersected_0_face),
        .b_zf(intersected_1_zf),
        .b_zb(intersected_1_zb),
        .b_face(intersected_1_face),
        .zf(nodes_0_zf),
        .zb(nodes_0_zb),
        .face(nodes_0_face)
    );

    interval_cover_w1_v1 front_cover (
        .place(nodes_0_zf),
        .is_sheet(front_cover_is_sheet),
        .other_0_zf(subtracted_0_zf),
        .other_1_zf(subtracted_1_zf),
        .other_0_zb(subtracted_0_zb),
        .other_1_zb(subtracted_1_zb),
        .is_covered(front_cover_is_covered)
    );

    interval_cover_w1_v2 covers_0 (
        .place(subtracted_0_zb),
        .is_sheet(1'd0),
        .other_0_zf(subtracted_1_zf),
        .other_0_zb(subtracted_1_zb),
        .is_covered(covers_0_is_covered)
    );

    interval_cover_w1_v2 covers_1 (
        .place(subtracted_1_zb),
        .is_sheet(1'd0),
        .other_0_zf(subtracted_0_zf),
        .other_0_zb(subtracted_0_zb),
        .is_covered(covers_1_is_covered)
    );

    assign front_is_seen = ((nodes_0_zf <= nodes_0_zb) & (nodes_0_zf < far)) & ~front_cover_is_covered;
    assign is_0_within = ((subtracted_0_zf < subtracted_0_zb) & (nodes_0_zf < subtracted_0_zb)) & (subtracted_0_zb < nodes_0_zb);
    assign is_1_within = ((subtracted_1_zf < subtracted_1_zb) & (nodes_0_zf < subtracted_1_zb)) & (subtracted_1_zb < nodes_0_zb);
    assign front_cover_is_sheet = nodes_0_zf == nodes_0_zb;
    assign candidate_0_depth = kept_depth_0;
    assign candidate_1_depth = kept_depth_1;
    assign candidate_2_depth = kept_depth_2;
    assign candidate_0_face = kept_face_0;
    assign candidate_1_face = kept_face_1;
    assign candidate_2_face = kept_face_2;

    always @(posedge clock) begin
        kept_depth_0 <= far;
        kept_face_0 <= no_face;
        if (front_is_seen) begin
            kept_depth_0 <= nodes_0_zf;
            kept_face_0 <= nodes_0_face;
        end
        kept_depth_1 <= far;
        kept_face_1 <= no_face;
        if (is_0_within & ~covers_0_is_covered) begin
            kept_depth_1 <= subtracted_0_zb;
            kept_face_1 <= subtracted_0_face;
        end
        kept_depth_2 <= far;
        kept_face_2 <= no_face;
        if (is_1_within & ~covers_1_is_covered) begin
            kept_depth_2 <= subtracted_1_zb;
            kept_face_2 <= subtracted_1_face;
        end
    end

endmodule
