// two_volume_merge: part of beam; see there.
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

    reg b_in_front = 1'd0;
    reg signed [23:0] a_zf_late_1 = 24'sd0, a_zb_late_1 = 24'sd0, b_zf_late_1 = 24'sd0, b_zb_late_1 = 24'sd0;
    reg [3:0] a_nf_late_1 = 4'd0, a_nb_late_1 = 4'd0, b_nf_late_1 = 4'd0, b_nb_late_1 = 4'd0;

    always @(posedge clock) begin
        b_in_front <= {zf_a[23], zf_b[22:0]} < {zf_b[23], zf_a[22:0]};
        a_zf_late_1 <= zf_a;
        a_nf_late_1 <= nf_a;
        a_zb_late_1 <= zb_a;
        a_nb_late_1 <= nb_a;
        b_zf_late_1 <= zf_b;
        b_nf_late_1 <= nf_b;
        b_zb_late_1 <= zb_b;
        b_nb_late_1 <= nb_b;
        zf <= b_in_front ? b_zf_late_1 : a_zf_late_1;
        nf <= b_in_front ? b_nf_late_1 : a_nf_late_1;
        zb <= b_in_front ? b_zb_late_1 : a_zb_late_1;
        nb <= b_in_front ? b_nb_late_1 : a_nb_late_1;
    end
endmodule
