//! One prepared scene: the golden picture against the truth, beside the bounds that were proven before.

use super::truth::{DEPTH_BITS, TruePixel, Truth};
use imogene_algebra::rational::{from_f64_exact, power_of_two, to_f64};
use imogene_algebra::vector::{cross, dot, length};
use imogene_analysis::bounds::{check, depth_bound, normal_bound, undecided_pixels};
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::forms::QuadraticForm;
use imogene_prepare::{NeededWidths, PreparedQuadric, PreparedScene};
use imogene_scene::FramedScene;
use num_rational::BigRational;
use num_traits::Signed;
use rayon::prelude::*;
use serde::Serialize;

/// What the exact depth itself can be off, in depth words: it is cut after its fraction bits.
const CUT: f64 = 4.0 / (1u64 << DEPTH_BITS) as f64;
/// Allowance for the angle of two vectors in floating point, in degrees.
const ANGLE_MARGIN: f64 = 1e-9;

/// What is proven of a picture before it is drawn; the keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Bounds {
    /// Greatest depth error at any pixel, in depth words.
    pub depth_words: f64,
    /// The same in pixels of projected depth.
    pub depth_px: f64,
    /// Greatest displacement of a silhouette, in pixels.
    pub silhouette_px: f64,
    /// Greatest angle of a normal whose direction the words determine, in degrees.
    pub normal_deg: f64,
}

/// What is found at the pixels; the keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Observed {
    /// Pixels at which both pictures show the same face: those of depth and normal.
    pub compared: usize,
    /// Greatest depth error, in depth words.
    pub depth_words: f64,
    /// The same in pixels of projected depth.
    pub depth_px: f64,
    /// Greatest displacement of a silhouette along the slope of f2, in pixels; none where no silhouette crosses a line
    /// or column of its screen box, or where one has no direction.
    pub silhouette_px: Option<f64>,
    /// Pixels that are covered in one picture alone.
    pub silhouette_pixels: usize,
    /// Pixels that show another object or face.
    pub wrong_faces: usize,
    /// Pixels among them whose normal the words determine.
    pub normals: usize,
    /// Greatest angle of these normals, in degrees.
    pub normal_deg: f64,
}

/// Greatest error at any pixel in parts of the bound *at that pixel*; the keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Ratios {
    /// Depth.
    pub depth: f64,
    /// Silhouette, in parts of the bound of the object.
    pub silhouette: f64,
    /// Normal.
    pub normal: f64,
}

/// All figures of a step; the keys are stable.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Figures {
    /// Depth word.
    pub depth_word: u32,
    /// Guard bits of f1 and f2.
    pub guards: [u32; 2],
    /// Depth words to the pixel.
    pub words_per_pixel: f64,
    /// Bits that the accumulators need.
    pub needed: NeededWidths,
    /// Pixels at which the golden picture shows an object.
    pub covered: usize,
    /// Pixels that were announced as undecided.
    pub undecided: usize,
    /// Pixels whose normal the words do not determine.
    pub normals_undetermined: usize,
    /// What was proven.
    pub bounds: Bounds,
    /// What was found.
    pub observed: Observed,
    /// One over the other.
    pub ratios: Ratios,
    /// Why `imogene check` fails, if it does.
    pub check_failed: Option<String>,
    /// What the preparation and the check tell a person, with the name of the object.
    pub problems: Vec<String>,
    /// Everything that breaks a rule; empty if all holds.
    pub violations: Vec<String>,
}

/// Measures a scene; `prepared` must come from `scene`.
pub fn measure(scene: &FramedScene, prepared: &PreparedScene) -> Figures {
    let report = check(scene, prepared);
    let words_per_pixel = to_f64(&prepared.depth_scale);
    let mut problems = vec![];
    for object in &report.objects {
        let named = |problem| format!("{}: {problem}", object.name);
        problems.extend(object.problems.iter().map(named));
    }
    let mut figures = Figures {
        depth_word: prepared.format.depth,
        guards: [prepared.format.guard_linear, prepared.format.guard_quadratic],
        words_per_pixel,
        needed: report.widths.needed.clone(),
        undecided: report.undecided_pixels,
        normals_undetermined: report.bounds.normals_undetermined,
        bounds: Bounds {
            depth_words: report.bounds.depth_lsb,
            depth_px: report.bounds.depth_lsb / words_per_pixel,
            silhouette_px: report.bounds.silhouette_px,
            normal_deg: report.bounds.normal_deg,
        },
        check_failed: (!report.ok).then(|| {
            format!(
                "check fails: a silhouette may be displaced by {:.2} pixels, that is a pixel or more",
                report.bounds.silhouette_px
            )
        }),
        problems,
        ..Figures::default()
    };
    compare_pixels(&mut figures, scene, prepared);
    for (object, (_, words)) in report.objects.iter().zip(prepared.quadrics()) {
        let bounds = &object.quadric().expect("a quadric").bounds;
        if bounds.silhouette_singular {
            figures.observed.silhouette_px = None;
            break;
        }
        if let Some(off) = displaced(words, &prepared.format) {
            let most = figures.observed.silhouette_px.unwrap_or(0.0);
            figures.observed.silhouette_px = Some(most.max(off));
            let (ratio, bound) = (&mut figures.ratios.silhouette, bounds.silhouette_px);
            hold(ratio, &mut figures.violations, [off, bound, 0.0], || {
                format!(
                    "the silhouette of '{}' is displaced by {off:.3e} pixels, proven were {bound:.3e}",
                    words.name
                )
            });
        }
    }
    figures
}

/// Holds an error, known to `spare`, against its bound: a violation if it is greater, else its part of the bound.
fn hold(
    ratio: &mut f64,
    violations: &mut Vec<String>,
    [off, bound, spare]: [f64; 3],
    violation: impl FnOnce() -> String,
) {
    if off > bound + spare {
        violations.push(violation());
    }
    if bound > 0.0 {
        *ratio = ratio.max(off / bound);
    }
}

fn compare_pixels(figures: &mut Figures, scene: &FramedScene, prepared: &PreparedScene) {
    let (width, height) = (prepared.width as usize, prepared.height as usize);
    let golden = prepared.frame(|| ());
    let undecided = undecided_pixels(scene, prepared);
    let truth = Truth::new(scene, prepared.format.z_max());
    let at = |index: usize| truth.at((index % width) as i64, (index / width) as i64);
    let exact: Vec<Option<TruePixel>> = (0..width * height).into_par_iter().map(at).collect();
    figures.covered = golden.covered();
    for (index, exact) in exact.iter().enumerate() {
        let (id, number) = (golden.id[index], golden.number[index]);
        match exact {
            None if id < 0 => continue,
            Some(exact) if (id, number) == (exact.id as i32, exact.number) => {
                compare_faces(figures, prepared, &golden, index, exact);
                continue;
            }
            Some(_) if id >= 0 => figures.observed.wrong_faces += 1,
            _ => figures.observed.silhouette_pixels += 1,
        }
        if !undecided[index] {
            let (x, y) = (index % width, index / width);
            figures.violations.push(format!(
                "pixel ({x}, {y}) shows another face than the truth and was not announced as undecided"
            ));
        }
    }
    figures.observed.depth_px = figures.observed.depth_words / figures.words_per_pixel;
}

fn compare_faces(
    figures: &mut Figures,
    prepared: &PreparedScene,
    golden: &Frame,
    index: usize,
    exact: &TruePixel,
) {
    let (observed, ratios) = (&mut figures.observed, &mut figures.ratios);
    let violations = &mut figures.violations;
    observed.compared += 1;
    let [x, y] = [index % golden.width, index / golden.width].map(|v| v as i64);
    let object = prepared.objects[exact.id].quadric().expect("a quadric");
    let f2 = object.words.f2_at(x, y, &prepared.format);
    let off = (i128::from(golden.depth[index]) << DEPTH_BITS) - exact.depth;
    let off = off.unsigned_abs() as f64 / (1u64 << DEPTH_BITS) as f64;
    let bound = depth_bound(object, exact.number, f2);
    observed.depth_words = observed.depth_words.max(off);
    // Without what the exact depth itself can be off.
    let certain = (off - CUT).max(0.0);
    hold(&mut ratios.depth, violations, [certain, bound, 0.0], || {
        format!("depth off by {off:.3} words at pixel ({x}, {y}), proven were {bound:.3}")
    });
    let normal = golden.normal[index];
    let bound = normal_bound(object, exact.number, f2, normal);
    if bound >= 180.0 {
        return;
    }
    let drawn = normal.map(f64::from);
    let sine = length(cross(drawn, exact.normal));
    let angle = sine.atan2(dot(drawn, exact.normal)).to_degrees();
    observed.normals += 1;
    observed.normal_deg = observed.normal_deg.max(angle);
    let held = [angle, bound, ANGLE_MARGIN];
    hold(&mut ratios.normal, violations, held, || {
        format!("normal off by {angle:.4} degrees at pixel ({x}, {y}), proven were {bound:.4}")
    });
}

/// How far the computed contour is from the true one, to first order: `|q2 - f2|` over the length of the gradient of
/// q2, at every point in which it crosses a line or a column of the screen box and that the planes keep. The numerator
/// is exact; the bound of the check divides the greatest such difference by the least gradient.
fn displaced(object: &PreparedQuadric, format: &Format) -> Option<f64> {
    let window = object.words.screen_box;
    if window.is_empty() {
        return None;
    }
    let unit = power_of_two(format.guard_quadratic);
    let residual = QuadraticForm::of_words(&object.words.f2).minus(&object.exact.f2.scaled(&unit));
    let lines = (window.y0..=window.y1).flat_map(|y| crossings(object, y, false));
    let columns = (window.x0..=window.x1).flat_map(|x| crossings(object, x, true));
    let off = |(at, slope): Crossing| {
        let [x, y] = at.map(from_f64_exact);
        let off = to_f64(&residual.at(&x, &y)).abs();
        is_kept(object, &x, &y).then(|| off / slope)
    };
    lines.chain(columns).filter_map(off).reduce(f64::max)
}

/// A point of the computed contour, with the length of the gradient there.
type Crossing = ([f64; 2], f64);

/// Where the computed contour crosses a line of the screen box, or a column of it.
fn crossings(object: &PreparedQuadric, number: i64, is_column: bool) -> Vec<Crossing> {
    /// What belongs to columns and to lines as what is along and across, or the other way round.
    fn turned<T>([first, second]: [T; 2], is_column: bool) -> [T; 2] {
        if is_column {
            [second, first]
        } else {
            [first, second]
        }
    }
    let window = object.words.screen_box;
    let sides = [[window.x0, window.x1], [window.y0, window.y1]];
    let [[first, last], _] = turned(sides, is_column);
    // About the middle, so that no digits are lost.
    let middle = (first + last) / 2;
    let [x, y] = turned([middle, number], is_column);
    let q = object.words.f2.from_zone(x, y);
    let [square, _] = turned([q.a, q.b], is_column);
    let [linear, across] = turned([q.d, q.e], is_column);
    let [a, b, c, across, mixed] = [square, linear, q.f, across, q.c].map(|v| v as f64);
    let root = (b * b - 4.0 * a * c).sqrt();
    // The root that does not cancel, and the other from the product of both.
    let steady = -0.5 * (b + root.copysign(b));
    let found = [steady / a, c / steady].map(|u| {
        let at = turned([middle as f64 + u, number as f64], is_column);
        (at, (2.0 * a * u + b).hypot(mixed * u + across))
    });
    let crossed = |(at, slope): &Crossing| {
        let mut places = sides.iter().zip(at);
        *slope > 0.0 && places.all(|(side, at)| (side[0] as f64..=side[1] as f64).contains(at))
    };
    found.into_iter().filter(crossed).collect()
}

fn is_kept(object: &PreparedQuadric, x: &BigRational, y: &BigRational) -> bool {
    let depth = object.exact.f1.at(x, y);
    let has_depth = !matches!(object.words.class, Class::Front | Class::Prism);
    let mut planes = object.words.planes.iter().zip(&object.exact.planes);
    planes.all(|(words, exact)| {
        let value = exact.at(x, y);
        match words.kind {
            PlaneKind::Perpendicular => !value.is_negative(),
            PlaneKind::Front if has_depth => depth >= value,
            PlaneKind::Back if has_depth => depth <= value,
            _ => true,
        }
    })
}
