// square: part of square_root_linear; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module square (
    input  wire [24:0] value,
    output wire [47:0] square
);

    wire [47:0] wide;
    wire [14:0] low;
    wire [14:0] middle;
    wire [14:0] high;
    wire [47:0] term_1;
    wire [47:0] term_2;
    wire [47:0] term_3;
    wire [47:0] term_4;
    wire [47:0] term_5;
    wire [47:0] lower_sum;
    wire [47:0] middle_sum;
    wire [47:0] upper_sum;
    wire [47:0] most;
    wire [47:0] products_0_product;
    wire [47:0] products_1_product;
    wire [47:0] products_2_product;
    wire [47:0] products_3_product;
    wire [47:0] products_4_product;
    wire [47:0] products_5_product;

    digit_product products_0 (
        .a(low),
        .b(low),
        .product(products_0_product)
    );

    digit_product products_1 (
        .a(low),
        .b(middle),
        .product(products_1_product)
    );

    digit_product products_2 (
        .a(middle),
        .b(middle),
        .product(products_2_product)
    );

    digit_product products_3 (
        .a(low),
        .b(high),
        .product(products_3_product)
    );

    digit_product products_4 (
        .a(middle),
        .b(high),
        .product(products_4_product)
    );

    digit_product products_5 (
        .a(high),
        .b(high),
        .product(products_5_product)
    );

    assign wide = {23'd0, value};
    assign low = wide[14:0];
    assign middle = wide[29:15];
    assign high = wide[44:30];
    assign term_1 = products_1_product << 8'd16;
    assign term_2 = products_2_product << 8'd30;
    assign term_3 = products_3_product << 8'd31;
    assign term_4 = products_4_product << 8'd46;
    assign term_5 = products_5_product << 8'd60;
    assign lower_sum = products_0_product + term_1;
    assign middle_sum = term_2 + term_3;
    assign upper_sum = term_4 + term_5;
    assign most = lower_sum + middle_sum;
    assign square = most + upper_sum;

    wire unused_bits = &{1'b0, wide[47:45]};

endmodule
