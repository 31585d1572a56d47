// half_space_register: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module half_space_register (
    input  wire clock,
    input  wire signed [23:0] a_front,
    input  wire [3:0] a_front_number,
    input  wire signed [23:0] a_back,
    input  wire [3:0] a_back_number,
    input  wire a_removed,
    output reg  signed [23:0] front = 24'sd0,
    output reg  [3:0] front_number = 4'd0,
    output reg  signed [23:0] back = 24'sd0,
    output reg  [3:0] back_number = 4'd0,
    output reg  removed = 1'd0
);

    always @(posedge clock) begin
        front <= a_front;
        front_number <= a_front_number;
        back <= a_back;
        back_number <= a_back_number;
        removed <= a_removed;
    end
endmodule
