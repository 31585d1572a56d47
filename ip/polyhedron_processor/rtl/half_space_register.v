// half_space_register: part of polyhedron_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module half_space_register (
    input  wire clock,
    input  wire signed [23:0] a_front,
    input  wire [3:0] a_front_number,
    input  wire signed [23:0] a_back,
    input  wire [3:0] a_back_number,
    input  wire a_removed,
    output wire signed [23:0] front,
    output wire [3:0] front_number,
    output wire signed [23:0] back,
    output wire [3:0] back_number,
    output wire removed
);

    reg signed [23:0] kept_front = 24'sd0;
    reg signed [23:0] kept_back = 24'sd0;
    reg [3:0] kept_front_number = 4'd0;
    reg [3:0] kept_back_number = 4'd0;
    reg kept_removed = 1'd0;

    assign front = kept_front;
    assign front_number = kept_front_number;
    assign back = kept_back;
    assign back_number = kept_back_number;
    assign removed = kept_removed;

    always @(posedge clock) begin
        kept_front <= a_front;
        kept_front_number <= a_front_number;
        kept_back <= a_back;
        kept_back_number <= a_back_number;
        kept_removed <= a_removed;
    end

endmodule
