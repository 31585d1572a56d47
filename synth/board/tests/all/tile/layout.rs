use imogene_board::{Layout, layout, with_short_names};

const DEF: &str =
    "UNITS DISTANCE MICRONS 100 ;\n\nDIEAREA ( -320 -300 ) ( 52800 38300 ) ;\nNETS 3780 ;\n";
const VERILOG: &str =
    "wire gnd = 1'b0;\nBUFX4 BUFX4_1 ( .A(clk), .Y(a) );\nINVX1 INVX1_1 ( .A(a), .Y(b) );\n";
const TIMES: &str =
    "Path DFFPOSX1_171/CLK to DFFPOSX1_321/D delay 7843.3 ps\nPath A/CLK to B/D delay 70 ps\n";

#[test]
fn reports_of_the_flow_are_read() {
    let texts = |route, comparison| layout([DEF, VERILOG, route, TIMES, "drc = 17\n", comparison]);
    let sound = texts("Final: No failed routes!\n", "\nTotal errors = 0\n");
    let mut expected = Layout {
        micrometres: [531.2, 386.0],
        cells: 2,
        nets: 3780,
        unrouted: 0,
        longest_ns: 7.8433,
        rule_errors: 17,
        differences: 0,
    };
    assert_eq!(sound.as_ref(), Ok(&expected));
    (expected.unrouted, expected.differences) = (4, 3);
    let failed = "Final: Failed net routes: 4\n";
    let unsound = texts(failed, "Total errors = 3\nDesign fails");
    assert_eq!(unsound, Ok(expected));
    // A comparison that did not happen is no equal one.
    let undone = texts("Final: No failed routes!\n", "LVS Done.");
    assert_eq!(undone, Err("Total errors ="));
}

#[test]
fn the_flow_is_given_short_names() {
    let given = "wire \\tile.planes[1].next[10] ;\nINVX1 a ( .A(\\tile.b ), .Y(c[2]), .B(\\tile.planes[1].next[10] ) );\n";
    let short = "wire net_0 ;\nINVX1 a ( .A(net_1 ), .Y(c[2]), .B(net_0 ) );\n";
    assert_eq!(with_short_names(given), short);
    assert_eq!(with_short_names("wire a;\n"), "wire a;\n");
}
