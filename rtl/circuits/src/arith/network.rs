//! A root network of any form.

use super::{
    square_root, square_root_iterative, square_root_leading, square_root_linear,
    square_root_non_restoring, square_root_quadratic,
};
use imogene_contract::{MachineWords, RootForm};
use imogene_hdl::{Bits, Value};

/// The root of a quadric, and the depth that it is for.
#[derive(Clone, Copy, Debug)]
pub struct Network {
    /// Bits of a depth word.
    pub depth: u32,
    /// Digits.
    pub digits: u32,
    /// Leading digits that are computed; the others are zero.
    pub rows: u32,
    /// Rows between registers.
    pub rows_per_stage: u32,
    /// How it is taken.
    pub form: RootForm,
}

impl Network {
    /// That of an object in the words of a machine or of a slot, which may have fewer rows than there are in a stage.
    pub fn of(words: &MachineWords, rows_per_stage: u32) -> Network {
        let rows = words.root - words.dropped_rows;
        Network {
            depth: words.depth,
            digits: words.root,
            rows,
            rows_per_stage: rows_per_stage.min(rows),
            form: words.root_form,
        }
    }

    /// Clocks.
    pub fn latency(&self) -> u32 {
        self.form.latency(self.rows, self.rows_per_stage)
    }

    /// The computed digits of the root of a radicand, which is `valid` on the clocks of pixels. An approximation has no
    /// more of them, because the radicand is below half of what the network takes.
    pub(crate) fn root(&self, at: &str, valid: Bits, radicand: Bits) -> Bits {
        let rows = self.rows_per_stage;
        match self.form {
            RootForm::Restoring => square_root(at, radicand, rows).root,
            RootForm::NonRestoring => square_root_non_restoring(at, radicand, rows).root,
            RootForm::Iterative => square_root_iterative(at, valid, radicand).result.root,
            RootForm::Linear(corrections) => {
                square_root_linear(at, radicand, corrections).low(self.rows)
            }
            RootForm::Quadratic(corrections) => {
                square_root_quadratic(at, radicand, corrections).low(self.rows)
            }
            RootForm::Leading(digits) => square_root_leading(at, radicand, digits, rows),
        }
    }
}
