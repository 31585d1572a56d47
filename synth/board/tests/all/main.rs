//! All tests of the crate, as one program.

mod boards;
mod description;
mod netlist;
mod pll;
mod screen;
mod stays;
mod tile;
mod tmds;
mod witness;
