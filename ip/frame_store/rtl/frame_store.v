// frame_store: the last whole frame that came, while the next one comes
//
// parameters: format 24
// latency:    3 clocks
// error:      exact
// source:     architecture, 8
// ports:
//   in  clock           1 unsigned
//   in  width          12 unsigned
//   in  s_tvalid        1 unsigned
//   in  s_tdata        24 unsigned
//   in  s_tuser        24 unsigned
//   in  s_tlast         1 unsigned
//   in  retrace         1 unsigned
//   in  need            1 unsigned
//   in  x              12 unsigned
//   in  y              12 unsigned
//   out s_tready        1 unsigned
//   out valid           1 unsigned
//   out r               8 unsigned
//   out g               8 unsigned
//   out b               8 unsigned
//   out swapped         1 unsigned
//
// Made by: imogene emit frame_store --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module frame_store (
    input  wire clock,
    input  wire [11:0] width,
    input  wire s_tvalid,
    input  wire [23:0] s_tdata,
    input  wire [23:0] s_tuser,
    input  wire s_tlast,
    input  wire retrace,
    input  wire need,
    input  wire [11:0] x,
    input  wire [11:0] y,
    output wire s_tready,
    output wire valid,
    output wire [7:0] r,
    output wire [7:0] g,
    output wire [7:0] b,
    output wire swapped
);

    wire taken;
    wire swaps;
    wire [23:0] colour;
    wire [11:0] write_place_x;
    wire [11:0] write_place_y;
    wire [23:0] write_place_place;
    wire [23:0] read_place_place;
    wire late_taken_late;
    wire [23:0] late_data_late;
    wire late_write_bank_late;
    wire late_need_late;
    wire late_read_bank_late;
    wire first_bank_write;
    wire [11:0] first_bank_write_address;
    wire [11:0] first_bank_read_address;
    wire [23:0] first_bank_read_data;
    wire second_bank_write;
    wire [11:0] second_bank_write_address;
    wire [11:0] second_bank_read_address;
    wire [23:0] second_bank_read_data;
    reg second_is_shown = 1'd0;
    reg is_whole = 1'd0;
    reg kept_swapped = 1'd0;

    pixel_place write_place (
        .clock(clock),
        .x(write_place_x),
        .y(write_place_y),
        .width(width),
        .place(write_place_place)
    );

    pixel_place read_place (
        .clock(clock),
        .x(x),
        .y(y),
        .width(width),
        .place(read_place_place)
    );

    word_delay_w1_x2 late_taken (
        .clock(clock),
        .word(taken),
        .late(late_taken_late)
    );

    word_delay_w24_x2 late_data (
        .clock(clock),
        .word(s_tdata),
        .late(late_data_late)
    );

    word_delay_w1_x2 late_write_bank (
        .clock(clock),
        .word(second_is_shown),
        .late(late_write_bank_late)
    );

    word_delay_w1_x3 late_need (
        .clock(clock),
        .word(need),
        .late(late_need_late)
    );

    word_delay_w1_x3 late_read_bank (
        .clock(clock),
        .word(second_is_shown),
        .late(late_read_bank_late)
    );

    block_memory first_bank (
        .clock(clock),
        .write(first_bank_write),
        .write_address(first_bank_write_address),
        .write_data(late_data_late),
        .read_address(first_bank_read_address),
        .read_data(first_bank_read_data)
    );

    block_memory second_bank (
        .clock(clock),
        .write(second_bank_write),
        .write_address(second_bank_write_address),
        .write_data(late_data_late),
        .read_address(second_bank_read_address),
        .read_data(second_bank_read_data)
    );

    assign taken = s_tvalid & ~is_whole;
    assign swaps = retrace & is_whole;
    assign colour = late_read_bank_late ? second_bank_read_data : first_bank_read_data;
    assign write_place_x = s_tuser[11:0];
    assign write_place_y = s_tuser[23:12];
    assign first_bank_write = late_taken_late & late_write_bank_late;
    assign first_bank_write_address = write_place_place[11:0];
    assign first_bank_read_address = read_place_place[11:0];
    assign second_bank_write = late_taken_late & ~late_write_bank_late;
    assign second_bank_write_address = write_place_place[11:0];
    assign second_bank_read_address = read_place_place[11:0];
    assign s_tready = ~is_whole;
    assign valid = late_need_late;
    assign r = colour[23:16];
    assign g = colour[15:8];
    assign b = colour[7:0];
    assign swapped = kept_swapped;

    wire unused_bits = &{1'b0, write_place_place[23:12], read_place_place[23:12]};

    always @(posedge clock) begin
        if (taken & s_tlast) begin
            is_whole <= 1'd1;
        end
        if (swaps) begin
            is_whole <= 1'd0;
            second_is_shown <= ~second_is_shown;
        end
        kept_swapped <= swaps;
    end

endmodule
