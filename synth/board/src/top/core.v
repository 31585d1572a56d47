// {{ heading }}

// The words of the images: bit {{ bits - 1 }} marks the last word of the memory, bit {{ bits - 2 }} that of an image; then
// kind, unit, address and data of a word of the machine, each as wide as its greatest value.
module scene_words (
    input  wire clock,
    input  wire [{{ address_bits - 1 }}:0] address,
    output reg  [{{ bits - 1 }}:0] word
);

    reg [{{ bits - 1 }}:0] words [0:{{ places - 1 }}];

    initial begin
{%- for word in words %}
        words[{{ loop.index0 }}] = {{ bits }}'h{{ word }};
{%- endfor %}
    end

    always @(posedge clock) word <= words[address];
endmodule

// The machine with the words of its scene, on the clock of the pixels.
module scene_display (
    input  wire clock,
    output wire hsync, vsync, de,
    output wire [7:0] red, green, blue
);

    wire [11:0] address;
    wire [{{ bits - 1 }}:0] word;
    wire is_there, is_taken;
    // Nobody looks at these.
    wire unused_swapped, unused_refused;
{%- if address_bits < 12 %}
    wire unused_address = |address[11:{{ address_bits }}];
{%- endif %}

    scene_words scene (.clock(clock), .address(address[{{ address_bits - 1 }}:0]), .word(word));
    scene_sequencer sequencer (
        .clock(clock), .last(word[{{ bits - 1 }}]), .ends(word[{{ bits - 2 }}]), .stays(8'd{{ stays }}),
        .m_tready(is_taken), .m_tvalid(is_there), .address(address)
    );
    {{ machine }} machine (
        .clock(clock), .s_tvalid(is_there), .s_tdest({ {{- kind -}} }),
        .s_tuser({ {{- unit }}, {{ address -}} }), .s_tdata({ {{- data -}} }),
        .s_tlast(word[{{ bits - 2 }}]), .s_tready(is_taken),
        .overlay_write(1'b0), .overlay_address(16'd0), .overlay_data(32'd0), .overlay_enable(1'b0),
        .overlay_colour(24'd0), .swapped(unused_swapped),
        .refused(unused_refused),
        .hsync(hsync), .vsync(vsync), .de(de), .red(red), .green(green), .blue(blue)
    );
endmodule
{% if tmds %}
// The words of three DVI channels{{ ", their pairs of bits on the fast clock" if pairs }}.
module scene_channels (
{%- if pairs %}
    input  wire pixel_clock, fast_clock,
    output wire [1:0] pair_0, pair_1, pair_2, pair_3
{%- else %}
    input  wire pixel_clock,
    output wire [9:0] blue_word, green_word, red_word
{%- endif %}
);

    wire hsync, vsync, de;
    wire [7:0] red, green, blue;

{%- if pairs %}
    wire [9:0] red_word, green_word, blue_word;
    // One for each channel, near it.
    reg [3:0] turns = 4'd0;

    always @(posedge pixel_clock) turns <= ~turns;
{%- endif %}

    scene_display display (
        .clock(pixel_clock), .hsync(hsync), .vsync(vsync), .de(de), .red(red), .green(green), .blue(blue)
    );
    tmds_encoder blue_channel (
        .clock(pixel_clock), .de(de), .level(blue), .control({vsync, hsync}), .word(blue_word)
    );
    tmds_encoder green_channel (
        .clock(pixel_clock), .de(de), .level(green), .control(2'd0), .word(green_word)
    );
    tmds_encoder red_channel (
        .clock(pixel_clock), .de(de), .level(red), .control(2'd0), .word(red_word)
    );
{%- if pairs %}
    tmds_serialiser blue_pairs (.clock(fast_clock), .turn(turns[0]), .word(blue_word), .pair(pair_0));
    tmds_serialiser green_pairs (.clock(fast_clock), .turn(turns[1]), .word(green_word), .pair(pair_1));
    tmds_serialiser red_pairs (.clock(fast_clock), .turn(turns[2]), .word(red_word), .pair(pair_2));
    tmds_serialiser clock_pairs (.clock(fast_clock), .turn(turns[3]), .word(10'b0000011111), .pair(pair_3));
{%- endif %}
endmodule
{% endif -%}
