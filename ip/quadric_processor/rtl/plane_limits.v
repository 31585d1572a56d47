// plane_limits: part of quadric_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module plane_limits (
    input  wire clock, valid, start, line,
    input  wire [1:0] kind,
    input  wire signed [35:0] a, b, c,
    output reg  signed [23:0] front = 24'sd0,
    output reg  signed [23:0] back = 24'sd0,
    output reg  removed = 1'd0
);

    wire signed [35:0] plane_value;
    reg is_in_word = 1'd0, is_before = 1'd0;
    reg signed [23:0] near_word = 24'sd0;
    wire signed [23:0] clamped;

    pe1_w36 plane (
        .clock(clock), .valid(valid), .start(start), .line(line), .a(a), .b(b), .c(c), .value(plane_value));

    assign clamped = is_in_word ? near_word : is_before ? 24'sh800000 : 24'sd8388607;

    always @(posedge clock) begin
        is_in_word <= (plane_value[35:23] == 13'd0) | (plane_value[35:23] == 13'd8191);
        is_before <= plane_value[35];
        near_word <= plane_value[23:0];
        front <= (kind == 2'd1) ? clamped : 24'sh800000;
        back <= (kind == 2'd2) ? clamped : 24'sd8388607;
        removed <= (kind == 2'd3) & is_before;
    end
endmodule
