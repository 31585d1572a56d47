// power_of_two: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module power_of_two (
    input  wire clock,
    input  wire [35:0] loss,
    output wire [16:0] value
);

    localparam [16:0] most = 17'd131071;
    wire [14:0] octaves;
    wire [23:0] curve_word;
    wire [17:0] power;
    wire [17:0] shifted;
    wire [2:0] curve_segment;
    wire [13:0] curve_place;
    wire signed [23:0] curve_value;
    wire [14:0] octave_delay_late;
    reg [17:0] kept_shifted = 18'd0;
    reg [16:0] kept = 17'd0;

    segment_curve_w24_v3 curve (
        .clock(clock),
        .segment(curve_segment),
        .place(curve_place),
        .value(curve_value)
    );

    word_delay_w15_x5 octave_delay (
        .clock(clock),
        .word(octaves),
        .late(octave_delay_late)
    );

    assign octaves = loss[35:21];
    assign curve_word = curve_value;
    assign power = curve_word[17:0];
    assign shifted = power >> octave_delay_late;
    assign curve_segment = loss[20:18];
    assign curve_place = loss[17:4];
    assign value = kept;

    wire unused_bits = &{1'b0, loss[3:0], curve_word[23:18]};

    always @(posedge clock) begin
        kept_shifted <= shifted;
        if (kept_shifted[17]) begin
            kept <= most;
        end else begin
            kept <= kept_shifted[16:0];
        end
    end

endmodule
