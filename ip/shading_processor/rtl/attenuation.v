// attenuation: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module attenuation (
    input  wire clock,
    input  wire is_on,
    input  wire signed [29:0] offset,
    input  wire [31:0] far,
    input  wire signed [27:0] ray_log,
    input  wire [5:0] ray_places,
    output wire [25:0] loss
);

    localparam [7:0] point = 8'd21;
    localparam [7:0] three = 8'd3;
    localparam [6:0] no_bits = 7'd0;
    localparam signed [5:0] no_high = 6'sd0;
    localparam signed [31:0] zero = 32'sd0;
    localparam [25:0] nothing = 26'd0;
    localparam [25:0] most = 26'd67108863;
    wire signed [31:0] wide_ray;
    wire signed [31:0] wide_far;
    wire signed [31:0] twice_far;
    wire signed [28:0] cut_offset;
    wire signed [31:0] wide_offset;
    wire [31:0] wide_places;
    wire [31:0] shifted_places;
    wire signed [31:0] places_part;
    wire signed [31:0] opposite;
    wire signed [31:0] magnitude;
    wire [6:0] beyond;
    wire [23:0] fall;
    wire [31:0] wide_fall;
    wire [31:0] shifted_fall;
    wire signed [31:0] fall_part;
    wire signed [31:0] rise;
    wire signed [31:0] sum;
    wire signed [5:0] high_bits;
    wire signed [27:0] logarithm_value;
    wire signed [27:0] far_delay_late;
    wire [5:0] curve_segment;
    wire [13:0] curve_place;
    wire signed [23:0] curve_value;
    wire is_beyond_word;
    wire is_beyond_late;
    wire signed [31:0] e_delay_late;
    reg signed [31:0] kept_near = 32'sd0;
    reg signed [31:0] kept_far = 32'sd0;
    reg signed [31:0] kept_e = 32'sd0;
    reg [31:0] kept_magnitude = 32'd0;
    reg [25:0] kept_loss = 26'd0;

    logarithm_w28_v1 logarithm (
        .clock(clock),
        .number(far),
        .value(logarithm_value)
    );

    word_delay_w28s_x6 far_delay (
        .clock(clock),
        .word(logarithm_value),
        .late(far_delay_late)
    );

    segment_curve_w24_v2 curve (
        .clock(clock),
        .segment(curve_segment),
        .place(curve_place),
        .value(curve_value)
    );

    word_delay_w1_x5 is_beyond (
        .clock(clock),
        .word(is_beyond_word),
        .late(is_beyond_late)
    );

    word_delay_w32s_x6 e_delay (
        .clock(clock),
        .word(kept_e),
        .late(e_delay_late)
    );

    assign wide_ray = {{4{ray_log[27]}}, ray_log};
    assign wide_far = {{4{far_delay_late[27]}}, far_delay_late};
    assign twice_far = wide_far + wide_far;
    assign cut_offset = offset[29:1];
    assign wide_offset = {{3{cut_offset[28]}}, cut_offset};
    assign wide_places = {26'd0, ray_places};
    assign shifted_places = wide_places << point;
    assign places_part = shifted_places;
    assign opposite = -kept_e;
    assign magnitude = kept_e[31] ? opposite : kept_e;
    assign beyond = kept_magnitude[31:25];
    assign fall = curve_value;
    assign wide_fall = {8'd0, fall};
    assign shifted_fall = wide_fall << three;
    assign fall_part = is_beyond_late ? zero : shifted_fall;
    assign rise = e_delay_late[31] ? zero : e_delay_late;
    assign sum = fall_part + rise;
    assign high_bits = sum[31:26];
    assign curve_segment = kept_magnitude[24:19];
    assign curve_place = kept_magnitude[18:5];
    assign is_beyond_word = beyond != no_bits;
    assign loss = kept_loss;

    wire unused_bits = &{1'b0, offset[0], kept_magnitude[4:0]};

    always @(posedge clock) begin
        kept_near <= wide_ray - places_part;
        kept_far <= wide_offset - twice_far;
        kept_e <= kept_near + kept_far;
        kept_magnitude <= magnitude;
        if (~is_on) begin
            kept_loss <= nothing;
        end else if (high_bits == no_high) begin
            kept_loss <= sum[25:0];
        end else begin
            kept_loss <= most;
        end
    end

endmodule
