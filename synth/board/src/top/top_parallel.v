// {{ about }}: the {{ bits }} highest bits of each colour.
module board_top (
    input  wire clock,
    output wire {{ outputs }}
);

    wire pixel_clock, in_hsync, in_vsync, is_shown;
    wire [7:0] red_level, green_level, blue_level;
    reg [{{ 3 * bits + 1 + has_de }}:0] pins = {{ 3 * bits + 2 + has_de }}'d0;
    wire unused_levels = |{red_level[{{ 7 - bits }}:0], green_level[{{ 7 - bits }}:0], blue_level[{{ 7 - bits }}:0]};
{%- if not has_de %}
    wire unused_de = is_shown;
{%- endif %}

    board_clock clocks (.clock(clock), .pixel_clock(pixel_clock));
    scene_display display (
        .clock(pixel_clock), .hsync(in_hsync), .vsync(in_vsync), .de(is_shown),
        .red(red_level), .green(green_level), .blue(blue_level)
    );

    always @(posedge pixel_clock) pins <= {
        {{ 'is_shown, ' if has_de }}blue_level[7:{{ 8 - bits }}], green_level[7:{{ 8 - bits }}], red_level[7:{{ 8 - bits }}],
        in_vsync, in_hsync
    };

    assign { {{- pins_of }}} = pins;
{%- if has_clock %}

    // Rises in the middle of a pixel.
    assign pixel_clock_out = ~pixel_clock;
{%- endif %}
endmodule
