// interval_cover_w1_v1: part of csg_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module interval_cover_w1_v1 (
    input  wire signed [23:0] place,
    input  wire is_sheet,
    input  wire signed [23:0] other_0_zf,
    input  wire signed [23:0] other_1_zf,
    input  wire signed [23:0] other_0_zb,
    input  wire signed [23:0] other_1_zb,
    output wire is_covered
);

    wire begins_0;
    wire begins_1;
    wire goes_0_on;
    wire goes_1_on;
    wire ends_0_here;
    wire ends_1_here;
    wire covered_0;
    wire covered_1;

    assign begins_0 = other_0_zf <= place;
    assign begins_1 = other_1_zf <= place;
    assign goes_0_on = place < other_0_zb;
    assign goes_1_on = place < other_1_zb;
    assign ends_0_here = is_sheet & (place == other_0_zb);
    assign ends_1_here = is_sheet & (place == other_1_zb);
    assign covered_0 = begins_0 & (goes_0_on | ends_0_here);
    assign covered_1 = covered_0 | (begins_1 & (goes_1_on | ends_1_here));
    assign is_covered = covered_1;

endmodule
