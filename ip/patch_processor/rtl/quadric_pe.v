// quadric_pe: part of patch_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module quadric_pe (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    input  wire signed [25:0] f1_a,
    input  wire signed [25:0] f1_b,
    input  wire signed [25:0] f1_c,
    input  wire signed [47:0] f2_a2,
    input  wire signed [47:0] f2_b2,
    input  wire signed [47:0] f2_c,
    input  wire signed [47:0] f2_i0,
    input  wire signed [47:0] f2_p0,
    input  wire signed [47:0] f2_f,
    output wire signed [25:0] near_sum,
    output wire signed [25:0] far_sum,
    output wire [23:0] root,
    output wire is_inside,
    output wire late_valid,
    output wire late_start,
    output wire late_line
);

    wire [25:0] wide_root;
    wire signed [25:0] step;
    wire signed [47:0] f2_value;
    wire flags_late_valid;
    wire flags_late_start;
    wire flags_late_line;
    wire signed [25:0] f1_value;
    wire [23:0] square_root_root;
    wire [24:0] unused_square_root_remainder;
    wire f2_is_negative_word;
    wire f2_is_negative_late;
    reg signed [25:0] kept_near_sum = 26'sd0;
    reg signed [25:0] kept_far_sum = 26'sd0;
    reg [23:0] kept_root = 24'd0;

    pe2 f2 (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .a2(f2_a2),
        .b2(f2_b2),
        .c(f2_c),
        .p0(f2_p0),
        .i0(f2_i0),
        .f(f2_f),
        .value(f2_value)
    );

    flag_delay_x72 flags (
        .clock(clock),
        .valid(valid),
        .start(start),
        .line(line),
        .late_valid(flags_late_valid),
        .late_start(flags_late_start),
        .late_line(flags_late_line)
    );

    pe1_w26 f1 (
        .clock(clock),
        .valid(flags_late_valid),
        .start(flags_late_start),
        .line(flags_late_line),
        .a(f1_a),
        .b(f1_b),
        .c(f1_c),
        .value(f1_value)
    );

    square_root square_root (
        .clock(clock),
        .radicand(f2_value),
        .root(square_root_root),
        .remainder(unused_square_root_remainder)
    );

    word_delay_w1_x25 f2_is_negative (
        .clock(clock),
        .word(f2_is_negative_word),
        .late(f2_is_negative_late)
    );

    assign wide_root = {2'd0, square_root_root};
    assign step = wide_root;
    assign f2_is_negative_word = f2_value[47];
    assign near_sum = kept_near_sum;
    assign far_sum = kept_far_sum;
    assign root = kept_root;
    assign is_inside = ~f2_is_negative_late;
    assign late_valid = flags_late_valid;
    assign late_start = flags_late_start;
    assign late_line = flags_late_line;

    always @(posedge clock) begin
        kept_near_sum <= f1_value - step;
        kept_far_sum <= f1_value + step;
        kept_root <= square_root_root;
    end

endmodule
