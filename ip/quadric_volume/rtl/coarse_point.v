// coarse_point: part of quadric_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module coarse_point (
    input  wire clock,
    input  wire signed [23:0] depth,
    input  wire [23:0] margin,
    input  wire [3:0] depth_shift,
    output wire signed [25:0] z,
    output wire signed [25:0] entered
);

    localparam [25:0] top = 26'd33554432;
    wire signed [25:0] wide_depth;
    wire [25:0] wide_margin;
    wire [25:0] raised_depth;
    wire [25:0] raised_entered;
    wire [25:0] offset;
    wire [25:0] term_1;
    wire [25:0] term_2;
    wire [25:0] term_3;
    reg signed [25:0] kept_z = 26'sd0;
    reg signed [25:0] kept_entered = 26'sd0;

    assign term_1 = wide_depth;
    assign term_2 = raised_depth >> depth_shift;
    assign term_3 = raised_entered >> depth_shift;
    assign wide_depth = {{2{depth[23]}}, depth};
    assign wide_margin = {2'd0, margin};
    assign raised_depth = term_1 + top;
    assign raised_entered = raised_depth - wide_margin;
    assign offset = top >> depth_shift;
    assign z = kept_z;
    assign entered = kept_entered;

    always @(posedge clock) begin
        kept_z <= term_2 - offset;
        kept_entered <= term_3 - offset;
    end

endmodule
