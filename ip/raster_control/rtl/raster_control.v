// raster_control: the raster flags of a zone, one pixel per clock, without a bubble
//
// parameters: format 24
// latency:    1 clock
// error:      exact
// source:     architecture, 2
// ports:
//   in  clock           1 unsigned
//   in  go              1 unsigned
//   in  width          12 unsigned
//   in  height         12 unsigned
//   out valid           1 unsigned
//   out start           1 unsigned
//   out line            1 unsigned
//   out x              12 unsigned
//   out y              12 unsigned
//   out last            1 unsigned
//
// Made by: imogene emit raster_control --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module raster_control (
    input  wire clock,
    input  wire go,
    input  wire [11:0] width,
    input  wire [11:0] height,
    output wire valid,
    output wire start,
    output wire line,
    output wire [11:0] x,
    output wire [11:0] y,
    output wire last
);

    localparam [11:0] zero = 12'd0;
    localparam [11:0] one = 12'd1;
    wire obeyed;
    wire line_ends;
    wire [11:0] next_x;
    wire [11:0] next_y;
    wire [11:0] last_x;
    wire [11:0] last_y;
    reg kept_valid = 1'd0;
    reg kept_start = 1'd0;
    reg kept_line = 1'd0;
    reg kept_last = 1'd0;
    reg [11:0] kept_x = 12'd0;
    reg [11:0] kept_y = 12'd0;
    reg [11:0] right_edge = 12'd0;
    reg [11:0] bottom_edge = 12'd0;

    assign obeyed = go & (~kept_valid | kept_last);
    assign line_ends = kept_x == right_edge;
    assign next_x = line_ends ? zero : kept_x + one;
    assign next_y = line_ends ? kept_y + one : kept_y;
    assign last_x = width - one;
    assign last_y = height - one;
    assign valid = kept_valid;
    assign start = kept_start;
    assign line = kept_line;
    assign x = kept_x;
    assign y = kept_y;
    assign last = kept_last;

    always @(posedge clock) begin
        if (obeyed) begin
            kept_valid <= 1'd1;
            kept_start <= 1'd1;
            kept_line <= 1'd0;
            kept_last <= (last_x == zero) & (last_y == zero);
            kept_x <= zero;
            kept_y <= zero;
            right_edge <= last_x;
            bottom_edge <= last_y;
        end else if (kept_last) begin
            kept_valid <= 1'd0;
            kept_start <= 1'd0;
            kept_line <= 1'd0;
            kept_last <= 1'd0;
        end else if (kept_valid) begin
            kept_start <= 1'd0;
            kept_line <= line_ends;
            kept_last <= (next_x == right_edge) & (next_y == bottom_edge);
            kept_x <= next_x;
            kept_y <= next_y;
        end
    end

endmodule
