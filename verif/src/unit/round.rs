//! The sphere and the cylinder processor of the first machine.

use super::Description;
use super::zone::{
    Likely, Processor, Reader, Timing, box_ports, golden, held, linear_ports, object_outputs,
    object_values, quadratic_ports, raster_ports, words,
};
use crate::signal::Signal;
use imogene_models::format::Format;
use imogene_models::object::cylinder::{self, CylinderProcessor, CylinderWords};
use imogene_models::object::sphere::{self, SphereProcessor, SphereWords};

impl Processor for SphereProcessor {
    fn line_step(&mut self) {
        SphereProcessor::line_step(self);
    }

    fn pixel(&mut self, _inputs: &[i64]) -> Vec<i64> {
        object_values(&SphereProcessor::pixel(self))
    }
}

impl Processor for CylinderProcessor {
    fn line_step(&mut self) {
        CylinderProcessor::line_step(self);
    }

    fn pixel(&mut self, _inputs: &[i64]) -> Vec<i64> {
        object_values(&CylinderProcessor::pixel(self))
    }
}

pub(super) fn sphere_processor(format: Format) -> Description {
    let mut inputs = raster_ports();
    inputs.extend(box_ports());
    inputs.extend(quadratic_ports("outline", format.quadratic));
    inputs.extend(quadratic_ports("front", format.quadratic));
    inputs.push(Signal::signed("depth_sum", format.sum));
    inputs.extend(linear_ports("nx", format.normal_linear));
    inputs.extend(linear_ports("ny", format.normal_linear));
    inputs.extend(quadratic_ports("nz", format.quadratic));
    Description {
        name: "sphere_processor".into(),
        inputs,
        outputs: object_outputs(format.depth),
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
    let mut inputs = raster_ports();
    inputs.extend(box_ports());
    for i in 0..4 {
        inputs.extend(linear_ports(&format!("side_{i}"), format.plane));
    }
    for i in 0..2 {
        inputs.extend(quadratic_ports(&format!("disc_{i}"), format.quadratic));
    }
    for name in ["body", "nx", "ny", "nz"] {
        inputs.extend(quadratic_ports(name, format.quadratic));
    }
    inputs.extend(linear_ports("lid", format.plane));
    inputs.extend(["lid_nx", "lid_ny", "lid_nz"].map(|name| Signal::signed(name, 16)));
    Description {
        name: "cylinder_processor".into(),
        inputs,
        outputs: object_outputs(format.depth),
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
