//! The patch processor and its decider.

use super::Description;
use super::normal::normal_words;
use super::zone::{Likely, Processor, Reader, Timing, golden, held, object_values, words};
use super::{Late, bit};
use crate::stimulus::depth;
use crate::subject::{GoldenFn, Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::patch::{at, latency};
use imogene_golden::object::quadric::{PlaneWords, QuadricProcessor, QuadricWords};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::interval::Class;
use imogene_golden::unit::patch_decider::{Faces, decide, kept, visible};
use proptest::prelude::*;

/// How a plane lies, by its word.
pub(super) fn plane_kind(word: i64) -> PlaneKind {
    use PlaneKind::{Back, Front, None, Perpendicular};
    [None, Front, Back, Perpendicular][word as usize]
}

/// f1, f2, the normal and the screen box, in this order, without planes.
pub(super) fn quadric_words(reader: &mut Reader, class: Class) -> QuadricWords {
    let (f1, f2) = (reader.linear(), reader.quadratic());
    let normal: Vec<i64> = (0..12).map(|_| reader.word()).collect();
    let screen_box = reader.screen_box();
    QuadricWords {
        class,
        screen_box,
        f1,
        f2,
        normal: normal_words(&normal, reader.word()),
        planes: vec![],
    }
}

struct Patch(QuadricProcessor);

impl Processor for Patch {
    fn line_step(&mut self) {
        self.0.line_step();
    }

    fn pixel(&mut self, _inputs: &[i64]) -> Vec<i64> {
        object_values(&self.0.step(at))
    }
}

pub(super) fn patch_processor(format: Format, planes: usize, rows_per_stage: usize) -> Description {
    let timing = Timing::of(latency(&format, rows_per_stage as u32));
    Description {
        golden: golden(timing, 6, move |i| {
            let mut reader = Reader::new(i);
            let mut words = quadric_words(&mut reader, Class::Patch);
            words.planes = (0..planes)
                .map(|_| PlaneWords {
                    kind: plane_kind(reader.word()),
                    depth: reader.linear(),
                    normal: [0; 3],
                })
                .collect();
            Box::new(Patch(QuadricProcessor::zone_start(&words, &format)))
        }),
        stimulus: patches,
    }
}

fn patches(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let depth_word = subject.outputs[1].width;
    let plan = [
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_0_kind", Likely::Any),
        ("plane_", Likely::Depth(0)),
    ];
    held(
        planes_any_kind(words(&subject.inputs, depth_word, &plan), subject),
        clocks,
    )
}

/// The same words, the kinds of all planes drawn evenly.
pub(super) fn planes_any_kind(
    words: BoxedStrategy<Inputs>,
    subject: &Subject,
) -> BoxedStrategy<Inputs> {
    let kinds: Vec<usize> = (super::zone::WORDS..subject.inputs.len())
        .filter(|k| subject.inputs[*k].name.ends_with("_kind"))
        .map(|k| k - super::zone::WORDS)
        .collect();
    (words, proptest::collection::vec(0i64..4, kinds.len()))
        .prop_map(move |(mut words, drawn)| {
            kinds
                .iter()
                .zip(drawn)
                .for_each(|(k, kind)| words[*k] = kind);
            words
        })
        .boxed()
}

/// Ports of the decider before those of the planes.
const DECIDER_PORTS: usize = 4;

pub(super) fn patch_decider(format: Format) -> Description {
    Description {
        golden: Box::new(move || {
            let mut late = Late::new(2);
            Box::new(GoldenFn(move |i: &[i64]| {
                let (near, far) = (i[0], i[1]);
                let there = visible(near, far, bit(i[2]) && bit(i[3]), &format);
                let left = i[DECIDER_PORTS..]
                    .chunks(2)
                    .map(|plane| kept(plane_kind(plane[0]), plane[1], near, far))
                    .fold(there, Faces::and);
                match late.push(decide(near, far, left, &format)) {
                    Some(face) => vec![Some(face.zf), Some(face.zb), Some(face.nf.into())],
                    None => vec![None; 3],
                }
            }))
        }),
        stimulus: decisions,
    }
}

/// Roots and planes on a few levels about zero and about both ends, so that ties are common.
fn decisions(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let width = subject.outputs[0].width;
    let sum = || prop_oneof![8 => depth(width), 1 => crate::stimulus::word(&subject.inputs[0])];
    let often = || prop_oneof![6 => Just(1i64), 1 => Just(0)];
    let planes = (subject.inputs.len() - DECIDER_PORTS) / 2;
    let plane = || (0i64..4, depth(width));
    let one = (
        sum(),
        sum(),
        often(),
        often(),
        proptest::collection::vec(plane(), planes),
    )
        .prop_map(|(a, b, inside, there, planes)| {
            let mut inputs = vec![a.min(b), a.max(b), inside, there];
            inputs.extend(planes.into_iter().flat_map(|(kind, zp)| [kind, zp]));
            inputs
        });
    proptest::collection::vec(one, clocks).boxed()
}
