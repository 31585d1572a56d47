//! Hardware units of imogene in rust-hdl.
