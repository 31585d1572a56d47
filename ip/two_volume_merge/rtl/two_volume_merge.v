// two_volume_merge: the half of a depth interval that lies in front
//
// parameters: format 24
// latency:    1 clock
// error:      exact
// source:     Nyiri 1994, 2.4.2
// ports:
//   in  clock           1 unsigned
//   in  zf_a           24 two's complement
//   in  nf_a            4 unsigned
//   in  zb_a           24 two's complement
//   in  nb_a            4 unsigned
//   in  zf_b           24 two's complement
//   in  nf_b            4 unsigned
//   in  zb_b           24 two's complement
//   in  nb_b            4 unsigned
//   out zf             24 two's complement
//   out nf              4 unsigned
//   out zb             24 two's complement
//   out nb              4 unsigned
//
// Made by: imogene emit two_volume_merge --format 24 --out DIR
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
    output wire signed [23:0] zf,
    output wire [3:0] nf,
    output wire signed [23:0] zb,
    output wire [3:0] nb
);

    wire b_in_front;
    reg signed [23:0] kept_zf = 24'sd0;
    reg [3:0] kept_nf = 4'd0;
    reg signed [23:0] kept_zb = 24'sd0;
    reg [3:0] kept_nb = 4'd0;

    assign b_in_front = zf_b < zf_a;
    assign zf = kept_zf;
    assign nf = kept_nf;
    assign zb = kept_zb;
    assign nb = kept_nb;

    always @(posedge clock) begin
        if (b_in_front) begin
            kept_zf <= zf_b;
            kept_nf <= nf_b;
            kept_zb <= zb_b;
            kept_nb <= nb_b;
        end else begin
            kept_zf <= zf_a;
            kept_nf <= nf_a;
            kept_zb <= zb_a;
            kept_nb <= nb_a;
        end
    end

endmodule
