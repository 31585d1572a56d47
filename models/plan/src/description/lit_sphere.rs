//! Tables of the direction of the normal in the place of a shading processor (`docs/architecture.md`, section 8.4).

use imogene_prepare::lit_sphere::{SphereForm, most_tables};
use serde::{Deserialize, Serialize};

/// Entries along each side of the smallest tables.
pub(crate) const SMALLEST_SIDE: u32 = 16;

/// Shading by tables of the direction of the normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct LitSphere {
    /// Entries along each side of a table: 16, 32, 64 or 128.
    pub side: u32,
    /// Materials, each with a table, and with twice as many for each light of the machine.
    pub materials: usize,
    /// The nearest entry is the colour, and nothing stands between entries.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub nearest: bool,
}

impl LitSphere {
    /// Bits of a coordinate in a table.
    pub fn places(&self) -> u32 {
        self.side.max(1).ilog2()
    }

    /// What its tables are like.
    pub fn form(&self) -> SphereForm {
        SphereForm {
            places: self.places(),
            nearest: self.nearest,
        }
    }

    /// Tables of this side at most.
    pub fn most_tables(&self) -> u32 {
        most_tables(self.places())
    }

    /// True if there are tables for its materials and the flags of so many lights.
    pub fn has_room(&self, lights: usize) -> bool {
        let most = self.most_tables().checked_shr(lights as u32);
        self.materials <= most.unwrap_or(0) as usize
    }
}
