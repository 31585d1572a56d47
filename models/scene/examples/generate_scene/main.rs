//! Writes a scene of many spheres to standard output: `cargo run --release -p imogene-scene --example generate_scene --
//! dna > scenes/shadows/dna.toml`.

mod dna;
mod sphere;
mod surface;

use std::process::ExitCode;

fn main() -> ExitCode {
    let name = std::env::args().nth(1);
    let text = match name.as_deref() {
        Some("dna") => dna::scene(),
        Some("molecule-480") => dna::without_shadows(),
        Some("sphere-surface") => surface::scene(),
        _ => {
            eprintln!(
                "error: the name of a scene is needed; accepted: dna, molecule-480, sphere-surface"
            );
            return ExitCode::from(2);
        }
    };
    print!("{text}");
    ExitCode::SUCCESS
}
