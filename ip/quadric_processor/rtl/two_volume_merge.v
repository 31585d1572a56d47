// two_volume_merge: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module two_volume_merge (
    input  wire clock,
    input  wire signed [23:0] zf_a,
    input  wire [3:0] nf_a,
    input  wire signed [23:0] zb_a,
    input  wire [3:0] nb_a,
    input  wire signed [23:0] zf_b,
    input  wire [3:0] nf_b,
    input  wire signed [23:0] zb_b,
    input  wire [3:0] nb_b,
    output reg  signed [23:0] zf = 24'sd0,
    output reg  [3:0] nf = 4'd0,
    output reg  signed [23:0] zb = 24'sd0,
    output reg  [3:0] nb = 4'd0
);

    wire b_in_front;

    assign b_in_front = zf_b < zf_a;

    always @(posedge clock) begin
        zf <= b_in_front ? zf_b : zf_a;
        nf <= b_in_front ? nf_b : nf_a;
        zb <= b_in_front ? zb_b : zb_a;
        nb <= b_in_front ? nb_b : nb_a;
    end
endmodule
