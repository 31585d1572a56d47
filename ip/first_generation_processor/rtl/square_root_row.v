// square_root_row: part of first_generation_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module square_root_row (
    input  wire [47:0] pairs,
    input  wire [23:0] root,
    input  wire [24:0] remainder,
    input  wire [25:0] live,
    output wire [47:0] next_pairs,
    output wire [23:0] next_root,
    output wire [24:0] next_remainder,
    output wire [25:0] next_live
);

    localparam [25:0] none = 26'd0;
    localparam [1:0] by_one = 2'd1;
    localparam [1:0] by_two = 2'd2;
    localparam [23:0] digit = 24'd1;
    localparam [25:0] wide_digit = 26'd1;
    wire [25:0] wide_remainder;
    wire [25:0] shifted_remainder;
    wire [1:0] top_pair;
    wire [25:0] pair;
    wire [25:0] dividend;
    wire [25:0] wide_root;
    wire [25:0] shifted_root;
    wire [25:0] divisor;
    wire [25:0] trial;
    wire [25:0] shifted_live;
    wire [25:0] grown_live;
    wire [25:0] sign;
    wire [25:0] trial_sign;
    wire negative;
    wire [25:0] kept;
    wire [25:0] live_kept;
    wire [23:0] doubled_root;

    assign wide_remainder = {1'd0, remainder};
    assign shifted_remainder = wide_remainder << by_two;
    assign top_pair = pairs[47:46];
    assign pair = {24'd0, top_pair};
    assign dividend = shifted_remainder | pair;
    assign wide_root = {2'd0, root};
    assign shifted_root = wide_root << by_two;
    assign divisor = shifted_root | wide_digit;
    assign trial = dividend - divisor;
    assign shifted_live = live << by_one;
    assign grown_live = shifted_live | wide_digit;
    assign sign = grown_live + wide_digit;
    assign trial_sign = trial & sign;
    assign negative = trial_sign != none;
    assign kept = negative ? dividend : trial;
    assign live_kept = kept & grown_live;
    assign doubled_root = root << by_one;
    assign next_pairs = pairs << by_two;
    assign next_root = negative ? doubled_root : doubled_root | digit;
    assign next_remainder = live_kept[24:0];
    assign next_live = grown_live;

    wire unused_bits = &{1'b0, live_kept[25]};

endmodule
