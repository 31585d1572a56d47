//! What hardware and golden models share: names, widths, addresses and the record of every unit, and no behaviour.

mod catalogue;
pub mod command_stream;
mod formula;
mod machine_words;
pub mod object;
pub mod parameters;
pub mod request;
pub mod shading;
pub mod unit;
pub mod video;
pub mod volume;
pub mod words;

pub use machine_words::MachineWords;
pub use request::{Request, RequestError};
pub use unit::{Record, Unit};
