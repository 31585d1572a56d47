// overlap: part of csg_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module overlap (
    input  wire clock,
    input  wire signed [23:0] a_zf,
    input  wire signed [23:0] a_zb,
    input  wire [12:0] a_face,
    input  wire signed [23:0] b_zf,
    input  wire signed [23:0] b_zb,
    input  wire [12:0] b_face,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [12:0] face
);

    wire b_is_front;
    reg signed [23:0] kept_zf = 24'sd0;
    reg signed [23:0] kept_zb = 24'sd0;
    reg [12:0] kept_face = 13'd0;

    assign b_is_front = (a_zf < b_zf) | ((a_zf == b_zf) & (b_face < a_face));
    assign zf = kept_zf;
    assign zb = kept_zb;
    assign face = kept_face;

    always @(posedge clock) begin
        if (b_is_front) begin
            kept_zf <= b_zf;
            kept_face <= b_face;
        end else begin
            kept_zf <= a_zf;
            kept_face <= a_face;
        end
        if (b_zb < a_zb) begin
            kept_zb <= b_zb;
        end else begin
            kept_zb <= a_zb;
        end
    end

endmodule
