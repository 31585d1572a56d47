// patch_plane: part of patch_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module patch_plane (
    input  wire clock,
    input  wire [1:0] kind,
    input  wire signed [23:0] zp,
    input  wire signed [25:0] near_sum,
    input  wire signed [25:0] far_sum,
    output wire keeps_near,
    output wire keeps_far
);

    localparam [1:0] front = 2'd1;
    localparam [1:0] back = 2'd2;
    localparam [1:0] perpendicular = 2'd3;
    wire signed [25:0] plane;
    wire is_front;
    wire is_back;
    wire removes_both;
    wire cuts_near;
    wire cuts_far;
    reg kept_near = 1'd0;
    reg kept_far = 1'd0;

    assign plane = {{2{zp[23]}}, zp};
    assign is_front = kind == front;
    assign is_back = kind == back;
    assign removes_both = (kind == perpendicular) & zp[23];
    assign cuts_near = (is_front & (near_sum < plane)) | (is_back & (plane < near_sum));
    assign cuts_far = (is_front & (far_sum < plane)) | (is_back & (plane < far_sum));
    assign keeps_near = kept_near;
    assign keeps_far = kept_far;

    always @(posedge clock) begin
        kept_near <= ~(removes_both | cuts_near);
        kept_far <= ~(removes_both | cuts_far);
    end

endmodule
