//! Lines and modules of every unit at the base format: `cargo run --release --example emit_sizes [DIR]`. With a directory, the
//! Verilog is written there.

use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{EmitRequest, emit};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let directory = std::env::args().nth(1);
    for unit in Unit::ALL {
        let emitted = emit(&EmitRequest::new(unit))?;
        for (name, text) in &emitted.files {
            println!(
                "{name}: {} lines, {} modules",
                text.lines().count(),
                emitted.modules
            );
            if let Some(directory) = &directory {
                std::fs::write(Path::new(directory).join(name), text)?;
            }
        }
    }
    Ok(())
}
