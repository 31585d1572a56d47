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
    wire [3:0] near_face, far_face, choice_2, inside_nf, inside_nb, choice, source_a_nf, source_a_nb;
    wire signed [1:0] from_near, from_far, inside_zf, inside_zb, source_a_zf, source_a_zb, source_b_zf;

    assign near_is_low = near_sum < -26'sd8388607;
    assign near_is_far = near_sum >= 26'sd8388607;
    assign near_face = near_is_low ? 4'd15 : 4'd0;
    assign far_is_low = far_sum < -26'sd8388607;
    assign far_is_far = far_sum >= 26'sd8388607;
    assign far_face = far_is_low ? 4'd15 : 4'd1;
    assign near_visible = ~(near_is_low | near_is_far);
    assign far_visible = ~(far_is_low | far_is_far);
    assign is_front = object_class == 2'd1;
    assign is_side = (object_class == 2'd0) & ~(near_is_far | far_is_low);
    assign is_before = is_front & ~near_is_low;
    assign is_surface = object_class == 2'd2;
    assign is_prism = object_class == 2'd3;
    assign has_b = ((in_box & is_inside) & is_front) & ~far_is_far;
    assign from_near = near_is_low ? -2'sd1 : near_is_far ? 2'sd1 : 2'sd0;
    assign from_far = far_is_low ? -2'sd1 : far_is_far ? 2'sd1 : 2'sh2;
    assign choice_2 = is_prism ? 4'd15 : 4'd0;
    assign inside_zf = is_side ? from_near : is_before ? -2'sd1 : is_surface ? (near_visible ? from_near : far_visible ? from_far : 2'sd1) : is_prism ? -2'sd1 : 2'sd1;
    assign inside_nf = is_side ? near_face : is_before ? 4'd15 : is_surface ? ((far_visible & ~near_visible) ? 4'd1 : 4'd0) : choice_2;
    assign inside_zb = is_side ? from_far : is_before ? from_near : is_surface ? (far_visible ? from_far : near_visible ? from_near : 2'sd1) : 2'sd1;
    assign inside_nb = is_side ? 4'd1 : is_before ? 4'd0 : is_surface ? (far_visible ? 4'd1 : 4'd0) : choice_2;
    assign choice = is_front ? 4'd15 : 4'd0;
    assign source_a_zf = in_box ? (is_inside ? inside_zf : is_front ? -2'sd1 : 2'sd1) : 2'sd1;
    assign source_a_nf = in_box ? (is_inside ? inside_nf : choice) : 4'd0;
    assign source_a_zb = in_box ? (is_inside ? inside_zb : 2'sd1) : 2'sd1;
    assign source_a_nb = in_box ? (is_inside ? inside_nb : choice) : 4'd0;
    assign source_b_zf = has_b ? from_far : 2'sd1;

    always @(posedge clock) begin
        zf_a <= source_a_zf[1] ? (source_a_zf[0] ? -24'sd8388607 : far_sum[23:0]) : source_a_zf[0] ? 24'sd8388607 : near_sum[23:0];
        nf_a <= source_a_nf;
        zb_a <= source_a_zb[1] ? (source_a_zb[0] ? -24'sd8388607 : far_sum[23:0]) : source_a_zb[0] ? 24'sd8388607 : near_sum[23:0];
        nb_a <= source_a_nb;
        zf_b <= source_b_zf[1] ? (source_b_zf[0] ? -24'sd8388607 : far_sum[23:0]) : source_b_zf[0] ? 24'sd8388607 : near_sum[23:0];
        nf_b <= has_b ? far_face : 4'd0;
        zb_b <= 24'sd8388607;
        nb_b <= has_b ? 4'd15 : 4'd0;
    end
endmodule
