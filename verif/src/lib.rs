//! imogene-verif
