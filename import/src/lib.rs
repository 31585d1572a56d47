//! Readers of real data: each turns one kind of file into a [`SceneFile`] and says what it left out, what is exact and
//! what is not.
//!
//! ```
//! use imogene_import::pdb::{Format, Options, read};
//! use imogene_scene::{Shape, Step};
//!
//! let atom = "ATOM      1  CA  ALA A   1      11.104  13.207   9.327  1.00  0.00           C";
//! let imported = read(atom.as_bytes(), Format::Pdb, "atom.pdb", &Options::default())?;
//!
//! // A carbon is a sphere of its van der Waals radius, 1.7 Angstrom, at its place.
//! let ball = &imported.scene.objects[0];
//! assert_eq!(ball.shape, Shape::Sphere { radius: 1.7 });
//! assert_eq!(ball.place, [Step::Translate([11.104, 13.207, 9.327])]);
//!
//! // What is no coordinate is refused where it stands.
//! let wrong = atom.replace("13.207", "13.2o7");
//! let refusal = read(wrong.as_bytes(), Format::Pdb, "atom.pdb", &Options::default()).unwrap_err();
//! assert!(refusal.to_string().starts_with("atom.pdb:1:41: the y coordinate `13.2o7` is not a number"));
//! # Ok::<(), imogene_import::ImportError>(())
//! ```

mod error;
pub mod faces;
mod kind;
pub mod pdb;
pub mod terrain;

pub use error::{ImportError, Place, Result};
pub use kind::{Kind, is_compressed, is_scene, kinds, unpack};

use imogene_scene::{Material, Object, SceneFile, Shape, Surface};
use std::collections::HashMap;

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

/// Names that are taken, and how often.
#[derive(Default)]
pub(crate) struct Names(HashMap<String, usize>);

impl Names {
    /// The name itself, or with the least number that makes it unique.
    pub(crate) fn unique(&mut self, name: String, number: fn(&str, usize) -> String) -> String {
        let mut own = name.clone();
        while self.0.contains_key(&own) {
            let count = self.0.entry(name.clone()).or_insert(1);
            *count += 1;
            own = number(&name, *count);
        }
        self.0.insert(own.clone(), 1);
        own
    }

    pub(crate) fn has(&self, name: &str) -> bool {
        self.0.contains_key(name)
    }
}

/// An opaque material with its shares of ambient, diffused and mirrored light, and the sharpness of the highlight.
pub(crate) fn material(
    name: String,
    colour: [f64; 3],
    [ambient, diffuse, specular]: [f64; 3],
    exponent: u32,
) -> Material {
    Material {
        name,
        colour,
        ambient,
        diffuse,
        specular,
        exponent,
        opacity: 1.0,
    }
}

/// A number of digits and some other letters; Rust would also take "nan" and "inf".
pub(crate) fn decimal(text: &[u8], letters: &[u8]) -> Option<f64> {
    let is_plain = |c: &u8| c.is_ascii_digit() || letters.contains(c);
    let text = Some(text).filter(|text| text.iter().all(is_plain))?;
    std::str::from_utf8(text).ok()?.parse().ok()
}

/// The number with four digits after the point, for people who read the file.
pub(crate) fn short(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

/// A solid where its coordinates put it, without cuts.
pub(crate) fn object(name: String, shape: Shape, material: String) -> Object {
    Object {
        name,
        shape,
        processor: None,
        mode: Surface::Solid,
        material,
        place: vec![],
        cuts: vec![],
        group: None,
        visible: true,
        casts_shadow: true,
    }
}
