//! The object processors: each reads its words from the ports in their order, and is tried on zones that reach every
//! branch.

use super::description::Description;
use super::zone::{Likely, Reader, Timing, WORDS, even_differences, held, planned, zone};
use crate::signal::Signal;
use crate::stimulus::word;
use crate::subject::{Inputs, Stimulus, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::curved_facet::{self, CurvedFacetWords};
use imogene_golden::object::cylinder::{self, CylinderWords};
use imogene_golden::object::facet::{self, FacetWords};
use imogene_golden::object::first_generation::{self, ContourPlane, FirstGenerationWords};
use imogene_golden::object::polyhedron::{self, PolyhedronProcessor, PolyhedronWords};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::sphere::{self, SphereWords};
use imogene_golden::object::words::Running;
use imogene_golden::object::{patch, quadric};
use imogene_golden::unit::depth_interval::Class;
use proptest::prelude::*;

/// Depths, face and normal behind `out_valid`, so many clocks after the flags, from the words that `words` reads.
fn object(
    stimulus: Stimulus,
    format: Format,
    latency: u32,
    words: impl Fn(&mut Reader) -> ProcessorWords + Clone + Send + Sync + 'static,
) -> Description {
    let start = move |i: &[i64]| Running::zone_start(&words(&mut Reader::new(i)), &format);
    let pixel = |processor: &mut Running<ProcessorWords>, _: &[i64]| {
        let p = processor.pixel();
        let [nx, ny, nz] = p.normal.map(i64::from);
        vec![p.zf, p.zb, p.number.into(), nx, ny, nz]
    };
    let timing = Timing::of(latency);
    zone(stimulus, timing, 6, start, Running::line_step, pixel)
}

pub(super) fn facet_processor(format: Format, sides: usize) -> Description {
    let stimulus = |subject: &_, clocks| {
        let plan = [("side_", Likely::Line), ("depth_", Likely::Depth(10))];
        planned(subject, clocks, &plan)
    };
    object(stimulus, format, facet::LATENCY, move |reader| {
        ProcessorWords::Facet(FacetWords {
            screen_box: reader.screen_box(),
            edges: (0..sides).map(|_| reader.linear()).collect(),
            depth: reader.linear(),
            normal: [(); 3].map(|()| reader.linear()),
        })
    })
}

pub(super) fn curved_facet_processor(format: Format, sides: usize) -> Description {
    let stimulus = |subject: &_, clocks| {
        let plan = [("side_", Likely::Conic), ("depth_", Likely::Bulge)];
        planned(subject, clocks, &plan)
    };
    object(stimulus, format, curved_facet::LATENCY, move |reader| {
        ProcessorWords::CurvedFacet(CurvedFacetWords {
            screen_box: reader.screen_box(),
            sides: (0..sides).map(|_| reader.quadratic()).collect(),
            depth: reader.quadratic(),
            normal: [(); 3].map(|()| reader.quadratic()),
        })
    })
}

pub(super) fn sphere_processor(format: Format) -> Description {
    let stimulus = |subject: &_, clocks| {
        let plan = [
            ("outline_", Likely::Conic),
            ("front_", Likely::Bulge),
            ("depth_sum", Likely::Depth(1)),
        ];
        planned(subject, clocks, &plan)
    };
    object(stimulus, format, sphere::LATENCY, |reader| {
        ProcessorWords::Sphere(SphereWords {
            screen_box: reader.screen_box(),
            contour: reader.quadratic(),
            front: reader.quadratic(),
            sum: reader.word(),
            normal: [(); 2].map(|()| reader.linear()),
            normal_z: reader.quadratic(),
        })
    })
}

pub(super) fn cylinder_processor(format: Format) -> Description {
    let stimulus = |subject: &_, clocks| {
        let plan = [
            ("side_", Likely::Line),
            ("disc_", Likely::Conic),
            ("body_", Likely::Bulge),
            ("lid_n", Likely::Any),
            ("lid_", Likely::Depth(10)),
        ];
        planned(subject, clocks, &plan)
    };
    object(stimulus, format, cylinder::LATENCY, |reader| {
        ProcessorWords::Cylinder(CylinderWords {
            screen_box: reader.screen_box(),
            sides: [(); 4].map(|()| reader.linear()),
            discs: [(); 2].map(|()| reader.quadratic()),
            body: reader.quadratic(),
            normal: [(); 3].map(|()| reader.quadratic()),
            disc: reader.linear(),
            disc_normal: reader.vector(),
        })
    })
}

pub(super) fn patch_processor(format: Format, planes: usize, rows_per_stage: usize) -> Description {
    let stimulus = |subject: &_, clocks| {
        let plan = [
            ("f1_", Likely::Depth(0)),
            ("f2_", Likely::Conic),
            ("plane_0_kind", Likely::Any),
            ("plane_", Likely::Depth(0)),
        ];
        planned(subject, clocks, &plan)
    };
    let latency = patch::latency(&format, rows_per_stage as u32);
    object(stimulus, format, latency, move |reader| {
        let mut words = reader.quadric();
        words.class = Class::Patch;
        words.planes = reader.planes(planes, false);
        ProcessorWords::Patch(words)
    })
}

pub(super) fn first_generation_processor(format: Format, rows_per_stage: usize) -> Description {
    let stimulus = |subject: &_, clocks| {
        let plan = [
            ("f1_", Likely::Depth(0)),
            ("f2_", Likely::Conic),
            ("depth_", Likely::Depth(0)),
            ("conic_", Likely::Conic),
            ("polar_", Likely::Line),
        ];
        planned(subject, clocks, &plan)
    };
    let latency = first_generation::latency(&format, rows_per_stage as u32);
    object(stimulus, format, latency, |reader| {
        let quadric = reader.quadric();
        let patch = super::description::bit(reader.word());
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
        ProcessorWords::FirstGeneration(FirstGenerationWords {
            patch,
            screen_box: quadric.screen_box,
            f1: quadric.f1,
            f2: quadric.f2,
            normal: quadric.normal,
            front: plane(0),
            back: plane(1),
        })
    })
}

pub(super) fn polyhedron_processor(format: Format, planes: usize) -> Description {
    let stimulus = |subject: &_, clocks| {
        let normals: Vec<String> = (0..12).map(|i| format!("plane_{i}_n")).collect();
        let normals = normals.iter().map(|prefix| (prefix.as_str(), Likely::Any));
        let plan: Vec<_> = normals.chain([("plane_", Likely::Depth(0))]).collect();
        planned(subject, clocks, &plan)
    };
    let start = move |i: &[i64]| {
        let mut reader = Reader::new(i);
        let words = PolyhedronWords {
            screen_box: reader.screen_box(),
            planes: reader.planes(planes, true),
        };
        PolyhedronProcessor::zone_start(&words, &format)
    };
    // Both faces go on, each with its normal.
    let pixel = |processor: &mut PolyhedronProcessor, _: &[i64]| {
        let p = processor.step(PolyhedronWords::faces_at);
        let [front, back] = [p.front_normal, p.back_normal].map(|normal| normal.map(i64::from));
        let depths = [p.interval.zf, p.interval.zb, p.interval.nf.into()];
        [&depths[..], &front, &[p.interval.nb.into()], &back].concat()
    };
    let timing = Timing::of(polyhedron::latency(planes));
    zone(
        stimulus,
        timing,
        10,
        start,
        PolyhedronProcessor::line_step,
        pixel,
    )
}

pub(super) fn quadric_processor(
    format: Format,
    planes: usize,
    rows_per_stage: usize,
) -> Description {
    let latency = quadric::latency(&format, planes, rows_per_stage as u32);
    object(quadrics, format, latency, move |reader| {
        ProcessorWords::Quadric(reader.quadric_processor(planes))
    })
}

/// Full-range words, or a plausible object whose depths, silhouette and planes meet on the zone.
fn quadrics(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let ports = &subject.inputs[WORDS..];
    let any_words: Vec<_> = ports.iter().map(word).collect();
    let any_words = even_differences(ports, any_words.boxed());
    held(
        prop_oneof![1 => any_words, 4 => plausible(ports)].boxed(),
        clocks,
    )
}

/// Words of an object about the middle of a small zone: depths of a few thousand units, planes through them.
pub(super) fn plausible(ports: &[Signal]) -> BoxedStrategy<Vec<i64>> {
    let one = |signal: &Signal| -> BoxedStrategy<i64> {
        let spread = |range: i64| (-range..=range).boxed();
        match signal.name.as_str() {
            "f1_a" | "f1_b" => spread(300),
            "f1_c" => spread(20_000),
            "f2_a2" | "f2_b2" => spread(1 << 18),
            "f2_c" => spread(1 << 16),
            "f2_i0" | "f2_p0" => spread(1 << 22),
            "f2_f" => spread(1 << 26),
            "box_x0" | "box_y0" => (0i64..4).boxed(),
            "box_x1" | "box_y1" => (4i64..30).boxed(),
            "shift" => (0i64..3).boxed(),
            name if name.ends_with("_a") || name.ends_with("_b") => spread(2_000),
            name if name.starts_with("plane_") && name.ends_with("_c") => spread(20_000),
            _ => word(signal),
        }
    };
    let words: Vec<_> = ports.iter().map(one).collect();
    even_differences(ports, words.boxed())
}
