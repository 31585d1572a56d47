// The pins of a board side by side.
module board_bench (
    input  wire clock,
    output wire [31:0] pins
);

    board_top board (.clock(clock){% for name in names %}, .{{ name }}(pins[{{ loop.index0 }}]){% endfor %});

    assign pins[31:{{ names | length }}] = {{ 32 - (names | length) }}'d0;
endmodule
