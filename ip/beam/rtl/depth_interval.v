// depth_interval: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module depth_interval (
    input  wire clock,
    input  wire signed [25:0] near_sum, far_sum,
    input  wire is_inside, in_box,
    input  wire [1:0] object_class,
    output reg  signed [23:0] zf_a = 24'sd0,
    output reg  [3:0] nf_a = 4'd0,
    output reg  signed [23:0] zb_a = 24'sd0,
    output reg  [3:0] nb_a = 4'd0,
    output reg  signed [23:0] zf_b = 24'sd0,
    output reg  [3:0] nf_b = 4'd0,
    output reg  signed [23:0] zb_b = 24'sd0,
    output reg  [3:0] nb_b = 4'd0
);

    wire near_is_low, near_is_far, far_is_low, far_is_far, near_visible, far_visible, is_front, is_side, is_before,
        is_surface, is_prism, has_b;
    wire signed [23:0] near_depth, far_depth, surface_zf, surface_zb, inside_zf, inside_zb;
    wire [3:0] near_face, far_face, surface_nf, surface_nb, choice_2, inside_nf, inside_nb, choice;

    assign near_is_low = near_sum < -26'sd8388607;
    assign near_is_far = near_sum >= 26'sd8388607;
    assign near_depth = near_is_low ? -24'sd8388607 : near_is_far ? 24'sd8388607 : near_sum[23:0];
    assign near_face = near_is_low ? 4'd15 : 4'd0;
    assign far_is_low = far_sum < -26'sd8388607;
    assign far_is_far = far_sum >= 26'sd8388607;
    assign far_depth = far_is_low ? -24'sd8388607 : far_is_far ? 24'sd8388607 : far_sum[23:0];
    assign far_face = far_is_low ? 4'd15 : 4'd1;
    assign near_visible = ~(near_is_low | near_is_far);
    assign far_visible = ~(far_is_low | far_is_far);
    assign is_front = object_class == 2'd1;
    assign is_side = (object_class == 2'd0) & ~(near_is_far | far_is_low);
    assign is_before = is_front & ~near_is_low;
    assign is_surface = object_class == 2'd2;
    assign is_prism = object_class == 2'd3;
    assign has_b = ((in_box & is_inside) & is_front) & ~far_is_far;
    assign surface_zf = near_visible ? near_depth : far_visible ? far_depth : 24'sd8388607;
    assign surface_nf = (far_visible & ~near_visible) ? 4'd1 : 4'd0;
    assign surface_zb = far_visible ? far_depth : near_visible ? near_depth : 24'sd8388607;
    assign surface_nb = far_visible ? 4'd1 : 4'd0;
    assign choice_2 = is_prism ? 4'd15 : 4'd0;
    assign inside_zf = is_side ? near_depth : is_before ? -24'sd8388607 : is_surface ? surface_zf : is_prism ? -24'sd8388607 : 24'sd8388607;
    assign inside_nf = is_side ? near_face : is_before ? 4'd15 : is_surface ? surface_nf : choice_2;
    assign inside_zb = is_side ? far_depth : is_before ? near_depth : is_surface ? surface_zb : 24'sd8388607;
    assign inside_nb = is_side ? 4'd1 : is_before ? 4'd0 : is_surface ? surface_nb : choice_2;
    assign choice = is_front ? 4'd15 : 4'd0;

    always @(posedge clock) begin
        zf_a <= in_box ? (is_inside ? inside_zf : is_front ? -24'sd8388607 : 24'sd8388607) : 24'sd8388607;
        nf_a <= in_box ? (is_inside ? inside_nf : choice) : 4'd0;
        zb_a <= in_box ? (is_inside ? inside_zb : 24'sd8388607) : 24'sd8388607;
        nb_a <= in_box ? (is_inside ? inside_nb : choice) : 4'd0;
        zf_b <= has_b ? far_depth : 24'sd8388607;
        nf_b <= has_b ? far_face : 4'd0;
        zb_b <= 24'sd8388607;
        nb_b <= has_b ? 4'd15 : 4'd0;
    end
endmodule
