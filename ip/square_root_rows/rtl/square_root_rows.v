// square_root_rows: the upper digits of floor(sqrt(radicand)), the lower ones zero
//
// parameters: format 24
//             digits 12
//             rows per stage 1
// latency:    12 clocks
// error:      bound: below 2^12 of the last place, downwards, for every radicand: small roots are lost
// source:     Nyiri 1994, 2.3.3
// ports:
//   in  clock           1 unsigned
//   in  radicand       48 unsigned
//   out root           24 unsigned
//
// Made by: imogene emit square_root_rows --format 24 --digits 12 --rows-per-stage 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_rows (
    input  wire clock,
    input  wire [47:0] radicand,
    output wire [23:0] root
);

    localparam [7:0] missing = 8'd12;
    wire [23:0] network_root;
    wire [24:0] unused_network_remainder;

    square_root network (
        .clock(clock),
        .radicand(radicand),
        .root(network_root),
        .remainder(unused_network_remainder)
    );

    assign root = network_root << missing;

endmodule
