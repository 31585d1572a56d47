// segment_curve_w24_v3: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module segment_curve_w24_v3 (
    input  wire clock,
    input  wire [2:0] segment,
    input  wire [13:0] place,
    output wire signed [23:0] value
);

    wire [59:0] node_8;
    wire [59:0] node_9;
    wire [59:0] node_10;
    wire [59:0] node_11;
    wire [59:0] node_12;
    wire [59:0] node_13;
    wire [59:0] node_14;
    wire signed [17:0] bend;
    wire [17:0] wide_place_1;
    wire signed [17:0] factor_1;
    wire signed [17:0] bend_part;
    wire signed [17:0] slope;
    wire [17:0] wide_place_3;
    wire signed [17:0] factor_3;
    wire signed [17:0] rise_part;
    wire signed [23:0] wide_rise;
    wire signed [23:0] base;
    wire signed [23:0] base_delay_late;
    reg [59:0] chosen = 60'd0;
    reg [13:0] place_1 = 14'd0;
    reg signed [35:0] kept_bend = 36'sd0;
    reg signed [17:0] slope_2 = 18'sd0;
    reg signed [17:0] kept_slope = 18'sd0;
    reg [13:0] place_2 = 14'd0;
    reg [13:0] place_3 = 14'd0;
    reg signed [35:0] kept_rise = 36'sd0;
    reg signed [23:0] kept_value = 24'sd0;

    word_delay_w24s_x3 base_delay (
        .clock(clock),
        .word(base),
        .late(base_delay_late)
    );

    assign node_8 = segment[0] ? 60'd8259734778151344 : 60'd9007264999145943;
    assign node_9 = segment[0] ? 60'd6945543939162475 : 60'd7574189504725388;
    assign node_10 = segment[0] ? 60'd5840535118151986 : 60'd6369125158617421;
    assign node_11 = segment[0] ? 60'd4911310660698369 : 60'd5355788089426200;
    assign node_12 = segment[1] ? node_9 : node_8;
    assign node_13 = segment[1] ? node_11 : node_10;
    assign node_14 = segment[2] ? node_13 : node_12;
    assign bend = chosen[17:0];
    assign wide_place_1 = {4'd0, place_1};
    assign factor_1 = wide_place_1;
    assign bend_part = kept_bend[31:14];
    assign slope = chosen[35:18];
    assign wide_place_3 = {4'd0, place_3};
    assign factor_3 = wide_place_3;
    assign rise_part = kept_rise[31:14];
    assign wide_rise = {{6{rise_part[17]}}, rise_part};
    assign base = chosen[59:36];
    assign value = kept_value;

    wire unused_bits = &{1'b0, kept_bend[35:32], kept_bend[13:0], kept_rise[35:32], kept_rise[13:0]};

    always @(posedge clock) begin
        chosen <= node_14;
        place_1 <= place;
        kept_bend <= bend * factor_1;
        slope_2 <= slope;
        place_2 <= place_1;
        kept_slope <= slope_2 + bend_part;
        place_3 <= place_2;
        kept_rise <= kept_slope * factor_3;
        kept_value <= base_delay_late + wide_rise;
    end

endmodule
