// vector_normaliser_w18: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module vector_normaliser_w18 (
    input  wire clock,
    input  wire signed [17:0] x,
    input  wire signed [17:0] y,
    input  wire signed [17:0] z,
    output wire signed [17:0] shifted_x,
    output wire signed [17:0] shifted_y,
    output wire signed [17:0] shifted_z,
    output wire [5:0] places
);

    localparam [17:0] one = 18'd1;
    localparam [5:0] no_places = 6'd0;
    wire [17:0] magnitude;
    wire [17:0] needed_0_magnitude;
    wire [17:0] needed_1_magnitude;
    wire [17:0] needed_2_magnitude;
    wire [17:0] long_steps_0_late_x;
    wire [17:0] long_steps_0_late_y;
    wire [17:0] long_steps_0_late_z;
    wire [17:0] long_steps_0_late_magnitude;
    wire [5:0] long_steps_0_late_count;
    wire [17:0] long_steps_1_late_x;
    wire [17:0] long_steps_1_late_y;
    wire [17:0] long_steps_1_late_z;
    wire [17:0] long_steps_1_late_magnitude;
    wire [5:0] long_steps_1_late_count;
    wire [17:0] long_steps_2_late_x;
    wire [17:0] long_steps_2_late_y;
    wire [17:0] long_steps_2_late_z;
    wire [17:0] long_steps_2_late_magnitude;
    wire [5:0] long_steps_2_late_count;
    wire [17:0] short_steps_0_late_x;
    wire [17:0] short_steps_0_late_y;
    wire [17:0] short_steps_0_late_z;
    wire [17:0] short_steps_0_late_magnitude;
    wire [5:0] short_steps_0_late_count;
    wire [17:0] short_steps_1_late_x;
    wire [17:0] short_steps_1_late_y;
    wire [17:0] short_steps_1_late_z;
    wire [17:0] unused_short_steps_1_late_magnitude;
    wire [5:0] short_steps_1_late_count;
    reg [17:0] kept_halfway_x = 18'd0;
    reg [17:0] kept_halfway_y = 18'd0;
    reg [17:0] kept_halfway_z = 18'd0;
    reg [17:0] kept_halfway_magnitude = 18'd0;
    reg [5:0] kept_halfway_count = 6'd0;
    reg [17:0] kept_x = 18'd0;
    reg [17:0] kept_y = 18'd0;
    reg [17:0] kept_z = 18'd0;
    reg [5:0] kept_count = 6'd0;

    needed_bits_w18 needed_0 (
        .part(x),
        .magnitude(needed_0_magnitude)
    );

    needed_bits_w18 needed_1 (
        .part(y),
        .magnitude(needed_1_magnitude)
    );

    needed_bits_w18 needed_2 (
        .part(z),
        .magnitude(needed_2_magnitude)
    );

    vector_step_w18_v1 long_steps_0 (
        .x(x),
        .y(y),
        .z(z),
        .magnitude(magnitude),
        .count(no_places),
        .late_x(long_steps_0_late_x),
        .late_y(long_steps_0_late_y),
        .late_z(long_steps_0_late_z),
        .late_magnitude(long_steps_0_late_magnitude),
        .late_count(long_steps_0_late_count)
    );

    vector_step_w18_v2 long_steps_1 (
        .x(long_steps_0_late_x),
        .y(long_steps_0_late_y),
        .z(long_steps_0_late_z),
        .magnitude(long_steps_0_late_magnitude),
        .count(long_steps_0_late_count),
        .late_x(long_steps_1_late_x),
        .late_y(long_steps_1_late_y),
        .late_z(long_steps_1_late_z),
        .late_magnitude(long_steps_1_late_magnitude),
        .late_count(long_steps_1_late_count)
    );

    vector_step_w18_v3 long_steps_2 (
        .x(long_steps_1_late_x),
        .y(long_steps_1_late_y),
        .z(long_steps_1_late_z),
        .magnitude(long_steps_1_late_magnitude),
        .count(long_steps_1_late_count),
        .late_x(long_steps_2_late_x),
        .late_y(long_steps_2_late_y),
        .late_z(long_steps_2_late_z),
        .late_magnitude(long_steps_2_late_magnitude),
        .late_count(long_steps_2_late_count)
    );

    vector_step_w18_v4 short_steps_0 (
        .x(kept_halfway_x),
        .y(kept_halfway_y),
        .z(kept_halfway_z),
        .magnitude(kept_halfway_magnitude),
        .count(kept_halfway_count),
        .late_x(short_steps_0_late_x),
        .late_y(short_steps_0_late_y),
        .late_z(short_steps_0_late_z),
        .late_magnitude(short_steps_0_late_magnitude),
        .late_count(short_steps_0_late_count)
    );

    vector_step_w18_v5 short_steps_1 (
        .x(short_steps_0_late_x),
        .y(short_steps_0_late_y),
        .z(short_steps_0_late_z),
        .magnitude(short_steps_0_late_magnitude),
        .count(short_steps_0_late_count),
        .late_x(short_steps_1_late_x),
        .late_y(short_steps_1_late_y),
        .late_z(short_steps_1_late_z),
        .late_magnitude(unused_short_steps_1_late_magnitude),
        .late_count(short_steps_1_late_count)
    );

    assign magnitude = ((needed_0_magnitude | needed_1_magnitude) | needed_2_magnitude) | one;
    assign shifted_x = kept_x;
    assign shifted_y = kept_y;
    assign shifted_z = kept_z;
    assign places = kept_count;

    always @(posedge clock) begin
        kept_halfway_x <= long_steps_2_late_x;
        kept_halfway_y <= long_steps_2_late_y;
        kept_halfway_z <= long_steps_2_late_z;
        kept_halfway_magnitude <= long_steps_2_late_magnitude;
        kept_halfway_count <= long_steps_2_late_count;
        kept_x <= short_steps_1_late_x;
        kept_y <= short_steps_1_late_y;
        kept_z <= short_steps_1_late_z;
        kept_count <= short_steps_1_late_count;
    end

endmodule
