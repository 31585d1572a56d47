// quadric_pe: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module quadric_pe (
    input  wire clock, valid, start, line,
    input  wire signed [25:0] f1_a, f1_b, f1_c,
    input  wire signed [47:0] f2_a2, f2_b2, f2_c, f2_i0, f2_p0, f2_f,
    output wire signed [25:0] near_sum, far_sum,
    output wire [23:0] root,
    output wire is_inside, early_valid, early_start, early_line
);

    wire signed [47:0] f2_value;
    reg [22:0] valid_late = 23'd0, start_late = 23'd0, line_late = 23'd0;
    reg valid_late_1 = 1'd0, start_late_1 = 1'd0, line_late_1 = 1'd0;
    wire signed [25:0] f1_value, step;
    wire [23:0] square_root_root;
    wire [24:0] unused_square_root_remainder;
    reg signed [25:0] kept_near_sum = 26'sd0, kept_far_sum = 26'sd0;
    reg [23:0] kept_root = 24'd0;
    reg [24:0] is_outside_kept = 25'd0;
    wire is_outside;

    pe2 f2 (
        .clock(clock), .valid(valid), .start(start), .line(line), .a2(f2_a2), .b2(f2_b2), .c(f2_c), .i0(f2_i0),
        .p0(f2_p0), .f(f2_f), .value(f2_value));

    pe1_w26 f1 (
        .clock(clock), .valid(valid_late_1), .start(start_late_1), .line(line_late_1), .a(f1_a), .b(f1_b), .c(f1_c),
        .value(f1_value));

    square_root square_root (
        .clock(clock), .radicand({1'd0, f2_value[46:0]}), .root(square_root_root),
        .remainder(unused_square_root_remainder));

    assign step = {2'd0, square_root_root};
    assign is_outside = is_outside_kept[24];
    assign is_inside = ~is_outside;
    assign near_sum = kept_near_sum;
    assign far_sum = kept_far_sum;
    assign root = kept_root;
    assign early_valid = valid_late[22];
    assign early_start = start_late[22];
    assign early_line = line_late[22];

    always @(posedge clock) begin
        valid_late <= {valid_late[21:0], valid};
        start_late <= {start_late[21:0], start};
        line_late <= {line_late[21:0], line};
        valid_late_1 <= valid_late[22];
        start_late_1 <= start_late[22];
        line_late_1 <= line_late[22];
        kept_near_sum <= f1_value - step;
        kept_far_sum <= f1_value + step;
        kept_root <= square_root_root;
        is_outside_kept <= {is_outside_kept[23:0], f2_value[47]};
    end
endmodule
