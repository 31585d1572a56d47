// square_root_iterative: root = floor(sqrt(radicand)) and remainder = radicand - root^2, one digit per clock
//
// parameters: format 24
// latency:    24 clocks
// error:      exact
// source:     Nyiri 1994, 2.3.3
// ports:
//   in  clock           1 unsigned
//   in  start           1 unsigned
//   in  radicand       48 unsigned
//   out busy            1 unsigned
//   out done            1 unsigned
//   out root           24 unsigned
//   out remainder      25 unsigned
//
// Made by: imogene emit square_root_iterative --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_iterative (
    input  wire clock,
    input  wire start,
    input  wire [47:0] radicand,
    output wire busy,
    output wire done,
    output wire [23:0] root,
    output wire [24:0] remainder
);

    localparam [5:0] all_digits = 6'd24;
    localparam [5:0] none = 6'd0;
    localparam [5:0] one = 6'd1;
    localparam [23:0] no_digits = 24'd0;
    localparam [24:0] no_remainder = 25'd0;
    localparam [25:0] all_live = 26'd16777215;
    wire is_busy;
    wire begins;
    wire [5:0] current;
    wire works;
    wire [5:0] less;
    wire [47:0] row_pairs;
    wire [23:0] row_root;
    wire [24:0] row_remainder;
    wire [47:0] row_next_pairs;
    wire [23:0] row_next_root;
    wire [24:0] row_next_remainder;
    wire [25:0] unused_row_next_live;
    reg [47:0] pairs_left = 48'd0;
    reg [23:0] kept_root = 24'd0;
    reg [24:0] kept_remainder = 25'd0;
    reg [5:0] digits_left = 6'd0;
    reg kept_done = 1'd0;

    square_root_row row (
        .pairs(row_pairs),
        .root(row_root),
        .remainder(row_remainder),
        .live(all_live),
        .next_pairs(row_next_pairs),
        .next_root(row_next_root),
        .next_remainder(row_next_remainder),
        .next_live(unused_row_next_live)
    );

    assign is_busy = digits_left != none;
    assign begins = start & ~is_busy;
    assign current = begins ? all_digits : digits_left;
    assign works = begins | is_busy;
    assign less = current - one;
    assign row_pairs = begins ? radicand : pairs_left;
    assign row_root = begins ? no_digits : kept_root;
    assign row_remainder = begins ? no_remainder : kept_remainder;
    assign busy = is_busy;
    assign done = kept_done;
    assign root = kept_root;
    assign remainder = kept_remainder;

    always @(posedge clock) begin
        kept_done <= current == one;
        if (works) begin
            pairs_left <= row_next_pairs;
            kept_root <= row_next_root;
            kept_remainder <= row_next_remainder;
            digits_left <= less;
        end
    end

endmodule
