// A tile with its reset, on the pins of a screen.
module board_top (
    input  wire clock,
    output wire {{ names | join(", ") }}
);

    wire [7:0] uo_out, uio_out, uio_oe;
    reg [3:0] held = 4'd0;

    // Between two rising edges, so that the cells have their time.
    always @(negedge clock) held <= {held[2:0], 1'b1};

    {{ top }} tile (
        .ui_in(8'd0), .uo_out(uo_out), .uio_in(8'd0), .uio_out(uio_out), .uio_oe(uio_oe),
        .ena(1'b1), .clk(clock), .rst_n(held[3])
    );
{% for pin in pins %}
    assign {{ pin[0] }} = {{ pin[1] }};
{%- endfor %}
endmodule
