//! One cut, everything: every front depth, back depth, plane depth, kind and class at a small depth word.

use super::account;
use imogene_models::format::Format;
use imogene_models::unit::cut_plane::{PlaneKind, cut};
use imogene_models::unit::interval::Interval;
use imogene_rtl::step::step;
use imogene_rtl::unit::cut_plane::CutPlane;
use imogene_rtl::word::{Int, Word};
use rust_hdl::core::prelude::Block;
use std::time::Instant;

pub(super) const KINDS: [PlaneKind; 4] = [
    PlaneKind::None,
    PlaneKind::Front,
    PlaneKind::Back,
    PlaneKind::Perpendicular,
];

/// A format of a depth word that is too small for a machine, but enough for one comparison.
const fn small_format(depth: u32) -> Format {
    Format {
        depth,
        sum: depth + 2,
        quadratic: 2 * depth,
        root: depth,
        plane: depth + 12,
        normal_linear: 24,
        normal: 16,
        guard_linear: 0,
        guard_quadratic: 0,
        dropped_rows: 0,
    }
}

/// What is left as the contract states it with sets of depths: the interval between, or the two faces.
fn by_sets(start: Interval, kind: PlaneKind, zp: i64, surface: bool, far: i64) -> (i64, i64) {
    let keeps = |z: i64| match kind {
        PlaneKind::None => true,
        PlaneKind::Front => z >= zp,
        PlaneKind::Back => z <= zp,
        PlaneKind::Perpendicular => zp >= 0,
    };
    let depths: Vec<i64> = if surface {
        [start.zf, start.zb]
            .into_iter()
            .filter(|z| keeps(*z))
            .collect()
    } else {
        (start.zf..=start.zb).filter(|z| keeps(*z)).collect()
    };
    match (depths.first(), depths.last()) {
        (Some(front), Some(back)) => (*front, *back),
        _ => (far, far),
    }
}

fn every_cut<const W: usize>() {
    let started = Instant::now();
    let format = small_format(W as u32);
    let mut unit = CutPlane::<W>::new();
    unit.connect_all();
    let words = || -(1i64 << (W - 1))..1 << (W - 1);
    let mut count = 0u64;
    for (kind, surface) in KINDS.into_iter().flat_map(|k| [(k, false), (k, true)]) {
        unit.kind.next = Word::new(kind as u64);
        unit.surface.next = surface;
        unit.number.next = Word::new(7);
        unit.nf.next = Word::new(4);
        unit.nb.next = Word::new(9);
        for (zf, zb) in words().flat_map(|zf| words().map(move |zb| (zf, zb))) {
            for zp in words() {
                unit.zp.next = Int::new(zp);
                unit.zf.next = Int::new(zf);
                unit.zb.next = Int::new(zb);
                step(&mut unit);
                let (nf, nb) = (4, 9);
                let start = Interval { zf, zb, nf, nb };
                let golden = cut(start, kind, zp, 7, surface, &format);
                let found = Interval {
                    zf: unit.cut_zf.val().get(),
                    zb: unit.cut_zb.val().get(),
                    nf: unit.cut_nf.val().get() as u8,
                    nb: unit.cut_nb.val().get() as u8,
                };
                let case = || format!("{kind:?} at {zp} of {start:?}, surface {surface}");
                assert_eq!(found, golden, "{}", case());
                if zf <= zb {
                    let sets = by_sets(start, kind, zp, surface, format.z_max());
                    assert_eq!((found.zf, found.zb), sets, "{}", case());
                }
                count += 1;
            }
        }
    }
    assert_eq!(count, 8 << (3 * W));
    account(&format!("cut_plane of {W} bits, cuts"), count, started);
}

#[test]
fn every_cut_of_small_depth_words() {
    every_cut::<2>();
    every_cut::<3>();
    every_cut::<4>();
    every_cut::<5>();
}
