//! A try to take a face apart.

use super::face::Slabs;
use super::rail::Rail;
use crate::faces::chart::Chart;

/// One try with the ends of slabs.
pub struct Work<'a> {
    pub face: &'a Slabs<'a>,
    pub chart: &'a Chart,
    pub rails: &'a [Rail],
    pub limits: Vec<f64>,
    /// Strips are also bounded by parallels.
    pub parallels: bool,
}

impl Work<'_> {
    /// Number of slabs.
    pub fn slabs(&self) -> usize {
        self.limits.len().saturating_sub(1)
    }

    /// The middle of a slab.
    pub fn middle(&self, slab: usize) -> f64 {
        0.5 * (self.limits[slab] + self.limits[slab + 1])
    }
}
