// three_taps_w10: part of post_filter; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module three_taps_w10 (
    input  wire [7:0] earlier,
    input  wire [7:0] here,
    input  wire [7:0] later,
    input  wire [1:0] kernel,
    output wire [9:0] sum
);

    localparam [1:0] one = 2'd1;
    wire [7:0] first;
    wire [7:0] third;
    wire [9:0] wide_first;
    wire [9:0] wide_here;
    wire [9:0] wide_third;
    wire [9:0] doubled;
    wire [9:0] outer;

    assign first = kernel[1] ? earlier :
        kernel[0] ? earlier : here;
    assign third = kernel[1] ? later :
        kernel[0] ? earlier : here;
    assign wide_first = {2'd0, first};
    assign wide_here = {2'd0, here};
    assign wide_third = {2'd0, third};
    assign doubled = wide_here << one;
    assign outer = wide_first + wide_third;
    assign sum = outer + doubled;

endmodule
