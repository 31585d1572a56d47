//! Readers of real data: each turns one kind of file into a [`SceneFile`] and says what it left out, what is exact and
//! what is not.
//!
//! Each kind of file is a feature: `pdb` for molecules, `cad` for face lists and STEP, `terrain` for grids of heights.

mod compressed;
mod error;
#[cfg(feature = "cad")]
pub mod faces;
mod kind;
#[cfg(feature = "pdb")]
pub mod pdb;
#[cfg(feature = "terrain")]
pub mod terrain;

pub use compressed::{is_compressed, unpack};
pub use error::{ImportError, Place};
pub use kind::{Kind, Kinds, is_scene};

use imogene_scene::SceneFile;

/// What a reader made of a file.
#[derive(Debug)]
pub struct Imported {
    /// The scene.
    pub scene: SceneFile,
    /// Counts and verdicts, one JSON object.
    pub report: serde_json::Value,
    /// What a person should know, one line each: what was left out, approximated or rejected.
    pub notes: Vec<String>,
}
