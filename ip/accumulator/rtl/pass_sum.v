// pass_sum: part of accumulator; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module pass_sum (
    input  wire [7:0] value,
    input  wire [11:0] earlier,
    input  wire first,
    input  wire fine,
    output wire [11:0] sum,
    output wire [7:0] mean
);

    localparam [11:0] fine_half = 12'd8;
    localparam [11:0] coarse_half = 12'd2;
    wire [11:0] wide;
    wire [11:0] total;
    wire [11:0] fine_sum;
    wire [11:0] coarse_sum;

    assign wide = {4'd0, value};
    assign total = first ? wide : earlier + wide;
    assign fine_sum = total + fine_half;
    assign coarse_sum = total + coarse_half;
    assign sum = total;
    assign mean = fine ? fine_sum[11:4] : coarse_sum[9:2];

    wire unused_bits = &{1'b0, fine_sum[3:0], coarse_sum[11:10], coarse_sum[1:0]};

endmodule
