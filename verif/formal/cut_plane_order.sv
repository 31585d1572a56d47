// Two cut planes one after the other leave the same depths in either order. A cut plane holds nothing from earlier clocks
// (cut_plane.sv), so constant words are enough.

module cut_plane_order #(parameter W = `W) (
    input wire clock
);
    (* anyconst *) wire surface;
    (* anyconst *) wire [1:0] kind_1;
    (* anyconst *) wire [1:0] kind_2;
    (* anyconst *) wire signed [W-1:0] zp_1;
    (* anyconst *) wire signed [W-1:0] zp_2;
    (* anyconst *) wire signed [W-1:0] zf;
    (* anyconst *) wire signed [W-1:0] zb;
    wire signed [W-1:0] once_zf, once_zb, twice_zf, twice_zb;
    wire signed [W-1:0] other_once_zf, other_once_zb, other_zf, other_zb;

    cut_plane first (.clock(clock), .kind(kind_1), .surface(surface), .number(4'd2), .zp(zp_1),
        .zf(zf), .nf(4'd0), .zb(zb), .nb(4'd1), .cut_zf(once_zf), .cut_nf(), .cut_zb(once_zb), .cut_nb());
    cut_plane second (.clock(clock), .kind(kind_2), .surface(surface), .number(4'd3), .zp(zp_2),
        .zf(once_zf), .nf(4'd0), .zb(once_zb), .nb(4'd1), .cut_zf(twice_zf), .cut_nf(), .cut_zb(twice_zb), .cut_nb());
    cut_plane other_first (.clock(clock), .kind(kind_2), .surface(surface), .number(4'd3), .zp(zp_2),
        .zf(zf), .nf(4'd0), .zb(zb), .nb(4'd1), .cut_zf(other_once_zf), .cut_nf(), .cut_zb(other_once_zb), .cut_nb());
    cut_plane other_second (.clock(clock), .kind(kind_1), .surface(surface), .number(4'd2), .zp(zp_1),
        .zf(other_once_zf), .nf(4'd0), .zb(other_once_zb), .nb(4'd1), .cut_zf(other_zf), .cut_nf(), .cut_zb(other_zb), .cut_nb());

    reg [2:0] clocks = 0;
    always @(posedge clock) if (clocks != 4) clocks <= clocks + 1;

    always @* begin
        assume (zf <= zb);
        if (clocks == 4) begin
            assert (twice_zf == other_zf);
            assert (twice_zb == other_zb);
        end
    end
endmodule
