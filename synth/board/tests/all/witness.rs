use imogene_board::multipliers::added;
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

/// A multiplier of two ports and one bit of product, with a parameter in its own tile and two bits of one in another.
#[test]
fn a_multiplier_is_made_of_its_nets_and_bits() {
    let database = "\
.dsp0_tile_bits 54 16
IpConfig.CBIT_0 B1[2]
IpConfig.CBIT_1 B0[1]

.dsp1_tile_bits 54 16

.extra_cell 0 5 0 MAC16
A_0 0 7 lutff_0/in_3
CE 0 7 lutff_global/cen
AHOLD 0 7 lutff_0/in_0
O_3 0 5 mult/O_3
A_REG 0 5 CBIT_1
TOPOUTPUT_SELECT_0 0 9 CBIT_0
TOPOUTPUT_SELECT_1 0 9 CBIT_1

.extra_cell 0 10 0 MAC16
O_0 0 10 mult/O_0
";
    let unpacked = ".dsp0_tile 0 5\n000\n001\n\n.ipcon_tile 0 9\n010\n000\n";
    let verilog = "module top (output a);\nwire n1;\n// (0, 7, 'lutff_0/in_3')\n// (0, 5, 'sp4')\nreg n2 = 0;\n\
                   // (0, 5, 'mult/O_3')\n/* DSP0 0 5 */ assign dsp0 = n1;\nendmodule\n";
    let text = added(verilog, unpacked, database);
    let has_others = text.contains("DSP0") || text.contains("mac16_0_10");
    assert!(!has_others, "{text}");
    for part in [
        "SB_MAC16 #(.A_REG(0), .TOPOUTPUT_SELECT(2)) mac16_0_5 (",
        "1'b0, n1}), .B(",
        "mac16_0_5_open[4], n2, mac16_0_5_open[2]",
        ".CE(1'b1), .AHOLD(1'b0));\nendmodule",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let own_tile = unpacked.replace("000\n001", "010\n000");
    assert!(added(verilog, &own_tile, database).contains(".A_REG(1)"));
}
