// square_root_stage: part of quadric_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_stage (
    input  wire clock,
    input  wire [47:0] pairs,
    input  wire [23:0] root,
    input  wire [24:0] remainder,
    input  wire [25:0] live,
    output wire [47:0] next_pairs,
    output wire [23:0] next_root,
    output wire [24:0] next_remainder,
    output wire [25:0] next_live
);

    wire [47:0] rows_0_next_pairs;
    wire [23:0] rows_0_next_root;
    wire [24:0] rows_0_next_remainder;
    wire [25:0] rows_0_next_live;
    reg [47:0] kept_pairs = 48'd0;
    reg [23:0] kept_root = 24'd0;
    reg [24:0] kept_remainder = 25'd0;

    square_root_row rows_0 (
        .pairs(pairs),
        .root(root),
        .remainder(remainder),
        .live(live),
        .next_pairs(rows_0_next_pairs),
        .next_root(rows_0_next_root),
        .next_remainder(rows_0_next_remainder),
        .next_live(rows_0_next_live)
    );

    assign next_pairs = kept_pairs;
    assign next_root = kept_root;
    assign next_remainder = kept_remainder;
    assign next_live = rows_0_next_live;

    always @(posedge clock) begin
        kept_pairs <= rows_0_next_pairs;
        kept_root <= rows_0_next_root;
        kept_remainder <= rows_0_next_remainder;
    end

endmodule
