use imogene_board::netlist::settle;
use serde_json::json;

#[test]
fn open_inputs_have_the_level_of_the_part() {
    let mut cell = json!({
        "type": "TRELLIS_FF",
        "parameters": {"GSR": "DISABLED", "LSRMUX": "INV", "CEMUX": "1 ", "SD": "0 "},
        "port_directions": {"CLK": "input", "LSR": "input", "CE": "input", "M": "input", "Q": "output"},
        "connections": {"CLK": [7], "LSR": [], "CE": [], "M": [8], "Q": []},
    });
    settle(&mut cell).unwrap();
    let wanted = json!({"CLK": [7], "LSR": ["0"], "CE": ["1"], "M": [8], "Q": []});
    assert_eq!(cell["connections"], wanted);
    let taken = json!({"LSRMUX": "LSR", "CEMUX": "1 ", "SD": "0 "});
    assert_eq!(cell["parameters"], taken);
}

#[test]
fn what_no_model_does_is_refused() {
    let memory = |port: &str, net: i32, mode: &str| {
        let mut cell = json!({
            "type": "DP16KD",
            "parameters": {"CSDECODE_A": mode, "WEBMUX": "INV", "RSTAMUX": "INV", "CSA0MUX": "INV"},
            "port_directions": {"WEB": "input", "RSTA": "input", "CSA0": "input"},
            "connections": {"WEB": [], "RSTA": [], "CSA0": []},
        });
        cell["connections"][port] = if net > 0 { json!([net]) } else { json!([]) };
        settle(&mut cell).err().unwrap_or_default()
    };
    assert_eq!(memory("WEB", 0, "0b000"), "");
    for (port, net, mode, problem) in [
        ("CSA0", 5, "0b000", "with CSA0 inverted"),
        ("RSTA", 5, "0b000", "with RSTA inverted"),
        ("WEB", 0, "0b001", "whose CSDECODE_A is \"0b001\""),
    ] {
        let wanted = format!("no model of a DP16KD {problem}");
        assert_eq!(memory(port, net, mode), wanted);
    }
    let mut other = json!({"type": "ALU54B", "parameters": {}});
    assert_eq!(settle(&mut other).unwrap_err(), "no model of a ALU54B");
}

#[test]
fn a_multiplier_may_have_registers_before_and_behind_but_none_inside() {
    let registers =
        json!({"REG_INPUTA_CLK": "CLK0", "REG_INPUTB_CLK": "CLK0", "REG_OUTPUT_CLK": "CLK0"});
    let mut cell = json!({"type": "MULT18X18D", "parameters": registers});
    settle(&mut cell).expect("a model");
    assert_eq!(cell["parameters"], registers);
    cell["parameters"]["REG_PIPELINE_CLK"] = "CLK0".into();
    let problem = "no model of a MULT18X18D whose REG_PIPELINE_CLK is \"CLK0\"";
    assert_eq!(settle(&mut cell).unwrap_err(), problem);
}
