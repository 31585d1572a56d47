//! What hardware and golden models share: names, widths and addresses, and no behaviour.

pub mod command_stream;
pub mod parameters;
pub mod shading;
pub mod video;
pub mod volume;
pub mod words;
