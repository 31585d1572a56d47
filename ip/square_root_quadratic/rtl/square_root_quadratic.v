// square_root_quadratic: an approximate square root by parabolas and corrections
//
// parameters: format 24
//             corrections 1
// latency:    5 clocks
// error:      bound: 0.532 % of the root besides floors; measured maximum with floors: 0.540 % at W = 24 and radicands
//             not below 2^23; not monotone: the root steps down by one at some radicands
// source:     Nyiri 1994, 2.3.3
// ports:
//   in  clock           1 unsigned
//   in  radicand       48 unsigned
//   out root           25 unsigned
//
// Made by: imogene emit square_root_quadratic --format 24 --corrections 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_quadratic (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [24:0] root
);

    localparam [24:0] one = 25'd1;
    localparam [35:0] four = 36'd4;
    localparam [7:0] by_4 = 8'd4;
    localparam [5:0] two_places = 6'd2;
    localparam [5:0] no_places = 6'd0;
    wire [24:0] power;
    wire [24:0] mask;
    wire [47:0] shifted;
    wire [24:0] low_part;
    wire [35:0] wide_scaled;
    wire [35:0] scaled_16;
    wire [35:0] scaled_15;
    wire [35:0] wide_rest;
    wire [35:0] rest_16;
    wire [35:0] rest_15;
    wire [35:0] rest_part;
    wire [35:0] offset;
    wire [35:0] slope;
    wire [5:0] places;
    wire [47:0] shifted_square;
    wire [35:0] square_part;
    wire [35:0] fifteenfold;
    wire [5:0] measured_length;
    wire [47:0] squarer_square;
    wire [24:0] fifteenth_quotient;
    wire [47:0] unused_corrections_0_late_radicand;
    wire [5:0] unused_corrections_0_late_length;
    wire [24:0] corrections_0_next_root;
    reg [23:0] kept_scaled = 24'd0;
    reg [24:0] kept_rest = 25'd0;
    reg [5:0] length_1 = 6'd0;
    reg [47:0] radicand_1 = 48'd0;
    reg [47:0] kept_square = 48'd0;
    reg [35:0] kept_sum = 36'd0;
    reg [5:0] length_2 = 6'd0;
    reg [47:0] radicand_2 = 48'd0;
    reg [5:0] length_3 = 6'd0;
    reg [47:0] radicand_3 = 48'd0;
    reg [24:0] kept_root = 25'd0;

    root_length measured (
        .radicand(radicand),
        .length(measured_length)
    );

    square_w48_v1 squarer (
        .value(kept_scaled),
        .square(squarer_square)
    );

    fifteenth fifteenth (
        .value(fifteenfold),
        .quotient(fifteenth_quotient)
    );

    root_correction corrections_0 (
        .clock(clock),
        .radicand(radicand_3),
        .length(length_3),
        .root(kept_root),
        .late_radicand(unused_corrections_0_late_radicand),
        .late_length(unused_corrections_0_late_length),
        .next_root(corrections_0_next_root)
    );

    assign power = one << measured_length;
    assign mask = power - one;
    assign shifted = radicand >> measured_length;
    assign low_part = radicand[24:0];
    assign wide_scaled = {12'd0, kept_scaled};
    assign scaled_16 = wide_scaled << by_4;
    assign scaled_15 = scaled_16 - wide_scaled;
    assign wide_rest = {11'd0, kept_rest};
    assign rest_16 = wide_rest << by_4;
    assign rest_15 = rest_16 - wide_rest;
    assign rest_part = rest_15 >> length_1;
    assign offset = four << length_1;
    assign slope = scaled_15 + rest_part;
    assign places = (length_2 < two_places) ? no_places : length_2 - two_places;
    assign shifted_square = kept_square >> places;
    assign square_part = shifted_square[35:0];
    assign fifteenfold = kept_sum - square_part;
    assign root = corrections_0_next_root;

    wire unused_bits = &{1'b0, shifted[47:24], shifted_square[47:36]};

    always @(posedge clock) begin
        kept_scaled <= shifted[23:0];
        kept_rest <= low_part & mask;
        length_1 <= measured_length;
        radicand_1 <= radicand;
        kept_sum <= slope + offset;
        kept_square <= squarer_square;
        length_2 <= length_1;
        radicand_2 <= radicand_1;
        kept_root <= fifteenth_quotient;
        length_3 <= length_2;
        radicand_3 <= radicand_2;
    end

endmodule
