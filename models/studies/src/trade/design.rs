//! The design space.

use crate::kit::words::widest;
use imogene_contract::MachineWords;
use serde::{Deserialize, Serialize};

/// What decides the pixels of a machine.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct Accuracy {
    /// Depth word.
    pub depth: u32,
    /// Bits of a normal component.
    pub normal: u32,
    /// Guard bits of f1.
    pub guard_linear: u32,
    /// Guard bits of f2.
    pub guard_quadratic: u32,
    /// Last digits of the root that are not computed.
    pub dropped_rows: u32,
    /// Columns and lines of the zones for which the coefficients are rounded anew; 0 for the whole screen, each object
    /// about the middle of its box.
    pub zone: u32,
    /// A machine of the catalogue instead of one that is as narrow as the scene allows: all other widths follow from
    /// the depth word, and all slots are alike.
    pub catalogue: bool,
}

/// A point of the design space: what decides the pixels, and what decides speed and area alone.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct Design {
    /// What decides the pixels.
    pub accuracy: Accuracy,
    /// Rows of the root network between registers.
    pub rows_per_stage: u32,
}

/// Which points are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// A dozen.
    Quick,
    /// Some two hundred and fifty.
    Full,
}

/// Depth words of the full space.
const DEPTHS: [u32; 7] = [12, 14, 16, 18, 20, 22, 24];
/// Guard bits of f1 and f2.
const GUARDS: [(u32, u32); 3] = [(0, 0), (1, 2), (2, 4)];

impl Accuracy {
    /// A fitted machine of a depth word, drawing the whole screen with normals of 16 bits.
    pub fn of_depth(depth: u32) -> Accuracy {
        Accuracy {
            depth,
            normal: 16,
            ..Accuracy::default()
        }
    }

    /// The widths before it is known what the scene requires.
    pub fn widest(&self) -> MachineWords {
        let guards = (self.guard_linear, self.guard_quadratic);
        widest(self.depth, self.normal, guards, self.dropped_rows)
    }

    /// A short name, which is that of its files.
    pub fn name(&self) -> String {
        let mut name = format!(
            "w{}-n{}-g{}.{}-d{}",
            self.depth, self.normal, self.guard_linear, self.guard_quadratic, self.dropped_rows
        );
        if self.zone > 0 {
            name += &format!("-z{}", self.zone);
        }
        if self.catalogue {
            name += "-catalogue";
        }
        name
    }
}

impl Design {
    /// A short name, which is that of its file.
    pub fn name(&self) -> String {
        format!("{}-r{}", self.accuracy.name(), self.rows_per_stage)
    }
}

impl Space {
    /// Its points, those of the same pixels side by side.
    pub fn designs(self) -> Vec<Design> {
        match self {
            Space::Quick => with_rows(&quick(), &[1, 2]),
            Space::Full => with_rows(&full(), &[1, 2, 4]),
        }
    }
}

fn with_rows(all: &[Accuracy], rows: &[u32]) -> Vec<Design> {
    let of = |&accuracy: &Accuracy| {
        rows.iter().map(move |&rows_per_stage| Design {
            accuracy,
            rows_per_stage,
        })
    };
    all.iter().flat_map(of).collect()
}

fn guarded(accuracy: Accuracy, (guard_linear, guard_quadratic): (u32, u32)) -> Accuracy {
    Accuracy {
        guard_linear,
        guard_quadratic,
        ..accuracy
    }
}

fn quick() -> Vec<Accuracy> {
    let of = Accuracy::of_depth;
    vec![
        of(10),
        of(12),
        of(16),
        guarded(of(16), (2, 4)),
        of(20),
        Accuracy {
            dropped_rows: 3,
            ..of(20)
        },
        of(24),
    ]
}

fn full() -> Vec<Accuracy> {
    let mut all = vec![Accuracy::of_depth(8), Accuracy::of_depth(10)];
    for depth in DEPTHS {
        let base = Accuracy::of_depth(depth);
        for guards in GUARDS {
            for dropped_rows in [0, 2, 4] {
                all.push(Accuracy {
                    dropped_rows,
                    ..guarded(base, guards)
                });
            }
        }
        all.extend([10, 12].map(|normal| Accuracy { normal, ..base }));
    }
    for depth in [16, 18, 20, 22, 24] {
        let base = Accuracy::of_depth(depth);
        all.extend([64, 32].map(|zone| Accuracy { zone, ..base }));
    }
    for depth in [16, 20, 24] {
        all.push(Accuracy {
            catalogue: true,
            ..Accuracy::of_depth(depth)
        });
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_have_names_of_their_own_and_those_of_the_same_pixels_stand_together() {
        for (space, least) in [(Space::Quick, 10), (Space::Full, 250)] {
            let designs = space.designs();
            assert!(designs.len() >= least, "{}", designs.len());
            let mut names: Vec<String> = designs.iter().map(Design::name).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), designs.len());
            let mut groups: Vec<Accuracy> = designs.iter().map(|d| d.accuracy).collect();
            groups.dedup();
            let together = groups.len();
            groups.sort_unstable();
            groups.dedup();
            assert_eq!(groups.len(), together);
        }
    }
}
