//! Machine descriptions: what a machine with a screen is made of, as a TOML file (`docs/machines.md`).

pub mod keys;
mod lit_sphere;
mod machine;
mod text;
mod validation;

pub use lit_sphere::LitSphere;
pub(crate) use lit_sphere::SMALLEST_SIDE;
pub use machine::{MachineDescription, MachineKind, Mode, Output, OwnMode, Smoothing, ZoneSize};
pub use validation::DescriptionError;
