// memory_pe2: value(x, y) of second degree by two adders, three registers and a memory of one port, field by field
//
// parameters: format 24
// latency:    1 clock
// error:      exact modulo the width of the value; whoever makes the coefficients proves that the true value fits
// source:     Chaillou 1991, IV.1.5
// ports:
//   in  clock           1 unsigned
//   in  load_valid      1 unsigned
//   in  load_address    4 unsigned
//   in  load_data      48 two's complement
//   in  field_start     1 unsigned
//   in  picture_start   1 unsigned
//   in  odd_field       1 unsigned
//   in  line_start      1 unsigned
//   in  pixel           1 unsigned
//   out ready           1 unsigned
//   out value_valid     1 unsigned
//   out value          48 two's complement
//
// Made by: imogene emit memory_pe2 --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module memory_pe2 (
    input  wire clock,
    input  wire load_valid,
    input  wire [3:0] load_address,
    input  wire signed [47:0] load_data,
    input  wire field_start,
    input  wire picture_start,
    input  wire odd_field,
    input  wire line_start,
    input  wire pixel,
    output wire ready,
    output wire value_valid,
    output wire signed [47:0] value
);

    localparam [4:0] restore = 5'd0;
    localparam [4:0] restore_end = 5'd5;
    localparam [4:0] line_step = 5'd6;
    localparam [4:0] line_step_end = 5'd17;
    localparam [4:0] line_entry = 5'd18;
    localparam [4:0] line_entry_end = 5'd20;
    localparam [4:0] pixel_step = 5'd21;
    localparam [4:0] idle = 5'd22;
    localparam [4:0] one = 5'd1;
    localparam [1:0] clear = 2'd1;
    localparam [1:0] memory = 2'd2;
    localparam [1:0] sum = 2'd3;
    localparam signed [47:0] zero = 48'sd0;
    localparam [10:0] no_instruction = 11'd0;
    wire [4:0] step;
    wire [4:0] following;
    wire goes_on;
    wire [10:0] instruction;
    wire [3:0] word;
    wire writes;
    wire signed [47:0] from_port;
    wire [1:0] r1_next;
    wire [1:0] r2_next;
    wire [1:0] r3_next;
    reg busy = 1'd0;
    reg [4:0] next_step = 5'd0;
    reg interlaced = 1'd0;
    reg two_steps_due = 1'd0;
    reg second_step = 1'd0;
    reg signed [47:0] r1 = 48'sd0;
    reg signed [47:0] r2 = 48'sd0;
    reg signed [47:0] r3 = 48'sd0;
    reg kept_valid = 1'd0;
    reg signed [47:0] words_0 = 48'sd0;
    reg signed [47:0] words_1 = 48'sd0;
    reg signed [47:0] words_2 = 48'sd0;
    reg signed [47:0] words_3 = 48'sd0;
    reg signed [47:0] words_4 = 48'sd0;
    reg signed [47:0] words_5 = 48'sd0;
    reg signed [47:0] words_6 = 48'sd0;
    reg signed [47:0] words_7 = 48'sd0;
    reg signed [47:0] words_8 = 48'sd0;

    assign step = busy ? next_step :
        field_start ? restore :
        ~picture_start ? (line_start ? line_step :
            pixel ? pixel_step : idle) : idle;
    assign following = (step == line_step_end) ? (second_step ? line_step : line_entry) : step + one;
    assign goes_on = ((step == restore_end) | (step == line_entry_end)) ? 1'd0 : step < pixel_step;
    assign instruction = (step == 5'd22) ? 11'd0 :
        (step == 5'd21) ? 11'd60 :
        (step == 5'd20) ? 11'd12 :
        (step == 5'd19) ? 11'd2 :
        (step == 5'd18) ? 11'd352 :
        (step == 5'd17) ? 11'd1280 :
        (step == 5'd16) ? 11'd48 :
        (step == 5'd15) ? 11'd12 :
        (step == 5'd14) ? 11'd264 :
        (step == 5'd13) ? 11'd130 :
        (step == 5'd12) ? 11'd1232 :
        (step == 5'd11) ? 11'd48 :
        (step == 5'd10) ? 11'd1360 :
        (step == 5'd9) ? 11'd48 :
        (step == 5'd8) ? 11'd364 :
        (step == 5'd7) ? 11'd200 :
        (step == 5'd6) ? 11'd66 :
        (step == 5'd5) ? 11'd1344 :
        (step == 5'd4) ? 11'd544 :
        (step == 5'd3) ? 11'd1280 :
        (step == 5'd2) ? 11'd480 :
        (step == 5'd1) ? 11'd1216 :
        (step == 5'd0) ? 11'd416 : no_instruction;
    assign word = instruction[9:6];
    assign writes = instruction[10];
    assign from_port = (word == 4'd8) ? words_8 :
        (word == 4'd7) ? words_7 :
        (word == 4'd6) ? words_6 :
        (word == 4'd5) ? words_5 :
        (word == 4'd4) ? words_4 :
        (word == 4'd3) ? words_3 :
        (word == 4'd2) ? words_2 :
        (word == 4'd1) ? words_1 :
        (word == 4'd0) ? words_0 : zero;
    assign r1_next = instruction[1:0];
    assign r2_next = instruction[3:2];
    assign r3_next = instruction[5:4];
    assign ready = ~busy;
    assign value_valid = kept_valid;
    assign value = r3;

    always @(posedge clock) begin
        if (~busy) begin
            if (field_start) begin
                interlaced <= 1'd1;
                two_steps_due <= odd_field;
            end else if (picture_start) begin
                interlaced <= 1'd0;
                two_steps_due <= 1'd0;
            end else if (line_start) begin
                second_step <= two_steps_due;
                two_steps_due <= interlaced;
            end
        end
        if (step == line_step_end) begin
            if (second_step) begin
                second_step <= 1'd0;
            end
        end
        busy <= goes_on;
        next_step <= following;
        if (word == 4'd0) begin
            if (writes) begin
                words_0 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd0)) begin
            words_0 <= load_data;
        end
        if (word == 4'd1) begin
            if (writes) begin
                words_1 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd1)) begin
            words_1 <= load_data;
        end
        if (word == 4'd2) begin
            if (writes) begin
                words_2 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd2)) begin
            words_2 <= load_data;
        end
        if (word == 4'd3) begin
            if (writes) begin
                words_3 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd3)) begin
            words_3 <= load_data;
        end
        if (word == 4'd4) begin
            if (writes) begin
                words_4 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd4)) begin
            words_4 <= load_data;
        end
        if (word == 4'd5) begin
            if (writes) begin
                words_5 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd5)) begin
            words_5 <= load_data;
        end
        if (word == 4'd6) begin
            if (writes) begin
                words_6 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd6)) begin
            words_6 <= load_data;
        end
        if (word == 4'd7) begin
            if (writes) begin
                words_7 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd7)) begin
            words_7 <= load_data;
        end
        if (word == 4'd8) begin
            if (writes) begin
                words_8 <= r3;
            end
        end
        if ((load_valid & ~busy) & (load_address == 4'd8)) begin
            words_8 <= load_data;
        end
        if (r1_next == memory) begin
            r1 <= from_port;
        end
        if (r2_next == memory) begin
            r2 <= from_port;
        end
        if (r2_next == sum) begin
            r2 <= r1 + r2;
        end
        if (r3_next == clear) begin
            r3 <= zero;
        end
        if (r3_next == memory) begin
            r3 <= from_port;
        end
        if (r3_next == sum) begin
            r3 <= r2 + r3;
        end
        kept_valid <= step == pixel_step;
    end

endmodule
