// half_space_node: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module half_space_node (
    input  wire clock,
    input  wire signed [23:0] a_front,
    input  wire [3:0] a_front_number,
    input  wire signed [23:0] a_back,
    input  wire [3:0] a_back_number,
    input  wire a_removed,
    input  wire signed [23:0] b_front,
    input  wire [3:0] b_front_number,
    input  wire signed [23:0] b_back,
    input  wire [3:0] b_back_number,
    input  wire b_removed,
    output reg  signed [23:0] front = 24'sd0,
    output reg  [3:0] front_number = 4'd0,
    output reg  signed [23:0] back = 24'sd0,
    output reg  [3:0] back_number = 4'd0,
    output reg  removed = 1'd0
);

    wire b_is_deeper, b_is_nearer;

    assign b_is_deeper = {b_front[23], a_front[22:0]} < {a_front[23], b_front[22:0]};
    assign b_is_nearer = {a_back[23], b_back[22:0]} < {b_back[23], a_back[22:0]};

    always @(posedge clock) begin
        front <= b_is_deeper ? b_front : a_front;
        front_number <= b_is_deeper ? b_front_number : a_front_number;
        back <= b_is_nearer ? b_back : a_back;
        back_number <= b_is_nearer ? b_back_number : a_back_number;
        removed <= a_removed | b_removed;
    end
endmodule
