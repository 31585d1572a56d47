// logarithm_w28_v1: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module logarithm_w28_v1 (
    input  wire clock,
    input  wire [31:0] number,
    output wire signed [27:0] value
);

    localparam [5:0] last_octave = 6'd31;
    localparam [7:0] point = 8'd20;
    wire [5:0] octave;
    wire [27:0] wide_octave;
    wire [27:0] whole;
    wire signed [27:0] part;
    wire signed [27:0] sum;
    wire [31:0] leading_shifted;
    wire [5:0] leading_places;
    wire [4:0] curve_segment;
    wire [13:0] curve_place;
    wire signed [23:0] curve_value;
    wire [5:0] octave_delay_late;
    reg signed [27:0] kept = 28'sd0;

    leading_one_w32 leading (
        .clock(clock),
        .number(number),
        .shifted(leading_shifted),
        .places(leading_places)
    );

    segment_curve_w24_v1 curve (
        .clock(clock),
        .segment(curve_segment),
        .place(curve_place),
        .value(curve_value)
    );

    word_delay_w6_x5 octave_delay (
        .clock(clock),
        .word(octave),
        .late(octave_delay_late)
    );

    assign octave = last_octave - leading_places;
    assign wide_octave = {22'd0, octave_delay_late};
    assign whole = wide_octave << point;
    assign part = {{4{curve_value[23]}}, curve_value};
    assign sum = whole;
    assign curve_segment = leading_shifted[30:26];
    assign curve_place = leading_shifted[25:12];
    assign value = kept;

    wire unused_bits = &{1'b0, leading_shifted[31], leading_shifted[11:0]};

    always @(posedge clock) begin
        kept <= sum + part;
    end

endmodule
