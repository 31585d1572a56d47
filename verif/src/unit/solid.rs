//! One product of a solid.

use super::description::{Description, late, stated};
use crate::stimulus::{depth, word};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::machine::csg::{Extent, front, latency, skew};
use imogene_golden::machine::skew::Skewed;
use proptest::prelude::*;

/// Ports of one object: depth, id, number and normal of its face, and the depth of its other end.
const FIELDS: usize = 7;

pub(super) fn csg_product(format: Format, intersected: usize, subtracted: usize) -> Description {
    Description::new(solids, move || {
        let starts = [vec![0; intersected], vec![skew(intersected); subtracted]].concat();
        let mut pixels = Skewed::new(starts);
        let clocks = latency(intersected, subtracted) as usize;
        let mut late = late(clocks - pixels.span());
        move |i: &[i64]| {
            let row: Vec<Vec<i64>> = i.chunks(FIELDS).map(<[i64]>::to_vec).collect();
            let seen = pixels.push(row).map(|objects| {
                let (kept, taken) = objects.split_at(intersected);
                // The face is the front of what is kept and the back of what is taken away.
                let kept = kept.iter().map(|i| Extent { zf: i[0], zb: i[6] });
                let taken = taken.iter().map(|i| Extent { zf: i[6], zb: i[0] });
                let (kept, taken): (Vec<_>, Vec<_>) = (kept.collect(), taken.collect());
                match front(&kept, &taken, format.z_max()) {
                    Some(seen) => [0, 1, 2, 3, 4, 5].map(|k| objects[seen.object][k]),
                    None => [format.z_max(), 0, 0, 0, 0, 0],
                }
            });
            stated(late.push(seen).flatten())
        }
    })
}

/// Intervals on few levels, so that ends meet; wide ones for the objects that are intersected, narrow ones for those
/// taken away; some absent, some of any words, which the rule covers too.
fn solids(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let width = subject.inputs[0].width;
    let far = (1i64 << (width - 1)) - 1;
    let one = |ports: &[crate::signal::Signal]| {
        let is_kept = ports[0].name.starts_with("intersected");
        let lengths = if is_kept { 4i64..16 } else { 0i64..6 };
        let on_levels = (-3i64..8, lengths).prop_map(|(zf, length)| [zf, zf + length]);
        let fronts = (-3i64..2, 8i64..12).prop_map(|(zf, zb)| [zf, zb]);
        let sheet = (-3i64..8).prop_map(|z| [z, z]);
        let absent = depth(width).prop_map(move |zb| [far, zb]);
        let open = depth(width).prop_map(move |zf| [zf, far]);
        let ends = (depth(width), depth(width)).prop_map(|(zf, zb)| [zf, zb]);
        let interval = prop_oneof![
            8 => on_levels, 6 => fronts, 1 => sheet, 1 => absent, 1 => open, 1 => ends
        ];
        let normal = [word(&ports[3]), word(&ports[4]), word(&ports[5])];
        (interval, 0i64..256, 0i64..16, normal).prop_map(
            move |([zf, zb], id, number, [x, y, z])| {
                let [face, end] = if is_kept { [zf, zb] } else { [zb, zf] };
                vec![face, id, number, x, y, z, end]
            },
        )
    };
    let objects: Vec<_> = subject.inputs.chunks(FIELDS).map(one).collect();
    let row = objects.prop_map(|objects| objects.concat());
    proptest::collection::vec(row, clocks).boxed()
}
