// side_interval: part of sphere_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module side_interval (
    input  wire signed [25:0] near_sum,
    input  wire signed [25:0] far_sum,
    input  wire is_there,
    output wire is_present,
    output wire signed [23:0] zf,
    output wire signed [23:0] zb,
    output wire [3:0] number
);

    localparam signed [25:0] low_sum = -26'sd8388607;
    localparam signed [25:0] end_sum = 26'sd8388607;
    localparam signed [23:0] low = -24'sd8388607;
    localparam signed [23:0] absent = 24'sd8388607;
    localparam [3:0] near_root = 4'd0;
    localparam [3:0] cap = 4'd15;
    wire present;

    assign present = (is_there & (near_sum < end_sum)) & (far_sum >= low_sum);
    assign is_present = present;
    assign zf = present ? ((near_sum < low_sum) ? low : near_sum[23:0]) : absent;
    assign zb = present ? ((far_sum < end_sum) ? far_sum[23:0] : absent) : absent;
    assign number = present ? ((near_sum < low_sum) ? cap : near_root) : near_root;

endmodule
