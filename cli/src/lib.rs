//! The command line of imogene as a library: what may be asked for. The tests read the examples of the documents with
//! it.

pub mod arguments;
