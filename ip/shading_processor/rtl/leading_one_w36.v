// leading_one_w36: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module leading_one_w36 (
    input  wire clock,
    input  wire [35:0] number,
    output wire [35:0] shifted,
    output wire [5:0] places
);

    localparam [5:0] no_places = 6'd0;
    wire [35:0] long_steps_0_shifted;
    wire [5:0] long_steps_0_late_count;
    wire [35:0] long_steps_1_shifted;
    wire [5:0] long_steps_1_late_count;
    wire [35:0] long_steps_2_shifted;
    wire [5:0] long_steps_2_late_count;
    wire [35:0] short_steps_0_shifted;
    wire [5:0] short_steps_0_late_count;
    wire [35:0] short_steps_1_shifted;
    wire [5:0] short_steps_1_late_count;
    wire [35:0] short_steps_2_shifted;
    wire [5:0] short_steps_2_late_count;
    reg [35:0] kept_halfway = 36'd0;
    reg [5:0] kept_halfway_count = 6'd0;
    reg [35:0] kept = 36'd0;
    reg [5:0] kept_count = 6'd0;

    leading_step_w36_v6 long_steps_0 (
        .number(number),
        .count(no_places),
        .shifted(long_steps_0_shifted),
        .late_count(long_steps_0_late_count)
    );

    leading_step_w36_v7 long_steps_1 (
        .number(long_steps_0_shifted),
        .count(long_steps_0_late_count),
        .shifted(long_steps_1_shifted),
        .late_count(long_steps_1_late_count)
    );

    leading_step_w36_v8 long_steps_2 (
        .number(long_steps_1_shifted),
        .count(long_steps_1_late_count),
        .shifted(long_steps_2_shifted),
        .late_count(long_steps_2_late_count)
    );

    leading_step_w36_v9 short_steps_0 (
        .number(kept_halfway),
        .count(kept_halfway_count),
        .shifted(short_steps_0_shifted),
        .late_count(short_steps_0_late_count)
    );

    leading_step_w36_v10 short_steps_1 (
        .number(short_steps_0_shifted),
        .count(short_steps_0_late_count),
        .shifted(short_steps_1_shifted),
        .late_count(short_steps_1_late_count)
    );

    leading_step_w36_v11 short_steps_2 (
        .number(short_steps_1_shifted),
        .count(short_steps_1_late_count),
        .shifted(short_steps_2_shifted),
        .late_count(short_steps_2_late_count)
    );

    assign shifted = kept;
    assign places = kept_count;

    always @(posedge clock) begin
        kept_halfway <= long_steps_2_shifted;
        kept_halfway_count <= long_steps_2_late_count;
        kept <= short_steps_2_shifted;
        kept_count <= short_steps_2_late_count;
    end

endmodule
