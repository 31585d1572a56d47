use imogene_synth::netlist::{modules, used};
use imogene_synth::{Target, cell_models};

const LIBRARY: &str = "(* lib *)\nmodule ADD(output O, input A);\nLUT l(.A(A), .O(O));\nendmodule\n\
    module LUT (output O, input A);\nendmodule\n\nmodule OTHER(input A);\nendmodule\n";

#[test]
fn a_netlist_gets_the_models_of_its_cells_and_of_theirs() {
    let models = modules(LIBRARY);
    assert_eq!(models.len(), 3);
    let texts = used(&models, &["ADD"], Target::Ice40Hx8k).expect("models of both");
    assert_eq!(texts.len(), 2);
    assert!(texts[0].starts_with("module ADD(") && texts[1].starts_with("module LUT ("));
}

#[test]
fn a_cell_without_a_model_is_named() {
    let error = used(&modules(LIBRARY), &["MULT"], Target::Ecp5With45k).expect_err("no model");
    let message = error.to_string();
    let is_named = message.contains("`MULT`") && message.contains("ecp5-45k");
    assert!(is_named, "{message}");
}

#[test]
fn a_target_without_models_is_refused() {
    let error = cell_models(&[], Target::Xilinx7).expect_err("no models");
    assert!(error.to_string().contains("ice40-hx8k"), "{error}");
}
