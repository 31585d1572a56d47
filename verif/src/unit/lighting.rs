//! The flags of the light sources.

use super::description::{Description, bit, late};
use crate::stimulus::word;
use crate::subject::{Inputs, Subject};
use imogene_golden::machine::shadow::{ShadowWords, flags, latency};
use imogene_golden::object::volume::VolumeKind;
use proptest::prelude::*;

/// Ports of one volume.
const FIELDS: usize = 4;

fn words_of(i: &[i64]) -> ShadowWords {
    ShadowWords {
        kind: [VolumeKind::Shadow, VolumeKind::Light][i[1] as usize],
        source: i[2] as u8,
        enabled: bit(i[3]),
    }
}

pub(super) fn shadow_stage(volumes: usize) -> Description {
    Description::new(answers, move || {
        let mut late = late(latency(volumes) as usize);
        move |i: &[i64]| {
            let list = i[1..].chunks(FIELDS);
            let (words, inside): (Vec<_>, Vec<_>) = list.map(|i| (words_of(i), bit(i[0]))).unzip();
            vec![late.push(flags(i[0] as u16, &words, &inside).into())]
        }
    })
}

/// Sources that are all different, or few, so that volumes of a source meet; answers mostly such that the flag stays,
/// since one volume among many would hide the others.
fn answers(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let count = (subject.inputs.len() - 1) / FIELDS;
    let before = prop_oneof![Just(0xffff), word(&subject.inputs[0])];
    let source = prop_oneof![0i64..16, 0i64..3];
    let takes_away = prop_oneof![6 => Just(0i64), 1 => Just(1)];
    let volume =
        (takes_away, 0i64..=1, source, 0i64..=1).prop_map(|(takes_away, kind, source, enabled)| {
            // A volume that does not count says the opposite: it must not be heard.
            [takes_away ^ kind ^ (1 - enabled), kind, source, enabled]
        });
    let one = (before, proptest::collection::vec(volume, count))
        .prop_map(|(before, volumes)| [vec![before], volumes.concat()].concat());
    proptest::collection::vec(one, clocks).boxed()
}
