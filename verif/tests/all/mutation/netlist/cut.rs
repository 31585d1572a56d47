use imogene_verif::mutation::netlist::cut::{cut, cut_command};

const NETLIST: &str = "module \\m
  attribute \\init 3'000
  wire width 3 output 2 \\value
  cell $dff $r$1
parameter \\CLK_POLARITY 1
parameter \\WIDTH 3
connect \\CLK \\clock
connect \\D $next
connect \\Q \\value
  end
end
";

#[test]
fn a_register_becomes_three_ports() {
    let text = cut(NETLIST);
    assert!(!text.contains("$dff") && !text.contains("init"), "{text}");
    for part in [
        "wire width 3 input 10000 \\cut_q_0",
        "wire width 3 output 10001 \\cut_d_0",
        "wire output 10002 \\cut_c_0",
        "connect \\cut_c_0 \\clock",
        "connect \\A \\cut_q_0\n    connect \\Y \\value",
        "connect \\A $next\n    connect \\Y \\cut_d_0",
    ] {
        assert!(text.contains(part), "no '{part}' in {text}");
    }
}

#[test]
fn mutants_of_a_register_move_to_its_buffers() {
    let moved = |port: &str| {
        let command = format!("-mode inv -cell $r$1 -port {port} -portbit 2");
        cut_command(&command, "$r$1", NETLIST)
    };
    assert_eq!(moved("Q"), "-mode inv -cell $r$1$q -port Y -portbit 2");
    assert_eq!(moved("D"), "-mode inv -cell $r$1$d -port A -portbit 2");
    let other = "-mode inv -cell $add$1 -port Y -portbit 2";
    assert_eq!(cut_command(other, "$add$1", NETLIST), other);
}
