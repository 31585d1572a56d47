//! What hardware and golden models share: names, widths and addresses, and no behaviour.

pub mod parameters;
pub mod words;
