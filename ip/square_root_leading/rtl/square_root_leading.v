// square_root_leading: the leading significant digits of floor(sqrt(radicand)), the lower ones zero
//
// parameters: format 24
//             digits 12
//             rows per stage 1
// latency:    14 clocks
// error:      bound: below 2^-11 of the root, downwards, or of one last place if that is more
// source:     Nyiri 1994, B.10
// ports:
//   in  clock           1 unsigned
//   in  radicand       48 unsigned
//   out root           24 unsigned
//
// Made by: imogene emit square_root_leading --format 24 --digits 12 --rows-per-stage 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_leading (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [23:0] root
);

    localparam [5:0] all_digits = 6'd24;
    localparam [1:0] by_one = 2'd1;
    localparam [7:0] missing = 8'd12;
    wire [5:0] places;
    wire [6:0] wide_places;
    wire [6:0] doubled_places;
    wire [23:0] aligned;
    wire [5:0] measured_length;
    wire [23:0] network_root;
    wire [24:0] unused_network_remainder;
    wire [5:0] beside_late;
    reg [47:0] normal = 48'd0;
    reg [5:0] kept_places = 6'd0;
    reg [23:0] kept_root = 24'd0;

    root_length measured (
        .radicand(radicand),
        .length(measured_length)
    );

    square_root network (
        .clock(clock),
        .radicand(normal),
        .root(network_root),
        .remainder(unused_network_remainder)
    );

    word_delay beside (
        .clock(clock),
        .word(kept_places),
        .late(beside_late)
    );

    assign places = all_digits - measured_length;
    assign wide_places = {1'd0, places};
    assign doubled_places = wide_places << by_one;
    assign aligned = network_root << missing;
    assign root = kept_root;

    always @(posedge clock) begin
        normal <= radicand << doubled_places;
        kept_places <= places;
        kept_root <= aligned >> beside_late;
    end

endmodule
