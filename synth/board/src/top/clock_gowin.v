// {{ input_mhz }} MHz / {{ pll.input + 1 }} x {{ pll.feedback + 1 }}: {{ fast }} MHz, of which a fifth is {{ pixel }} MHz.
// The oscillator runs {{ pll.output }} times as fast.
module board_clock (
    input  wire clock,
    output wire pixel_clock, fast_clock
);

    wire unused_lock, unused_phase, unused_divided, unused_third;

    rPLL #(
        .FCLKIN("{{ input_mhz }}"), .DEVICE("{{ series }}"), .IDIV_SEL({{ pll.input }}), .FBDIV_SEL({{ pll.feedback }}),
        .ODIV_SEL({{ pll.output }}), .DYN_IDIV_SEL("false"), .DYN_FBDIV_SEL("false"), .DYN_ODIV_SEL("false"),
        .DYN_DA_EN("false"), .DYN_SDIV_SEL(2), .PSDA_SEL("0000"), .DUTYDA_SEL("1000"), .CLKFB_SEL("internal"),
        .CLKOUT_BYPASS("false"), .CLKOUTP_BYPASS("false"), .CLKOUTD_BYPASS("false"), .CLKOUTD_SRC("CLKOUT"),
        .CLKOUTD3_SRC("CLKOUT"), .CLKOUT_FT_DIR(1'b1), .CLKOUTP_FT_DIR(1'b1), .CLKOUT_DLY_STEP(0), .CLKOUTP_DLY_STEP(0)
    ) pll (
        .CLKIN(clock), .CLKFB(1'b0), .RESET(1'b0), .RESET_P(1'b0), .FBDSEL(6'd0), .IDSEL(6'd0), .ODSEL(6'd0),
        .PSDA(4'd0), .DUTYDA(4'd0), .FDLY(4'd0), .CLKOUT(fast_clock), .LOCK(unused_lock), .CLKOUTP(unused_phase),
        .CLKOUTD(unused_divided), .CLKOUTD3(unused_third)
    );
    CLKDIV #(.DIV_MODE("5"), .GSREN("false")) fifth (
        .HCLKIN(fast_clock), .RESETN(1'b1), .CALIB(1'b0), .CLKOUT(pixel_clock)
    );
endmodule
