use imogene_verif::mutation::netlist::mutant::parse;

#[test]
fn a_line_of_yosys_is_understood() {
    let list = "mutate -mode cnot1 -module pe1 -cell $add$unit.v:2$1 -port B -portbit 18 -ctrlbit 23 \
                -wire kept_b -wirebit 18 -src unit.v:1.23-1.29 -src unit.v:2.24-2.43\n";
    let found = parse(list, "reg b;\n  assign next = a + b;\n").expect("a legal list");
    let [mutant] = found.as_slice() else {
        panic!("one mutant, not {}", found.len())
    };
    let command = "-mode cnot1 -cell $add$unit.v:2$1 -port B -portbit 18 -ctrlbit 23";
    assert_eq!(mutant.command, command);
    let text =
        "cnot1 of B[18] by [23] (kept_b[18]) at $add$unit.v:2$1, line 2: assign next = a + b;";
    assert_eq!(mutant.text, text);
}

#[test]
fn a_line_without_a_cell_is_refused() {
    let outcome = parse("mutate -mode inv -port A -portbit 0", "");
    assert!(outcome.is_err_and(|error| error.to_string().contains("-port A")));
}
