// plane_depth: part of polyhedron_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module plane_depth (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire signed [35:0] a,
    input  wire signed [35:0] b,
    input  wire signed [35:0] c,
    output wire signed [23:0] depth
);

    localparam signed [35:0] largest = 36'sd8388607;
    localparam signed [35:0] smallest = -36'sd8388608;
    localparam signed [23:0] farthest = 24'sd8388607;
    localparam signed [23:0] nearest = 24'sh800000;
    wire above;
    wire below;
    wire signed [35:0] plane_value;
    reg signed [23:0] clamped = 24'sd0;

    pe1 plane (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a(a),
        .b(b),
        .c(c),
        .value(plane_value)
    );

    assign above = plane_value > largest;
    assign below = plane_value < smallest;
    assign depth = clamped;

    always @(posedge clock) begin
        if (above) begin
            clamped <= farthest;
        end else if (below) begin
            clamped <= nearest;
        end else begin
            clamped <= plane_value[23:0];
        end
    end

endmodule
