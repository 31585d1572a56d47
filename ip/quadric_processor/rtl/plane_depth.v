// plane_depth: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module plane_depth (
    input  wire clock, valid, start, line,
    input  wire signed [35:0] a, b, c,
    output reg  signed [23:0] depth = 24'sd0
);

    wire signed [35:0] plane_value;
    wire above, below;

    pe1_w36 plane (
        .clock(clock), .valid(valid), .start(start), .line(line), .a(a), .b(b), .c(c), .value(plane_value));

    assign above = plane_value > 36'sd8388607;
    assign below = plane_value < -36'sd8388608;

    always @(posedge clock) begin
        depth <= above ? 24'sd8388607 : below ? 24'sh800000 : plane_value[23:0];
    end
endmodule
