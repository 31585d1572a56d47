// {{ about }}: channels 0 blue, 1 green, 2 red, 3 clock.
module board_top (
    input  wire clock,
    output wire channel_0, channel_1, channel_2, channel_3,
    output wire channel_n_0, channel_n_1, channel_n_2, channel_n_3
);

    wire pixel_clock, fast_clock;
    wire [9:0] word_0, word_1, word_2;
    wire [9:0] word_3 = 10'b0000011111;

    board_clock clocks (.clock(clock), .pixel_clock(pixel_clock), .fast_clock(fast_clock));
    scene_channels channels (
        .pixel_clock(pixel_clock), .blue_word(word_0), .green_word(word_1), .red_word(word_2)
    );
{%- for index in range(4) %}
    wire bit_{{ index }};
    OSER10 #(.GSREN("false"), .LSREN("true")) out_{{ index }} (
        .FCLK(fast_clock), .PCLK(pixel_clock), .RESET(1'b0),
        .D0(word_{{ index }}[0]), .D1(word_{{ index }}[1]), .D2(word_{{ index }}[2]), .D3(word_{{ index }}[3]), .D4(word_{{ index }}[4]),
        .D5(word_{{ index }}[5]), .D6(word_{{ index }}[6]), .D7(word_{{ index }}[7]), .D8(word_{{ index }}[8]), .D9(word_{{ index }}[9]), .Q(bit_{{ index }})
    );
    {{ "T" if true_pairs else "E" }}LVDS_OBUF pair_{{ index }} (.I(bit_{{ index }}), .O(channel_{{ index }}), .OB(channel_n_{{ index }}));
{%- endfor %}
endmodule
