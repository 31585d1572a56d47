// {{ input_mhz }} MHz / {{ pll.divr + 1 }} x {{ pll.divf + 1 }} / 2^{{ pll.divq }}: {{ pixel }} MHz.
module board_clock (
    input  wire clock,
    output wire pixel_clock
);

    SB_PLL40_{{ 'PAD' if pad else 'CORE' }} #(
        .FEEDBACK_PATH("SIMPLE"), .DIVR(4'd{{ pll.divr }}), .DIVF(7'd{{ pll.divf }}), .DIVQ(3'd{{ pll.divq }}),
        .FILTER_RANGE(3'd{{ pll.filter }})
    ) pll (
        .{{ 'PACKAGEPIN' if pad else 'REFERENCECLK' }}(clock), .PLLOUTGLOBAL(pixel_clock), .RESETB(1'b1), .BYPASS(1'b0)
    );
endmodule
