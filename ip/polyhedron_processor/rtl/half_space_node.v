// half_space_node: part of polyhedron_processor; see there.
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
    output wire signed [23:0] front,
    output wire [3:0] front_number,
    output wire signed [23:0] back,
    output wire [3:0] back_number,
    output wire removed
);

    wire b_is_deeper;
    wire b_is_nearer;
    reg signed [23:0] kept_front = 24'sd0;
    reg signed [23:0] kept_back = 24'sd0;
    reg [3:0] kept_front_number = 4'd0;
    reg [3:0] kept_back_number = 4'd0;
    reg kept_removed = 1'd0;

    assign b_is_deeper = a_front < b_front;
    assign b_is_nearer = b_back < a_back;
    assign front = kept_front;
    assign front_number = kept_front_number;
    assign back = kept_back;
    assign back_number = kept_back_number;
    assign removed = kept_removed;

    always @(posedge clock) begin
        if (b_is_deeper) begin
            kept_front <= b_front;
            kept_front_number <= b_front_number;
        end else begin
            kept_front <= a_front;
            kept_front_number <= a_front_number;
        end
        if (b_is_nearer) begin
            kept_back <= b_back;
            kept_back_number <= b_back_number;
        end else begin
            kept_back <= a_back;
            kept_back_number <= a_back_number;
        end
        kept_removed <= a_removed | b_removed;
    end

endmodule
