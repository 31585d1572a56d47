// video_scan_w13_v2: part of video_timing; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module video_scan_w13_v2 (
    input  wire clock,
    input  wire enable,
    output wire [12:0] column,
    output wire [12:0] row,
    output wire active,
    output wire start,
    output wire line,
    output wire [11:0] x,
    output wire [11:0] y,
    output wire retrace
);

    localparam [12:0] begin_column = 13'd40;
    localparam [12:0] begin_row = 13'd0;
    localparam [12:0] last_column = 13'd167;
    localparam [12:0] last_row = 13'd121;
    localparam [12:0] left = 13'd8;
    localparam [12:0] top = 13'd2;
    localparam [11:0] low_left = 12'd8;
    localparam [11:0] low_top = 12'd2;
    localparam [11:0] origin = 12'd0;
    localparam [12:0] zero = 13'd0;
    localparam [12:0] one = 13'd1;
    wire [12:0] now_column;
    wire [12:0] now_row;
    wire [12:0] next_column;
    wire [12:0] next_row;
    wire is_shown;
    wire is_left;
    wire is_top;
    wire [11:0] low_column;
    wire [11:0] low_row;
    reg [12:0] kept_column = 13'd0;
    reg [12:0] kept_row = 13'd0;
    reg kept_active = 1'd0;
    reg kept_start = 1'd0;
    reg kept_line = 1'd0;
    reg [11:0] kept_x = 12'd0;
    reg [11:0] kept_y = 12'd0;
    reg kept_retrace = 1'd0;

    assign now_column = kept_column ^ begin_column;
    assign now_row = kept_row ^ begin_row;
    assign next_column = (now_column == last_column) ? zero : now_column + one;
    assign next_row = (now_column == last_column) ? ((now_row == last_row) ? zero : now_row + one) : now_row;
    assign is_shown = (now_column >= left) & (now_row >= top);
    assign is_left = now_column == left;
    assign is_top = now_row == top;
    assign low_column = now_column[11:0];
    assign low_row = now_row[11:0];
    assign column = now_column;
    assign row = now_row;
    assign active = kept_active;
    assign start = kept_start;
    assign line = kept_line;
    assign x = kept_x;
    assign y = kept_y;
    assign retrace = kept_retrace;

    always @(posedge clock) begin
        if (enable) begin
            kept_column <= next_column ^ begin_column;
            kept_row <= next_row ^ begin_row;
            kept_active <= is_shown;
            kept_start <= (is_shown & is_left) & is_top;
            kept_line <= (is_shown & is_left) & ~is_top;
            kept_retrace <= (now_column == zero) & (now_row == zero);
            kept_x <= origin;
            kept_y <= origin;
            if (is_shown) begin
                kept_x <= low_column - low_left;
                kept_y <= low_row - low_top;
            end
        end
    end

endmodule
