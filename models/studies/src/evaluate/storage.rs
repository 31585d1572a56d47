//! Numbers to keep and to send (source: 4.1.3, chapter 5; Chaillou, IV.2, IV.5.4).

use super::EvaluateError;
use super::row::{Group, Row};
use super::scenes::{Moving, OBJECT_SIDE, ZONE_SIDE};
use crate::compare::fair_sides;
use crate::compare::tessellate::to_mesh;
use imogene_algebra::rational::from_decimal;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ID_BITS;
use imogene_golden::object::load::{FIRST_PLANE, LoadWord, PLANE_WORDS, load_words};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::SOURCES;
use imogene_scene::{Mesh, Object, Plane, Quadric, SceneFile, Shape};
use serde::Serialize;
use serde_json::Value;

const SCENE: &str = include_str!("../../../../scenes/comparison/three-solids.toml");

/// Numbers in a structure, wherever they stand in it, but for its screen box, which the source's machines do not have.
pub fn numbers(of: &impl Serialize) -> f64 {
    fn leaves(value: &Value) -> usize {
        match value {
            Value::Number(_) => 1,
            Value::Array(list) => list.iter().map(leaves).sum(),
            Value::Object(map) => {
                let kept = map.iter().filter(|(key, _)| *key != "screen_box");
                kept.map(|(_, value)| leaves(value)).sum()
            }
            _ => 0,
        }
    }
    let value = serde_json::to_value(of).expect("words of processors fit 64 bits");
    leaves(&value) as f64
}

/// Reals of a facet with its normals, unshared, and of a whole mesh with shared corners.
fn reals(mesh: &Mesh) -> [f64; 2] {
    let corner = (mesh.vertices[0].len() + mesh.normals[0].len()) as f64;
    [3.0 * corner, mesh.vertices.len() as f64 * corner]
}

/// Reals of a quadric with so many planes.
fn quadric_reals(planes: usize) -> f64 {
    let zero = from_decimal(0.0);
    let quadric = Quadric::from_array(std::array::from_fn(|_| zero.clone()));
    let plane = Plane {
        a: zero.clone(),
        b: zero.clone(),
        c: zero.clone(),
        d: zero,
    };
    (quadric.coefficients().len() + planes * plane.coefficients().len()) as f64
}

fn mesh_of(object: &Object, sides: usize) -> Mesh {
    let mut object = object.clone();
    to_mesh(&mut object, sides);
    match object.shape {
        Shape::Mesh(mesh) => mesh,
        _ => unreachable!("to_mesh makes a mesh"),
    }
}

/// Facets of a ball of 80 pixels whose sides are within half a pixel of its outline: around, and those that face the viewer.
pub fn fair_ball() -> Result<[f64; 2], EvaluateError> {
    let scene = SceneFile::parse(SCENE, "three-solids.toml")?;
    let ball = scene
        .objects
        .iter()
        .find(|object| matches!(object.shape, Shape::Sphere { .. }));
    let sides = fair_sides(f64::from(OBJECT_SIDE) / 2.0);
    let mesh = mesh_of(ball.expect("the scene has a ball"), sides);
    // Seen along z, a facet faces the viewer if the normals of its corners do so on the whole.
    let is_seen = |face: &&Vec<usize>| {
        face.iter()
            .map(|&corner| mesh.normals[corner][2])
            .sum::<f64>()
            > 0.0
    };
    Ok([
        sides as f64,
        mesh.faces.iter().filter(is_seen).count() as f64,
    ])
}

/// Mean of the reals of a mesh with 20 sides over those of the quadric.
fn file_ratio() -> Result<[f64; 2], EvaluateError> {
    let scene = SceneFile::parse(SCENE, "three-solids.toml")?;
    let meshes: Vec<(Mesh, usize)> = scene
        .objects
        .iter()
        .map(|object| (mesh_of(object, 20), object.cuts.len()))
        .collect();
    let mean = meshes
        .iter()
        .map(|(mesh, cuts)| reals(mesh)[1] / quadric_reals(*cuts));
    Ok([
        mean.sum::<f64>() / meshes.len() as f64,
        reals(&meshes[0].0)[0],
    ])
}

/// Bits of load words, without those that a patch processor does not read: the constant normals of planes.
pub fn patch_bits(words: &[LoadWord]) -> f64 {
    let is_read = |word: &&LoadWord| {
        word.address < FIRST_PLANE || (word.address - FIRST_PLANE) % PLANE_WORDS < 4
    };
    words
        .iter()
        .filter(is_read)
        .map(|w| f64::from(w.width))
        .sum()
}

/// Bits of a facet's words.
fn facet_bits(words: &ProcessorWords, format: &Format) -> Option<f64> {
    let ProcessorWords::Facet(facet) = words else {
        return None;
    };
    let plane = numbers(&facet.edges) + numbers(&facet.depth);
    Some(plane * f64::from(format.plane) + numbers(&facet.normal) * f64::from(format.normal_linear))
}

fn words_of(others: &[ProcessorWords], is_wanted: impl Fn(&ProcessorWords) -> Option<f64>) -> f64 {
    others
        .iter()
        .find_map(is_wanted)
        .expect("the scenes have one")
}

/// What is kept and sent.
///
/// # Errors
///
/// When a scene that is compiled in is refused: a defect.
pub fn group(patch: &Moving, others: &[ProcessorWords]) -> Result<Group, EvaluateError> {
    let format = Format::BASE;
    let [ratio, facet] = file_ratio()?;
    let three = quadric_reals(3);
    let facet_words = words_of(others, |w| match w {
        ProcessorWords::Facet(f) if f.edges.len() == 3 => Some(numbers(f)),
        _ => None,
    });
    let facet_bits = words_of(others, |w| match w {
        ProcessorWords::Facet(f) if f.edges.len() == 3 => facet_bits(w, &format),
        _ => None,
    });
    let sphere = words_of(others, |w| match w {
        ProcessorWords::Sphere(s) => Some(numbers(s)),
        _ => None,
    });
    let cylinder = words_of(others, |w| match w {
        ProcessorWords::Cylinder(c) => Some(numbers(c)),
        _ => None,
    });
    let load = load_words(patch.words(), &format, 4);
    let bits = patch_bits(&load);
    let quadric = load_words(patch.words(), &format, 0);
    let depth_words = quadric.iter().take(9).count() as f64;
    let pixel = f64::from(format.depth + ID_BITS + 3 * format.normal) + f64::from(SOURCES);
    let zone = f64::from(ZONE_SIDE * ZONE_SIDE) * pixel / 8.0;
    let no_box = "no box in space: the screen box comes from the tangents of the outline, or from a search with the planes";
    Ok(Group {
        name: "storage",
        title: "Storage and words to send",
        about: "Numbers are counted in the structures themselves: coefficients of the scene, words of the processors, bits of the load bus (screen boxes, which the source does not have, left out of the words)."
            .into(),
        rows: vec![
            Row::new("facet of three corners", "chapter 5", 18.0, facet, "reals").why("place and normal of each corner"),
            Row::new("quadric with three planes", "chapter 5", 46.0, three, "reals").why(format!("10 and 4 for each plane, as there; the other 24 are a box: {no_box}")),
            Row::new("three facets", "chapter 5", 54.0, 3.0 * facet, "reals").why("the source finds that a quadric takes less than three facets; here it takes less than two"),
            Row::new("file of facets over one of quadrics, 20 facets each", "chapter 5", 5.0, ratio, "times")
                .why("mean of two cylinders and a ball with 20 sides each, as meshes with shared corners and normals, of which the ball has 200 facets; the source quotes another author's 20 facets each"),
            Row::new("facet, words to send", "chapter 5; Chaillou, IV.2.2", 21.0, facet_words, "words").why("seven expressions of first degree"),
            Row::new("facet, bits", "chapter 5", 504.0, facet_bits, "bits")
                .why("sides and depth have 36 bits, so that no plane leaves its word on any screen; the source has 24"),
            Row::new("patch, bits", "chapter 5", 936.0, bits, "bits")
                .why("as many expressions; depth and planes are wider for the same reason, and screen box, class and kinds of planes are sent too"),
            Row::new("patch, words of 24 bits", "chapter 5", 39.0, bits / 24.0, "words").why("the same in the source's unit"),
            Row::new("seven facets over a patch, bits", "chapter 5", 3.0, 7.0 * facet_bits / bits, "times")
                .corrected(7.0 * 504.0 / 936.0)
                .why("147 words over 39 is 3.77"),
            Row::new("sphere by a paraboloid, words", "Chaillou, IV.5.4", 24.0, sphere, "words")
                .why("one more, the sum of front and back depth, gives the back depth, for which the source would send 30"),
            Row::new("cylinder by paraboloids, words", "Chaillou, IV.2.5", 54.0, cylinder, "words").why("15 PE1 words, 36 PE2 words, the constant normal of the disc"),
            Row::new("quadric, words of its depth", "Chaillou, IV.1.8", 9.0, depth_words, "words").why("three of first and six of second degree"),
            Row::new("z-buffer, one pixel", "4.1.3", 24.0, pixel / 8.0, "bytes")
                .corrected(14.0)
                .why(format!("the print's fields are 112 bits; ours are a depth of {}, an id of {ID_BITS}, a normal of 3 x {} and {SOURCES} flags", format.depth, format.normal)),
            Row::new("z-buffer of the machine", "4.1.3", "nothing", zone, "bytes")
                .corrected(720.0 * 540.0 * 14.0)
                .why("a zone of 128 x 128 pixels is kept; the source keeps a screen of 720 x 540 pixels of 14 bytes"),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_golden::unit::pe2::Quadratic;

    #[test]
    fn numbers_of_nested_structures() {
        assert_eq!(numbers(&Quadratic::default()), 6.0);
        assert_eq!(
            numbers(
                &serde_json::json!({ "a": [1, [2, 3]], "screen_box": { "x": 1 }, "kind": "none" })
            ),
            3.0
        );
    }

    #[test]
    fn half_of_a_ball_is_seen() {
        // 20 sides and ten bands: 200 facets.
        assert_eq!(fair_ball().unwrap(), [20.0, 100.0]);
    }
}
