// {{ about }}: channels 0 blue, 1 green, 2 red, 3 clock.
module board_top (
    input  wire clock,
    output wire channel_0, channel_1, channel_2, channel_3
);

    wire pixel_clock, fast_clock;
    wire [1:0] pair_0, pair_1, pair_2, pair_3;

    board_clock clocks (.clock(clock), .pixel_clock(pixel_clock), .fast_clock(fast_clock));
    scene_channels channels (
        .pixel_clock(pixel_clock), .fast_clock(fast_clock),
        .pair_0(pair_0), .pair_1(pair_1), .pair_2(pair_2), .pair_3(pair_3)
    );
{%- for index in range(4) %}
    ODDRX1F out_{{ index }} (
        .SCLK(fast_clock), .RST(1'b0), .D0(pair_{{ index }}[0]), .D1(pair_{{ index }}[1]), .Q(channel_{{ index }})
    );
{%- endfor %}
endmodule
