//! The command line of imogene as a library: what may be asked for, how a command fails, and what can be said of it
//! without running one. The tests read the examples of the documents with it.

pub mod arguments;
pub mod failure;
pub mod help;
pub mod progress;
pub mod verdict;
