//! The zone machine: few processors that draw many objects, zone by zone (`docs/zone-machine.md`).
//!
//! K object processors and V volume processors are loaded again and again with the objects and volumes of one
//! zone of the screen; a buffer keeps what is seen so far at each pixel of the zone. The host cuts the screen and sends
//! a stream of words and commands ([`beat`]). The golden machine ([`golden`]) is driven by that stream alone.

pub mod beat;
pub mod decode;
pub mod golden;
pub mod sample;

use crate::object::quadric::MAX_PLANES;
use imogene_contract::object::ProductSlots;
use imogene_contract::slots::{FittedSlot, one_of_each};
use thiserror::Error;

/// Bits of an object's id in the zone buffer.
pub const ID_BITS: u32 = 12;
/// Most processors of a kind: a unit number has 8 bits.
pub const MAX_PROCESSORS: usize = imogene_contract::words::MOST_OBJECTS as usize;
/// Most pixels along a side of the screen: coordinates have 12 bits.
pub const MAX_PICTURE: u32 = 4096;
/// Most pixels along a side of a zone: its width and height have 12 bits.
pub const MAX_ZONE: u32 = 4095;

/// Samples of a pixel along each side that there are machines for.
pub const SAMPLES: [u32; 3] = [1, 2, 4];

/// What a zone machine is made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ZoneMachine {
    /// Object processors: K for objects that are in no solid, at least 1 if there are no products, and behind them
    /// those of products, product by product.
    pub slots: Vec<FittedSlot>,
    /// Products of solids.
    pub products: Vec<ProductSlots>,
    /// Processors of transparent objects, the first of the farthest. Their numbers follow those of `slots`.
    pub layers: Vec<FittedSlot>,
    /// V: volume processors with a quadric; none in a machine without shadows and spots.
    pub volume_processors: usize,
    /// M: planes of each.
    pub volume_planes: usize,
    /// Columns of a zone; zones at the right edge can be narrower.
    pub zone_width: u32,
    /// Lines of a zone; zones at the lower edge can be lower.
    pub zone_height: u32,
    /// Samples of a pixel along each side: 1, or 2 or 4 in a machine that supersamples.
    pub samples: u32,
}

/// No zone machine is like this.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ZoneMachineError {
    /// A number is out of its range: what is asked for, of what, the fewest and the most.
    #[error("a zone machine with {0} {1}: accepted are {2} to {3}")]
    Range(usize, &'static str, usize, usize),
    /// No machine has so many samples.
    #[error("{0} x {0} samples of a pixel: accepted are 1, 2 or 4 along each side")]
    Samples(u32),
}

impl ZoneMachine {
    /// K: how many of its object processors are of no product.
    pub fn alone(&self) -> usize {
        let members: usize = self.products.iter().map(ProductSlots::count).sum();
        self.slots.len().saturating_sub(members)
    }

    /// The same with so many processors of each kind that it has for objects in no solid, with the most planes of one.
    pub fn with_processors(&self, count: usize) -> ZoneMachine {
        let (alone, members) = self.slots.split_at(self.alone());
        let kinds = one_of_each(alone.iter().copied());
        let alone = kinds.into_iter().flat_map(|kind| vec![kind; count]);
        ZoneMachine {
            slots: alone.chain(members.iter().copied()).collect(),
            ..self.clone()
        }
    }

    /// Is there such a machine?
    pub fn check(&self) -> Result<(), ZoneMachineError> {
        let [columns, lines, side] =
            [self.zone_width, self.zone_height, MAX_ZONE].map(|n| n as usize);
        let processors = self.slots.len() + self.layers.len();
        let volumes = self.volume_processors;
        let planes = self.slots.iter().map(|slot| slot.planes as usize).max();
        for (what, value, least, most) in [
            ("object processors", processors, 1, MAX_PROCESSORS),
            ("planes", planes.unwrap_or(0), 0, MAX_PLANES),
            ("volume processors", volumes, 0, MAX_PROCESSORS),
            ("planes of a volume", self.volume_planes, 0, MAX_PLANES),
            ("zone width", columns, 1, side),
            ("zone height", lines, 1, side),
        ] {
            if !(least..=most).contains(&value) {
                return Err(ZoneMachineError::Range(value, what, least, most));
            }
        }
        let is_known = SAMPLES.contains(&self.samples).then_some(());
        is_known.ok_or(ZoneMachineError::Samples(self.samples))
    }
}
