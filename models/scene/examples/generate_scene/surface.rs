//! Four thousand spheres on a rippled surface under one source with shadows, one volume each.

use super::sphere::sphere;
use std::fmt::Write;

const COLUMNS: usize = 80;
const ROWS: usize = 50;
/// Distance of neighbours.
const STEP: f64 = 0.2;
const RADIUS: f64 = 0.115;
/// Materials from valley to crest.
const SHADES: usize = 8;

const HEAD: &str = r#"# Written by `cargo run --release -p imogene-scene --example generate_scene -- sphere-surface`; change the generator, not this file.
# Four thousand spheres on the surface y = 0.9 cos(2.1 r) exp(-r / 5) about a point beside the middle.
format = 1
title = "Surface of 4000 spheres"
background = [0.06, 0.07, 0.11]
ambient = [0.6, 0.65, 0.75]
image = { width = 720, height = 540 }
lights = [
  { kind = "directional", from = [-6, 4, -1.5], colour = [1.0, 0.93, 0.8], intensity = 0.95, shadows = true },
  { kind = "directional", from = [3, 6, 8], colour = [0.5, 0.65, 1.0], intensity = 0.25 },
]
materials = [
"#;

const TAIL: &str = r#"]

[camera]
kind = "perspective"
eye = [5, 9, 14]
target = [0.3, -0.6, 0.2]
viewer_distance = 17
view_height = 10.8
"#;

/// The text of the scene file.
pub fn scene() -> String {
    let mut text = HEAD.to_owned();
    for shade in 0..SHADES {
        let [r, g, b] = colour(shade);
        writeln!(
            text,
            "  {{ name = \"{shade}\", colour = [{r:.3}, {g:.3}, {b:.3}], ambient = 0.3, specular = 0.35, exponent = 40 }},"
        )
        .expect("a string takes all");
    }
    text += "]\nobjects = [\n";
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let x = STEP * (column as f64 - 0.5 * (COLUMNS - 1) as f64);
            let z = STEP * (row as f64 - 0.5 * (ROWS - 1) as f64);
            let y = height(x, z);
            let share = ((y + 0.6) / 1.3).clamp(0.0, 0.999);
            let shade = (share * SHADES as f64) as usize;
            let name = (row * COLUMNS + column + 1).to_string();
            text += &sphere(&name, &shade.to_string(), RADIUS, [x, y, z]);
        }
    }
    text + TAIL
}

fn height(x: f64, z: f64) -> f64 {
    let r = (x + 1.5).hypot(z - 0.8);
    0.9 * (2.1 * r).cos() * (-r / 5.0).exp()
}

/// From deep blue over green to sand.
fn colour(shade: usize) -> [f64; 3] {
    const STOPS: [[f64; 3]; 3] = [[0.1, 0.25, 0.6], [0.15, 0.65, 0.5], [0.95, 0.75, 0.35]];
    let at = 2.0 * shade as f64 / (SHADES - 1) as f64;
    let first = (at as usize).min(1);
    let share = at - first as f64;
    [0, 1, 2].map(|k| STOPS[first][k] * (1.0 - share) + STOPS[first + 1][k] * share)
}
