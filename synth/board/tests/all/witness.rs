use imogene_board::{declared_once, with_pad};

#[test]
fn the_pad_of_a_pll_is_the_clock() {
    let verilog = "SB_PLL40_PAD p (\n  .PACKAGEPIN(n30),\n  .LOCK(n1)\n);\n";
    assert_eq!(with_pad(verilog), verilog.replace("n30", "clock"));
}

#[test]
fn ports_are_declared_once() {
    let verilog = "module top (input clock, output a, output b, output ab);\nwire n1, clock, n2;\nwire b;\n\
                   reg n3 = 0, a = 0;\nassign b = n1;\n";
    let wanted = "module top (input clock, output reg a = 0, output b, output ab);\nwire n1, n2;\nreg n3 = 0;\n\
                  assign b = n1;\n";
    assert_eq!(declared_once(verilog), wanted);
}
