//! All tests of the crate, as one program.

mod culling;
mod description;
mod products;
mod split;
mod tile;
mod zone_machine;
