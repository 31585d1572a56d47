//! One cut, everything: every front depth, back depth, plane depth, kind and class at a small depth word.

use super::account;
use imogene_circuits::object::{self, Cut, cut_plane};
use imogene_contract::RootForm;
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::Interval;
use imogene_verif::engine::circuit::Circuit;
use std::time::Instant;

pub(crate) const KINDS: [PlaneKind; 4] = {
    use PlaneKind::*;
    [None, Front, Back, Perpendicular]
};

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
        root_form: RootForm::Restoring,
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
    let mut depths: Vec<i64> = match surface {
        true => vec![start.zf, start.zb],
        false => (start.zf..=start.zb).collect(),
    };
    depths.retain(|z| keeps(*z));
    match (depths.first(), depths.last()) {
        (Some(front), Some(back)) => (*front, *back),
        _ => (far, far),
    }
}

fn every_cut<const W: usize>() {
    let started = Instant::now();
    let format = small_format(W as u32);
    let interval = || object::Interval::input(W as u32);
    let mut unit = Circuit::of(|| cut_plane("top", Cut::input(W as u32), interval()));
    let words = || -(1i64 << (W - 1))..1 << (W - 1);
    let mut count = 0u64;
    for (kind, surface) in KINDS.into_iter().flat_map(|k| [(k, false), (k, true)]) {
        for (zf, zb) in words().flat_map(|zf| words().map(move |zb| (zf, zb))) {
            for zp in words() {
                let (nf, nb) = (4, 9);
                let plane = [kind as i64, surface.into(), 7, zp];
                let half = [zf, nf.into(), zb, nb.into()];
                // Latency 2.
                for _ in 0..2 {
                    unit.clock(&[plane, half].concat());
                }
                let start = Interval { zf, zb, nf, nb };
                let golden = cut(start, kind, zp, 7, surface, &format);
                let found = Interval {
                    zf: unit.output(0),
                    zb: unit.output(2),
                    nf: unit.output(1) as u8,
                    nb: unit.output(3) as u8,
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
