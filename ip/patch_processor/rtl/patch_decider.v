// patch_decider: part of patch_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module patch_decider (
    input  wire clock,
    input  wire signed [25:0] near_sum,
    input  wire signed [25:0] far_sum,
    input  wire is_inside,
    input  wire in_box,
    input  wire [1:0] plane_0_kind,
    input  wire [1:0] plane_1_kind,
    input  wire [1:0] plane_2_kind,
    input  wire [1:0] plane_3_kind,
    input  wire signed [23:0] plane_0_zp,
    input  wire signed [23:0] plane_1_zp,
    input  wire signed [23:0] plane_2_zp,
    input  wire signed [23:0] plane_3_zp,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number
);

    localparam signed [25:0] low = -26'sd8388607;
    localparam signed [25:0] far_limit = 26'sd8388607;
    localparam signed [23:0] absent = 24'sd8388607;
    localparam [3:0] near_root = 4'd0;
    localparam [3:0] far_root = 4'd1;
    wire is_there;
    wire near_left;
    wire far_left;
    wire planes_0_keeps_near;
    wire planes_0_keeps_far;
    wire planes_1_keeps_near;
    wire planes_1_keeps_far;
    wire planes_2_keeps_near;
    wire planes_2_keeps_far;
    wire planes_3_keeps_near;
    wire planes_3_keeps_far;
    reg near_exists = 1'd0;
    reg far_exists = 1'd0;
    reg signed [23:0] near_depth = 24'sd0;
    reg signed [23:0] far_depth = 24'sd0;
    reg signed [23:0] kept_zf = 24'sd0;
    reg signed [23:0] kept_zb = 24'sd0;
    reg [3:0] kept_number = 4'd0;

    patch_plane planes_0 (
        .clock(clock),
        .kind(plane_0_kind),
        .zp(plane_0_zp),
        .near_sum(near_sum),
        .far_sum(far_sum),
        .keeps_near(planes_0_keeps_near),
        .keeps_far(planes_0_keeps_far)
    );

    patch_plane planes_1 (
        .clock(clock),
        .kind(plane_1_kind),
        .zp(plane_1_zp),
        .near_sum(near_sum),
        .far_sum(far_sum),
        .keeps_near(planes_1_keeps_near),
        .keeps_far(planes_1_keeps_far)
    );

    patch_plane planes_2 (
        .clock(clock),
        .kind(plane_2_kind),
        .zp(plane_2_zp),
        .near_sum(near_sum),
        .far_sum(far_sum),
        .keeps_near(planes_2_keeps_near),
        .keeps_far(planes_2_keeps_far)
    );

    patch_plane planes_3 (
        .clock(clock),
        .kind(plane_3_kind),
        .zp(plane_3_zp),
        .near_sum(near_sum),
        .far_sum(far_sum),
        .keeps_near(planes_3_keeps_near),
        .keeps_far(planes_3_keeps_far)
    );

    assign is_there = is_inside & in_box;
    assign near_left = ~planes_3_keeps_near ? 1'd0 :
        ~planes_2_keeps_near ? 1'd0 :
        ~planes_1_keeps_near ? 1'd0 :
        ~planes_0_keeps_near ? 1'd0 : near_exists;
    assign far_left = ~planes_3_keeps_far ? 1'd0 :
        ~planes_2_keeps_far ? 1'd0 :
        ~planes_1_keeps_far ? 1'd0 :
        ~planes_0_keeps_far ? 1'd0 : far_exists;
    assign zf = kept_zf;
    assign zb = kept_zb;
    assign number = kept_number;

    always @(posedge clock) begin
        near_exists <= (is_there & (near_sum >= low)) & (near_sum < far_limit);
        far_exists <= (is_there & (far_sum >= low)) & (far_sum < far_limit);
        near_depth <= near_sum[23:0];
        far_depth <= far_sum[23:0];
        kept_zf <= absent;
        kept_zb <= absent;
        kept_number <= near_root;
        if (far_left) begin
            kept_zf <= far_depth;
            kept_zb <= far_depth;
            kept_number <= far_root;
        end
        if (near_left) begin
            kept_zf <= near_depth;
            kept_number <= near_root;
            if (~far_left) begin
                kept_zb <= near_depth;
            end
        end
    end

endmodule
