// face_register: part of csg_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module face_register (
    input  wire clock,
    input  wire signed [23:0] a_depth,
    input  wire [12:0] a_face,
    output wire signed [23:0] depth,
    output wire [12:0] face
);

    reg signed [23:0] kept_depth = 24'sd0;
    reg [12:0] kept_face = 13'd0;

    assign depth = kept_depth;
    assign face = kept_face;

    always @(posedge clock) begin
        kept_depth <= a_depth;
        kept_face <= a_face;
    end

endmodule
