// interval_cover_w1_v2: part of csg_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module interval_cover_w1_v2 (
    input  wire signed [23:0] place,
    input  wire is_sheet,
    input  wire signed [23:0] other_0_zf,
    input  wire signed [23:0] other_0_zb,
    output wire is_covered
);

    wire begins_0;
    wire goes_0_on;
    wire ends_0_here;
    wire covered_0;

    assign begins_0 = other_0_zf <= place;
    assign goes_0_on = place < other_0_zb;
    assign ends_0_here = is_sheet & (place == other_0_zb);
    assign covered_0 = begins_0 & (goes_0_on | ends_0_here);
    assign is_covered = covered_0;

endmodule
