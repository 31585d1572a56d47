//! Object processors.

pub mod quadric_processor;
