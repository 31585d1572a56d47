//! The host of a machine: words over AXI4-Stream.

use super::Machine;
use super::run::{PinsOutcome, PinsRun};
use super::stalls::Stalls;
use imogene_plan::display::Image;

/// The host: the words of the images, one beat after the other.
pub(super) struct Host<'a> {
    images: &'a [Image],
    image: usize,
    beat: usize,
    wait: u64,
    began: Vec<u64>,
    stalls: Stalls,
    late: u64,
}

impl<'a> Host<'a> {
    pub(super) fn new(images: &'a [Image], options: &PinsRun) -> Self {
        Host {
            images,
            image: 0,
            beat: 0,
            wait: options.late,
            began: vec![],
            stalls: Stalls::new(options.stalls),
            late: options.late,
        }
    }

    /// Clocks after which a machine that shows nothing is given up; `frames` are those of the last image.
    pub(super) fn limit(&self, clocks_of_frame: u64, frames: usize) -> u64 {
        let of_image = |image: &Image| {
            let plan = image.plan.iter();
            let passes = plan.flat_map(|plan| {
                let each = u64::from(plan.machine.zone_width * plan.machine.zone_height) + 600;
                let passes = move |zone| plan.passes(zone, false).count() as u64 * each;
                plan.zones.iter().map(passes)
            });
            let words = image.beats.len() as u64 + passes.sum::<u64>() + self.late;
            8 * words + 4 * clocks_of_frame
        };
        let images: u64 = self.images.iter().map(of_image).sum();
        images + (frames as u64 + 16) * clocks_of_frame
    }

    /// The clock of the first word of an image.
    pub(super) fn began(&self, image: usize) -> Option<u64> {
        self.began.get(image).copied()
    }

    /// Sets the stream for the next clock.
    pub(super) fn offer(
        &mut self,
        hardware: &mut Machine,
        is_beam: bool,
        outcome: &mut PinsOutcome,
    ) {
        self.wait = self.wait.saturating_sub(1);
        let image = self.images.get(self.image).filter(|_| self.wait == 0);
        let beat = image.and_then(|image| image.beats.get(self.beat));
        let beat = beat.filter(|_| !self.stalls.stall());
        let is_ready = hardware.is_set("s_tready");
        hardware.offer(beat);
        if is_beam {
            hardware.set("s_tlast", i64::from(beat.is_some_and(|beat| beat.last)));
        }
        if self.beat == 0 && beat.is_some() && self.began.len() == self.image {
            self.began.push(hardware.clocks);
        }
        if let Some(beat) = beat.filter(|_| is_ready) {
            self.beat += 1;
            if beat.last {
                outcome
                    .taking
                    .push(hardware.clocks - self.began[self.image]);
                self.image += 1;
                self.beat = 0;
                self.wait = self.late;
            }
        }
    }
}
