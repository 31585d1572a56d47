//! Lines and modules of every unit at the base format: `cargo run --release --example emit_sizes [DIR]`. With a directory, the
//! Verilog is written there.

use imogene_contract::{Request, Unit};
use imogene_rtl::emit::emit;
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let directory = std::env::args().nth(1);
    for unit in Unit::ALL {
        let emitted = emit(&Request::new(unit))?;
        let text = emitted.bundle();
        println!(
            "{}: {} lines, {} modules",
            emitted.top,
            text.lines().count(),
            emitted.modules.len()
        );
        if let Some(directory) = &directory {
            std::fs::write(
                Path::new(directory).join(format!("{}.v", emitted.top)),
                text,
            )?;
        }
    }
    Ok(())
}
