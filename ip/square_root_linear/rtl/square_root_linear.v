// square_root_linear: an approximate square root by straight lines and corrections, monotone
//
// parameters: format 24
//             corrections 2
// latency:    5 clocks
// error:      bound: 0.473 % of the root besides floors; measured maximum with floors: 0.507 % at W = 24 and radicands
//             not below 2^23; monotone
// source:     Nyiri 1994, 2.3.3
// ports:
//   in  clock           1 unsigned
//   in  radicand       48 unsigned
//   out root           25 unsigned
//
// Made by: imogene emit square_root_linear --format 24 --corrections 2 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_linear (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [24:0] root
);

    localparam [24:0] one = 25'd1;
    localparam [24:0] none = 25'd0;
    localparam [1:0] by_one = 2'd1;
    localparam [1:0] by_two = 2'd2;
    wire [24:0] power;
    wire [24:0] half;
    wire [24:0] quarter;
    wire [24:0] rest;
    wire [47:0] shifted;
    wire [24:0] scaled;
    wire [24:0] half_scaled;
    wire [24:0] top_digit;
    wire is_even;
    wire [24:0] slope;
    wire [24:0] offset;
    wire [5:0] measured_length;
    wire [47:0] corrections_0_late_radicand;
    wire [5:0] corrections_0_late_length;
    wire [24:0] corrections_0_next_root;
    wire [47:0] unused_corrections_1_late_radicand;
    wire [5:0] unused_corrections_1_late_length;
    wire [24:0] corrections_1_next_root;
    reg [47:0] kept_radicand = 48'd0;
    reg [5:0] kept_length = 6'd0;
    reg [24:0] kept_root = 25'd0;

    root_length measured (
        .radicand(radicand),
        .length(measured_length)
    );

    root_correction corrections_0 (
        .clock(clock),
        .radicand(kept_radicand),
        .length(kept_length),
        .root(kept_root),
        .late_radicand(corrections_0_late_radicand),
        .late_length(corrections_0_late_length),
        .next_root(corrections_0_next_root)
    );

    root_correction corrections_1 (
        .clock(clock),
        .radicand(corrections_0_late_radicand),
        .length(corrections_0_late_length),
        .root(corrections_0_next_root),
        .late_radicand(unused_corrections_1_late_radicand),
        .late_length(unused_corrections_1_late_length),
        .next_root(corrections_1_next_root)
    );

    assign power = one << measured_length;
    assign half = power >> by_one;
    assign quarter = power >> by_two;
    assign rest = half - quarter;
    assign shifted = radicand >> measured_length;
    assign scaled = shifted[24:0];
    assign half_scaled = scaled >> by_one;
    assign top_digit = scaled & half;
    assign is_even = top_digit != none;
    assign slope = is_even ? half_scaled : scaled;
    assign offset = is_even ? half : rest;
    assign root = corrections_1_next_root;

    wire unused_bits = &{1'b0, shifted[47:25]};

    always @(posedge clock) begin
        kept_root <= slope + offset;
        kept_radicand <= radicand;
        kept_length <= measured_length;
    end

endmodule
