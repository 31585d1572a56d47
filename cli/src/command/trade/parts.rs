//! The points in parts, as jobs of a HyperQueue server.

use crate::arguments::Trade;
use crate::failure::Failure;
use serde_json::json;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// What submits the jobs: HyperQueue's own Python interface.
const DRIVER: &str = include_str!("hyperqueue.py");
/// Parts of each worker: what is lost with a part is measured again.
const PARTS: usize = 4;

/// Runs all parts of the points, each by this program.
pub fn run(options: &Trade, points: &str) -> Result<(), Failure> {
    let program = std::env::current_exe().map_err(Failure::input)?;
    let mut command = vec![
        program.display().to_string(),
        "trade".into(),
        options.scene.display().to_string(),
        "--out".into(),
        options.out.display().to_string(),
        "--target".into(),
        options.target.clone(),
        "--points".into(),
        points.into(),
    ];
    if let Some(size) = options.size {
        command.extend(["--size".into(), format!("{}x{}", size.width, size.height)]);
    }
    let request = json!({
        "command": command,
        "parts": PARTS * usize::from(options.workers),
        "workers": options.workers,
        "server": options.server,
    });
    let output = Command::new(python())
        .args(["-c", DRIVER, &request.to_string()])
        .stdin(Stdio::null())
        .output()
        .map_err(|error| Failure::Input(format!("cannot run Python: {error}; {HOW}")))?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stderr);
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
    let named = std::env::var_os("IMOGENE_TOOLS").map(PathBuf::from);
    let current = std::env::current_dir().unwrap_or_default();
    let above = current.ancestors().map(|f| f.join("target/tools/bin"));
    let folders: Vec<PathBuf> = match named {
        Some(folder) => vec![folder],
        None => above.collect(),
    };
    let candidates = folders.into_iter().map(|folder| folder.join("python"));
    let mut candidates = candidates.filter(|python| python.is_file());
    candidates.next().unwrap_or_else(|| "python3".into())
}
