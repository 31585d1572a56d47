//! The shadow and light volumes.

use super::Description;
use super::patch::{plane_kind, plane_ports, planes_any_kind};
use super::zone::{
    Likely, Processor, Reader, Timing, box_ports, golden, held, linear_ports, quadratic_ports,
    raster_ports, words,
};
use crate::signal::Signal;
use crate::stimulus::depth;
use crate::subject::{Inputs, Subject};
use imogene_models::format::Format;
use imogene_models::object::volume::{
    VolumeKind, VolumePlane, VolumeProcessor, VolumeQuadric, VolumeWords, polyhedral_latency,
    quadric_latency,
};
use imogene_models::unit::interval::Class;
use proptest::prelude::*;

/// Where the visible depth comes in, behind all words.
struct Volume {
    processor: VolumeProcessor,
    depth: usize,
}

impl Processor for Volume {
    fn line_step(&mut self) {
        self.processor.line_step();
    }

    fn pixel(&mut self, inputs: &[i64]) -> Vec<i64> {
        vec![i64::from(self.processor.pixel(inputs[self.depth]))]
    }
}

/// What a volume needs besides its quadric.
fn common_ports(format: &Format, planes: usize) -> Vec<Signal> {
    let mut ports = vec![Signal::unsigned("margin", format.depth)];
    ports.extend(plane_ports(format, planes, false));
    ports.push(Signal::signed("depth", format.depth));
    ports
}

fn words_of(reader: &mut Reader, quadric: Option<VolumeQuadric>, planes: usize) -> VolumeWords {
    // Shadow or light, and whose: the flags behind the processor are told, not the processor.
    VolumeWords {
        kind: VolumeKind::Shadow,
        source: 0,
        screen_box: reader.screen_box(),
        margin: reader.word() as u32,
        quadric,
        planes: (0..planes)
            .map(|_| VolumePlane {
                kind: plane_kind(reader.word()),
                depth: reader.linear(),
            })
            .collect(),
    }
}

fn outputs() -> Vec<Signal> {
    vec![Signal::bit("out_valid"), Signal::bit("is_inside")]
}

pub(super) fn quadric_volume(format: Format, planes: usize, rows_per_stage: usize) -> Description {
    let mut inputs = raster_ports();
    inputs.extend(linear_ports("f1", format.sum));
    inputs.extend(quadratic_ports("f2", format.quadratic));
    inputs.push(Signal::unsigned("object_class", 2));
    inputs.push(Signal::unsigned("depth_shift", 4));
    inputs.extend(box_ports());
    inputs.extend(common_ports(&format, planes));
    let depth = inputs.len() - 1;
    let latency = quadric_latency(&format, rows_per_stage as u32) as usize;
    let timing = Timing {
        entry: latency - 3,
        latency,
    };
    Description {
        name: "quadric_volume".into(),
        inputs,
        outputs: outputs(),
        golden: golden(timing, 1, move |i| {
            let mut reader = Reader::new(i);
            let (f1, f2) = (reader.linear(), reader.quadratic());
            let class = reader.word() as usize;
            let quadric = VolumeQuadric {
                class: [Class::Side, Class::Front, Class::Patch, Class::Prism][class],
                f1,
                f2,
                shift: reader.word() as u8,
            };
            let words = words_of(&mut reader, Some(quadric), planes);
            let processor = VolumeProcessor::zone_start(&words, &format);
            Box::new(Volume { processor, depth })
        }),
        stimulus: points,
    }
}

pub(super) fn polyhedral_volume(format: Format, planes: usize) -> Description {
    let mut inputs = raster_ports();
    inputs.extend(box_ports());
    inputs.extend(common_ports(&format, planes));
    let depth = inputs.len() - 1;
    Description {
        name: "polyhedral_volume".into(),
        inputs,
        outputs: outputs(),
        golden: golden(Timing::of(polyhedral_latency()), 1, move |i| {
            let mut reader = Reader::new(i);
            let words = words_of(&mut reader, None, planes);
            let processor = VolumeProcessor::zone_start(&words, &format);
            Box::new(Volume { processor, depth })
        }),
        stimulus: points,
    }
}

/// Words held over a zone, and a visible depth that changes every clock: at the parts of the volume, at the ends, or anything.
fn points(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let last = subject.inputs.len() - 1;
    let width = subject.inputs[last].width;
    let plan = [
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_", Likely::Depth(0)),
        ("depth_shift", Likely::UpTo(8)),
        ("margin", Likely::UpTo((1 << (width - 1)) - 1)),
    ];
    let words = planes_any_kind(words(&subject.inputs, width, &plan), subject);
    // The golden model takes no more than half the depth word.
    let margin = subject.inputs.iter().position(|port| port.name == "margin");
    let margin = margin.expect("a volume has a margin");
    let point = prop_oneof![4 => -12_000i64..12_000, 1 => depth(width)];
    (
        held(words, clocks),
        proptest::collection::vec(point, clocks),
    )
        .prop_map(move |(mut list, points)| {
            for (inputs, point) in list.iter_mut().zip(points) {
                inputs[margin] &= (1 << (width - 1)) - 1;
                inputs[last] = point;
            }
            list
        })
        .boxed()
}
