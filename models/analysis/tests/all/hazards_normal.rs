//! The normal's sign on the near and far face: the source's `+- sqrt(K^2 f2)` loses the sign of K.

use imogene_analysis::bounds::normal_bound;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::QuadricWords;
use imogene_golden::unit::normal::select;
use imogene_golden::unit::root::fast_root;
use imogene_scene::{FramedScene, Surface};
use imogene_testkit::*;

const F: Format = Format::BASE;

/// True gradient at the point of the camera frame that pixel (x, y) shows at a depth word.
fn true_normal(scene: &FramedScene, x: i64, y: i64, depth: i64) -> [f64; 3] {
    let full = 1000.0 / F.z_max() as f64;
    let centre = scene.pixel_centre(x as usize, y as usize);
    let point = scene.projection.antecedent(centre, depth as f64 * full);
    gradient(&framed(scene).quadric, point)
}

/// The normal with the factors' signs lost, as printed.
fn naive(words: &QuadricWords, x: i64, y: i64, number: u8) -> [i16; 3] {
    let mut printed = words.normal;
    printed.k = printed
        .k
        .map(|k| k.checked_abs().expect("scaled to 15 bits and a sign"));
    let bits = F.normal_linear;
    let g = printed.g.map(|g| g.wrapped_at(x, y, bits) as i64);
    let root = fast_root(words.f2.wrapped_at(x, y, F.quadratic) as i64);
    select(number, true, g, root, &printed, &[], &F)
}

fn off_axis_ball(planes: &[[i64; 4]]) -> FramedScene {
    let ball = sphere([150, -120, 300], 100);
    scene(vec![object("ball", Surface::Patch, ball, planes)])
}

#[test]
fn factors_of_either_sign_give_the_true_gradient_on_both_faces() {
    // Whole ball: near faces. Front half cut away: far faces.
    for (planes, number) in [(vec![], 0), (vec![[0, 0, -1, 300]], 1)] {
        let scene = off_axis_ball(&planes);
        let prepared = prepare(&scene);
        let object = first(&prepared);
        let words = &object.words;
        let k = words.normal.k;
        assert!(k.iter().any(|&k| k < 0), "{k:?}");
        assert!(words.normal.k.iter().any(|&k| k > 0));
        let (mut worst, mut worst_naive, mut seen) = (0.0f64, 0.0f64, 0);
        for y in (0..i64::from(HEIGHT)).step_by(3) {
            for x in (0..i64::from(WIDTH)).step_by(3) {
                let Some(pixel) = golden_at(words, x, y).filter(|p| p.number == number) else {
                    continue;
                };
                let f2 = words.f2.wrapped_at(x, y, F.quadratic) as i64;
                // Near the silhouette the computed depth is off; the bound of the normal covers the true point.
                if f2 < 1 << 36 {
                    continue;
                }
                let truth = true_normal(&scene, x, y, pixel.zf);
                let off = angle_deg(pixel.normal.map(f64::from), truth);
                let bound = normal_bound(object, number, f2, pixel.normal);
                let most = bound + 1e-3;
                assert!(off <= most, "({x}, {y}): {off} beyond {bound}");
                let printed = angle_deg(naive(words, x, y, number).map(f64::from), truth);
                worst_naive = worst_naive.max(printed);
                worst = worst.max(off);
                seen += 1;
            }
        }
        println!(
            "face {number}: worst {worst:.4} degrees, as printed {worst_naive:.1} degrees, {seen} pixels"
        );
        assert!(seen > 100 && worst < 0.05);
        assert!(worst_naive > 5.0);
    }
}
