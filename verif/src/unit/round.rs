//! The sphere and the cylinder processor of the first machine.

use super::Description;
use super::zone::{Likely, Reader, Timing, golden, held, words};
use imogene_golden::format::Format;
use imogene_golden::object::cylinder;
use imogene_golden::object::cylinder::{CylinderProcessor, CylinderWords};
use imogene_golden::object::sphere;
use imogene_golden::object::sphere::{SphereProcessor, SphereWords};

pub(super) fn sphere_processor(format: Format) -> Description {
    Description {
        golden: golden(Timing::of(sphere::LATENCY), 6, move |i| {
            let mut reader = Reader::new(i);
            let words = SphereWords {
                screen_box: reader.screen_box(),
                contour: reader.quadratic(),
                front: reader.quadratic(),
                sum: reader.word(),
                normal: [(); 2].map(|()| reader.linear()),
                normal_z: reader.quadratic(),
            };
            Box::new(SphereProcessor::zone_start(&words, &format))
        }),
        stimulus: |subject, clocks| {
            let width = subject.outputs[1].width;
            let plan = [
                ("outline_", Likely::Conic),
                ("front_", Likely::Bulge(width - 2)),
                ("depth_sum", Likely::Depth(1)),
            ];
            held(words(&subject.inputs, width, &plan), clocks)
        },
    }
}

pub(super) fn cylinder_processor(format: Format) -> Description {
    Description {
        golden: golden(Timing::of(cylinder::LATENCY), 6, move |i| {
            let mut reader = Reader::new(i);
            let words = CylinderWords {
                screen_box: reader.screen_box(),
                sides: [(); 4].map(|()| reader.linear()),
                discs: [(); 2].map(|()| reader.quadratic()),
                body: reader.quadratic(),
                normal: [(); 3].map(|()| reader.quadratic()),
                disc: reader.linear(),
                disc_normal: reader.vector(),
            };
            Box::new(CylinderProcessor::zone_start(&words, &format))
        }),
        stimulus: |subject, clocks| {
            let width = subject.outputs[1].width;
            let plan = [
                ("side_", Likely::Line),
                ("disc_", Likely::Conic),
                ("body_", Likely::Bulge(width - 2)),
                ("lid_n", Likely::Any),
                ("lid_", Likely::Depth(10)),
            ];
            held(words(&subject.inputs, width, &plan), clocks)
        },
    }
}
