//! The polyhedron processor.

use super::Description;
use super::patch::{plane_kind, planes_any_kind};
use super::zone::{Likely, Processor, Reader, Timing, golden, held, words};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::polyhedron::{
    PolyhedronPixel, PolyhedronProcessor, PolyhedronWords, latency,
};
use imogene_golden::object::quadric::PlaneWords;
use proptest::prelude::*;

struct Solid(PolyhedronProcessor);

impl Processor for Solid {
    fn line_step(&mut self) {
        self.0.line_step();
    }

    fn pixel(&mut self, _inputs: &[i64]) -> Vec<i64> {
        let PolyhedronPixel {
            interval,
            front_normal,
            back_normal,
        } = self.0.step(PolyhedronWords::faces_at);
        let mut values = vec![interval.zf, interval.zb, interval.nf.into()];
        values.extend(front_normal.map(i64::from));
        values.push(interval.nb.into());
        values.extend(back_normal.map(i64::from));
        values
    }
}

pub(super) fn polyhedron_processor(format: Format, planes: usize) -> Description {
    Description {
        golden: golden(Timing::of(latency(planes)), 10, move |i| {
            let mut reader = Reader::new(i);
            let screen_box = reader.screen_box();
            let mut plane = || PlaneWords {
                kind: plane_kind(reader.word()),
                depth: reader.linear(),
                normal: reader.vector(),
            };
            let words = PolyhedronWords {
                screen_box,
                planes: (0..planes).map(|_| plane()).collect(),
            };
            Box::new(Solid(PolyhedronProcessor::zone_start(&words, &format)))
        }),
        stimulus: solids,
    }
}

fn solids(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let mut plan = Vec::new();
    let normals: Vec<String> = (0..12).map(|i| format!("plane_{i}_n")).collect();
    plan.extend(normals.iter().map(|prefix| (prefix.as_str(), Likely::Any)));
    plan.push(("plane_", Likely::Depth(0)));
    let words = words(&subject.inputs, subject.outputs[1].width, &plan);
    held(planes_any_kind(words, subject), clocks)
}
