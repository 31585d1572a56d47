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
    output wire last
);

    reg [11:0] column_before = 12'd0, line_before = 12'd0;
    reg is_narrow = 1'd0, in_last_column = 1'd0, in_last_line = 1'd0;
    wire last_2, goes_on, obeyed, steps, one_column, one_line, column_is_last, line_is_last;
    wire [11:0] next_x, next_y;

    assign last_2 = (valid & in_last_column) & in_last_line;
    assign goes_on = valid & ~last_2;
    assign obeyed = go & ~goes_on;
    assign steps = obeyed | goes_on;
    assign next_x = in_last_column ? 12'd0 : (x + 12'd1);
    assign next_y = in_last_column ? (y + 12'd1) : y;
    assign one_column = width == 12'd1;
    assign one_line = height == 12'd1;
    assign column_is_last = is_narrow | (x == column_before);
    assign line_is_last = in_last_line | (in_last_column & (y == line_before));
    assign last = last_2;

    always @(posedge clock) begin
        valid <= steps;
        start <= obeyed;
        line <= goes_on & in_last_column;
        if (steps) begin
            x <= obeyed ? 12'd0 : next_x;
            y <= obeyed ? 12'd0 : next_y;
            in_last_column <= obeyed ? one_column : column_is_last;
            in_last_line <= obeyed ? one_line : line_is_last;
        end
        if (obeyed) begin
            column_before <= width - 12'd2;
            line_before <= height - 12'd2;
            is_narrow <= one_column;
        end
    end
endmodule
