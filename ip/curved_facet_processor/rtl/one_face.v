// one_face: part of curved_facet_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module one_face (
    input  wire signed [25:0] z,
    input  wire is_there,
    output wire is_present,
    output wire signed [23:0] depth
);

    localparam signed [25:0] low_sum = -26'sd8388607;
    localparam signed [25:0] end_sum = 26'sd8388607;
    localparam signed [23:0] absent = 24'sd8388607;
    wire present;

    assign present = (is_there & (z >= low_sum)) & (z < end_sum);
    assign is_present = present;
    assign depth = present ? z[23:0] : absent;

endmodule
