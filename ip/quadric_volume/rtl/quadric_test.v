// quadric_test: part of quadric_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module quadric_test (
    input  wire clock,
    input  wire [1:0] object_class,
    input  wire signed [25:0] near_sum,
    input  wire signed [25:0] far_sum,
    input  wire is_inside,
    input  wire signed [25:0] z,
    input  wire signed [25:0] entered,
    output wire holds
);

    localparam [1:0] side = 2'd0;
    localparam [1:0] front = 2'd1;
    localparam [1:0] prism = 2'd3;
    wire between;
    wire outside;
    reg kept = 1'd0;

    assign between = (near_sum <= entered) & (z <= far_sum);
    assign outside = (z <= near_sum) | (far_sum <= entered);
    assign holds = kept;

    always @(posedge clock) begin
        kept <= 1'd0;
        if (object_class == side) begin
            kept <= is_inside & between;
        end
        if (object_class == front) begin
            kept <= ~is_inside | outside;
        end
        if (object_class == prism) begin
            kept <= is_inside;
        end
    end

endmodule
