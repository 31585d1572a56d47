// cut_plane: one half of a depth interval cut by one plane
//
// parameters: format 24
// latency:    1 clock
// error:      exact
// source:     Nyiri 1994, 2.4.2
// ports:
//   in  clock           1 unsigned
//   in  kind            2 unsigned
//   in  surface         1 unsigned
//   in  number          4 unsigned
//   in  zp             24 two's complement
//   in  zf             24 two's complement
//   in  nf              4 unsigned
//   in  zb             24 two's complement
//   in  nb              4 unsigned
//   out cut_zf         24 two's complement
//   out cut_nf          4 unsigned
//   out cut_zb         24 two's complement
//   out cut_nb          4 unsigned
//
// Made by: imogene emit cut_plane --format 24 --out DIR
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

    wire before_front, at_front, before_back, at_back, cuts_front, cuts_back, leaves_nothing, removed;

    assign before_front = zp < zf;
    assign at_front = zp == zf;
    assign before_back = zp < zb;
    assign at_back = zp == zb;
    assign cuts_front = (kind == 2'd1) & ~(before_front | at_front);
    assign cuts_back = (kind == 2'd2) & before_back;
    assign leaves_nothing = cuts_front & ~(before_back | at_back);
    assign removed = (((kind == 2'd3) & zp[23]) | leaves_nothing) | (cuts_back & before_front);

    always @(posedge clock) begin
        cut_zf <= removed ? 24'sd8388607 : cuts_front ? (surface ? zb : zp) : zf;
        cut_nf <= removed ? 4'd0 : cuts_front ? (surface ? nb : number) : nf;
        cut_zb <= removed ? 24'sd8388607 : cuts_front ? zb : cuts_back ? (surface ? zf : zp) : zb;
        cut_nb <= removed ? 4'd0 : cuts_front ? nb : cuts_back ? (surface ? nf : number) : nb;
    end
endmodule
