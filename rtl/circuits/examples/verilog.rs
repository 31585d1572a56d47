//! Writes the Verilog of a unit with the parameters of `Parameters::of`, a file for each module, and prints its lines:
//! `cargo run --release -p imogene-circuits --example verilog -- quadric_pe 24 FOLDER`.

use imogene_circuits::units::{UNITS, design};
use imogene_contract::parameters::Parameters;
use imogene_hdl::verilog;
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let names: Vec<&str> = UNITS.iter().map(|unit| unit.0).collect();
    let usage = || {
        format!(
            "usage: verilog UNIT DEPTH_WORD FOLDER, with a unit of: {}",
            names.join(", ")
        )
    };
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, word, folder] = &arguments[..] else {
        return Err(usage().into());
    };
    let word = word.parse().map_err(|_| usage())?;
    let design = design(name, &Parameters::of(word)).ok_or_else(usage)?;
    std::fs::create_dir_all(folder)?;
    let mut lines = 0;
    for module in design.top.all() {
        let text = verilog::write(&module, "");
        lines += text.lines().count();
        std::fs::write(Path::new(folder).join(format!("{}.v", module.name)), text)?;
    }
    println!("{name}: {lines} lines");
    Ok(())
}
