// quadric_cut: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module quadric_cut (
    input  wire clock,
    input  wire signed [25:0] near_sum, far_sum,
    input  wire is_inside, in_box,
    input  wire [1:0] object_class,
    input  wire signed [23:0] front,
    input  wire [3:0] front_number,
    input  wire signed [23:0] back,
    input  wire [3:0] back_number,
    input  wire removed,
    output reg  signed [23:0] zf = 24'sd0,
    output reg  signed [23:0] zb = 24'sd0,
    output reg  [3:0] number = 4'd0
);

    wire near_is_outside, near_is_low, far_is_outside, far_is_low, far_is_far, is_inside_2, is_outside, is_front,
        is_in_front, is_surface, is_left, between, before_2, all_2, behind, near_point, far_point, from_end, at_plane,
        at_root, cut_behind, front_is_far, back_is_far;
    reg near_is_low_late_1 = 1'd0, near_is_far_late_1 = 1'd0, far_is_low_late_1 = 1'd0, far_is_far_late_1 = 1'd0,
        is_inside_late_1 = 1'd0, in_box_late_1 = 1'd0, parts_between_late_1 = 1'd0, parts_before_late_1 = 1'd0,
        parts_behind_late_1 = 1'd0, parts_all_late_1 = 1'd0, parts_near_point_late_1 = 1'd0,
        parts_far_point_late_1 = 1'd0, parts_near_is_low_late_1 = 1'd0, parts_far_is_low_late_1 = 1'd0,
        order_front_hides_near_late_1 = 1'd0, order_front_hides_far_late_1 = 1'd0,
        order_back_hides_near_late_1 = 1'd0, order_back_hides_far_late_1 = 1'd0, order_has_front_late_1 = 1'd0,
        order_front_is_last_late_1 = 1'd0, order_nothing_left_late_1 = 1'd0, parts_between_late_1_2 = 1'd0,
        parts_before_late_1_2 = 1'd0, parts_behind_late_1_2 = 1'd0, parts_all_late_1_2 = 1'd0,
        parts_near_point_late_1_2 = 1'd0, parts_far_point_late_1_2 = 1'd0, parts_near_is_low_late_1_2 = 1'd0,
        parts_far_is_low_late_1_2 = 1'd0, sources_front_is_root_late_1 = 1'd0, sources_front_is_plane_late_1 = 1'd0,
        sources_back_is_root_late_1 = 1'd0, sources_back_is_plane_late_1 = 1'd0;
    reg [1:0] object_class_late_1 = 2'd0;
    reg signed [25:0] near_sum_late_1 = 26'sd0, far_sum_late_1 = 26'sd0;
    wire signed [23:0] near_late_depth, far_late_depth;
    reg signed [23:0] near_root_late_1 = 24'sd0, far_root_late_1 = 24'sd0, near_root_late_1_2 = 24'sd0,
        far_root_late_1_2 = 24'sd0, sources_front_root_late_1 = 24'sd0, sources_back_root_late_1 = 24'sd0,
        front_late_1 = 24'sd0, front_late_2 = 24'sd0, back_late_1 = 24'sd0, back_late_2 = 24'sd0;
    wire [22:0] word;
    reg [3:0] sources_face_late_1 = 4'd0, front_number_late_1 = 4'd0, front_number_late_2 = 4'd0;

    assign near_is_outside = ~((near_sum[25:23] == 3'd0) | (near_sum[25:23] == 3'd7));
    assign near_is_low = near_sum[25] & (near_is_outside | (near_sum[22:0] == 23'd0));
    assign far_is_outside = ~((far_sum[25:23] == 3'd0) | (far_sum[25:23] == 3'd7));
    assign far_is_low = far_sum[25] & (far_is_outside | (far_sum[22:0] == 23'd0));
    assign far_is_far = ~far_sum[25] & (far_is_outside | (far_sum[22:0] == 23'h7fffff));
    assign near_late_depth = near_is_low_late_1 ? -24'sd8388607 : near_is_far_late_1 ? 24'sd8388607 : near_sum_late_1[23:0];
    assign far_late_depth = far_is_low_late_1 ? -24'sd8388607 : far_is_far_late_1 ? 24'sd8388607 : far_sum_late_1[23:0];
    assign is_inside_2 = in_box_late_1 & is_inside_late_1;
    assign is_outside = in_box_late_1 & ~is_inside_late_1;
    assign is_front = object_class_late_1 == 2'd1;
    assign is_in_front = is_front & is_inside_2;
    assign is_surface = (object_class_late_1 == 2'd2) & is_inside_2;
    assign word = front[22:0];
    assign is_left = ~order_nothing_left_late_1;
    assign between = (parts_between_late_1_2 & is_left) & ~(order_front_hides_far_late_1 | order_back_hides_near_late_1);
    assign before_2 = (parts_before_late_1_2 & is_left) & ~order_front_hides_near_late_1;
    assign all_2 = parts_all_late_1_2 & is_left;
    assign behind = (parts_behind_late_1_2 & is_left) & ~((before_2 | order_back_hides_far_late_1) | order_front_is_last_late_1);
    assign near_point = (parts_near_point_late_1_2 & is_left) & ~(order_front_hides_near_late_1 | order_back_hides_near_late_1);
    assign far_point = (parts_far_point_late_1_2 & is_left) & ~(order_front_hides_far_late_1 | order_back_hides_far_late_1);
    assign from_end = before_2 | all_2;
    assign at_plane = (between & order_front_hides_near_late_1) | (behind & order_front_hides_far_late_1);
    assign at_root = ((between | behind) | near_point) | far_point;
    assign cut_behind = (between & order_back_hides_far_late_1) | (before_2 & order_back_hides_near_late_1);
    assign front_is_far = ~(parts_between_late_1_2 | near_point);
    assign back_is_far = parts_between_late_1_2 | far_point;
    wire unused = &{1'b0, back_number, near_sum_late_1[25:24], far_sum_late_1[25:24], word[0]};

    always @(posedge clock) begin
        near_is_low_late_1 <= near_is_low;
        near_is_far_late_1 <= ~near_sum[25] & near_is_outside;
        far_is_low_late_1 <= far_is_low;
        far_is_far_late_1 <= far_is_far;
        object_class_late_1 <= object_class;
        near_sum_late_1 <= near_sum;
        far_sum_late_1 <= far_sum;
        is_inside_late_1 <= is_inside;
        in_box_late_1 <= in_box;
        parts_between_late_1 <= ((object_class_late_1 == 2'd0) & is_inside_2) & ~(near_is_far_late_1 | far_is_low_late_1);
        parts_before_late_1 <= is_in_front & ~near_is_low_late_1;
        parts_behind_late_1 <= is_in_front & ~far_is_far_late_1;
        parts_all_late_1 <= ((object_class_late_1 == 2'd3) & is_inside_2) | (is_front & is_outside);
        parts_near_point_late_1 <= is_surface & ~(near_is_low_late_1 | near_is_far_late_1);
        parts_far_point_late_1 <= is_surface & ~(far_is_low_late_1 | far_is_far_late_1);
        parts_near_is_low_late_1 <= near_is_low_late_1;
        parts_far_is_low_late_1 <= far_is_low_late_1;
        near_root_late_1 <= near_late_depth;
        far_root_late_1 <= far_late_depth;
        order_front_hides_near_late_1 <= {front[23], near_root_late_1[22:0]} < {near_root_late_1[23], front[22:0]};
        order_front_hides_far_late_1 <= {front[23], far_root_late_1[22:0]} < {far_root_late_1[23], front[22:0]};
        order_back_hides_near_late_1 <= {near_root_late_1[23], back[22:0]} < {back[23], near_root_late_1[22:0]};
        order_back_hides_far_late_1 <= {far_root_late_1[23], back[22:0]} < {back[23], far_root_late_1[22:0]};
        order_has_front_late_1 <= ~(front[23] & (word[22:1] == 22'd0));
        order_front_is_last_late_1 <= front == 24'sd8388607;
        order_nothing_left_late_1 <= (removed | ({front[23], back[22:0]} < {back[23], front[22:0]})) | (back == 24'sh800000);
        parts_between_late_1_2 <= parts_between_late_1;
        parts_before_late_1_2 <= parts_before_late_1;
        parts_behind_late_1_2 <= parts_behind_late_1;
        parts_all_late_1_2 <= parts_all_late_1;
        parts_near_point_late_1_2 <= parts_near_point_late_1;
        parts_far_point_late_1_2 <= parts_far_point_late_1;
        parts_near_is_low_late_1_2 <= parts_near_is_low_late_1;
        parts_far_is_low_late_1_2 <= parts_far_is_low_late_1;
        near_root_late_1_2 <= near_root_late_1;
        far_root_late_1_2 <= far_root_late_1;
        sources_front_is_root_late_1 <= (at_root & ~at_plane) | (from_end & ~order_has_front_late_1);
        sources_front_is_plane_late_1 <= at_plane | from_end;
        sources_back_is_root_late_1 <= (((between | before_2) | near_point) | far_point) & ~cut_behind;
        sources_back_is_plane_late_1 <= (cut_behind | all_2) | behind;
        sources_front_root_late_1 <= front_is_far ? far_root_late_1_2 : near_root_late_1_2;
        sources_back_root_late_1 <= back_is_far ? far_root_late_1_2 : near_root_late_1_2;
        sources_face_late_1 <= from_end ? 4'd15 : front_is_far ? (parts_far_is_low_late_1_2 ? 4'd15 : 4'd1) : parts_near_is_low_late_1_2 ? 4'd15 : 4'd0;
        front_late_1 <= front;
        front_late_2 <= front_late_1;
        front_number_late_1 <= front_number;
        front_number_late_2 <= front_number_late_1;
        back_late_1 <= back;
        back_late_2 <= back_late_1;
        zf <= sources_front_is_root_late_1 ? (sources_front_is_plane_late_1 ? -24'sd8388607 : sources_front_root_late_1) : sources_front_is_plane_late_1 ? front_late_2 : 24'sd8388607;
        zb <= sources_back_is_root_late_1 ? sources_back_root_late_1 : sources_back_is_plane_late_1 ? back_late_2 : 24'sd8388607;
        number <= sources_front_is_root_late_1 ? sources_face_late_1 : sources_front_is_plane_late_1 ? front_number_late_2 : 4'd0;
    end
endmodule
