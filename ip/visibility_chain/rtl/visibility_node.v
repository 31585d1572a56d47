// visibility_node: part of visibility_chain; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module visibility_node (
    input  wire clock,
    input  wire signed [23:0] a_depth,
    input  wire [7:0] a_id,
    input  wire [3:0] a_number,
    input  wire signed [15:0] a_nx,
    input  wire signed [15:0] a_ny,
    input  wire signed [15:0] a_nz,
    input  wire signed [23:0] b_depth,
    input  wire [7:0] b_id,
    input  wire [3:0] b_number,
    input  wire signed [15:0] b_nx,
    input  wire signed [15:0] b_ny,
    input  wire signed [15:0] b_nz,
    output wire signed [23:0] depth,
    output wire [7:0] id,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    wire b_is_nearer;
    wire depths_are_equal;
    wire b_has_smaller_id;
    wire b_wins;
    reg signed [23:0] kept_depth = 24'sd0;
    reg [7:0] kept_id = 8'd0;
    reg [3:0] kept_number = 4'd0;
    reg signed [15:0] kept_nx = 16'sd0;
    reg signed [15:0] kept_ny = 16'sd0;
    reg signed [15:0] kept_nz = 16'sd0;

    assign b_is_nearer = b_depth < a_depth;
    assign depths_are_equal = b_depth == a_depth;
    assign b_has_smaller_id = b_id < a_id;
    assign b_wins = b_is_nearer | (depths_are_equal & b_has_smaller_id);
    assign depth = kept_depth;
    assign id = kept_id;
    assign number = kept_number;
    assign nx = kept_nx;
    assign ny = kept_ny;
    assign nz = kept_nz;

    always @(posedge clock) begin
        if (b_wins) begin
            kept_depth <= b_depth;
            kept_id <= b_id;
            kept_number <= b_number;
            kept_nx <= b_nx;
            kept_ny <= b_ny;
            kept_nz <= b_nz;
        end else begin
            kept_depth <= a_depth;
            kept_id <= a_id;
            kept_number <= a_number;
            kept_nx <= a_nx;
            kept_ny <= a_ny;
            kept_nz <= a_nz;
        end
    end

endmodule
