// cut_plane: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module cut_plane (
    input  wire clock,
    input  wire [1:0] kind,
    input  wire surface,
    input  wire [3:0] number,
    input  wire signed [23:0] zp, zf,
    input  wire [3:0] nf,
    input  wire signed [23:0] zb,
    input  wire [3:0] nb,
    output reg  signed [23:0] cut_zf = 24'sd0,
    output reg  [3:0] cut_nf = 4'd0,
    output reg  signed [23:0] cut_zb = 24'sd0,
    output reg  [3:0] cut_nb = 4'd0
);

    reg before_front = 1'd0, at_front = 1'd0, before_back = 1'd0, at_back = 1'd0, surface_late_1 = 1'd0;
    reg [1:0] kind_late_1 = 2'd0;
    reg [3:0] number_late_1 = 4'd0, nf_late_1 = 4'd0, nb_late_1 = 4'd0;
    reg signed [23:0] zp_late_1 = 24'sd0, zf_late_1 = 24'sd0, zb_late_1 = 24'sd0;
    wire cuts_front, cuts_back, leaves_nothing, removed;

    assign cuts_front = (kind_late_1 == 2'd1) & ~(before_front | at_front);
    assign cuts_back = (kind_late_1 == 2'd2) & before_back;
    assign leaves_nothing = cuts_front & ~(before_back | at_back);
    assign removed = (((kind_late_1 == 2'd3) & zp_late_1[23]) | leaves_nothing) | (cuts_back & before_front);

    always @(posedge clock) begin
        before_front <= {zf[23], zp[22:0]} < {zp[23], zf[22:0]};
        at_front <= zp == zf;
        before_back <= {zb[23], zp[22:0]} < {zp[23], zb[22:0]};
        at_back <= zp == zb;
        kind_late_1 <= kind;
        surface_late_1 <= surface;
        number_late_1 <= number;
        zp_late_1 <= zp;
        zf_late_1 <= zf;
        nf_late_1 <= nf;
        zb_late_1 <= zb;
        nb_late_1 <= nb;
        cut_zf <= removed ? 24'sd8388607 : cuts_front ? (surface_late_1 ? zb_late_1 : zp_late_1) : zf_late_1;
        cut_nf <= removed ? 4'd0 : cuts_front ? (surface_late_1 ? nb_late_1 : number_late_1) : nf_late_1;
        cut_zb <= removed ? 24'sd8388607 : cuts_front ? zb_late_1 : cuts_back ? (surface_late_1 ? zf_late_1 : zp_late_1) : zb_late_1;
        cut_nb <= removed ? 4'd0 : cuts_front ? nb_late_1 : cuts_back ? (surface_late_1 ? nf_late_1 : number_late_1) : nb_late_1;
    end
endmodule
