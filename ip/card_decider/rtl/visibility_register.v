// visibility_register: part of card_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module visibility_register (
    input  wire clock,
    input  wire signed [23:0] a_depth,
    input  wire [7:0] a_id,
    input  wire [3:0] a_number,
    input  wire signed [15:0] a_nx,
    input  wire signed [15:0] a_ny,
    input  wire signed [15:0] a_nz,
    output wire signed [23:0] depth,
    output wire [7:0] id,
    output wire [3:0] number,
    output wire signed [15:0] nx,
    output wire signed [15:0] ny,
    output wire signed [15:0] nz
);

    reg signed [23:0] kept_depth = 24'sd0;
    reg [7:0] kept_id = 8'd0;
    reg [3:0] kept_number = 4'd0;
    reg signed [15:0] kept_nx = 16'sd0;
    reg signed [15:0] kept_ny = 16'sd0;
    reg signed [15:0] kept_nz = 16'sd0;

    assign depth = kept_depth;
    assign id = kept_id;
    assign number = kept_number;
    assign nx = kept_nx;
    assign ny = kept_ny;
    assign nz = kept_nz;

    always @(posedge clock) begin
        kept_depth <= a_depth;
        kept_id <= a_id;
        kept_number <= a_number;
        kept_nx <= a_nx;
        kept_ny <= a_ny;
        kept_nz <= a_nz;
    end

endmodule
