// depth_interval: the two halves of the depth interval of a quadric object
//
// parameters: format 24
// latency:    1 clock
// error:      exact
// source:     Nyiri 1994, 2.4.2
// ports:
//   in  clock           1 unsigned
//   in  near_sum       26 two's complement
//   in  far_sum        26 two's complement
//   in  is_inside       1 unsigned
//   in  in_box          1 unsigned
//   in  object_class    2 unsigned
//   out zf_a           24 two's complement
//   out nf_a            4 unsigned
//   out zb_a           24 two's complement
//   out nb_a            4 unsigned
//   out zf_b           24 two's complement
//   out nf_b            4 unsigned
//   out zb_b           24 two's complement
//   out nb_b            4 unsigned
//
// Made by: imogene emit depth_interval --format 24 --out DIR
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


    wire near_is_low = near_sum < -26'sd8388607;
    wire near_is_far = near_sum >= 26'sd8388607;
    wire far_is_low = far_sum < -26'sd8388607;
    wire far_is_far = far_sum >= 26'sd8388607;
    // 0 near, 1 far, 2 lowest, 3 absent
    wire [1:0] near = near_is_low ? 2'd2 : near_is_far ? 2'd3 : 2'd0;
    wire [1:0] far = far_is_low ? 2'd2 : far_is_far ? 2'd3 : 2'd1;
    wire near_visible = ~(near_is_low | near_is_far);
    wire far_visible = ~(far_is_low | far_is_far);
    wire side_present = ~(near_is_far | far_is_low);
    wire [1:0] surface_front = near_visible ? 2'd0 : far_visible ? 2'd1 : 2'd3;
    wire [1:0] surface_back = far_visible ? 2'd1 : near_visible ? 2'd0 : 2'd3;
    reg [1:0] front, back, behind;
    reg [3:0] front_face, back_face;
    always @* begin
        case (object_class)
        2'd0: begin front = side_present ? near : 2'd3; back = side_present ? far : 2'd3; front_face = (side_present & near_is_low) ? 4'd15 : 4'd0; back_face = side_present ? 4'd1 : 4'd0; end
        2'd1: begin front = near_is_low ? 2'd3 : 2'd2; back = near_is_low ? 2'd3 : near; front_face = near_is_low ? 4'd0 : 4'd15; back_face = 4'd0; end
        2'd2: begin front = surface_front; back = surface_back; front_face = (far_visible & ~near_visible) ? 4'd1 : 4'd0; back_face = far_visible ? 4'd1 : 4'd0; end
        2'd3: begin front = 2'd2; back = 2'd3; front_face = 4'd15; back_face = 4'd15; end
        endcase
        if (~is_inside) begin front = object_class == 2'd1 ? 2'd2 : 2'd3; back = 2'd3; front_face = object_class == 2'd1 ? 4'd15 : 4'd0; back_face = front_face; end
        if (~in_box) begin front = 2'd3; back = 2'd3; front_face = 4'd0; back_face = 4'd0; end
    end
    wire has_b = in_box & is_inside & (object_class == 2'd1) & ~far_is_far;
    function signed [23:0] depth(input [1:0] source, input [23:0] near_bits, far_bits);
        depth = source[1] ? (source[0] ? 24'sd8388607 : -24'sd8388607) : (source[0] ? far_bits : near_bits);
    endfunction
    always @(posedge clock) begin
        zf_a <= depth(front, near_sum[23:0], far_sum[23:0]);
        nf_a <= front_face;
        zb_a <= depth(back, near_sum[23:0], far_sum[23:0]);
        nb_a <= back_face;
        zf_b <= depth(has_b ? far : 2'd3, near_sum[23:0], far_sum[23:0]);
        nf_b <= has_b ? (far_is_low ? 4'd15 : 4'd1) : 4'd0;
        zb_b <= 24'sd8388607;
        nb_b <= has_b ? 4'd15 : 4'd0;
    end
endmodule
