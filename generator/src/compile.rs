//! Compiling and running the program.

use crate::cache::{folder, workspace};
use crate::error::GeneratorError;
use crate::program;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::MachineRequest;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What the program answers to a request.
type Answer = Result<Emitted, String>;

/// Writes, compiles and runs the program for these requests. Only one process at a time does so; others wait.
pub(crate) fn run(requests: &[MachineRequest]) -> Result<Vec<Answer>, GeneratorError> {
    let folder = folder();
    let lock_path = folder.join("lock");
    fs::create_dir_all(folder.join("src")).map_err(GeneratorError::file(&folder))?;
    let lock = File::create(&lock_path).map_err(GeneratorError::file(&lock_path))?;
    lock.lock().map_err(GeneratorError::file(&lock_path))?;
    write(
        &folder.join("Cargo.toml"),
        &program::manifest(&workspace().join("rtl")),
    )?;
    write(
        &folder.join("src").join("main.rs"),
        &program::source(requests),
    )?;
    let versions = workspace().join("Cargo.lock");
    let copied = fs::read_to_string(&versions).map_err(GeneratorError::file(&versions))?;
    write(&folder.join("Cargo.lock"), &copied)?;
    let answers = start(&compile(&folder)?, requests)?;
    drop(lock);
    Ok(answers)
}

/// Leaves a file as it is if it has this text, so that cargo sees no change.
fn write(path: &Path, text: &str) -> Result<(), GeneratorError> {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    fs::write(path, text).map_err(GeneratorError::file(path))
}

fn compile(folder: &Path) -> Result<PathBuf, GeneratorError> {
    // The dependencies were fetched when this program was built; they are compiled once and kept.
    let target = workspace().join("target");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .current_dir(folder)
        .args(["build", "--release", "--quiet", "--offline", "--target-dir"])
        .arg(&target)
        .output()
        .map_err(GeneratorError::Cargo)?;
    if output.status.success() {
        let name = format!("imogene-fitted{}", std::env::consts::EXE_SUFFIX);
        return Ok(target.join("release").join(name));
    }
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(GeneratorError::Compile(said))
}

fn start(program: &Path, requests: &[MachineRequest]) -> Result<Vec<Answer>, GeneratorError> {
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(GeneratorError::file(program))?;
    let text = serde_json::to_string(requests).expect("plain numbers and texts");
    if let Some(mut input) = child.stdin.take() {
        // A program that ends early says why on its error stream.
        let _ = input.write_all(text.as_bytes());
    }
    let output = child
        .wait_with_output()
        .map_err(GeneratorError::file(program))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(GeneratorError::Program(said));
    }
    let answers = serde_json::from_slice(&output.stdout);
    answers.map_err(|error| GeneratorError::Program(error.to_string()))
}
