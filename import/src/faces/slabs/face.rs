//! A face that is taken apart.

use crate::faces::chart::{Chart, free_pole};
use crate::faces::curve::Curve;
use crate::faces::parting::Parting;
use crate::faces::surface::{Implicit, Surface};
use crate::faces::vector::{minus, unit};

/// Greatest gap between the ends of two pieces of a border that follow each other, in sizes of the part or radians.
pub const WIDEST_GAP: f64 = 1e-4;
/// Share of its height by which a band goes on under or over the next, so that the rounding of both leaves no pixel to
/// neither. Out there a chord is a twelfth of the deviation off.
pub const OVERLAP: f64 = 0.02;

/// A part of the surface between two parallels, drawn as one quadric.
#[derive(Clone, Debug)]
pub struct Band {
    /// Its quadric; nothing on a plane.
    pub quadric: Option<Implicit>,
    /// Least and greatest v.
    pub ends: [f64; 2],
    /// Share of its height by which it goes on beyond the border of its face, within the deviation.
    pub beyond: f64,
}

impl Band {
    /// All of a surface.
    pub fn whole(surface: &Surface) -> Vec<Band> {
        vec![Band {
            quadric: surface.implicit(),
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            beyond: 0.0,
        }]
    }
}

/// What is needed to take a face apart.
pub struct Slabs<'a> {
    /// What it lies on.
    pub surface: &'a Surface,
    /// Its border.
    pub parting: &'a Parting,
    /// What it is drawn with.
    pub bands: &'a [Band],
    /// The plane of a face that is flat.
    pub flat: Option<usize>,
    /// Size of the part, scene units.
    pub size: f64,
}

impl Slabs<'_> {
    /// The coordinates of the surface.
    pub fn chart(&self) -> Option<Chart> {
        let line = |curve: &Curve| match curve {
            Curve::Line { from, to } => Some(unit(minus(*to, *from))),
            _ => None,
        };
        let mut border = self.parting.boundaries.iter();
        let north = if self.surface.is_plane() {
            border.find_map(|own| line(&own.curve))
        } else {
            free_pole(self.surface, &self.parting.separators)
        };
        Chart::of(self.surface, north)
    }
}
