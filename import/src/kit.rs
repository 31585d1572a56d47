//! What all readers need.

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
pub(crate) fn material(name: String, colour: [f64; 3], light: [f64; 3], exponent: u32) -> Material {
    let [ambient, diffuse, specular] = light;
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
