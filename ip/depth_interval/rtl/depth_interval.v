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
    input  wire signed [25:0] near_sum,
    input  wire signed [25:0] far_sum,
    input  wire is_inside,
    input  wire in_box,
    input  wire [1:0] object_class,
    output wire signed [23:0] zf_a,
    output wire [3:0] nf_a,
    output wire signed [23:0] zb_a,
    output wire [3:0] nb_a,
    output wire signed [23:0] zf_b,
    output wire [3:0] nf_b,
    output wire signed [23:0] zb_b,
    output wire [3:0] nb_b
);

    localparam signed [25:0] low_sum = -26'sd8388607;
    localparam signed [25:0] far_end_sum = 26'sd8388607;
    localparam signed [23:0] low = -24'sd8388607;
    localparam signed [23:0] absent = 24'sd8388607;
    localparam [3:0] near_root = 4'd0;
    localparam [3:0] far_root = 4'd1;
    localparam [3:0] cap = 4'd15;
    localparam [3:0] no_face = 4'd0;
    localparam [1:0] side = 2'd0;
    localparam [1:0] front = 2'd1;
    localparam [1:0] patch = 2'd2;
    localparam [1:0] prism = 2'd3;
    wire near_is_low;
    wire near_is_far;
    wire far_is_low;
    wire far_is_far;
    wire signed [23:0] near_depth;
    wire signed [23:0] far_depth;
    wire [3:0] near_face;
    wire [3:0] far_face;
    wire near_visible;
    wire far_visible;
    wire is_side;
    wire is_front;
    wire is_patch;
    wire is_prism;
    wire side_present;
    reg signed [23:0] kept_zf_a = 24'sd0;
    reg [3:0] kept_nf_a = 4'd0;
    reg signed [23:0] kept_zb_a = 24'sd0;
    reg [3:0] kept_nb_a = 4'd0;
    reg signed [23:0] kept_zf_b = 24'sd0;
    reg [3:0] kept_nf_b = 4'd0;
    reg signed [23:0] kept_zb_b = 24'sd0;
    reg [3:0] kept_nb_b = 4'd0;

    assign near_is_low = near_sum < low_sum;
    assign near_is_far = near_sum >= far_end_sum;
    assign far_is_low = far_sum < low_sum;
    assign far_is_far = far_sum >= far_end_sum;
    assign near_depth = near_is_low ? low :
        near_is_far ? absent : near_sum[23:0];
    assign far_depth = far_is_low ? low :
        far_is_far ? absent : far_sum[23:0];
    assign near_face = near_is_low ? cap : near_root;
    assign far_face = far_is_low ? cap : far_root;
    assign near_visible = ~(near_is_low | near_is_far);
    assign far_visible = ~(far_is_low | far_is_far);
    assign is_side = object_class == side;
    assign is_front = object_class == front;
    assign is_patch = object_class == patch;
    assign is_prism = object_class == prism;
    assign side_present = is_side & ~(near_is_far | far_is_low);
    assign zf_a = kept_zf_a;
    assign nf_a = kept_nf_a;
    assign zb_a = kept_zb_a;
    assign nb_a = kept_nb_a;
    assign zf_b = kept_zf_b;
    assign nf_b = kept_nf_b;
    assign zb_b = kept_zb_b;
    assign nb_b = kept_nb_b;

    always @(posedge clock) begin
        kept_zf_a <= absent;
        kept_nf_a <= no_face;
        kept_zb_a <= absent;
        kept_nb_a <= no_face;
        kept_zf_b <= absent;
        kept_nf_b <= no_face;
        kept_zb_b <= absent;
        kept_nb_b <= no_face;
        if (in_box) begin
            if (is_inside) begin
                if (side_present) begin
                    kept_zf_a <= near_depth;
                    kept_nf_a <= near_face;
                    kept_zb_a <= far_depth;
                    kept_nb_a <= far_root;
                end
                if (is_front) begin
                    if (~near_is_low) begin
                        kept_zf_a <= low;
                        kept_nf_a <= cap;
                        kept_zb_a <= near_depth;
                        kept_nb_a <= near_root;
                    end
                    if (~far_is_far) begin
                        kept_zf_b <= far_depth;
                        kept_nf_b <= far_face;
                        kept_zb_b <= absent;
                        kept_nb_b <= cap;
                    end
                end
                if (is_patch) begin
                    if (near_visible) begin
                        kept_zf_a <= near_depth;
                        kept_nf_a <= near_root;
                        kept_zb_a <= near_depth;
                        kept_nb_a <= near_root;
                        if (far_visible) begin
                            kept_zb_a <= far_depth;
                            kept_nb_a <= far_root;
                        end
                    end else if (far_visible) begin
                        kept_zf_a <= far_depth;
                        kept_nf_a <= far_root;
                        kept_zb_a <= far_depth;
                        kept_nb_a <= far_root;
                    end
                end
                if (is_prism) begin
                    kept_zf_a <= low;
                    kept_nf_a <= cap;
                    kept_zb_a <= absent;
                    kept_nb_a <= cap;
                end
            end else if (is_front) begin
                kept_zf_a <= low;
                kept_nf_a <= cap;
                kept_zb_a <= absent;
                kept_nb_a <= cap;
            end
        end
    end

endmodule
