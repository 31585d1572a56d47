// Cut plane: one half of a depth interval against one plane, for any words on the ports in every clock.
//
// A half is ordered, zf <= zb; an absent one has both at ZMAX. `z` is any depth before ZMAX. A solid half holds the depths from
// zf to zb, a patch its two faces alone; a plane keeps those on its side, nothing else, and no depth is made.

module cut_plane_properties #(parameter W = 24) (
    input wire clock,
    input wire [1:0] kind,
    input wire surface,
    input wire [3:0] number,
    input wire signed [W-1:0] zp, zf,
    input wire [3:0] nf,
    input wire signed [W-1:0] zb,
    input wire [3:0] nb,
    input wire signed [W-1:0] cut_zf,
    input wire [3:0] cut_nf,
    input wire signed [W-1:0] cut_zb,
    input wire [3:0] cut_nb
);
    localparam [1:0] FRONT = 2'd1, BACK = 2'd2, PERPENDICULAR = 2'd3;
    localparam signed [W-1:0] ZMAX = {1'b0, {(W-1){1'b1}}};

    (* anyconst *) wire signed [W-1:0] z;

    // The ports two clocks ago: latency 2.
    reg [1:0] clocks = 0;
    wire started = clocks == 2;
    reg [1:0] late_kind, old_kind;
    reg late_surface, old_surface;
    reg [3:0] late_number, late_nf, late_nb, old_number, old_nf, old_nb;
    reg signed [W-1:0] late_zp, late_zf, late_zb, old_zp, old_zf, old_zb;

    always @(posedge clock) begin
        if (!started) clocks <= clocks + 1;
        {late_kind, late_surface, late_number, late_nf, late_nb} <= {kind, surface, number, nf, nb};
        {late_zp, late_zf, late_zb} <= {zp, zf, zb};
        {old_kind, old_surface, old_number, old_nf, old_nb} <= {late_kind, late_surface, late_number, late_nf, late_nb};
        {old_zp, old_zf, old_zb} <= {late_zp, late_zf, late_zb};
    end

    wire kept = (old_kind == FRONT) ? z >= old_zp
        : (old_kind == BACK) ? z <= old_zp
        : (old_kind == PERPENDICULAR) ? old_zp >= 0
        : 1'b1;
    wire given = old_surface ? z == old_zf || z == old_zb : old_zf <= z && z <= old_zb;
    wire found = old_surface ? z == cut_zf || z == cut_zb : cut_zf <= z && z <= cut_zb;
    wire absent = cut_zf == ZMAX && cut_zb == ZMAX && cut_nf == 0 && cut_nb == 0;

    always @* begin
        assume (zf <= zb);
        assume (z < ZMAX);
        if (started) begin
            // Ordered, and only shrinking.
            assert (cut_zf <= cut_zb);
            assert (cut_zf >= old_zf);
            assert (cut_zb <= old_zb || absent);
            // Exactly the depths that the half holds and the plane keeps.
            assert (found == (given && kept));
            // A face keeps its number, or is the plane's, or belongs to the face that took its place.
            assert (absent || cut_nf == (cut_zf == old_zf && !(old_kind == FRONT && old_zp > old_zf) ? old_nf
                : old_surface ? old_nb : old_number));
            assert (absent || cut_nb == (cut_zb == old_zb && !(old_kind == BACK && old_zp < old_zb) ? old_nb
                : old_surface ? old_nf : old_number));
        end
    end
endmodule

bind cut_plane cut_plane_properties #(.W(`W)) properties (
    .clock(clock), .kind(kind), .surface(surface), .number(number), .zp(zp),
    .zf(zf), .nf(nf), .zb(zb), .nb(nb), .cut_zf(cut_zf), .cut_nf(cut_nf), .cut_zb(cut_zb), .cut_nb(cut_nb)
);
