//! The units of the depth interval: opening it, cutting it, merging its halves.

use super::description::{Description, any_raster, bit, last_pixel, late, stated};
use super::words::{Ports, class, plane_kind, read};
use crate::stimulus::{depth, interval};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::cut;
use imogene_golden::unit::depth_interval::{Interval, halves};
use imogene_golden::unit::merge::merge;
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::plane_depth::saturate;
use proptest::prelude::*;

/// Clocks from the roots to an interval, and from an interval to what a unit makes of it.
const BEGIN: usize = 3;
const LATENCY: usize = 2;

fn flat(half: &Interval) -> [i64; 4] {
    [half.zf, half.nf.into(), half.zb, half.nb.into()]
}

fn interval_of(i: &[i64]) -> Interval {
    Interval {
        zf: i[0],
        nf: i[1] as u8,
        zb: i[2],
        nb: i[3] as u8,
    }
}

pub(super) fn depth_interval(format: Format) -> Description {
    Description::new(sums, move || {
        let mut late = late(BEGIN);
        move |i: &[i64]| {
            let (a, b) = match bit(i[3]) {
                true => halves(class(i[4]), i[0], i[1], !bit(i[2]), &format),
                false => [(); 2].map(|()| Interval::absent(&format)).into(),
            };
            let found = late.push([flat(&a), flat(&b)]);
            let [a, b] = [0, 1].map(|half| stated(found.map(|halves| halves[half])));
            [a, b].concat()
        }
    })
}

/// Near and far sums around the ends of the depth word; half the time ordered, as they are in a machine.
fn sums(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let far = (1i64 << (subject.inputs[0].width - 3)) - 1;
    let low = [-3 * far].into_iter().chain(-far - 2..=-far + 1);
    let levels = low.chain(-1..=1).chain(far - 1..=far + 1).chain([3 * far]);
    let level = proptest::sample::select(levels.collect::<Vec<i64>>());
    let any_sum = crate::stimulus::word(&subject.inputs[0]);
    // Next to an end of the depth word but for one bit: a comparator that neglects that bit takes it for the end.
    let near_end = (
        proptest::sample::select(vec![-far, far]),
        -1i64..=1,
        0..subject.inputs[0].width - 1,
    )
        .prop_map(|(end, offset, bit)| (end + offset) ^ (1 << bit));
    let sum = || prop_oneof![3 => level.clone(), 2 => near_end.clone(), 1 => any_sum.clone()];
    let one = (sum(), sum(), 0i64..=1, 0i64..8, 0i64..4).prop_map(
        |(near, far, inside, in_box, class)| vec![near, far, inside, in_box.min(1), class],
    );
    proptest::collection::vec(one, clocks).boxed()
}

pub(super) fn plane_depth(format: Format) -> Description {
    Description::new(any_raster, move || {
        let words = move |i: &[i64]| read(&i[3..], &format, Ports::line);
        let start = move |i: &[i64]| Pe1::object_start(&words(i), format.plane);
        let depth = move |pe: &mut Pe1| saturate(pe.pixel() as i64, &format);
        let mut last = last_pixel(start, Pe1::line_step, depth);
        let mut late = late(2);
        move |i: &[i64]| vec![late.push(last(i)).flatten()]
    })
}

pub(super) fn cut_plane(format: Format) -> Description {
    Description::new(cuts, move || {
        let mut late = late(LATENCY);
        move |i: &[i64]| {
            let kind = plane_kind(i[0]);
            let start = interval_of(&i[4..]);
            let left = cut(start, kind, i[3], i[2] as u8, bit(i[1]), &format);
            stated(late.push(flat(&left)))
        }
    })
}

/// A plane's depth: any, or that of an end of the interval but for one bit at most.
fn plane_at(width: u32, zf: i64, zb: i64) -> impl Strategy<Value = i64> {
    let flipped = (proptest::sample::select(vec![zf, zb]), 0..2 * width)
        .prop_map(move |(z, bit)| if bit < width - 1 { z ^ (1 << bit) } else { z });
    prop_oneof![2 => depth(width), 1 => flipped]
}

fn cuts(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
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

pub(super) fn two_volume_merge() -> Description {
    Description::new(two_halves, || {
        let mut late = late(LATENCY);
        move |i: &[i64]| stated(late.push(flat(&merge(interval_of(i), interval_of(&i[4..])))))
    })
}

fn two_halves(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let half = (interval(subject.inputs[0].width), 0i64..16, 0i64..16);
    let half = half.prop_map(|((zf, zb), nf, nb)| [zf, nf, zb, nb]);
    let one = [half.clone(), half].prop_map(|halves| halves.concat());
    proptest::collection::vec(one, clocks).boxed()
}
