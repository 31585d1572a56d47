// video_timing: the raster of a screen with its blanking, and the same some clocks ahead
//
// parameters: format 24
//             mode 0
// latency:    1 clock
// error:      exact
// source:     Chaillou 1991, I.2.4.2 and IV.4.4
// ports:
//   in  clock           1 unsigned
//   in  enable          1 unsigned
//   out de              1 unsigned
//   out start           1 unsigned
//   out line            1 unsigned
//   out x              12 unsigned
//   out y              12 unsigned
//   out hsync           1 unsigned
//   out vsync           1 unsigned
//   out frame_start     1 unsigned
//   out need            1 unsigned
//   out go              1 unsigned
//   out need_line       1 unsigned
//   out need_x         12 unsigned
//   out need_y         12 unsigned
//
// Made by: imogene emit video_timing --format 24 --mode 0 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module video_timing (
    input  wire clock,
    input  wire enable,
    output wire de,
    output wire start,
    output wire line,
    output wire [11:0] x,
    output wire [11:0] y,
    output wire hsync,
    output wire vsync,
    output wire frame_start,
    output wire need,
    output wire go,
    output wire need_line,
    output wire [11:0] need_x,
    output wire [11:0] need_y
);

    localparam [12:0] hsync_begin = 13'd2;
    localparam [12:0] hsync_end = 13'd5;
    localparam [12:0] vsync_begin = 13'd1;
    localparam [12:0] vsync_end = 13'd2;
    localparam hsync_low = 1'd1;
    localparam vsync_low = 1'd0;
    wire [12:0] shown_column;
    wire [12:0] shown_row;
    wire shown_active;
    wire shown_start;
    wire shown_line;
    wire [11:0] shown_x;
    wire [11:0] shown_y;
    wire shown_retrace;
    wire [12:0] unused_ahead_column;
    wire [12:0] unused_ahead_row;
    wire ahead_active;
    wire ahead_start;
    wire ahead_line;
    wire [11:0] ahead_x;
    wire [11:0] ahead_y;
    wire unused_ahead_retrace;
    reg in_hsync = 1'd0;
    reg in_vsync = 1'd0;

    video_scan_w13_v1 shown (
        .clock(clock),
        .enable(enable),
        .column(shown_column),
        .row(shown_row),
        .active(shown_active),
        .start(shown_start),
        .line(shown_line),
        .x(shown_x),
        .y(shown_y),
        .retrace(shown_retrace)
    );

    video_scan_w13_v2 ahead (
        .clock(clock),
        .enable(enable),
        .column(unused_ahead_column),
        .row(unused_ahead_row),
        .active(ahead_active),
        .start(ahead_start),
        .line(ahead_line),
        .x(ahead_x),
        .y(ahead_y),
        .retrace(unused_ahead_retrace)
    );

    assign de = shown_active;
    assign start = shown_start;
    assign line = shown_line;
    assign x = shown_x;
    assign y = shown_y;
    assign hsync = in_hsync ^ hsync_low;
    assign vsync = in_vsync ^ vsync_low;
    assign frame_start = shown_retrace;
    assign need = ahead_active;
    assign go = ahead_start;
    assign need_line = ahead_line;
    assign need_x = ahead_x;
    assign need_y = ahead_y;

    always @(posedge clock) begin
        if (enable) begin
            if (shown_column == hsync_end) begin
                in_hsync <= 1'd0;
            end
            if (shown_column == hsync_begin) begin
                in_hsync <= 1'd1;
                if (shown_row == vsync_end) begin
                    in_vsync <= 1'd0;
                end
                if (shown_row == vsync_begin) begin
                    in_vsync <= 1'd1;
                end
            end
        end
    end

endmodule
