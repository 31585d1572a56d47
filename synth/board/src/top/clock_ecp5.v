{% set apart = pll.looped != pll.fast -%}
// {{ input_mhz }} MHz / {{ pll.reference }} x {{ pll.feedback }} x {{ pll.looped }} in the oscillator, {{ fast }} MHz and
// {{ pixel }} MHz out of it.
module board_clock (
    input  wire clock,
    output wire pixel_clock, fast_clock
);

    wire fed_back, unused_feedback, unused_lock;

    (* FREQUENCY_PIN_CLKI = "{{ input_mhz }}", FREQUENCY_PIN_CLKOP = "{{ fast }}", FREQUENCY_PIN_CLKOS = "{{ pixel }}",
       ICP_CURRENT = "12", LPF_RESISTOR = "8", MFG_ENABLE_FILTEROPAMP = "1", MFG_GMCREF_SEL = "2" *)
    EHXPLLL #(
        .PLLRST_ENA("DISABLED"), .INTFB_WAKE("DISABLED"), .STDBY_ENABLE("DISABLED"), .DPHASE_SOURCE("DISABLED"),
        .OUTDIVIDER_MUXA("DIVA"), .OUTDIVIDER_MUXB("DIVB"), .OUTDIVIDER_MUXC("DIVC"), .OUTDIVIDER_MUXD("DIVD"),
        .CLKI_DIV({{ pll.reference }}), .CLKFB_DIV({{ pll.feedback }}),
        .CLKOP_ENABLE("ENABLED"), .CLKOP_DIV({{ pll.fast }}), .CLKOP_CPHASE({{ pll.fast // 2 }}), .CLKOP_FPHASE(0),
        .CLKOS_ENABLE("ENABLED"), .CLKOS_DIV({{ pll.pixel }}), .CLKOS_CPHASE({{ pll.fast // 2 }}), .CLKOS_FPHASE(0),
{%- if apart %}
        .CLKOS2_ENABLE("ENABLED"), .CLKOS2_DIV({{ pll.looped }}), .CLKOS2_CPHASE({{ pll.fast // 2 }}), .CLKOS2_FPHASE(0),
        .FEEDBK_PATH("CLKOS2")
{%- else %}
        .FEEDBK_PATH("CLKOP")
{%- endif %}
    ) pll (
        .RST(1'b0), .STDBY(1'b0), .CLKI(clock), .CLKOP(fast_clock), .CLKOS(pixel_clock),
{%- if apart %}
        .CLKOS2(fed_back),
{%- endif %}
        .CLKFB(fed_back), .CLKINTFB(unused_feedback), .PHASESEL0(1'b0), .PHASESEL1(1'b0), .PHASEDIR(1'b1), .PHASESTEP(1'b1),
        .PHASELOADREG(1'b1), .PLLWAKESYNC(1'b0), .ENCLKOP(1'b0), .LOCK(unused_lock)
    );
{%- if not apart %}

    assign fed_back = fast_clock;
{%- endif %}
endmodule
