//! Forty base pairs of a double helix in 480 spheres before a wall, under two point sources: 960 shadow volumes, or
//! none.

use super::sphere::sphere;
use std::fmt::Write;

const PAIRS: usize = 40;
/// Pairs of a turn.
const TURN: f64 = 10.0;
/// Length of the axis from pair to pair, the radius of the helix being 1.
const RISE: f64 = 0.34;
/// Angle between the strands in degrees: less than half a turn, which leaves a wide and a narrow groove.
const GROOVE: f64 = 150.0;
/// The sequence of one strand, repeated.
const SEQUENCE: &[u8] = b"ATGCCGTAGCATTACGGCAT";

const HEAD: &str = r#"# Written by `cargo run --release -p imogene-scene --example generate_scene -- dna`; change the generator, not this file.
# Forty base pairs of a double helix, twelve spheres each: phosphate and sugar of both strands, and four spheres for each base.
format = 1
title = "Double helix"
background = [0.05, 0.06, 0.1]
ambient = [0.5, 0.55, 0.65]
image = { width = 720, height = 540 }
lights = [
  { kind = "point", position = [-9, 8, 16], colour = [1.0, 0.95, 0.85], intensity = 0.75, shadows = true },
  { kind = "point", position = [11, 6, 14], colour = [0.6, 0.75, 1.0], intensity = 0.5, shadows = true },
]
materials = [
  { name = "phosphate", colour = [0.95, 0.55, 0.15], ambient = 0.3, specular = 0.5, exponent = 50 },
  { name = "sugar", colour = [0.75, 0.75, 0.78], ambient = 0.3, specular = 0.4, exponent = 50 },
  { name = "A", colour = [0.2, 0.6, 0.3], ambient = 0.3, specular = 0.4, exponent = 50 },
  { name = "T", colour = [0.8, 0.2, 0.25], ambient = 0.3, specular = 0.4, exponent = 50 },
  { name = "G", colour = [0.25, 0.4, 0.85], ambient = 0.3, specular = 0.4, exponent = 50 },
  { name = "C", colour = [0.9, 0.8, 0.25], ambient = 0.3, specular = 0.4, exponent = 50 },
  { name = "wall", colour = [0.55, 0.55, 0.6], ambient = 0.3, specular = 0.05 },
]
objects = [
  { name = "wall", kind = "elliptic_cylinder", radii = [14, 14], material = "wall", casts_shadow = false, place = [{ rotate = { axis = "x", degrees = 90 } }], cuts = [{ point = [0, -3, 0], normal = [0, 1, 0] }, { point = [0, -3.2, 0], normal = [0, -1, 0] }] },
"#;

const TAIL: &str = r#"]

[camera]
kind = "perspective"
eye = [1, 2, 21]
target = [0, -0.1, 0]
viewer_distance = 20
view_height = 9.6
"#;

/// The text of the scene file.
pub fn scene() -> String {
    after(HEAD)
}

/// The same without shadows.
pub fn without_shadows() -> String {
    let head = HEAD.replace(", shadows = true", "");
    after(&head.replace("generate_scene -- dna", "generate_scene -- molecule-480"))
}

fn after(head: &str) -> String {
    let mut text = head.to_owned();
    for pair in 0..PAIRS {
        let base = SEQUENCE[pair % SEQUENCE.len()];
        for (strand, letter) in [(0, base), (1, partner(base))] {
            push_strand(&mut text, pair, strand, letter);
        }
    }
    text + TAIL
}

fn partner(base: u8) -> u8 {
    match base {
        b'A' => b'T',
        b'T' => b'A',
        b'G' => b'C',
        _ => b'G',
    }
}

fn push_strand(text: &mut String, pair: usize, strand: usize, letter: u8) {
    let along = RISE * (pair as f64 - 0.5 * (PAIRS - 1) as f64);
    let turned = 360.0 * pair as f64 / TURN + GROOVE * strand as f64;
    let own = direction(turned);
    let middle = middle_of_pair(pair);
    let name = |part: &str| format!("{part} {}{}", pair + 1, ["a", "b"][strand]);
    let mut push = |part: &str, material: &str, radius, [y, z]: [f64; 2], shift: f64| {
        let place = placed([along + shift, y, z]);
        text.write_str(&sphere(&name(part), material, radius, place))
            .expect("a string takes all");
    };
    push("phosphate", "phosphate", 0.26, own, 0.5 * RISE);
    push("sugar", "sugar", 0.2, own.map(|v| 0.82 * v), 0.0);
    let material = char::from(letter).to_string();
    for part in 0..4 {
        // From the sugar to just before the middle of the pair.
        let share = 0.2 + 0.22 * f64::from(part);
        let at = [0, 1].map(|k| 0.82 * own[k] * (1.0 - share) + middle[k] * share);
        push(&format!("base {}", part + 1), &material, 0.155, at, 0.0);
    }
}

/// The middle between both sugars of a pair.
fn middle_of_pair(pair: usize) -> [f64; 2] {
    let turned = 360.0 * pair as f64 / TURN;
    let (a, b) = (direction(turned), direction(turned + GROOVE));
    [0, 1].map(|k| 0.41 * (a[k] + b[k]))
}

fn direction(degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [cos, sin]
}

/// The axis of the helix leans across the picture and a little towards the viewer.
fn placed([x, y, z]: [f64; 3]) -> [f64; 3] {
    let turn = |[u, v]: [f64; 2], degrees: f64| {
        let [cos, sin] = direction(degrees);
        [u * cos - v * sin, u * sin + v * cos]
    };
    let [x, z] = turn([x, z], -14.0);
    let [x, y] = turn([x, y], 24.0);
    [x, y, z]
}
