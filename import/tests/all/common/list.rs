//! Face lists, and what they are compiled to.

use imogene_import::faces::vector::Vector;
use imogene_import::faces::{Compilation, Compiled, FaceOptions, Part, Verdict, compile};
use std::path::Path;

/// What a list with the material `m` begins with.
pub const HEAD: &str =
    "format = 1\ntitle = \"t\"\n[[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n";

/// Each face by itself.
pub const EACH_FACE: FaceOptions = FaceOptions {
    max_deviation: None,
    no_volumes: true,
};

/// The part of a list, each face by itself.
pub fn part(text: &str, max_deviation: f64) -> Part {
    let mut options = EACH_FACE;
    options.max_deviation = Some(max_deviation);
    compile(text.as_bytes(), "test", &options).unwrap()
}

/// The faces of a solid, which is no volume.
pub fn faces(part: &Part, solid: usize) -> &[Compiled] {
    match &part.solids[solid] {
        Compilation::Faces(faces) => faces,
        Compilation::Volume(_) => panic!("volumes are switched off"),
    }
}

/// How far the border of a face that is drawn is off.
#[track_caller]
pub fn off(verdict: &Verdict) -> f64 {
    match verdict {
        Verdict::Exact => 0.0,
        Verdict::Approximated(off) => *off,
        Verdict::Rejected(reason) => panic!("{reason}"),
    }
}

/// A file of the repository.
pub fn file(path: &str) -> Vec<u8> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    std::fs::read(root.join(path)).expect(path)
}

/// The text of such a file.
pub fn text(path: &str) -> String {
    String::from_utf8(file(path)).expect(path)
}

pub fn line(name: &str, from: &str, to: &str) -> String {
    format!("[[edges]]\nname = \"{name}\"\nkind = \"line\"\nstart = \"{from}\"\nend = \"{to}\"\n")
}

/// A whole circle.
pub fn circle(name: &str, centre: Vector, axis: Vector, radius: f64) -> String {
    format!(
        "[[edges]]\nname = \"{name}\"\nkind = \"circle\"\ncentre = {centre:?}\naxis = {axis:?}\nradius = {radius:?}\n"
    )
}

/// The part of a circle between two vertices.
pub fn arc(circle: String, from: &str, to: &str) -> String {
    format!("{circle}start = \"{from}\"\nend = \"{to}\"\n")
}

pub fn face(name: &str, surface: &str, loops: &str) -> String {
    format!("[[faces]]\nname = \"{name}\"\nsurface = {{ {surface} }}\nloops = {loops}\n")
}

/// The only solid, of faces whose names are given with their quotes.
pub fn solid(faces: &str) -> String {
    format!("[[solids]]\nname = \"s\"\nmaterial = \"m\"\nfaces = [{faces}]\n")
}
