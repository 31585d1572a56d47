// colour_blend: part of transparency_pipeline; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module colour_blend (
    input  wire clock,
    input  wire [7:0] front,
    input  wire [7:0] behind,
    input  wire [7:0] weight,
    input  wire is_seen,
    output wire [7:0] blend
);

    localparam [15:0] half = 16'd128;
    localparam [7:0] by_byte = 8'd8;
    wire [8:0] wide_front;
    wire [8:0] wide_behind;
    wire [8:0] wide_weight;
    wire signed [8:0] signed_weight;
    wire [8:0] difference;
    wire signed [8:0] signed_difference;
    wire signed [15:0] low_product;
    wire [15:0] product;
    wire [15:0] single;
    wire [15:0] shifted;
    wire [15:0] base;
    wire [15:0] sum;
    wire [15:0] quotient;
    wire [15:0] rounded;
    wire [15:0] term_1;
    reg signed [17:0] kept_product = 18'sd0;
    reg [7:0] kept_behind = 8'd0;
    reg kept_is_seen = 1'd0;
    reg [7:0] kept_blend = 8'd0;

    assign term_1 = base + product;
    assign wide_front = {1'd0, front};
    assign wide_behind = {1'd0, behind};
    assign wide_weight = {1'd0, weight};
    assign signed_weight = wide_weight;
    assign difference = wide_front - wide_behind;
    assign signed_difference = difference;
    assign low_product = kept_product[15:0];
    assign product = low_product;
    assign single = {8'd0, kept_behind};
    assign shifted = single << by_byte;
    assign base = shifted - single;
    assign sum = term_1 + half;
    assign quotient = sum >> by_byte;
    assign rounded = sum + quotient;
    assign blend = kept_blend;

    wire unused_bits = &{1'b0, rounded[7:0], kept_product[17:16]};

    always @(posedge clock) begin
        kept_product <= signed_difference * signed_weight;
        kept_behind <= behind;
        kept_is_seen <= is_seen;
        if (kept_is_seen) begin
            kept_blend <= rounded[15:8];
        end else begin
            kept_blend <= kept_behind;
        end
    end

endmodule
