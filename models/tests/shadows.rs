//! Shadows and spots of the golden machine against exact rays to the light.
//!
//! Where the rounding of the words and the margin cannot change an answer, golden and exact flags are equal; that is decided in whole numbers, from
//! the proven bounds of the words and the distance of the two visible depths. Everywhere else they may differ, and it is counted how often
//! they do.

mod common;

use common::*;
use imogene_models::exact;
use imogene_models::exact::render::{DEPTH_FRACTION, ExactPixel};
use imogene_models::format::Format;
use imogene_models::machine::beam;
use imogene_models::machine::frame::Frame;
use imogene_models::machine::lighting::Lighting;
use imogene_models::object::volume::VolumeKind;
use imogene_models::prepare::PreparedScene;
use imogene_models::prepare::volume::{Beginning, PreparedVolume};
use imogene_models::rational::{from_f64_exact, integer, power_of_two};
use imogene_models::scene::{
    FramedQuadric, FramedScene, FramedSource, Projection, SceneFile, SpotCone, Surface,
};
use imogene_models::unit::cut_plane::PlaneKind;
use imogene_models::unit::interval::{Class, FACE_NEAR_END, FACE_PLANE};
use num_traits::ToPrimitive;

const F: Format = Format::BASE;
const UNIT: i128 = 1 << DEPTH_FRACTION;

/// Whether a point is in a volume, for every value that the words may stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    In,
    Out,
    Unknown,
}

fn state(inside: bool, outside: bool) -> State {
    match (inside, outside) {
        (true, _) => State::In,
        (_, true) => State::Out,
        _ => State::Unknown,
    }
}

/// A bound in fractions of a count, upwards.
fn fractions(bound: f64) -> i128 {
    let scaled = from_f64_exact(bound) * power_of_two(DEPTH_FRACTION);
    scaled.ceil().to_integer().to_i128().expect("a small bound")
}

/// All depths at which golden and exact membership ask, in fractions of a count: golden and exact depth, the margin, and the counts that roots and
/// coarse units are rounded by.
fn depths(volume: &PreparedVolume, golden: i64, exact: i64) -> (i128, i128) {
    let words = &volume.words;
    let coarse = 2i128 << words.quadric.map_or(0, |q| q.shift);
    let entered = i128::from(golden) - i128::from(words.margin);
    (
        i128::from(exact).min((entered - coarse) * UNIT),
        (i128::from(exact) + 1).max((i128::from(golden) + coarse) * UNIT),
    )
}

fn quadric_state(volume: &PreparedVolume, x: i64, y: i64, (low, high): (i128, i128)) -> State {
    let Some(q) = &volume.words.quadric else {
        return State::In;
    };
    let value = |v: num_bigint::BigInt| v.to_i128().expect("fits its word");
    let unit = UNIT << q.shift;
    let middle = value(q.f1.exact_at(x, y)) * unit;
    let middle_error = fractions(volume.bounds.f1) << q.shift;
    // f2 in squares of fractions.
    let f2 = value(q.f2.exact_at(x, y)) * unit * unit;
    let f2_error = (fractions(volume.bounds.f2) << (2 * q.shift)) * UNIT;
    let (f2_low, f2_high) = (f2 - f2_error, f2 + f2_error);
    let (near, far) = (low - middle - middle_error, high - middle + middle_error);
    let least = if near <= 0 && far >= 0 {
        0
    } else {
        near.abs().min(far.abs())
    };
    let most = near.abs().max(far.abs());
    match q.class {
        Class::Side => state(most * most <= f2_low, least * least > f2_high),
        Class::Front => state(least * least >= f2_high, most * most < f2_low),
        Class::Prism => state(f2_low >= 0, f2_high < 0),
        Class::Patch => panic!("a volume is no patch"),
    }
}

fn plane_state(
    volume: &PreparedVolume,
    index: usize,
    x: i64,
    y: i64,
    (low, high): (i128, i128),
) -> State {
    let plane = &volume.words.planes[index];
    let margin = i128::from(volume.words.margin) * UNIT;
    let error = fractions(volume.bounds.planes[index]) + margin + UNIT;
    let depth = plane.depth.exact_at(x, y).to_i128().expect("fits its word") * UNIT;
    match plane.kind {
        PlaneKind::None => State::In,
        PlaneKind::Front => state(depth + error <= low, depth - error > high),
        PlaneKind::Back => state(high <= depth - error, low > depth + error),
        PlaneKind::Perpendicular => state(depth - error >= 0, depth + error < 0),
    }
}

/// At its own beginning a shadow is open, and the margin is proven to keep it so: a cut face that faces the light is outside the volume that begins
/// at it, one that faces away is at the volume's end, inside.
fn begins_at_face(
    volume: &PreparedVolume,
    face: (usize, u8),
    framed: &FramedScene,
) -> Option<State> {
    let (object, Beginning::Cut(cut)) = volume.caster? else {
        return None;
    };
    if face != (object, FACE_PLANE + cut as u8) {
        return None;
    }
    let [x, y, z, w] = &framed.sources[usize::from(volume.words.source)].point;
    let p = &framed.objects[object].caster()?.planes[cut];
    let side = &p.a * x + &p.b * y + &p.c * z + &p.d * w;
    Some(if side > integer(0) {
        State::Out
    } else {
        State::In
    })
}

fn volume_state(
    framed: &FramedScene,
    volume: &PreparedVolume,
    x: i64,
    y: i64,
    golden: i64,
    exact: &ExactPixel,
) -> State {
    if !volume.words.screen_box.contains(x, y) {
        return State::Out;
    }
    let depths = depths(volume, golden, exact.depth);
    let planes = 0..volume.words.planes.len();
    let mut parts = vec![quadric_state(volume, x, y, depths)];
    parts.extend(planes.map(|index| plane_state(volume, index, x, y, depths)));
    if let Some(known) = begins_at_face(volume, (exact.id as usize, exact.number), framed) {
        parts[1] = known;
    }
    if parts.contains(&State::Out) {
        State::Out
    } else if parts.contains(&State::Unknown) {
        State::Unknown
    } else {
        State::In
    }
}

/// Does the source reach the point; nothing if the words leave that open.
fn decided(
    framed: &FramedScene,
    scene: &PreparedScene,
    source: usize,
    x: i64,
    y: i64,
    golden: i64,
    exact: &ExactPixel,
) -> Option<bool> {
    let (mut lit, mut dark) = (true, false);
    let own = scene.volumes.iter();
    for volume in own.filter(|v| usize::from(v.words.source) == source) {
        let found = volume_state(framed, volume, x, y, golden, exact);
        let (keeps, takes) = match volume.words.kind {
            VolumeKind::Shadow => (State::Out, State::In),
            VolumeKind::Light => (State::In, State::Out),
        };
        lit &= found == keeps;
        dark |= found == takes;
    }
    match (lit, dark) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        _ => None,
    }
}

/// What a comparison counts, over all pixels and sources.
#[derive(Debug, Default, PartialEq, Eq)]
struct Tally {
    /// Flags of pixels at which both see the same face.
    flags: usize,
    /// Flags that the words leave open.
    open: usize,
    /// Open flags that differ.
    differing: usize,
    /// Lit and dark flags of the exact picture.
    lit: usize,
    dark: usize,
}

fn golden_frame(prepared: &PreparedScene) -> Frame {
    let (width, height) = (prepared.width as usize, prepared.height as usize);
    beam::render(&prepared.slots(), &prepared.format, width, height, || ())
}

/// Compares the flags of all pixels; where the words decide, golden and exact flags are what they decide.
fn compare(framed: &FramedScene, prepared: &PreparedScene, tally: &mut Tally) {
    let frame = golden_frame(prepared);
    let golden = Lighting::of(&frame, prepared, || ());
    let truth = exact::shadow::lighting(framed, || ());
    let seen = exact::render::render(framed, &F, || ());
    for (index, pixel) in seen.iter().enumerate() {
        let Some(pixel) = same_face(*pixel, &frame, index) else {
            continue;
        };
        let (x, y) = (index % frame.width, index / frame.width);
        for source in 0..framed.sources.len() {
            let flag = |lighting: &Lighting| lighting.flags[index] >> source & 1 == 1;
            let (got, wanted) = (flag(&golden), flag(&truth));
            tally.flags += 1;
            tally.lit += usize::from(wanted);
            tally.dark += usize::from(!wanted);
            let depth = frame.depth[index];
            match decided(framed, prepared, source, x as i64, y as i64, depth, &pixel) {
                Some(lit) => assert_eq!(
                    (got, wanted),
                    (lit, lit),
                    "{} at ({x}, {y}), lights[{source}], object {}, face {}",
                    framed.title,
                    framed.objects[pixel.id as usize].name(),
                    pixel.number
                ),
                None => {
                    tally.open += 1;
                    tally.differing += usize::from(got != wanted);
                }
            }
        }
    }
}

fn same_face(pixel: Option<ExactPixel>, frame: &Frame, index: usize) -> Option<ExactPixel> {
    let pixel = pixel?;
    let same = frame.id[index] == pixel.id as i32 && frame.number[index] == pixel.number;
    // Where the near end opens a solid one sees its inside, which is in no volume.
    (same && pixel.number != FACE_NEAR_END).then_some(pixel)
}

/// A floor, a ball, a bowl of a half sphere and an oblique can under a directional light and a spot.
#[test]
fn a_scene_with_a_spot_has_the_shadows_of_the_exact_rays() {
    let path = format!("{}/tests/scenes/shadows.toml", env!("CARGO_MANIFEST_DIR"));
    let file = SceneFile::read(path.as_ref()).expect("a valid scene");
    let framed = file.frame(180, 135).expect("a valid size");
    let prepared = prepare(&framed);
    // Ball 1, half sphere 2, can and floor 3 for each source, less those that meet nothing; one cone.
    let mut tally = Tally::default();
    compare(&framed, &prepared, &mut tally);
    eprintln!("{} volumes, {tally:?}", prepared.volumes.len());
    assert!(tally.lit > 10_000 && tally.dark > 5_000, "{tally:?}");
    // All on the terminators of ball and can, where the light only grazes.
    assert!(tally.open <= 38 && tally.differing <= 32, "{tally:?}");
}

/// The robot of the collection: 38 solids cast shadows of a spot and a directional light.
#[test]
fn the_robot_has_the_shadows_of_the_exact_rays() {
    let path = format!(
        "{}/../scenes/shadows/robot.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let file = SceneFile::read(path.as_ref()).expect("a valid scene");
    let framed = file.frame(120, 90).expect("a valid size");
    let prepared = prepare(&framed);
    let mut tally = Tally::default();
    compare(&framed, &prepared, &mut tally);
    eprintln!("{} volumes, {tally:?}", prepared.volumes.len());
    assert!(prepared.volumes.len() > 100);
    assert!(tally.lit > 3_000 && tally.dark > 2_000, "{tally:?}");
    assert!(tally.open <= 22 && tally.differing <= 15, "{tally:?}");
}

/// A quadric of random shape about a centre: ellipsoid, cylinder, hyperboloid of one or two sheets, cone.
fn random_caster(random: &mut Random, name: &str) -> FramedQuadric {
    const KINDS: [([i64; 3], i64); 6] = [
        ([1, 1, 1], 12),
        ([1, 1, 1], 9),
        ([1, 1, 0], 7),
        ([1, 1, -1], 5),
        ([1, 1, -1], 0),
        ([1, 1, -1], -5),
    ];
    let mut whole = |most: f64| (random.signed() * most).round() as i64;
    let kind = (whole(2.99) + 2).clamp(0, 5) as usize;
    let (signs, size) = KINDS[kind];
    let m: [[i64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| whole(9.0)));
    // m' diag(signs) m is a quadric of that kind unless m is singular; its constant makes it some pixels wide.
    let entry = |i: usize, j: usize| -> i64 { (0..3).map(|k| signs[k] * m[k][i] * m[k][j]).sum() };
    let scale = (0..3)
        .map(|k| entry(k, k).abs())
        .max()
        .expect("three")
        .max(1);
    let centre: [i64; 3] = std::array::from_fn(|_| whole(16.0));
    let moved: [i64; 3] = std::array::from_fn(|i| (0..3).map(|j| entry(i, j) * centre[j]).sum());
    let about: i64 = (0..3).map(|i| moved[i] * centre[i]).sum();
    let q = whole_quadric([
        entry(0, 0),
        entry(1, 1),
        entry(2, 2),
        entry(0, 1),
        entry(0, 2),
        entry(1, 2),
        -moved[0],
        -moved[1],
        -moved[2],
        about - size * size.abs() * scale,
    ]);
    let plane_at = |n: [i64; 3], distance: i64| {
        let at: i64 = (0..3).map(|k| n[k] * centre[k]).sum();
        [n[0], n[1], n[2], -at - distance]
    };
    let mut cuts: Vec<[i64; 4]> = vec![];
    for _ in 0..(whole(2.49) + 1).clamp(0, 3) {
        let n: [i64; 3] = std::array::from_fn(|_| whole(20.0));
        cuts.push(plane_at(n, 20 * (whole(7.0) + 4)));
    }
    if kind >= 2 {
        // Endless ones are cut on both sides.
        cuts.extend([1, -1].map(|side| plane_at([3 * side, 20 * side, 5 * side], 200)));
    }
    cuts.retain(|c| c[..3] != [0; 3]);
    object(name, Surface::Solid, q, &cuts)
}

fn source(point: [i64; 4], cone: Option<SpotCone>) -> FramedSource {
    FramedSource {
        point: point.map(integer),
        shadows: true,
        cone,
    }
}

/// Random cut quadrics before a wall, a point source and a directional one, in both projections.
#[test]
fn random_cut_quadrics_have_the_shadows_of_the_exact_rays() {
    let mut random = Random(7);
    let mut tally = Tally::default();
    let (mut prepared_scenes, mut refused, mut parts) = (0, 0, 0);
    for round in 0..24 {
        let wall = FramedQuadric {
            casts_shadow: false,
            ..object("wall", Surface::Solid, sphere([0, 0, 250], 200), &[])
        };
        let objects = vec![
            wall,
            random_caster(&mut random, "first"),
            random_caster(&mut random, "second"),
        ];
        let projection = if round % 2 == 0 {
            Projection::Perspective {
                distance: integer(150),
            }
        } else {
            Projection::Orthographic {
                half_depth: integer(150),
            }
        };
        let mut framed = scene_of(96, 72, projection, objects);
        framed.title = format!("round {round}");
        let mut at = |most: f64| (random.signed() * most).round() as i64;
        framed.sources = vec![
            source([at(90.0), at(90.0), -50 - at(40.0).abs(), 1], None),
            source([at(10.0), at(10.0), -3 - at(10.0).abs(), 0], None),
        ];
        match imogene_models::prepare::prepare(&framed, F) {
            Ok(prepared) => {
                prepared_scenes += 1;
                parts += prepared.volumes.len();
                compare(&framed, &prepared, &mut tally);
            }
            Err(_) => refused += 1,
        }
    }
    eprintln!("{prepared_scenes} scenes, {refused} refused, {parts} volumes, {tally:?}");
    assert!(prepared_scenes + refused == 24 && prepared_scenes >= 16 && parts > 200);
    assert!(tally.lit > 100_000 && tally.dark > 30_000, "{tally:?}");
    assert!(
        tally.differing * 1000 < tally.flags && tally.open * 20 < tally.flags,
        "{tally:?}"
    );
}
