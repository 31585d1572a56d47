//! The object processors: each reads its words from the ports in their order, and is tried on zones that reach every
//! branch.

use super::description::Description;
use super::likely::{Likely, even_differences, planned};
use super::zone::{Reader, zone};
use crate::signal::Signal;
use crate::stimulus::word;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::curved_facet::{self, CurvedFacetWords};
use imogene_golden::object::cylinder::{self, CylinderWords};
use imogene_golden::object::facet::{self, FacetWords};
use imogene_golden::object::first_generation::{self, ContourPlane, FirstGenerationWords};
use imogene_golden::object::polyhedron::{self, PolyhedronProcessor, PolyhedronWords};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::sphere::{self, SphereWords};
use imogene_golden::object::{patch, quadric};
use imogene_golden::unit::depth_interval::Class;
use proptest::prelude::*;

/// Depths, face and normal behind `out_valid`, so many clocks after the flags, from the words that `words` reads.
fn object(
    stimulus: impl Fn(&Subject, usize) -> BoxedStrategy<Vec<Inputs>> + Sync + 'static,
    format: Format,
    latency: u32,
    words: impl Fn(&mut Reader) -> ProcessorWords + Clone + Send + Sync + 'static,
) -> Description {
    let words = move |i: &[i64]| words(&mut Reader::new(i));
    zone(stimulus, format, [0, latency], words, |processor, _| {
        let p = processor.pixel();
        let [nx, ny, nz] = p.normal.map(i64::from);
        [p.zf, p.zb, p.number.into(), nx, ny, nz]
    })
}

pub(super) fn facet_processor(format: Format, sides: usize) -> Description {
    let plan = planned(&[("side_", Likely::Line), ("depth_", Likely::Depth(10))]);
    object(plan, format, facet::LATENCY, move |reader| {
        ProcessorWords::Facet(FacetWords {
            screen_box: reader.screen_box(),
            edges: (0..sides).map(|_| reader.linear()).collect(),
            depth: reader.linear(),
            normal: [(); 3].map(|()| reader.linear()),
        })
    })
}

pub(super) fn curved_facet_processor(format: Format, sides: usize) -> Description {
    let plan = planned(&[("side_", Likely::Conic), ("depth_", Likely::Bulge)]);
    object(plan, format, curved_facet::LATENCY, move |reader| {
        ProcessorWords::CurvedFacet(CurvedFacetWords {
            screen_box: reader.screen_box(),
            sides: (0..sides).map(|_| reader.quadratic()).collect(),
            depth: reader.quadratic(),
            normal: [(); 3].map(|()| reader.quadratic()),
        })
    })
}

pub(super) fn sphere_processor(format: Format) -> Description {
    let plan = planned(&[
        ("outline_", Likely::Conic),
        ("front_", Likely::Bulge),
        ("depth_sum", Likely::Depth(1)),
    ]);
    object(plan, format, sphere::LATENCY, |reader| {
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
    let plan = planned(&[
        ("side_", Likely::Line),
        ("disc_", Likely::Conic),
        ("body_", Likely::Bulge),
        ("lid_", Likely::Depth(10)),
    ]);
    object(plan, format, cylinder::LATENCY, |reader| {
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
    let plan = planned(&[
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_0_kind", Likely::Any),
        ("plane_", Likely::Depth(0)),
    ]);
    let latency = patch::latency(&format, rows_per_stage as u32);
    object(plan, format, latency, move |reader| {
        let mut words = reader.quadric();
        words.class = Class::Patch;
        words.planes = reader.planes(planes, false);
        ProcessorWords::Patch(words)
    })
}

pub(super) fn first_generation_processor(format: Format, rows_per_stage: usize) -> Description {
    let plan = planned(&[
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("depth_", Likely::Depth(0)),
        ("conic_", Likely::Conic),
        ("polar_", Likely::Line),
    ]);
    let latency = first_generation::latency(&format, rows_per_stage as u32);
    object(plan, format, latency, |reader| {
        let quadric = reader.quadric();
        let patch = super::description::bit(reader.word());
        let mut planes = [ContourPlane::default(); 2];
        planes.iter_mut().for_each(|p| p.depth = reader.linear());
        planes.iter_mut().for_each(|p| p.conic = reader.quadratic());
        planes.iter_mut().for_each(|p| p.polar = reader.linear());
        planes[0].normal = reader.vector();
        let [front, back] = planes;
        ProcessorWords::FirstGeneration(FirstGenerationWords {
            patch,
            screen_box: quadric.screen_box,
            f1: quadric.f1,
            f2: quadric.f2,
            normal: quadric.normal,
            front,
            back,
        })
    })
}

pub(super) fn polyhedron_processor(format: Format, planes: usize) -> Description {
    let words = move |i: &[i64]| {
        let mut reader = Reader::new(i);
        PolyhedronWords {
            screen_box: reader.screen_box(),
            planes: reader.planes(planes, true),
        }
    };
    // Both faces go on, each with its normal.
    let pixel = |processor: &mut PolyhedronProcessor, _: &[i64]| {
        let p = processor.step(PolyhedronWords::faces_at);
        let ([fx, fy, fz], [bx, by, bz]) = (p.front_normal, p.back_normal);
        let [fx, fy, fz, bx, by, bz] = [fx, fy, fz, bx, by, bz].map(i64::from);
        let (nf, nb) = (p.interval.nf.into(), p.interval.nb.into());
        [p.interval.zf, p.interval.zb, nf, fx, fy, fz, nb, bx, by, bz]
    };
    let plan = planned(&[("plane_", Likely::Depth(0))]);
    zone(plan, format, [0, polyhedron::latency(planes)], words, pixel)
}

pub(super) fn quadric_processor(
    format: Format,
    planes: usize,
    rows_per_stage: usize,
) -> Description {
    let latency = quadric::latency(&format, planes, rows_per_stage as u32);
    let plan = planned(&[
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_", Likely::Depth(0)),
    ]);
    object(plan, format, latency, move |reader| {
        ProcessorWords::Quadric(reader.quadric_processor(planes))
    })
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
