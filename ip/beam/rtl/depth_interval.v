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
    output wire signed [23:0] zb_b,
    output reg  [3:0] nb_b = 4'd0
);

    wire near_is_outside, near_is_low, near_is_far, far_is_outside, far_is_low, far_is_far, near_visible, far_visible,
        is_front, is_side, is_before, is_surface, is_prism, has_b;
    reg near_is_low_late_1 = 1'd0, near_is_far_late_1 = 1'd0, far_is_low_late_1 = 1'd0, far_is_far_late_1 = 1'd0,
        is_inside_late_1 = 1'd0, in_box_late_1 = 1'd0;
    reg signed [25:0] near_sum_late_1 = 26'sd0, far_sum_late_1 = 26'sd0;
    reg [1:0] object_class_late_1 = 2'd0;
    wire [3:0] near_late_face, far_late_face, choice_2, inside_nf, inside_nb, choice;
    wire signed [1:0] from_near, from_far, inside_zf, inside_zb;
    reg signed [1:0] source_a_zf_late_1 = 2'sd0, source_a_zb_late_1 = 2'sd0, source_b_zf = 2'sd0;
    reg [3:0] source_a_nf_late_1 = 4'd0, source_a_nb_late_1 = 4'd0, nf_b_kept = 4'd0, nb_b_kept = 4'd0;
    reg signed [23:0] near_bits = 24'sd0, far_bits = 24'sd0;

    assign near_is_outside = ~((near_sum[25:23] == 3'd0) | (near_sum[25:23] == 3'd7));
    assign near_is_low = near_sum[25] & (near_is_outside | (near_sum[22:0] == 23'd0));
    assign near_is_far = ~near_sum[25] & (near_is_outside | (near_sum[22:0] == 23'h7fffff));
    assign far_is_outside = ~((far_sum[25:23] == 3'd0) | (far_sum[25:23] == 3'd7));
    assign far_is_low = far_sum[25] & (far_is_outside | (far_sum[22:0] == 23'd0));
    assign far_is_far = ~far_sum[25] & (far_is_outside | (far_sum[22:0] == 23'h7fffff));
    assign near_late_face = near_is_low_late_1 ? 4'd15 : 4'd0;
    assign far_late_face = far_is_low_late_1 ? 4'd15 : 4'd1;
    assign near_visible = ~(near_is_low_late_1 | near_is_far_late_1);
    assign far_visible = ~(far_is_low_late_1 | far_is_far_late_1);
    assign is_front = object_class_late_1 == 2'd1;
    assign is_side = (object_class_late_1 == 2'd0) & ~(near_is_far_late_1 | far_is_low_late_1);
    assign is_before = is_front & ~near_is_low_late_1;
    assign is_surface = object_class_late_1 == 2'd2;
    assign is_prism = object_class_late_1 == 2'd3;
    assign has_b = ((in_box_late_1 & is_inside_late_1) & is_front) & ~far_is_far_late_1;
    assign from_near = near_is_low_late_1 ? -2'sd1 : near_is_far_late_1 ? 2'sd1 : 2'sd0;
    assign from_far = far_is_low_late_1 ? -2'sd1 : far_is_far_late_1 ? 2'sd1 : 2'sh2;
    assign choice_2 = is_prism ? 4'd15 : 4'd0;
    assign inside_zf = is_side ? from_near : is_before ? -2'sd1 : is_surface ? (near_visible ? from_near : far_visible ? from_far : 2'sd1) : is_prism ? -2'sd1 : 2'sd1;
    assign inside_nf = is_side ? near_late_face : is_before ? 4'd15 : is_surface ? ((far_visible & ~near_visible) ? 4'd1 : 4'd0) : choice_2;
    assign inside_zb = is_side ? from_far : is_before ? from_near : is_surface ? (far_visible ? from_far : near_visible ? from_near : 2'sd1) : 2'sd1;
    assign inside_nb = is_side ? 4'd1 : is_before ? 4'd0 : is_surface ? (far_visible ? 4'd1 : 4'd0) : choice_2;
    assign choice = is_front ? 4'd15 : 4'd0;
    assign zb_b = 24'sd8388607;
    wire unused = &{1'b0, near_sum_late_1[25:24], far_sum_late_1[25:24]};

    always @(posedge clock) begin
        near_is_low_late_1 <= near_is_low;
        near_is_far_late_1 <= near_is_far;
        far_is_low_late_1 <= far_is_low;
        far_is_far_late_1 <= far_is_far;
        near_sum_late_1 <= near_sum;
        far_sum_late_1 <= far_sum;
        is_inside_late_1 <= is_inside;
        in_box_late_1 <= in_box;
        object_class_late_1 <= object_class;
        source_a_zf_late_1 <= in_box_late_1 ? (is_inside_late_1 ? inside_zf : is_front ? -2'sd1 : 2'sd1) : 2'sd1;
        source_a_nf_late_1 <= in_box_late_1 ? (is_inside_late_1 ? inside_nf : choice) : 4'd0;
        source_a_zb_late_1 <= in_box_late_1 ? (is_inside_late_1 ? inside_zb : 2'sd1) : 2'sd1;
        source_a_nb_late_1 <= in_box_late_1 ? (is_inside_late_1 ? inside_nb : choice) : 4'd0;
        source_b_zf <= has_b ? from_far : 2'sd1;
        near_bits <= near_sum_late_1[23:0];
        far_bits <= far_sum_late_1[23:0];
        nf_b_kept <= has_b ? far_late_face : 4'd0;
        nf_b <= nf_b_kept;
        nb_b_kept <= has_b ? 4'd15 : 4'd0;
        nb_b <= nb_b_kept;
        zf_a <= source_a_zf_late_1[1] ? (source_a_zf_late_1[0] ? -24'sd8388607 : far_bits) : source_a_zf_late_1[0] ? 24'sd8388607 : near_bits;
        nf_a <= source_a_nf_late_1;
        zb_a <= source_a_zb_late_1[1] ? (source_a_zb_late_1[0] ? -24'sd8388607 : far_bits) : source_a_zb_late_1[0] ? 24'sd8388607 : near_bits;
        nb_a <= source_a_nb_late_1;
        zf_b <= source_b_zf[1] ? (source_b_zf[0] ? -24'sd8388607 : far_bits) : source_b_zf[0] ? 24'sd8388607 : near_bits;
    end
endmodule
