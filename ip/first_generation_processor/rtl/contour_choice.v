// contour_choice: part of first_generation_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module contour_choice (
    input  wire clock,
    input  wire surface,
    input  wire signed [25:0] near_sum,
    input  wire signed [25:0] far_sum,
    input  wire is_there,
    input  wire signed [23:0] front_zp,
    input  wire signed [23:0] back_zp,
    input  wire front_inside,
    input  wire back_inside,
    input  wire middle_kept,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number
);

    localparam signed [23:0] low = -24'sd8388607;
    localparam signed [23:0] absent = 24'sd8388607;
    localparam [3:0] near_root = 4'd0;
    localparam [3:0] far_root = 4'd1;
    localparam [3:0] front_plane = 4'd2;
    wire left;
    wire signed [23:0] cut_zf;
    wire signed [23:0] cut_zb;
    wire [3:0] cut_number;
    wire cut_present;
    wire solid_is_present;
    wire signed [23:0] solid_zf;
    wire signed [23:0] solid_zb;
    wire [3:0] solid_number;
    wire near_face_is_there;
    wire near_face_is_present;
    wire signed [23:0] near_face_depth;
    wire far_face_is_there;
    wire far_face_is_present;
    wire signed [23:0] far_face_depth;
    reg signed [23:0] kept_zf = 24'sd0;
    reg signed [23:0] kept_zb = 24'sd0;
    reg [3:0] kept_number = 4'd0;

    side_interval solid (
        .near_sum(near_sum),
        .far_sum(far_sum),
        .is_there(left),
        .is_present(solid_is_present),
        .zf(solid_zf),
        .zb(solid_zb),
        .number(solid_number)
    );

    one_face near_face (
        .z(near_sum),
        .is_there(near_face_is_there),
        .is_present(near_face_is_present),
        .depth(near_face_depth)
    );

    one_face far_face (
        .z(far_sum),
        .is_there(far_face_is_there),
        .is_present(far_face_is_present),
        .depth(far_face_depth)
    );

    assign left = is_there & ((front_inside | back_inside) | middle_kept);
    assign cut_zf = (front_inside & (low < front_zp)) ? front_zp : solid_zf;
    assign cut_zb = (back_inside & (back_zp < absent)) ? back_zp : solid_zb;
    assign cut_number = (front_inside & (low < front_zp)) ? front_plane : solid_number;
    assign cut_present = (solid_is_present & (cut_zf <= cut_zb)) & (cut_zf < absent);
    assign near_face_is_there = left & ~front_inside;
    assign far_face_is_there = left & ~back_inside;
    assign zf = kept_zf;
    assign zb = kept_zb;
    assign number = kept_number;

    always @(posedge clock) begin
        kept_zf <= absent;
        kept_zb <= absent;
        kept_number <= near_root;
        if (surface) begin
            if (far_face_is_present) begin
                kept_zf <= far_face_depth;
                kept_zb <= far_face_depth;
                kept_number <= far_root;
            end
            if (near_face_is_present) begin
                kept_zf <= near_face_depth;
                kept_number <= near_root;
                if (~far_face_is_present) begin
                    kept_zb <= near_face_depth;
                end
            end
        end else if (cut_present) begin
            kept_zf <= cut_zf;
            kept_zb <= cut_zb;
            kept_number <= cut_number;
        end
    end

endmodule
