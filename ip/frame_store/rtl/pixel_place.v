// pixel_place: part of frame_store; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module pixel_place (
    input  wire clock,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire [11:0] width,
    output wire [23:0] place
);

    wire [12:0] wide_y;
    wire [12:0] wide_width;
    wire signed [12:0] factor_y;
    wire signed [12:0] factor_width;
    wire signed [25:0] product;
    wire [23:0] wide_x;
    reg [23:0] line_place = 24'd0;
    reg [11:0] kept_x = 12'd0;
    reg [23:0] kept_place = 24'd0;

    assign wide_y = {1'd0, y};
    assign wide_width = {1'd0, width};
    assign factor_y = wide_y;
    assign factor_width = wide_width;
    assign product = factor_y * factor_width;
    assign wide_x = {12'd0, kept_x};
    assign place = kept_place;

    wire unused_bits = &{1'b0, product[25:24]};

    always @(posedge clock) begin
        line_place <= product[23:0];
        kept_x <= x;
        kept_place <= line_place + wide_x;
    end

endmodule
