//! All tests of the crate, as one program.

mod decider_form;
mod formula;
mod request;
mod root_form;
mod slots;
mod video;
