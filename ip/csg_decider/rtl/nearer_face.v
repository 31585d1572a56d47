// nearer_face: part of csg_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module nearer_face (
    input  wire clock,
    input  wire signed [23:0] a_depth,
    input  wire [12:0] a_face,
    input  wire signed [23:0] b_depth,
    input  wire [12:0] b_face,
    output wire signed [23:0] depth,
    output wire [12:0] face
);

    wire b_wins;
    reg signed [23:0] kept_depth = 24'sd0;
    reg [12:0] kept_face = 13'd0;

    assign b_wins = (b_depth < a_depth) | ((b_depth == a_depth) & (b_face < a_face));
    assign depth = kept_depth;
    assign face = kept_face;

    always @(posedge clock) begin
        if (b_wins) begin
            kept_depth <= b_depth;
            kept_face <= b_face;
        end else begin
            kept_depth <= a_depth;
            kept_face <= a_face;
        end
    end

endmodule
