// {{ input_mhz }} MHz / {{ pll.reference }} x {{ "%.3f"|format(pll.feedback / 8) }} / {{ "%.3f"|format(pll.output / 8) }}: {{ pixel }} MHz.
module board_clock (
    input  wire clock,
    output wire pixel_clock
);

    wire fed_back, made;

    MMCME2_BASE #(
        .CLKIN1_PERIOD({{ period }}), .DIVCLK_DIVIDE({{ pll.reference }}), .CLKFBOUT_MULT_F({{ "%.3f"|format(pll.feedback / 8) }}),
        .CLKOUT0_DIVIDE_F({{ "%.3f"|format(pll.output / 8) }})
    ) mmcm (
        .CLKIN1(clock), .CLKFBIN(fed_back), .CLKFBOUT(fed_back), .CLKOUT0(made), .RST(1'b0), .PWRDWN(1'b0)
    );
    BUFG pixels (.I(made), .O(pixel_clock));
endmodule
