// square_root_stage: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_stage (
    input  wire clock,
    input  wire [47:0] pairs,
    input  wire [23:0] root,
    input  wire [24:0] remainder,
    input  wire [25:0] live,
    output reg  [47:0] next_pairs = 48'd0,
    output reg  [23:0] next_root = 24'd0,
    output reg  [24:0] next_remainder = 25'd0
);

    wire [47:0] rows_0_next_pairs;
    wire [23:0] rows_0_next_root;
    wire [24:0] rows_0_next_remainder;

    square_root_row rows_0 (
        .pairs(pairs), .root(root), .remainder(remainder), .live(live), .next_pairs(rows_0_next_pairs),
        .next_root(rows_0_next_root), .next_remainder(rows_0_next_remainder));

    always @(posedge clock) begin
        next_pairs <= rows_0_next_pairs;
        next_root <= rows_0_next_root;
        next_remainder <= rows_0_next_remainder;
    end
endmodule
