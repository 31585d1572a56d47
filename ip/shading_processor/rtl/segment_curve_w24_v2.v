// segment_curve_w24_v2: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module segment_curve_w24_v2 (
    input  wire clock,
    input  wire [5:0] segment,
    input  wire [13:0] place,
    output wire signed [23:0] value
);

    wire [59:0] node_64;
    wire [59:0] node_65;
    wire [59:0] node_66;
    wire [59:0] node_67;
    wire [59:0] node_68;
    wire [59:0] node_69;
    wire [59:0] node_70;
    wire [59:0] node_71;
    wire [59:0] node_72;
    wire [59:0] node_73;
    wire [59:0] node_74;
    wire [59:0] node_75;
    wire [59:0] node_76;
    wire [59:0] node_77;
    wire [59:0] node_78;
    wire [59:0] node_79;
    wire [59:0] node_80;
    wire [59:0] node_81;
    wire [59:0] node_82;
    wire [59:0] node_83;
    wire [59:0] node_84;
    wire [59:0] node_85;
    wire [59:0] node_86;
    wire [59:0] node_87;
    wire [59:0] node_88;
    wire [59:0] node_89;
    wire [59:0] node_90;
    wire [59:0] node_91;
    wire [59:0] node_92;
    wire [59:0] node_93;
    wire [59:0] node_94;
    wire [59:0] node_95;
    wire [59:0] node_96;
    wire [59:0] node_97;
    wire [59:0] node_98;
    wire [59:0] node_99;
    wire [59:0] node_100;
    wire [59:0] node_101;
    wire [59:0] node_102;
    wire [59:0] node_103;
    wire [59:0] node_104;
    wire [59:0] node_105;
    wire [59:0] node_106;
    wire [59:0] node_107;
    wire [59:0] node_108;
    wire [59:0] node_109;
    wire [59:0] node_110;
    wire [59:0] node_111;
    wire [59:0] node_112;
    wire [59:0] node_113;
    wire [59:0] node_114;
    wire [59:0] node_115;
    wire [59:0] node_116;
    wire [59:0] node_117;
    wire [59:0] node_118;
    wire [59:0] node_119;
    wire [59:0] node_120;
    wire [59:0] node_121;
    wire [59:0] node_122;
    wire [59:0] node_123;
    wire [59:0] node_124;
    wire [59:0] node_125;
    wire [59:0] node_126;
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

    assign node_64 = segment[0] ? 60'd15860103787054452 : 60'd18014458639287689;
    assign node_65 = segment[0] ? 60'd12127331973596432 : 60'd13899125531346251;
    assign node_66 = segment[0] ? 60'd9121543383155828 : 60'd10537782437217480;
    assign node_67 = segment[0] ? 60'd6764672637993916 : 60'd7867825847534618;
    assign node_68 = segment[0] ? 60'd4958931900433153 : 60'd5799370649240414;
    assign node_69 = segment[0] ? 60'd3601860434330200 : 60'd4230574569685674;
    assign node_70 = segment[0] ? 60'd2597594589823431 : 60'd3061175905419788;
    assign node_71 = segment[0] ? 60'd1863327425757523 : 60'd2201289606037898;
    assign node_72 = segment[0] ? 60'd1331301566906617 : 60'd1575667873874211;
    assign node_73 = segment[0] ? 60'd948396884230325 : 60'd1123975036141781;
    assign node_74 = segment[0] ? 60'd674206347427971 : 60'd799825470423194;
    assign node_75 = segment[0] ? 60'd478562123251806 : 60'd568103543767151;
    assign node_76 = segment[0] ? 60'd339336553824323 : 60'd403039467339855;
    assign node_77 = segment[0] ? 60'd240449291288624 : 60'd285666677620792;
    assign node_78 = segment[0] ? 60'd170286751416354 : 60'd202378726080552;
    assign node_79 = segment[0] ? 60'd120533883027480 : 60'd143280014884892;
    assign node_80 = segment[0] ? 60'd85349534007313 : 60'd101429881077780;
    assign node_81 = segment[0] ? 60'd60404380467212 : 60'd71811806003214;
    assign node_82 = segment[0] ? 60'd42743486480393 : 60'd50783660015626;
    assign node_83 = segment[0] ? 60'd30236549840902 : 60'd35940262739975;
    assign node_84 = segment[0] ? 60'd21440462585860 : 60'd25494909091845;
    assign node_85 = segment[0] ? 60'd15186994397187 : 60'd18073210585092;
    assign node_86 = segment[0] ? 60'd10788950769666 : 60'd12781814284291;
    assign node_87 = segment[0] ? 60'd7627856936962 : 60'd9070964899842;
    assign node_88 = segment[0] ? 60'd5428835254273 : 60'd6459626618881;
    assign node_89 = segment[0] ? 60'd3848288337921 : 60'd4604202057729;
    assign node_90 = segment[0] ? 60'd2748777234433 : 60'd3298532786177;
    assign node_91 = segment[0] ? 60'd1992863514624 : 60'd2336460636160;
    assign node_92 = segment[0] ? 60'd1443108225024 : 60'd1717985869824;
    assign node_93 = segment[0] ? 60'd1030791626752 : 60'd1236949794816;
    assign node_94 = segment[0] ? 60'd755913719808 : 60'd893352673280;
    assign node_95 = segment[0] ? 60'd549755551744 : 60'd687194505216;
    assign node_96 = segment[1] ? node_65 : node_64;
    assign node_97 = segment[1] ? node_67 : node_66;
    assign node_98 = segment[1] ? node_69 : node_68;
    assign node_99 = segment[1] ? node_71 : node_70;
    assign node_100 = segment[1] ? node_73 : node_72;
    assign node_101 = segment[1] ? node_75 : node_74;
    assign node_102 = segment[1] ? node_77 : node_76;
    assign node_103 = segment[1] ? node_79 : node_78;
    assign node_104 = segment[1] ? node_81 : node_80;
    assign node_105 = segment[1] ? node_83 : node_82;
    assign node_106 = segment[1] ? node_85 : node_84;
    assign node_107 = segment[1] ? node_87 : node_86;
    assign node_108 = segment[1] ? node_89 : node_88;
    assign node_109 = segment[1] ? node_91 : node_90;
    assign node_110 = segment[1] ? node_93 : node_92;
    assign node_111 = segment[1] ? node_95 : node_94;
    assign node_112 = segment[2] ? node_97 : node_96;
    assign node_113 = segment[2] ? node_99 : node_98;
    assign node_114 = segment[2] ? node_101 : node_100;
    assign node_115 = segment[2] ? node_103 : node_102;
    assign node_116 = segment[2] ? node_105 : node_104;
    assign node_117 = segment[2] ? node_107 : node_106;
    assign node_118 = segment[2] ? node_109 : node_108;
    assign node_119 = segment[2] ? node_111 : node_110;
    assign node_120 = segment[3] ? node_113 : node_112;
    assign node_121 = segment[3] ? node_115 : node_114;
    assign node_122 = segment[3] ? node_117 : node_116;
    assign node_123 = segment[3] ? node_119 : node_118;
    assign node_124 = segment[4] ? node_121 : node_120;
    assign node_125 = segment[4] ? node_123 : node_122;
    assign node_126 = segment[5] ? node_125 : node_124;
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
        chosen <= node_126;
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
