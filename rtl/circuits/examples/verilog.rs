//! Writes the Verilog of a unit with its default parameters, a file for each module, and prints its lines:
//! `cargo run --release -p imogene-circuits --example verilog -- quadric_pe 24 FOLDER`.

use imogene_circuits::units::design;
use imogene_contract::request::Request;
use imogene_hdl::verilog;
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let usage = "usage: verilog UNIT DEPTH_WORD FOLDER";
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, word, folder] = &arguments[..] else {
        return Err(usage.into());
    };
    let request = Request::given(name, word.parse().map_err(|_| usage)?, &[]);
    let design = design(&request.map_err(|error| error.to_string())?);
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
