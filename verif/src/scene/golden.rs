//! The golden machine pixel by pixel, with the values inside its processors.

use imogene_golden::format::Format;
use imogene_golden::machine::decider::{Visible, decide};
use imogene_golden::object::quadric::{Probe, QuadricWords};
use imogene_golden::object::words::Object;

/// All objects of a machine over one zone.
pub(crate) struct GoldenMachine {
    objects: Vec<QuadricWords>,
    format: Format,
    width: usize,
    /// Pixels before the next one.
    done: usize,
}

impl GoldenMachine {
    pub(crate) fn new(objects: &[QuadricWords], format: &Format, width: usize) -> GoldenMachine {
        GoldenMachine {
            objects: objects.to_vec(),
            format: *format,
            width,
            done: 0,
        }
    }

    /// What is seen at the next pixel, and the values inside the processor of `traced`.
    pub(crate) fn pixel(&mut self, traced: Option<usize>) -> (Visible, Option<Probe>) {
        let [x, y] = [self.done % self.width, self.done / self.width].map(|place| place as i64);
        self.done += 1;
        let mut probe = None;
        let visible = |(id, words): (usize, &QuadricWords)| {
            let output = if traced == Some(id) {
                probe.insert(words.probe_at(x, y, &self.format)).output
            } else {
                words.at(x, y, &self.format)
            };
            Visible::of(&output, id as u8)
        };
        let objects = self.objects.iter().enumerate();
        let inputs: Vec<Visible> = objects.map(visible).collect();
        (decide(&inputs), probe)
    }
}

/// The values of a probe in the order of [`crate::engine::processor_signals`].
pub(super) fn probe_values(p: &Probe) -> Vec<i64> {
    let depths = &p.depths;
    let mut list = vec![depths.f2, depths.f1, depths.root, depths.near, depths.far];
    list.extend(&p.plane);
    let [nx, ny, nz] = p.output.normal.map(i64::from);
    list.extend([p.merged.zf, p.merged.zb, p.merged.nf.into()]);
    list.extend([p.output.zf, p.output.zb, p.output.number.into(), nx, ny, nz]);
    list
}
