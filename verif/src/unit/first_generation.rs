//! The quadric processor of the first generation.

use super::patch::quadric_words;
use super::zone::{Likely, Reader, Timing, golden, held, words};
use super::{Description, bit};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::first_generation::{
    ContourPlane, FirstGenerationProcessor, FirstGenerationWords, latency,
};
use imogene_golden::unit::interval::Class;
use proptest::prelude::*;

fn words_of(i: &[i64]) -> FirstGenerationWords {
    let mut reader = Reader::new(i);
    let quadric = quadric_words(&mut reader, Class::Side);
    let patch = bit(reader.word());
    let depths = [(); 2].map(|()| reader.linear());
    let conics = [(); 2].map(|()| reader.quadratic());
    let polars = [(); 2].map(|()| reader.linear());
    let normals = [(); 2].map(|()| reader.vector());
    let plane = |side: usize| ContourPlane {
        depth: depths[side],
        conic: conics[side],
        polar: polars[side],
        normal: normals[side],
    };
    FirstGenerationWords {
        patch,
        screen_box: quadric.screen_box,
        f1: quadric.f1,
        f2: quadric.f2,
        normal: quadric.normal,
        front: plane(0),
        back: plane(1),
    }
}

pub(super) fn first_generation_processor(format: Format, rows_per_stage: usize) -> Description {
    let timing = Timing::of(latency(&format, rows_per_stage as u32));
    Description {
        golden: golden(timing, 6, move |i| {
            Box::new(FirstGenerationProcessor::zone_start(&words_of(i), &format))
        }),
        stimulus: quadrics,
    }
}

fn quadrics(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let plan = [
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("depth_", Likely::Depth(0)),
        ("conic_", Likely::Conic),
        ("polar_", Likely::Line),
    ];
    held(
        words(&subject.inputs, subject.outputs[1].width, &plan),
        clocks,
    )
}
