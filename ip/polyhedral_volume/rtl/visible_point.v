// visible_point: part of polyhedral_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module visible_point (
    input  wire clock,
    input  wire signed [23:0] depth,
    input  wire [23:0] margin,
    output wire signed [23:0] z,
    output wire signed [25:0] entered,
    output wire is_surface
);

    localparam signed [23:0] background = 24'sd8388607;
    wire signed [25:0] wide_depth;
    wire [25:0] wide_margin;
    wire signed [25:0] step;
    reg signed [23:0] kept_z = 24'sd0;
    reg signed [25:0] kept_entered = 26'sd0;
    reg kept_surface = 1'd0;

    assign wide_depth = {{2{depth[23]}}, depth};
    assign wide_margin = {2'd0, margin};
    assign step = wide_margin;
    assign z = kept_z;
    assign entered = kept_entered;
    assign is_surface = kept_surface;

    always @(posedge clock) begin
        kept_z <= depth;
        kept_entered <= wide_depth - step;
        kept_surface <= kept_z != background;
    end

endmodule
