//! Refusals of scenes by zone machines.

use imogene_contract::slots::FittedSlot;
use imogene_golden::machine::zone::{ID_BITS, MAX_PICTURE, ZoneMachineError};
use imogene_golden::object::as_quadric::AsQuadricError;
use thiserror::Error;

pub(super) type Result<T = (), E = PlanError> = std::result::Result<T, E>;

/// Why a scene cannot be drawn by a zone machine.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum PlanError {
    /// No machine is like this.
    #[error(transparent)]
    Machine(#[from] ZoneMachineError),
    /// A picture that is not whole pixels.
    #[error("a picture of {0} x {1} samples for pixels of {2} x {2}: both have to be a multiple")]
    PartOfPixel(u32, u32, u32),
    /// An object that its processors cannot draw.
    #[error("object '{0}': {1}")]
    Object(String, AsQuadricError),
    /// An object that no slot is for, what would do, and what there is.
    #[error("object '{0}' needs a slot such as {1}; the machine has {2} for objects in no solid")]
    NoSlot(String, FittedSlot, String),
    /// A volume, named by whose it is, that its processors cannot answer for.
    #[error("{0}: {1}")]
    Volume(String, AsQuadricError),
    /// Volumes without a processor.
    #[error(
        "the scene has {0} shadow and light volumes and the machine no volume processor; accepted is at least one"
    )]
    NoVolumeProcessor(usize),
    /// Objects without a processor.
    #[error(
        "{0} objects are in no solid, and the machine has object processors of products alone; accepted is one more at \
         least"
    )]
    NoObjectProcessor(usize),
    /// More transparent objects than layers: how many, and how many layers there are.
    #[error("{0} transparent objects, and the machine has {1} layers; accepted is layers = {0}")]
    Layers(usize, usize),
    /// A product that is larger than those of the machine.
    #[error(
        "a product of a solid intersects {} objects and takes {} away; accepted are machines with products such as \
         \"{}-{}\"", .0[0], .0[1], .0[0], .0[1]
    )]
    NoProduct([usize; 2]),
    /// More objects than ids.
    #[error("{0} objects: an id has {ID_BITS} bits; accepted are up to {most}", most = 1 << ID_BITS)]
    Objects(usize),
    /// More pixels than coordinates.
    #[error("a picture of {0} x {1} pixels; accepted are up to {MAX_PICTURE} each way")]
    Picture(u32, u32),
    /// Materials of other objects: how many, and how many objects there are.
    #[error("{0} materials for {1} objects; one is needed for each object")]
    Materials(usize, usize),
}
