//! The units that planes cut with: the depth of a plane, one cut, all cuts of a quadric, and the decider of patches.

use super::description::{Description, bit, last_pixel, late, stated, zones};
use super::words::{Ports, read};
use crate::stimulus::{depth, interval, mapped, word};
use crate::subject::{Stimuli, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::{Class, Interval, halves};
use imogene_golden::unit::merge::merge;
use imogene_golden::unit::patch_decider::{Faces, decide, kept, visible};
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::plane_depth::saturate;
use proptest::prelude::*;

/// Near and far sums around the ends of the depth word; half the time ordered, as they are in a machine.
fn sums(subject: &Subject, clocks: usize) -> Stimuli {
    let far = (1i64 << (subject.inputs[0].width - 3)) - 1;
    let low = [-3 * far].into_iter().chain(-far - 2..=-far + 1);
    let levels = low.chain(-1..=1).chain(far - 1..=far + 1).chain([3 * far]);
    let level = proptest::sample::select(levels.collect::<Vec<i64>>());
    let any_sum = word(&subject.inputs[0]);
    // Next to an end of the depth word but for one bit: a comparator that neglects that bit takes it for the end.
    let ends = proptest::sample::select(vec![-far, far]);
    let near_end = (ends, -1i64..=1, 0..subject.inputs[0].width - 1);
    let near_end = near_end.prop_map(|(end, offset, bit)| (end + offset) ^ (1 << bit));
    let sum = || prop_oneof![3 => level.clone(), 2 => near_end.clone(), 1 => any_sum.clone()];
    let one = (sum(), sum(), 0i64..=1, 0i64..8, 0i64..4).prop_map(
        |(near, far, inside, in_box, class)| vec![near, far, inside, in_box.min(1), class],
    );
    proptest::collection::vec(one, clocks).boxed()
}

pub(super) fn plane_depth(format: Format) -> Description {
    Description::new(zones, move || {
        let words = move |i: &[i64]| read(&i[3..], &format, Ports::line);
        let start = move |i: &[i64]| Pe1::object_start(&words(i), format.plane);
        let depth = move |pe: &mut Pe1| saturate(pe.pixel() as i64, &format);
        let mut last = last_pixel(start, Pe1::line_step, depth);
        let mut late = late(2);
        move |i: &[i64]| vec![late.push(last(i)).flatten()]
    })
}

pub(super) fn cut_plane(format: Format) -> Description {
    Description::pipeline(cuts, 2, move |i| {
        let kind = PlaneKind::ALL[i[0] as usize];
        let start = Interval {
            zf: i[4],
            nf: i[5] as u8,
            zb: i[6],
            nb: i[7] as u8,
        };
        let left = cut(start, kind, i[3], i[2] as u8, bit(i[1]), &format);
        [left.zf, left.nf.into(), left.zb, left.nb.into()]
    })
}

/// A plane's depth: any, or that of an end of the interval but for one bit at most.
fn plane_at(width: u32, zf: i64, zb: i64) -> impl Strategy<Value = i64> {
    let flipped = (proptest::sample::select(vec![zf, zb]), 0..2 * width)
        .prop_map(move |(z, bit)| if bit < width - 1 { z ^ (1 << bit) } else { z });
    prop_oneof![2 => depth(width), 1 => flipped]
}

fn cuts(subject: &Subject, clocks: usize) -> Stimuli {
    let width = subject.inputs[3].width;
    let one = (
        (0i64..4, 0i64..2, 2i64..14, 0i64..16, 0i64..16),
        interval(width).prop_flat_map(move |(zf, zb)| (plane_at(width, zf, zb), Just((zf, zb)))),
    )
        .prop_map(|((kind, surface, number, nf, nb), (zp, (zf, zb)))| {
            vec![kind, surface, number, zp, zf, nf, zb, nb]
        });
    proptest::collection::vec(one, clocks).boxed()
}

/// The chain of the source over two planes at the limits, and one perpendicular to the screen.
pub(super) fn quadric_cut(format: Format) -> Description {
    Description::new(cut_quadrics, move || {
        // The roots of two clocks before stand beside the limits of this one.
        let (mut early, mut late) = (late(3), late(3));
        move |i: &[i64]| {
            let roots = early.push([i[0], i[1], i[2], i[3], i[4]]);
            let seen = roots.map(|[near, far, is_inside, in_box, object_class]| {
                let class = Class::ALL[object_class as usize];
                let whole = match bit(in_box) {
                    true => halves(class, near, far, !bit(is_inside), &format),
                    false => [(); 2].map(|()| Interval::absent(&format)).into(),
                };
                let planes = [
                    (PlaneKind::Front, i[5], i[6]),
                    (PlaneKind::Back, i[7], i[8]),
                    (PlaneKind::Perpendicular, -i[9], 0),
                ];
                let is_surface = class == Class::Patch;
                let left = |half: Interval| {
                    planes.into_iter().fold(half, |left, (kind, zp, number)| {
                        cut(left, kind, zp, number as u8, is_surface, &format)
                    })
                };
                let seen = merge(left(whole.0), left(whole.1));
                [seen.zf, seen.zb, seen.nf.into()]
            });
            stated(late.push(seen).flatten())
        }
    })
}

/// Roots in order, and two clocks later limits about them.
fn cut_quadrics(subject: &Subject, clocks: usize) -> Stimuli {
    let width = subject.inputs[5].width;
    let end = (1i64 << (width - 1)) - 1;
    let numbers = (0i64..16, 0i64..16);
    let limits = (limit(width), limit(width));
    let one = (sums(subject, 1), limits, numbers, 0i64..32);
    let one = one.prop_map(move |(sums, (front, back), numbers, removed)| {
        let sums = sums[0].clone();
        let (near, far) = (sums[0].min(sums[1]), sums[0].max(sums[1]));
        let at = |limit: Limit| match limit {
            Limit::At(z) => z,
            Limit::AtRoot(is_far, flipped) => {
                let z = if is_far { far } else { near }.clamp(-end, end);
                z ^ if flipped < width - 1 { 1 << flipped } else { 0 }
            }
        };
        let (front, back) = (at(front), at(back));
        let roots = vec![near, far, sums[2], sums[3], sums[4]];
        let removed = i64::from(removed == 0);
        (roots, vec![front, numbers.0, back, numbers.1, removed])
    });
    let later = proptest::collection::vec(one, clocks + 2);
    mapped(later, move |list| {
        let one = |at: usize| [&list[at + 2].0[..], &list[at].1[..]].concat();
        (0..clocks).map(one).collect()
    })
}

/// A depth, or that of a root but for one bit at most.
#[derive(Clone, Copy, Debug)]
enum Limit {
    At(i64),
    AtRoot(bool, u32),
}

fn limit(width: u32) -> BoxedStrategy<Limit> {
    let none = proptest::sample::select(vec![-(1i64 << (width - 1)), (1 << (width - 1)) - 1]);
    let near_root = (any::<bool>(), 0..2 * width);
    prop_oneof![
        2 => depth(width).prop_map(Limit::At),
        1 => none.prop_map(Limit::At),
        3 => near_root.prop_map(|(is_far, flipped)| Limit::AtRoot(is_far, flipped)),
    ]
    .boxed()
}

/// Ports of the decider before those of the planes.
const DECIDER_PORTS: usize = 4;

pub(super) fn patch_decider(format: Format) -> Description {
    Description::pipeline(decisions, 3, move |i| {
        let (near, far) = (i[0], i[1]);
        let there = visible(near, far, bit(i[2]) && bit(i[3]), &format);
        let left = i[DECIDER_PORTS..]
            .chunks(2)
            .map(|plane| kept(PlaneKind::ALL[plane[0] as usize], plane[1], near, far))
            .fold(there, Faces::and);
        let face = decide(near, far, left, &format);
        [face.zf, face.zb, face.nf.into()]
    })
}

/// Roots and planes on a few levels about zero and both ends, so that ties are common; some roots in wrong order.
fn decisions(subject: &Subject, clocks: usize) -> Stimuli {
    let width = subject.outputs[0].width;
    let sum = || prop_oneof![8 => depth(width), 1 => word(&subject.inputs[0])];
    let often = || prop_oneof![6 => Just(1i64), 1 => Just(0)];
    let planes = (subject.inputs.len() - DECIDER_PORTS) / 2;
    let plane = || (0i64..4, depth(width));
    let planes = proptest::collection::vec(plane(), planes);
    let one = ([sum(), sum()], [often(), often(), often()], planes).prop_map(
        |([a, b], [inside, there, in_order], planes)| {
            let is_turned = in_order == 1 && a > b;
            let [near, far] = if is_turned { [b, a] } else { [a, b] };
            let mut inputs = vec![near, far, inside, there];
            inputs.extend(planes.into_iter().flat_map(|(kind, zp)| [kind, zp]));
            inputs
        },
    );
    proptest::collection::vec(one, clocks).boxed()
}
