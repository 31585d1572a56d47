//! The decider of patches.

use super::description::{Description, bit, late, stated};
use super::words::plane_kind;
use crate::stimulus::depth;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::patch_decider::{Faces, decide, kept, visible};
use proptest::prelude::*;

/// Ports of the decider before those of the planes.
const DECIDER_PORTS: usize = 4;

pub(super) fn patch_decider(format: Format) -> Description {
    Description::new(decisions, move || {
        let mut late = late(3);
        move |i: &[i64]| {
            let (near, far) = (i[0], i[1]);
            let there = visible(near, far, bit(i[2]) && bit(i[3]), &format);
            let left = i[DECIDER_PORTS..]
                .chunks(2)
                .map(|plane| kept(plane_kind(plane[0]), plane[1], near, far))
                .fold(there, Faces::and);
            let face = late.push(decide(near, far, left, &format));
            stated(face.map(|face| [face.zf, face.zb, face.nf.into()]))
        }
    })
}

/// Roots and planes on a few levels about zero and about both ends, so that ties are common; some roots in the other
/// order, to which sums beyond their width come.
fn decisions(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let width = subject.outputs[0].width;
    let sum = || prop_oneof![8 => depth(width), 1 => crate::stimulus::word(&subject.inputs[0])];
    let often = || prop_oneof![6 => Just(1i64), 1 => Just(0)];
    let planes = (subject.inputs.len() - DECIDER_PORTS) / 2;
    let plane = || (0i64..4, depth(width));
    let planes = proptest::collection::vec(plane(), planes);
    let one = ([sum(), sum()], [often(), often(), often()], planes).prop_map(
        |([a, b], [inside, there, in_order], planes)| {
            let [near, far] = if in_order == 1 {
                [a.min(b), a.max(b)]
            } else {
                [a, b]
            };
            let mut inputs = vec![near, far, inside, there];
            inputs.extend(planes.into_iter().flat_map(|(kind, zp)| [kind, zp]));
            inputs
        },
    );
    proptest::collection::vec(one, clocks).boxed()
}
