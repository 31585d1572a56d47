//! The golden machine pixel by pixel, with the values inside its processors.

use imogene_golden::format::Format;
use imogene_golden::machine::decider::{Visible, decide};
use imogene_golden::object::quadric::{Probe, QuadricProcessor, QuadricWords};

/// All objects of a machine over one zone.
pub(crate) struct GoldenMachine {
    processors: Vec<QuadricProcessor>,
    width: usize,
    column: usize,
}

impl GoldenMachine {
    /// Zone start.
    pub(crate) fn new(objects: &[QuadricWords], format: &Format, width: usize) -> GoldenMachine {
        let processors = objects.iter();
        let processors = processors.map(|words| QuadricProcessor::zone_start(words, format));
        GoldenMachine {
            processors: processors.collect(),
            width,
            column: 0,
        }
    }

    /// What is seen at the next pixel, and the values inside the processor of `traced`.
    pub(crate) fn pixel(&mut self, traced: Option<usize>) -> (Visible, Option<Probe>) {
        if self.column == self.width {
            self.column = 0;
            let processors = self.processors.iter_mut();
            processors.for_each(QuadricProcessor::line_step);
        }
        self.column += 1;
        let mut probe = None;
        let visible = |(id, processor): (usize, &mut QuadricProcessor)| {
            let output = if traced == Some(id) {
                probe.insert(processor.probe()).output
            } else {
                processor.pixel()
            };
            Visible::of(&output, id as u8)
        };
        let processors = self.processors.iter_mut().enumerate();
        let inputs: Vec<Visible> = processors.map(visible).collect();
        (decide(&inputs), probe)
    }
}

/// The values of a probe in the order of [`crate::engine::processor_signals`].
pub(super) fn probe_values(p: &Probe) -> Vec<i64> {
    let (a, b) = &p.halves;
    let mut list = vec![p.f2, p.f1, p.root, p.near, p.far, a.zf, a.zb, b.zf, b.zb];
    for (plane, (a, b)) in p.plane.iter().zip(&p.cut) {
        list.extend([*plane, a.zf, a.zb, b.zf, b.zb]);
    }
    let [nx, ny, nz] = p.output.normal.map(i64::from);
    list.extend([p.merged.zf, p.merged.zb, p.merged.nf.into()]);
    list.extend([p.output.zf, p.output.zb, p.output.number.into(), nx, ny, nz]);
    list
}
