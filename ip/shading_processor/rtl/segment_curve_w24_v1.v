// segment_curve_w24_v1: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module segment_curve_w24_v1 (
    input  wire clock,
    input  wire [4:0] segment,
    input  wire [13:0] place,
    output wire signed [23:0] value
);

    wire [59:0] node_32;
    wire [59:0] node_33;
    wire [59:0] node_34;
    wire [59:0] node_35;
    wire [59:0] node_36;
    wire [59:0] node_37;
    wire [59:0] node_38;
    wire [59:0] node_39;
    wire [59:0] node_40;
    wire [59:0] node_41;
    wire [59:0] node_42;
    wire [59:0] node_43;
    wire [59:0] node_44;
    wire [59:0] node_45;
    wire [59:0] node_46;
    wire [59:0] node_47;
    wire [59:0] node_48;
    wire [59:0] node_49;
    wire [59:0] node_50;
    wire [59:0] node_51;
    wire [59:0] node_52;
    wire [59:0] node_53;
    wire [59:0] node_54;
    wire [59:0] node_55;
    wire [59:0] node_56;
    wire [59:0] node_57;
    wire [59:0] node_58;
    wire [59:0] node_59;
    wire [59:0] node_60;
    wire [59:0] node_61;
    wire [59:0] node_62;
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

    assign node_32 = segment[0] ? 60'd3199041096383838 : 60'd81110236468;
    assign node_33 = segment[0] ? 60'd9315898473315752 : 60'd6302412312411524;
    assign node_34 = segment[0] ? 60'd15092800672759270 : 60'd12244447379324360;
    assign node_35 = segment[0] ? 60'd20565481811607067 : 60'd17865150240914946;
    assign node_36 = segment[0] ? 60'd25764384608878153 : 60'd23197437516578355;
    assign node_37 = segment[0] ? 60'd30715691177344624 : 60'd28269484183649885;
    assign node_38 = segment[0] ? 60'd35441804060655251 : 60'd33105616929816194;
    assign node_39 = segment[0] ? 60'd39962377023913649 : 60'd37726657751285410;
    assign node_40 = segment[0] ? 60'd44294589932109515 : 60'd42151023462842046;
    assign node_41 = segment[0] ? 60'd48453423627239139 : 60'd46394794418110167;
    assign node_42 = segment[0] ? 60'd52452278404644600 : 60'd50472058106937070;
    assign node_43 = segment[0] ? 60'd56302974011440906 : 60'd54395458909896449;
    assign node_44 = segment[0] ? 60'd60016093244948251 : 60'd58176129379598099;
    assign node_45 = segment[0] ? 60'd63601188110597930 : 60'd61824102558072611;
    assign node_46 = segment[0] ? 60'd67066711101931320 : 60'd65348380694675249;
    assign node_47 = segment[0] ? 60'd70420496238247748 : 60'd68757141405302590;
    assign node_48 = segment[1] ? node_33 : node_32;
    assign node_49 = segment[1] ? node_35 : node_34;
    assign node_50 = segment[1] ? node_37 : node_36;
    assign node_51 = segment[1] ? node_39 : node_38;
    assign node_52 = segment[1] ? node_41 : node_40;
    assign node_53 = segment[1] ? node_43 : node_42;
    assign node_54 = segment[1] ? node_45 : node_44;
    assign node_55 = segment[1] ? node_47 : node_46;
    assign node_56 = segment[2] ? node_49 : node_48;
    assign node_57 = segment[2] ? node_51 : node_50;
    assign node_58 = segment[2] ? node_53 : node_52;
    assign node_59 = segment[2] ? node_55 : node_54;
    assign node_60 = segment[3] ? node_57 : node_56;
    assign node_61 = segment[3] ? node_59 : node_58;
    assign node_62 = segment[4] ? node_61 : node_60;
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
        chosen <= node_62;
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
