// visibility_node: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module visibility_node (
    input  wire clock,
    input  wire signed [23:0] a_depth,
    input  wire [7:0] a_id,
    input  wire [3:0] a_number,
    input  wire signed [15:0] a_nx, a_ny, a_nz,
    input  wire signed [23:0] b_depth,
    input  wire [7:0] b_id,
    input  wire [3:0] b_number,
    input  wire signed [15:0] b_nx, b_ny, b_nz,
    output reg  signed [23:0] depth = 24'sd0,
    output reg  [7:0] id = 8'd0,
    output reg  [3:0] number = 4'd0,
    output reg  signed [15:0] nx = 16'sd0,
    output reg  signed [15:0] ny = 16'sd0,
    output reg  signed [15:0] nz = 16'sd0
);

    wire signed [31:0] rank, other_rank;
    wire b_wins;

    assign rank = {b_depth, b_id};
    assign other_rank = {a_depth, a_id};
    assign b_wins = {other_rank[31], rank[30:0]} < {rank[31], other_rank[30:0]};

    always @(posedge clock) begin
        depth <= b_wins ? b_depth : a_depth;
        id <= b_wins ? b_id : a_id;
        number <= b_wins ? b_number : a_number;
        nx <= b_wins ? b_nx : a_nx;
        ny <= b_wins ? b_ny : a_ny;
        nz <= b_wins ? b_nz : a_nz;
    end
endmodule
