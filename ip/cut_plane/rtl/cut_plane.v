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
    input  wire signed [23:0] zp,
    input  wire signed [23:0] zf,
    input  wire [3:0] nf,
    input  wire signed [23:0] zb,
    input  wire [3:0] nb,
    output wire signed [23:0] cut_zf,
    output wire [3:0] cut_nf,
    output wire signed [23:0] cut_zb,
    output wire [3:0] cut_nb
);

    localparam [1:0] front = 2'd1;
    localparam [1:0] back = 2'd2;
    localparam [1:0] perpendicular = 2'd3;
    localparam signed [23:0] absent = 24'sd8388607;
    localparam [3:0] no_face = 4'd0;
    wire is_front;
    wire is_back;
    wire is_perpendicular;
    wire before_front;
    wire at_front;
    wire before_back;
    wire at_back;
    wire removed;
    wire cuts_front;
    wire cuts_back;
    wire plane_is_negative;
    reg signed [23:0] kept_zf = 24'sd0;
    reg [3:0] kept_nf = 4'd0;
    reg signed [23:0] kept_zb = 24'sd0;
    reg [3:0] kept_nb = 4'd0;

    assign is_front = kind == front;
    assign is_back = kind == back;
    assign is_perpendicular = kind == perpendicular;
    assign before_front = zp < zf;
    assign at_front = zp == zf;
    assign before_back = zp < zb;
    assign at_back = zp == zb;
    assign removed = ((is_perpendicular & plane_is_negative) | (cuts_front & ~(before_back | at_back))) | (cuts_back & before_front);
    assign cuts_front = is_front & ~(before_front | at_front);
    assign cuts_back = is_back & before_back;
    assign plane_is_negative = zp[23];
    assign cut_zf = kept_zf;
    assign cut_nf = kept_nf;
    assign cut_zb = kept_zb;
    assign cut_nb = kept_nb;

    always @(posedge clock) begin
        kept_zf <= zf;
        kept_nf <= nf;
        kept_zb <= zb;
        kept_nb <= nb;
        if (removed) begin
            kept_zf <= absent;
            kept_nf <= no_face;
            kept_zb <= absent;
            kept_nb <= no_face;
        end else if (cuts_front) begin
            if (surface) begin
                kept_zf <= zb;
                kept_nf <= nb;
            end else begin
                kept_zf <= zp;
                kept_nf <= number;
            end
        end else if (cuts_back) begin
            if (surface) begin
                kept_zb <= zf;
                kept_nb <= nf;
            end else begin
                kept_zb <= zp;
                kept_nb <= number;
            end
        end
    end

endmodule
