// light_component: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module light_component (
    input  wire clock,
    input  wire signed [31:0] depth,
    input  wire signed [29:0] place,
    input  wire signed [27:0] base,
    input  wire signed [27:0] slope,
    output wire signed [29:0] result
);

    wire signed [31:0] factor;
    wire signed [29:0] wide_base;
    wire signed [29:0] deep;
    reg signed [63:0] kept_product = 64'sd0;
    reg signed [29:0] kept_rest = 30'sd0;
    reg signed [29:0] kept = 30'sd0;

    assign factor = {{4{slope[27]}}, slope};
    assign wide_base = {{2{base[27]}}, base};
    assign deep = kept_product[60:31];
    assign result = kept;

    wire unused_bits = &{1'b0, kept_product[63:61], kept_product[30:0]};

    always @(posedge clock) begin
        kept_product <= factor * depth;
        kept_rest <= wide_base - place;
        kept <= kept_rest - deep;
    end

endmodule
