//! Shared by the command line tests.

use assert_cmd::Command;
use std::path::PathBuf;

/// The program.
pub fn imogene() -> Command {
    Command::cargo_bin("imogene").expect("the program was built")
}

/// A scene of the repository.
// Not every file of tests draws one.
#[allow(dead_code)]
pub fn scene(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../scenes")
        .join(name)
}
