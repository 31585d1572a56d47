// raster_control: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module raster_control (
    input  wire clock, go,
    input  wire [11:0] width, height,
    output reg  valid = 1'd0,
    output reg  start = 1'd0,
    output reg  line = 1'd0,
    output reg  [11:0] x = 12'd0,
    output reg  [11:0] y = 12'd0,
    output reg  last = 1'd0
);

    reg [11:0] right_edge = 12'd0, bottom_edge = 12'd0;
    wire obeyed, line_ends, is_single, next_is_last, moves, goes_on;
    wire [11:0] next_x, next_y, last_x, last_y;

    assign obeyed = go & (~valid | last);
    assign line_ends = x == right_edge;
    assign next_x = line_ends ? 12'd0 : (x + 12'd1);
    assign next_y = line_ends ? (y + 12'd1) : y;
    assign last_x = width - 12'd1;
    assign last_y = height - 12'd1;
    assign is_single = (last_x == 12'd0) & (last_y == 12'd0);
    assign next_is_last = (next_x == right_edge) & (next_y == bottom_edge);
    assign moves = (obeyed | last) | valid;
    assign goes_on = ~last;

    always @(posedge clock) begin
        if (moves) begin
            valid <= obeyed ? 1'd1 : goes_on;
            start <= obeyed;
            line <= obeyed ? 1'd0 : (goes_on & line_ends);
            last <= obeyed ? is_single : (goes_on & next_is_last);
        end
        if (obeyed | (goes_on & valid)) begin x <= obeyed ? 12'd0 : next_x; y <= obeyed ? 12'd0 : next_y; end
        if (obeyed) begin right_edge <= last_x; bottom_edge <= last_y; end
    end
endmodule
