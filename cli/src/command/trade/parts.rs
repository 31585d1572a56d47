//! The points in parts, as jobs of a HyperQueue server.

use crate::arguments::Trade;
use crate::failure::Failure;
use imogene_tools::{call, find, own_folders};
use serde_json::json;
use std::path::PathBuf;
use std::process::Command;

/// What submits the jobs: HyperQueue's own Python interface.
const DRIVER: &str = include_str!("hyperqueue.py");
/// Parts of each worker: what is lost with a part is measured again.
const PARTS: usize = 4;

/// Runs all parts of the points, each by this program.
pub fn run(options: &Trade) -> Result<(), Failure> {
    let program = std::env::current_exe()?;
    let mut command = vec![
        program.display().to_string(),
        "trade".into(),
        options.scene.display().to_string(),
        "--out".into(),
        options.out.display().to_string(),
        "--target".into(),
        options.target.clone(),
        "--points".into(),
        options.points().into(),
    ];
    if let Some((width, height)) = options.size {
        command.extend(["--size".into(), format!("{width}x{height}")]);
    }
    let request = json!({
        "command": command,
        "parts": PARTS * usize::from(options.workers),
        "workers": options.workers,
        "server": options.server,
    });
    let said = call(Command::new(python()).args(["-c", DRIVER, &request.to_string()]))
        .map_err(|error| Failure::Input(format!("cannot run Python: {error}; {HOW}")))?;
    if said.succeeded() {
        return Ok(());
    }
    let said = said.errors;
    if said.contains("No module named 'hyperqueue'") {
        return Err(Failure::Input(format!(
            "HyperQueue is not installed; {HOW}"
        )));
    }
    let last = said.trim().lines().last().unwrap_or("it says nothing");
    Err(Failure::Input(format!(
        "the points in parts: {last}; run the command again, it goes on where it stopped"
    )))
}

const HOW: &str = "scripts/setup --parts installs it in target/tools";

/// The Python of the folder of tools, which `IMOGENE_TOOLS` may name, or the system's.
fn python() -> PathBuf {
    find(&own_folders(), &["python"]).unwrap_or_else(|| "python3".into())
}
