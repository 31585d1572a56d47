//! The flat and the non-planar facet processor.

use super::Description;
use super::zone::{Likely, Reader, Timing, golden, held, words};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::curved_facet;
use imogene_golden::object::curved_facet::{CurvedFacetProcessor, CurvedFacetWords};
use imogene_golden::object::facet;
use imogene_golden::object::facet::{FacetProcessor, FacetWords};
use proptest::prelude::*;

pub(super) fn facet_processor(format: Format, sides: usize) -> Description {
    Description {
        golden: golden(Timing::of(facet::LATENCY), 6, move |i| {
            let mut reader = Reader::new(i);
            let words = FacetWords {
                screen_box: reader.screen_box(),
                edges: (0..sides).map(|_| reader.linear()).collect(),
                depth: reader.linear(),
                normal: [(); 3].map(|()| reader.linear()),
            };
            Box::new(FacetProcessor::zone_start(&words, &format))
        }),
        stimulus: |subject, clocks| {
            let plan = [("side_", Likely::Line), ("depth_", Likely::Depth(10))];
            zones(subject, clocks, &plan)
        },
    }
}

pub(super) fn curved_facet_processor(format: Format, sides: usize) -> Description {
    Description {
        golden: golden(Timing::of(curved_facet::LATENCY), 6, move |i| {
            let mut reader = Reader::new(i);
            let words = CurvedFacetWords {
                screen_box: reader.screen_box(),
                sides: (0..sides).map(|_| reader.quadratic()).collect(),
                depth: reader.quadratic(),
                normal: [(); 3].map(|()| reader.quadratic()),
            };
            Box::new(CurvedFacetProcessor::zone_start(&words, &format))
        }),
        stimulus: |subject, clocks| {
            let guard = subject.outputs[1].width - 2;
            let plan = [("side_", Likely::Conic), ("depth_", Likely::Bulge(guard))];
            zones(subject, clocks, &plan)
        },
    }
}

fn zones(subject: &Subject, clocks: usize, plan: &[(&str, Likely)]) -> BoxedStrategy<Vec<Inputs>> {
    held(
        words(&subject.inputs, subject.outputs[1].width, plan),
        clocks,
    )
}
