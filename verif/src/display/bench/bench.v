// A bench for {{ top }}: it sends the beats of {{ files.beats }} and compares every pixel with {{ files.pixels }}.
//
//     {{ run }}
//
// in the folder of these files. It says "0 differences" and ends with 0 if the picture is right, and with 1 if not.
// {{ files.description }} describes the files, the ports and the handshake.
`timescale 1ns / 1ps

module bench;
    localparam BEATS = {{ beats }};
    localparam FRAMES = {{ frames }};
    localparam WIDTH = {{ width }};
    localparam HEIGHT = {{ height }};
    localparam PIXELS = WIDTH * HEIGHT;
    // Clocks without a beat or a pixel after which the machine is given up.
    localparam PATIENCE = {{ patience }};

    reg clock = 0;
    always #5 clock = !clock;

    // A beat, from its high end: last beat of a frame (4 bits), kind (4), unit (8), address (16), data ({{ padded }}).
    reg [{{ padded + 31 }}:0] beats [0:BEATS-1];
    // A pixel: red, green, blue.
    reg [23:0] pixels [0:FRAMES*PIXELS-1];
{%- if overlay %}
    reg [31:0] overlay [0:{{ overlay - 1 }}];
{%- endif %}
    initial begin
        $readmemh("{{ files.beats }}", beats);
        $readmemh("{{ files.pixels }}", pixels);
{%- if overlay %}
        $readmemh("{{ files.overlay }}", overlay);
{%- endif %}
    end
{%- if overlay %}

    // The plane is written first, a word on every clock.
    integer written = 0;
    always @(posedge clock) if (written < {{ overlay }}) written <= written + 1;
{%- endif %}

    // The host sends the beats of a frame as fast as they are taken, and those of the next one when it was compared.
    integer sent = 0, ended = 0, compared = 0;
    wire ready;
    wire valid = sent < BEATS && ended == compared{% if overlay %} && written == {{ overlay }}{% endif %};
    wire [{{ padded + 31 }}:0] beat = beats[valid ? sent : 0];
    always @(posedge clock) if (valid && ready) begin
        sent <= sent + 1;
        if (beat[{{ padded + 28 }}]) ended <= ended + 1;
    end
{% if beam %}
    wire swapped, refused;
{%- elif pins %}
    wire swapped;
{%- endif %}
{%- if pins %}
    wire hsync, vsync, de;
    wire [7:0] red, green, blue;
{%- else %}
    wire m_tvalid, m_tlast;
{%- if lanes > 1 %}
    // The pixels of a clock, the leftmost in the low bits.
    localparam LANES = {{ lanes }};
    wire [24*LANES-1:0] m_tdata;
{%- else %}
    wire [23:0] m_tdata;
{%- endif %}
    wire {% if not beam %}[23:0] {% endif %}m_tuser;
{%- endif %}
    {{ top }} machine (
        .clock(clock),
        .s_tvalid(valid), .s_tready(ready), .s_tdest(beat[{{ padded + 27 }}:{{ padded + 24 }}]),
        .s_tuser(beat[{{ padded + 23 }}:{{ padded }}]), .s_tdata(beat[{{ data - 1 }}:0]){% if beam %}, .s_tlast(beat[{{ padded + 28 }}]){% endif %},
{%- if overlay %}
        .overlay_write(written < {{ overlay }}), .overlay_address(written[15:0]), .overlay_data(overlay[written]),
        .overlay_enable(1'b1), .overlay_colour(24'h{{ overlay_colour }}),
{%- elif pins %}
        .overlay_write(1'b0), .overlay_address(16'd0), .overlay_data(32'd0), .overlay_enable(1'b0), .overlay_colour(24'd0),
{%- endif %}
{%- if beam %}
        .swapped(swapped), .refused(refused),
{%- elif pins %}
        .swapped(swapped),
{%- endif %}
{%- if pins %}
        .hsync(hsync), .vsync(vsync), .de(de), .red(red), .green(green), .blue(blue)
{%- else %}
        .m_tvalid(m_tvalid), .m_tready(1'b1), {% if lanes > 1 %}{% for lane in range(lanes) %}.m_tdata_{{ lane }}(m_tdata[{{ 24 * lane + 23 }}:{{ 24 * lane }}]), {% endfor %}
        {% else %}.m_tdata(m_tdata), {% endif %}.m_tuser(m_tuser), .m_tlast(m_tlast)
{%- endif %}
    );

    integer idle = 0, place = 0, differences = 0;
    task differs(input integer at, input [24*8-1:0] what);
        begin
            differences = differences + 1;
            if (differences <= 10)
                $display("frame %0d, column %0d, line %0d: %0s", compared, at % WIDTH, at / WIDTH, what);
        end
    endtask
    task compare(input integer at, input [23:0] colour);
        if (colour !== pixels[compared * PIXELS + at]) begin
            differs(at, "another colour");
            if (differences <= 10) $display("    %h, expected %h", colour, pixels[compared * PIXELS + at]);
        end
    endtask
{% if beam or pins %}
    // A frame that has begun is the old one to its end, also if the words of the next one come to work meanwhile.
    reg fresh = 0, watched = 0;
{%- if lanes > 1 %}
    integer lane;
{%- endif %}
{%- else %}
    // Pixels come in the order of the zones, each of them once.
    reg [PIXELS-1:0] seen = 0;
    integer at;
{%- endif %}
    always @(posedge clock) begin
        idle = valid && ready ? 0 : idle + 1;
{%- if beam or pins %}
        if (swapped) fresh = 1;
        if ({% if pins %}de{% else %}m_tvalid{% endif %}) begin
            if (place == 0) watched = fresh;
{%- if pins %}
            if (watched) begin
                idle = 0;
                compare(place, {red, green, blue});
            end
{%- else %}
            if (watched) begin
                idle = 0;
{%- if lanes > 1 %}
                for (lane = 0; lane < LANES; lane = lane + 1) compare(place + lane, m_tdata[24*lane +: 24]);
{%- else %}
                compare(place, m_tdata);
{%- endif %}
            end
            if (m_tuser !== (place == 0)) differs(place, "m_tuser");
            if (m_tlast !== (place % WIDTH == WIDTH - {{ lanes }})) differs(place, "m_tlast");
{%- endif %}
            place = place + {% if pins %}1{% else %}{{ lanes }}{% endif %};
            if (place == PIXELS) begin
                place = 0;
                if (watched) begin
                    compared <= compared + 1;
                    fresh = 0;
                    watched = 0;
                end
            end
        end
{%- else %}
        if (m_tvalid) begin
            idle = 0;
            at = m_tuser[23:12] * WIDTH + m_tuser[11:0];
            compare(at, m_tdata);
            if (seen[at] !== 1'b0) differs(at, "a pixel again");
            seen[at] = 1;
            place = place + 1;
            if (m_tlast !== (place == PIXELS)) differs(at, "m_tlast");
            if (place == PIXELS) begin
                place = 0;
                seen = 0;
                compared <= compared + 1;
            end
        end
{%- endif %}
        if (compared == FRAMES) begin
            $display("%0d frames of %0d pixels, %0d beats: %0d differences", FRAMES, PIXELS, BEATS, differences);
            if (differences == 0) $finish;
            else $fatal(1, "the pictures differ");
        end
{%- if beam %}
        if (refused) $fatal(1, "a frame has more words than the machine keeps");
{%- endif %}
        if (idle == PATIENCE)
            $fatal(1, "%0d of %0d frames and %0d of %0d beats, then nothing", compared, FRAMES, sent, BEATS);
    end
endmodule
