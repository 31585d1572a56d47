//! What the words leave of a flag: decided in whole numbers, from the proven bounds of the words and the distance of
//! the two visible depths.

use crate::pictures::Pictures;
use imogene_algebra::rational::{from_f64_exact, integer, power_of_two};
use imogene_algebra::vector::{cross, dot, minus};
use imogene_analysis::exact::render::{DEPTH_FRACTION, ExactPixel};
use imogene_golden::object::volume::VolumeKind;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{Class, FACE_PLANE};
use imogene_prepare::volume::{Beginning, PreparedVolume};
use imogene_scene::{FramedObject, FramedScene, Projection};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

const UNIT: i128 = 1 << DEPTH_FRACTION;

/// Column and line of a pixel.
type Place = (i64, i64);
/// The least and the greatest depth, in fractions of a count.
type Depths = (i128, i128);

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

/// All depths at which golden and exact membership ask, in fractions of a count: golden and exact depth, the margin,
/// and the counts that roots and coarse units are rounded by.
fn depths(volume: &PreparedVolume, golden: i64, exact: i64) -> Depths {
    let words = &volume.words;
    let coarse = 2i128 << words.quadric.map_or(0, |q| q.shift);
    let entered = i128::from(golden) - i128::from(words.margin);
    (
        i128::from(exact).min((entered - coarse) * UNIT),
        (i128::from(exact) + 1).max((i128::from(golden) + coarse) * UNIT),
    )
}

fn quadric_state(volume: &PreparedVolume, (x, y): Place, (low, high): Depths) -> State {
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
    let crosses = near <= 0 && far >= 0;
    let least = if crosses {
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

fn plane_state(volume: &PreparedVolume, index: usize, (x, y): Place, depths: Depths) -> State {
    let (low, high) = depths;
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

/// At its own beginning a shadow is open, and the margin is proven to keep it so: a cut face that faces the light is
/// outside the volume that begins at it, one that faces away is at the volume's end, inside; of a facet the side counts
/// that is seen.
fn begins_at_face(
    volume: &PreparedVolume,
    seen: &ExactPixel,
    framed: &FramedScene,
) -> Option<State> {
    let (object, beginning) = volume.caster?;
    let [x, y, z, w] = &framed.sources[usize::from(volume.words.source)].point;
    let is_lit = match (beginning, &framed.objects[object]) {
        (Beginning::Cut(cut), caster) if seen.number == FACE_PLANE + cut as u8 => {
            let p = &caster.caster()?.planes[cut];
            &p.a * x + &p.b * y + &p.c * z + &p.d * w > integer(0)
        }
        (Beginning::Facet(facet), FramedObject::Mesh(mesh)) if seen.part as usize == facet => {
            let corner = |k: usize| &mesh.vertices[mesh.facets[facet].corners[k]];
            let normal = cross(minus(corner(1), corner(0)), minus(corner(2), corner(0)));
            let away = dot(&normal, corner(0));
            let side = |[x, y, z]: [&BigRational; 3], w: &BigRational| {
                let [a, b, c] = &normal;
                (a * x + b * y + c * z - &away * w).is_positive()
            };
            let [zero, one] = [0, 1].map(integer);
            let viewer = match &framed.projection {
                Projection::Perspective { distance } => side([&zero, &zero, &-distance], &one),
                Projection::Orthographic { .. } => side([&zero, &zero, &-&one], &zero),
            };
            viewer == side([x, y, z], w)
        }
        _ => return None,
    };
    let own = seen.id as usize == object;
    own.then_some(if is_lit { State::Out } else { State::In })
}

fn volume_state(
    pictures: &Pictures,
    volume: &PreparedVolume,
    index: usize,
    exact: &ExactPixel,
) -> State {
    let (x, y) = pictures.place(index);
    if !volume.words.screen_box.contains(x, y) {
        return State::Out;
    }
    let depths = depths(volume, pictures.golden.depth[index], exact.depth);
    let planes = 0..volume.words.planes.len();
    let mut parts = vec![quadric_state(volume, (x, y), depths)];
    parts.extend(planes.map(|index| plane_state(volume, index, (x, y), depths)));
    if let Some(known) = begins_at_face(volume, exact, &pictures.scene) {
        parts[1] = known;
    }
    let mut first = [State::Out, State::Unknown].into_iter();
    first
        .find(|state| parts.contains(state))
        .unwrap_or(State::In)
}

/// Does the source reach the point; `None` if the words leave that open.
pub fn decided(
    pictures: &Pictures,
    source: usize,
    index: usize,
    exact: &ExactPixel,
) -> Option<bool> {
    let (mut lit, mut dark) = (true, false);
    let own = pictures.prepared.volumes.iter();
    for volume in own.filter(|v| usize::from(v.words.source) == source) {
        let found = volume_state(pictures, volume, index, exact);
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
