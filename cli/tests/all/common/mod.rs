//! Shared by the command line tests.

use assert_cmd::Command;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The program.
pub fn imogene() -> Command {
    Command::cargo_bin("imogene").expect("the program was built")
}

/// A scene of the repository.
pub fn scene(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../scenes")
        .join(name)
}

/// Exit code, standard output and standard error of a run.
pub fn said(output: std::process::Output) -> (Option<i32>, String, String) {
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    let code = output.status.code();
    (code, text(output.stdout), text(output.stderr))
}

/// What a command says as JSON, run in a folder.
pub fn json_in(arguments: &[&str], folder: &Path) -> Value {
    let mut command = imogene();
    let output = command
        .args(arguments)
        .arg("--json")
        .current_dir(folder)
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    serde_json::from_slice(&output.stdout).unwrap()
}

/// What a command says as JSON.
pub fn json(arguments: &[&str]) -> Value {
    json_in(arguments, Path::new("."))
}

pub fn assert_keys(value: &Value, keys: &[&str]) {
    for key in keys {
        assert!(value.get(key).is_some(), "no key '{key}' in {value}");
    }
}

/// Keys of every co-simulation.
pub const COSIM_KEYS: [&str; 8] = [
    "engine",
    "cycles",
    "pixels",
    "mismatches",
    "seconds",
    "cycles_per_second",
    "seed",
    "files",
];

/// What a command that is refused says, run in a folder.
pub fn refusal_in(arguments: &[&str], folder: &Path) -> String {
    let output = imogene()
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(!folder.join("never.toml").exists());
    String::from_utf8(output.stderr).unwrap()
}
