//! The shadow and light volumes.

use super::Description;
use super::patch::{plane_kind, planes_any_kind};
use super::zone::{Likely, Processor, Reader, Timing, WORDS, golden, held, words};
use crate::stimulus::depth;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::volume::{
    VolumeKind, VolumePlane, VolumeProcessor, VolumeQuadric, VolumeWords, polyhedral_latency,
    quadric_latency,
};
use imogene_golden::unit::interval::Class;
use proptest::prelude::*;

/// The visible depth comes in before the words.
const DEPTH: usize = WORDS;

struct Volume(VolumeProcessor);

impl Processor for Volume {
    fn line_step(&mut self) {
        self.0.line_step();
    }

    fn pixel(&mut self, inputs: &[i64]) -> Vec<i64> {
        vec![i64::from(self.0.pixel(inputs[DEPTH]))]
    }
}

/// The words behind the visible depth, of a volume with a quadric or without.
fn words_of(i: &[i64], planes: usize, has_quadric: bool) -> VolumeWords {
    let mut reader = Reader::new(i);
    let (_depth, margin) = (reader.word(), reader.word() as u32);
    let f = has_quadric.then(|| (reader.linear(), reader.quadratic()));
    let screen_box = reader.screen_box();
    let plane = |_| VolumePlane {
        kind: plane_kind(reader.word()),
        depth: reader.linear(),
    };
    let planes = (0..planes).map(plane).collect();
    let quadric = f.map(|(f1, f2)| VolumeQuadric {
        f1,
        f2,
        class: [Class::Side, Class::Front, Class::Patch, Class::Prism][reader.word() as usize],
        shift: reader.word() as u8,
    });
    // Shadow or light, and whose: the flags behind the processor are told, not the processor.
    VolumeWords {
        kind: VolumeKind::Shadow,
        source: 0,
        screen_box,
        margin,
        quadric,
        planes,
    }
}

pub(super) fn quadric_volume(format: Format, planes: usize, rows_per_stage: usize) -> Description {
    let latency = quadric_latency(&format, rows_per_stage as u32) as usize;
    let timing = Timing {
        entry: latency - 3,
        latency,
    };
    Description {
        golden: golden(timing, 1, move |i| {
            let words = words_of(i, planes, true);
            let processor = VolumeProcessor::zone_start(&words, &format);
            Box::new(Volume(processor))
        }),
        stimulus: points,
    }
}

pub(super) fn polyhedral_volume(format: Format, planes: usize) -> Description {
    Description {
        golden: golden(Timing::of(polyhedral_latency()), 1, move |i| {
            let words = words_of(i, planes, false);
            let processor = VolumeProcessor::zone_start(&words, &format);
            Box::new(Volume(processor))
        }),
        stimulus: points,
    }
}

/// Words held over a zone, and a visible depth that changes every clock: at the parts of the volume, at the ends, or anything.
fn points(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let width = subject.inputs[DEPTH].width;
    let plan = [
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_", Likely::Depth(0)),
        ("depth_shift", Likely::UpTo(8)),
        ("margin", Likely::UpTo((1 << (width - 1)) - 1)),
    ];
    let words = planes_any_kind(words(&subject.inputs, width, &plan), subject);
    let near = 12_000i64.min((1 << (width - 1)) - 1);
    let point = prop_oneof![4 => -near..near, 1 => depth(width)];
    (
        held(words, clocks),
        proptest::collection::vec(point, clocks),
    )
        .prop_map(move |(mut list, points)| {
            for (inputs, point) in list.iter_mut().zip(points) {
                // The golden model takes no more than half the depth word.
                inputs[DEPTH + 1] &= (1 << (width - 1)) - 1;
                inputs[DEPTH] = point;
            }
            list
        })
        .boxed()
}
