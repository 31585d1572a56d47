// {{ input_mhz }} MHz / {{ pll.reference }} x {{ pll.feedback }} / {{ pll.output }}: {{ pixel }} MHz.
module board_clock (
    input  wire clock,
    output wire pixel_clock
);

    wire fed_back, made;

    MMCME2_BASE #(
        .CLKIN1_PERIOD({{ pll.period }}), .DIVCLK_DIVIDE({{ pll.reference }}), .CLKFBOUT_MULT_F({{ pll.feedback }}),
        .CLKOUT0_DIVIDE_F({{ pll.output }})
    ) mmcm (
        .CLKIN1(clock), .CLKFBIN(fed_back), .CLKFBOUT(fed_back), .CLKOUT0(made), .RST(1'b0), .PWRDWN(1'b0)
    );
    BUFG pixels (.I(made), .O(pixel_clock));
endmodule
