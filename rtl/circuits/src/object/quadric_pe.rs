//! The two depths of a quadric.

use crate::arith::{
    square_root, square_root_leading, square_root_linear, square_root_non_restoring,
    square_root_quadratic,
};
use crate::raster::{Flags, Linear, Quadratic, pe1, pe2};
use imogene_contract::words::depth_sum;
use imogene_contract::{MachineWords, RootForm};
use imogene_hdl::{Bits, Bundle, Value, bundle, module, net};

bundle! {
    /// Both depths, as far as f2 is not negative.
    Depths(sum, root) {
        near_sum: Int(sum), "f1 - r, modulo its width";
        far_sum: Int(sum), "f1 + r, modulo its width";
        root: Bits(root), "r = floor(sqrt(f2)), with the sums";
        is_inside: Bits(1), "f2 >= 0; where it is low the sums and the root mean nothing";
    }
}

/// Depths and root of a quadric.
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

    /// The computed digits of the root. An approximation has no more of them where f2 is not negative, because its
    /// radicand is below half of what the network takes.
    fn root(&self, at: &str, radicand: Bits) -> Bits {
        let rows = self.rows_per_stage;
        match self.form {
            RootForm::Restoring => square_root(at, radicand, rows).root,
            RootForm::NonRestoring => square_root_non_restoring(at, radicand, rows).root,
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

/// `f1 - r` and `f1 + r` with `r = floor(sqrt(f2))`, or an approximation: a PE2, the root network behind it, and a PE1
/// started late enough to meet the root. With it the flags as the PE1 has them. What f1 has beyond the bits of a depth
/// and f2 beyond two for each row are guard bits below the last one: they are dropped, rounding down.
///
/// Latency that of the network and 2. Section 2.4.2.
pub fn quadric_pe(
    at: &str,
    flags: Flags,
    (f1, f2): (Linear, Quadratic),
    network: Network,
) -> (Depths, Flags) {
    let f1 = ("f1", f1, "linear part of the depth");
    let f2 = ("f2", f2, "quadratic under the root");
    let inputs = (flags, f1, f2);
    module("quadric_pe", at, inputs, |(flags, f1, f2)| {
        let (stages, sum) = (network.latency(), depth_sum(network.depth));
        let f2 = pe2("f2", flags, f2);
        let late = flags.delayed(stages);
        let f1 = pe1("f1", late, f1).high(sum);
        let radicand = f2.high(2 * network.rows).bits();
        let found = network.root("square_root", radicand);
        let root = found.extend(network.digits);
        let root = root.left(network.digits - network.rows);
        net! {
            let step = root.extend(sum).int();
            let kept_near_sum = (f1 - step).reg();
            let kept_far_sum = (f1 + step).reg();
            let kept_root = root.reg();
            let is_outside = f2.is_negative().delay(stages + 1);
        }
        let depths = Depths {
            near_sum: kept_near_sum,
            far_sum: kept_far_sum,
            root: kept_root,
            is_inside: !is_outside,
        };
        let meaning = "flags ceil(W / R) clocks later, for a PE1 that is to meet the sums";
        (depths, ("late", late, meaning))
    })
}
