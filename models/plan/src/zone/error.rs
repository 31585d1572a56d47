//! Refusals of scenes by zone machines.

use imogene_contract::slots::FittedSlot;
use imogene_golden::machine::zone::{ID_BITS, MAX_PICTURE, ZoneMachineError};
use imogene_golden::object::as_quadric::AsQuadricError;
use thiserror::Error;

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
    #[error("object '{object}': {why}")]
    Object {
        /// Name of the object.
        object: String,
        /// What is wrong.
        why: AsQuadricError,
    },
    /// An object that no slot is for.
    #[error(
        "object '{object}' needs a slot such as {needed}; the machine has {slots} for objects in no solid"
    )]
    NoSlot {
        /// Name of the object.
        object: String,
        /// What would do.
        needed: FittedSlot,
        /// What there is.
        slots: String,
    },
    /// A volume that its processors cannot answer for.
    #[error("{volume}: {why}")]
    Volume {
        /// Whose it is.
        volume: String,
        /// What is wrong.
        why: AsQuadricError,
    },
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
    /// More transparent objects than layers.
    #[error(
        "{needed} transparent objects, and the machine has {given} layers; accepted is layers = {needed}"
    )]
    Layers {
        /// Of the scene.
        needed: usize,
        /// Of the machine.
        given: usize,
    },
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
    /// Materials of other objects.
    #[error("{given} materials for {objects} objects; one is needed for each object")]
    Materials {
        /// In the list.
        given: usize,
        /// Of the scene.
        objects: usize,
    },
}
