//! `imogene new`.

use crate::arguments::New;
use crate::failure::{Failure, Result};
use crate::output;
use serde_json::json;
use std::fs::File;
use std::io::{Error, ErrorKind, Write};

/// The scene that is written.
const SCENE: &str = include_str!("new.toml");

pub fn run(options: &New, json: bool) -> Result {
    let path = options.file.display();
    let refuse = |error: Error| {
        Failure::Input(match error.kind() {
            ErrorKind::AlreadyExists => {
                format!("{path} exists and is not overwritten; give another name")
            }
            _ => format!("{path}: cannot be written: {error}"),
        })
    };
    let mut file = File::create_new(&options.file).map_err(refuse)?;
    if let Err(error) = file.write_all(SCENE.as_bytes()) {
        // What was begun is removed; that this fails too would say nothing new.
        let _ = std::fs::remove_file(&options.file);
        return Err(refuse(error));
    }
    if json {
        output::json(&json!({ "files": [&options.file] }));
    } else {
        output::text(format!("wrote {path}; draw it with: imogene render {path}"));
    }
    Ok(())
}
