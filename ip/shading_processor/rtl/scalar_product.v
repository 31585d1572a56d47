// scalar_product: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module scalar_product (
    input  wire clock,
    input  wire signed [17:0] ax,
    input  wire signed [17:0] ay,
    input  wire signed [17:0] az,
    input  wire signed [17:0] bx,
    input  wire signed [17:0] by,
    input  wire signed [17:0] bz,
    output wire signed [37:0] product
);

    wire signed [37:0] wide_x;
    wire signed [37:0] wide_y;
    wire signed [37:0] wide_z;
    wire signed [37:0] first_sum;
    reg signed [35:0] product_x = 36'sd0;
    reg signed [35:0] product_y = 36'sd0;
    reg signed [35:0] product_z = 36'sd0;
    reg signed [37:0] kept_sum = 38'sd0;

    assign wide_x = {{2{product_x[35]}}, product_x};
    assign wide_y = {{2{product_y[35]}}, product_y};
    assign wide_z = {{2{product_z[35]}}, product_z};
    assign first_sum = wide_x + wide_y;
    assign product = kept_sum;

    always @(posedge clock) begin
        product_x <= ax * bx;
        product_y <= ay * by;
        product_z <= az * bz;
        kept_sum <= first_sum + wide_z;
    end

endmodule
