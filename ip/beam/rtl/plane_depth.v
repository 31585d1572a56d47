// plane_depth: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module plane_depth (
    input  wire clock, valid, start, line,
    input  wire signed [35:0] a, b, c,
    output reg  signed [23:0] depth = 24'sd0
);

    wire signed [35:0] plane_value;
    wire is_in_word;
    wire signed [23:0] saturated;

    pe1_w36 plane (
        .clock(clock), .valid(valid), .start(start), .line(line), .a(a), .b(b), .c(c), .value(plane_value));

    assign is_in_word = (plane_value[35:23] == 13'd0) | (plane_value[35:23] == 13'd8191);
    assign saturated = plane_value[35] ? 24'sh800000 : 24'sd8388607;

    always @(posedge clock) begin
        depth <= is_in_word ? plane_value[23:0] : saturated;
    end
endmodule
