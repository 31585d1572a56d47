//! Words of a machine that is fitted to a scene.

use crate::root_form::RootForm;
use crate::words::{
    LEAST_DEPTH, LEAST_NORMAL, LEAST_ROOT, MOST_BITS, MOST_DEPTH, MOST_DROPPED, MOST_GUARD, NORMAL,
    WordRange, plane, quadratic,
};
use serde::{Deserialize, Serialize};

/// The words from which all others of a machine follow, in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct MachineWords {
    /// Depth word `W`, 8 to 32.
    pub depth: u32,
    /// Root `K`, 4 to `W`: roots stay below `2^(K - 1/2)`. f2 has `2 K` bits.
    pub root: u32,
    /// Plane word `P`, `W` to `W + 12`.
    pub plane: u32,
    /// Normal component, 10 to 16.
    pub normal: u32,
    /// Guard bits g1 of f1.
    pub guard_linear: u32,
    /// Guard bits g2 of f2.
    pub guard_quadratic: u32,
    /// Last digits of the root that are not computed, but zero; 0 to 8 and less than `K`.
    #[serde(default)]
    pub dropped_rows: u32,
    /// How the root is taken.
    #[serde(default, skip_serializing_if = "RootForm::is_usual")]
    pub root_form: RootForm,
}

impl MachineWords {
    /// Words that all follow from the depth word.
    pub const fn of(depth: u32) -> MachineWords {
        MachineWords {
            depth,
            root: depth,
            plane: plane(depth),
            normal: NORMAL,
            guard_linear: 0,
            guard_quadratic: 0,
            dropped_rows: 0,
            root_form: RootForm::Restoring,
        }
    }

    /// Clocks from one pixel to the next, at least.
    pub const fn clocks_per_pixel(&self) -> u32 {
        self.root_form.clocks(self.root - self.dropped_rows)
    }

    /// The shortest root that a processor of these words may have.
    pub fn least_root(&self) -> u32 {
        LEAST_ROOT.max(self.dropped_rows + self.root_form.least_digits())
    }

    /// The first word that is out of its range; each range stands on the words before it. No word has more than 64
    /// bits.
    pub fn refused(&self) -> Option<WordRange> {
        let root = self.root;
        let left = MOST_BITS.saturating_sub(quadratic(root.min(MOST_DEPTH)));
        let dropped = MOST_DROPPED.min(root.saturating_sub(1));
        let words = [
            ("depth word", self.depth, LEAST_DEPTH, MOST_DEPTH),
            ("root", root, LEAST_ROOT, self.depth),
            ("plane word", self.plane, self.depth, plane(self.depth)),
            ("normal component", self.normal, LEAST_NORMAL, NORMAL),
            ("dropped digits of the root", self.dropped_rows, 0, dropped),
            ("guard bits of f1", self.guard_linear, 0, MOST_GUARD),
            (
                "guard bits of f2",
                self.guard_quadratic,
                0,
                MOST_GUARD.min(left),
            ),
        ];
        let is_out = |(_, bits, least, most): &WordRange| !(least..=most).contains(&bits);
        let form = || self.root_form.refused(root - self.dropped_rows);
        words.into_iter().find(is_out).or_else(form)
    }
}
