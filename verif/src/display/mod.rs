//! Co-simulation of machines with everything between the object processors and the picture.

pub mod bench;
pub mod pins;
pub mod request;
mod run;
pub mod stream;
mod waves;
