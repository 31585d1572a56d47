//! One scene in every depth word and with guard bits.

use crate::sweep::grid::{BESIDE, cut, perspective, scene, solid};
use crate::sweep::{Axis, Step, Sweep};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_scene::{Axis as Turn, Rotation, SceneFile, Shape, Step as Place};

/// Guard bits of f1 and f2.
const GUARDS: [(u32, u32); 4] = [(0, 0), (2, 4), (4, 8), (8, 16)];

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "word-length",
    title: "Depth word and guard bits",
    about: "A cut ball pierced by a rod, in every depth word from 12 to 32 bits and with four choices of guard bits. Errors in words do not depend on the word, so that each bit halves the depth \
            error in pixels and quarters the displacement of the silhouette; guard bits take away what the coefficients lose, down to the floors of root and depth, and then the cut planes, which have none, are the \
            worst faces. Normals have words of their own and stop improving at their 16 bits. Formats whose accumulators would be wider than 64 bits are refused.",
    axis: Axis::linear("depth word (bits)"),
    series: &[
        "no guard bits",
        "guard bits 2:4",
        "guard bits 4:8",
        "guard bits 8:16",
    ],
    has_own_formats: true,
    steps: all,
};

fn all(_format: Format) -> Vec<Step> {
    let of = |series: usize| {
        (12..=32).map(move |depth| Step {
            series,
            parameter: depth.to_string(),
            scene: pierced_ball(),
            format: format(depth, GUARDS[series]),
            with_naive: false,
        })
    };
    (0..GUARDS.len()).flat_map(of).collect()
}

fn format(depth: u32, (guard_linear, guard_quadratic): (u32, u32)) -> Result<Format, String> {
    let widths = MachineWords {
        depth,
        root: depth,
        plane: depth + 12,
        normal: 16,
        guard_linear,
        guard_quadratic,
        dropped_rows: 0,
    };
    Format::fitted(&widths).map_err(|error| error.to_string())
}

fn pierced_ball() -> SceneFile {
    let mut ball = solid(
        "ball",
        Shape::Sphere { radius: 24.0 },
        vec![cut([6.0, 0.0, 12.0], [0.5, 0.25, 1.0])],
    );
    ball.place = vec![Place::Translate(BESIDE)];
    let ends =
        [-40.0, 0.0].map(|y: f64| cut([0.0, y, 0.0], [0.0, if y < 0.0 { -1.0 } else { 1.0 }, 0.0]));
    let mut rod = solid(
        "rod",
        Shape::EllipticCylinder { radii: [7.0, 5.0] },
        ends.to_vec(),
    );
    let turn = Rotation {
        axis: Turn::Z,
        degrees: 60.0,
    };
    rod.place = vec![Place::Rotate(turn), Place::Translate([-30.0, 20.0, 8.0])];
    scene("pierced ball", perspective(200.0), vec![ball, rod])
}
