//! Machine descriptions: what a machine with a screen is made of, as a TOML file (`docs/machines.md`).

mod error;
pub mod keys;
mod machine;
mod text;
mod validation;

pub use error::DescriptionError;
pub(crate) use machine::SMALLEST_SIDE;
pub use machine::{
    LitSphere, MachineDescription, MachineKind, Mode, Output, OwnMode, Smoothing, ZoneSize,
};
