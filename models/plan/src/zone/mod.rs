//! Zones: which objects and volumes a zone machine is given in which zone (`docs/zone-machine.md`).
//!
//! [`plan`] cuts the screen, `share` finds slots for what is drawn, [`refine`] leaves out what no pixel of a zone
//! shows, [`stream`] writes the beats that the machine is told, [`clocks`] counts what a frame takes, [`growth`] for
//! smaller and smaller zones.

pub mod clocks;
mod error;
pub mod growth;
pub mod plan;
pub mod refine;
mod share;
pub mod stream;
