// digit_product: part of square_root_quadratic; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module digit_product (
    input  wire [14:0] a,
    input  wire [14:0] b,
    output wire [47:0] product
);

    wire [15:0] wide_a;
    wire [15:0] wide_b;
    wire signed [15:0] factor_a;
    wire signed [15:0] factor_b;
    wire signed [31:0] signed_product;
    wire [31:0] plain_product;

    assign wide_a = {1'd0, a};
    assign wide_b = {1'd0, b};
    assign factor_a = wide_a;
    assign factor_b = wide_b;
    assign signed_product = factor_a * factor_b;
    assign plain_product = signed_product;
    assign product = {16'd0, plain_product};

endmodule
