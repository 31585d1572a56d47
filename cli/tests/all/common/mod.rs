//! Shared by the command line tests.

use assert_cmd::Command;
use std::path::PathBuf;

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
