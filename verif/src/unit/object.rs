//! The object processors, each tried on zones that reach every branch.

use super::description::Description;
use super::likely::{Likely, even_differences, planned};
use super::words::Ports;
use super::zone::zone;
use crate::signal::Signal;
use crate::stimulus::word;
use imogene_golden::format::Format;
use imogene_golden::object::curved_facet::{self, CurvedFacetWords};
use imogene_golden::object::cylinder::{self, CylinderWords};
use imogene_golden::object::facet::{self, FacetWords};
use imogene_golden::object::first_generation::{self, FirstGenerationWords};
use imogene_golden::object::patch;
use imogene_golden::object::polyhedron::{self, PolyhedronWords};
use imogene_golden::object::quadric::{self, PlaneWords, QuadricWords};
use imogene_golden::object::quotient::{self, QuotientWords};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::sphere::{self, SphereWords};
use imogene_golden::object::words::Object;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

/// Depths, face and normal behind `out_valid`, so many clocks after the flags; its words have the shape of these, and
/// are likely what the plan says.
fn object(
    format: Format,
    latency: u32,
    plan: &'static [(&str, Likely)],
    words: ProcessorWords,
) -> Description {
    let pixel = |words: &ProcessorWords, [x, y]: [i64; 2], format: &Format, _: &[i64]| {
        let p = words.at(x, y, format);
        let [nx, ny, nz] = p.normal.map(i64::from);
        [p.zf, p.zb, p.number.into(), nx, ny, nz]
    };
    let plan = planned(plan);
    zone(plan, format, [0, latency], words, Ports::processor, pixel)
}

pub(super) fn facet_processor(format: Format, sides: usize) -> Description {
    let plan = &[("side_", Likely::Line), ("depth_", Likely::Depth(10))];
    let words = FacetWords {
        edges: vec![Linear::default(); sides],
        ..FacetWords::default()
    };
    object(format, facet::LATENCY, plan, ProcessorWords::Facet(words))
}

pub(super) fn curved_facet_processor(format: Format, sides: usize) -> Description {
    let plan = &[("side_", Likely::Conic), ("depth_", Likely::Bulge)];
    let words = ProcessorWords::CurvedFacet(CurvedFacetWords {
        sides: vec![Quadratic::default(); sides],
        ..CurvedFacetWords::default()
    });
    object(format, curved_facet::LATENCY, plan, words)
}

pub(super) fn sphere_processor(format: Format) -> Description {
    let plan = &[
        ("outline_", Likely::Conic),
        ("front_", Likely::Bulge),
        ("depth_sum", Likely::Depth(1)),
    ];
    let words = ProcessorWords::Sphere(SphereWords::default());
    object(format, sphere::LATENCY, plan, words)
}

pub(super) fn cylinder_processor(format: Format) -> Description {
    let plan = &[
        ("side_", Likely::Line),
        ("disc_", Likely::Conic),
        ("body_", Likely::Bulge),
        ("lid_", Likely::Depth(10)),
    ];
    let words = ProcessorWords::Cylinder(CylinderWords::default());
    object(format, cylinder::LATENCY, plan, words)
}

/// Of a quadric with so many planes.
pub(super) fn quadric_words(class: Class, planes: usize) -> QuadricWords {
    QuadricWords {
        class,
        planes: vec![PlaneWords::default(); planes],
        ..QuadricWords::default()
    }
}

pub(super) fn patch_processor(format: Format, planes: usize, rows_per_stage: usize) -> Description {
    let plan = &[
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_0_kind", Likely::Any),
        ("plane_", Likely::Depth(0)),
    ];
    let latency = patch::latency(&format, rows_per_stage as u32);
    let words = ProcessorWords::Patch(quadric_words(Class::Patch, planes));
    object(format, latency, plan, words)
}

pub(super) fn first_generation_processor(format: Format, rows_per_stage: usize) -> Description {
    let plan = &[
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("depth_", Likely::Depth(0)),
        ("conic_", Likely::Conic),
        ("polar_", Likely::Line),
    ];
    let latency = first_generation::latency(&format, rows_per_stage as u32);
    let words = ProcessorWords::FirstGeneration(FirstGenerationWords::default());
    object(format, latency, plan, words)
}

pub(super) fn polyhedron_processor(format: Format, planes: usize) -> Description {
    // Both faces go on, each with its normal.
    let pixel = |words: &PolyhedronWords, [x, y]: [i64; 2], format: &Format, _: &[i64]| {
        let p = words.faces_at(x, y, format);
        let ([fx, fy, fz], [bx, by, bz]) = (p.front_normal, p.back_normal);
        let [fx, fy, fz, bx, by, bz] = [fx, fy, fz, bx, by, bz].map(i64::from);
        let (nf, nb) = (p.interval.nf.into(), p.interval.nb.into());
        [p.interval.zf, p.interval.zb, nf, fx, fy, fz, nb, bx, by, bz]
    };
    let plan = planned(&[("plane_", Likely::Depth(0))]);
    let clocks = [0, polyhedron::latency(planes)];
    let words = PolyhedronWords {
        planes: vec![PlaneWords::default(); planes],
        ..PolyhedronWords::default()
    };
    zone(plan, format, clocks, words, Ports::polyhedron, pixel)
}

pub(super) fn quadric_processor(
    format: Format,
    planes: usize,
    rows_per_stage: usize,
) -> Description {
    let latency = quadric::latency(&format, planes, rows_per_stage as u32);
    let plan = &[
        ("f1_", Likely::Depth(0)),
        ("f2_", Likely::Conic),
        ("plane_", Likely::Depth(0)),
    ];
    let words = ProcessorWords::Quadric(quadric_words(Class::Side, planes));
    object(format, latency, plan, words)
}

pub(super) fn quotient_processor(
    format: Format,
    planes: usize,
    rows_per_stage: usize,
) -> Description {
    let latency = quotient::latency(&format, planes, rows_per_stage as u32);
    // About as many units as half a depth word has, over a denominator of a few hundred.
    let plan = &[
        ("numerator_", Likely::Bulge),
        ("denominator_", Likely::Line),
        ("plane_", Likely::Depth(0)),
    ];
    let words = ProcessorWords::Quotient(QuotientWords {
        planes: vec![PlaneWords::default(); planes],
        ..QuotientWords::default()
    });
    object(format, latency, plan, words)
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
