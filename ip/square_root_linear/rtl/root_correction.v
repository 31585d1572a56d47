// root_correction: part of square_root_linear; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module root_correction (
    input  wire clock,
    input  wire [47:0] radicand,
    input  wire [5:0] length,
    input  wire [24:0] root,
    output wire [47:0] late_radicand,
    output wire [5:0] late_length,
    output wire [24:0] next_root
);

    localparam [5:0] one = 6'd1;
    wire [47:0] excess;
    wire negative;
    wire [47:0] magnitude;
    wire [5:0] places;
    wire [47:0] shifted;
    wire [24:0] narrow;
    wire [24:0] taken;
    wire [47:0] squarer_square;
    reg [47:0] kept_square = 48'd0;
    reg [47:0] kept_radicand = 48'd0;
    reg [5:0] kept_length = 6'd0;
    reg [24:0] kept_root = 25'd0;
    reg [47:0] last_radicand = 48'd0;
    reg [5:0] last_length = 6'd0;
    reg [24:0] last_root = 25'd0;

    square squarer (
        .value(root),
        .square(squarer_square)
    );

    assign excess = kept_square - kept_radicand;
    assign negative = excess[47];
    assign magnitude = negative ? ~excess : excess;
    assign places = kept_length + one;
    assign shifted = magnitude >> places;
    assign narrow = shifted[24:0];
    assign taken = negative ? ~narrow : narrow;
    assign late_radicand = last_radicand;
    assign late_length = last_length;
    assign next_root = last_root;

    wire unused_bits = &{1'b0, shifted[47:25]};

    always @(posedge clock) begin
        kept_square <= squarer_square;
        kept_radicand <= radicand;
        kept_length <= length;
        kept_root <= root;
        last_root <= kept_root - taken;
        last_radicand <= kept_radicand;
        last_length <= kept_length;
    end

endmodule
