//! A beam machine whose widths, planes and halves are those that a scene requires.
//!
//! A slot without half B is for objects that the viewer is not inside of (no class front); it has no merge and is a
//! clock shorter. Slots with fewer planes are shorter too; the raster flags reach them later, so that all slots hand on
//! the same pixel at the same clock.

use crate::format::{FittedError, Format};
use crate::machine::decider;
pub use crate::slots::FittedSlot;
use crate::{slots, widths};
use imogene_contract::MachineWords;
use serde::{Deserialize, Serialize};

/// The machine.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct FittedMachine {
    /// Widths of all words.
    pub widths: MachineWords,
    /// Rows of the root network between registers.
    pub rows_per_stage: u32,
    /// The slots in the order of their objects.
    pub slots: Vec<FittedSlot>,
}

impl FittedMachine {
    /// The machine of a format of the catalogue: all slots alike, with as many planes as the greatest needs, and with
    /// half B.
    pub fn uniform(format: &Format, objects: usize, planes: u32, rows_per_stage: u32) -> Self {
        let slot = FittedSlot::full(planes);
        FittedMachine {
            widths: format.widths(),
            rows_per_stage,
            slots: vec![slot; objects],
        }
    }

    /// The command line that emits it.
    pub fn command(&self) -> String {
        format!(
            "imogene emit beam --widths {} --slots {} --rows-per-stage {} --out DIR",
            widths::print(&self.widths),
            slots::print(&self.slots),
            self.rows_per_stage
        )
    }

    /// The format of its words, or the word that is out of its range.
    pub fn format(&self) -> Result<Format, FittedError> {
        Format::fitted(&self.widths)
    }

    /// Clocks from `go` to the first pixel: raster control, the longest slot, the decider.
    pub fn latency(&self, format: &Format) -> u32 {
        let slots = self.slots.iter();
        let longest = slots
            .map(|slot| slot.latency(format, self.rows_per_stage))
            .max();
        1 + longest.unwrap_or(0) + decider::latency(self.slots.len())
    }

    /// Clocks of an image: one for each pixel, and the latency.
    pub fn clocks_per_frame(&self, format: &Format, width: u32, height: u32) -> u64 {
        u64::from(width) * u64::from(height) + u64::from(self.latency(format))
    }
}
