//! All tests of the crate, as one program.

mod fitted;
mod fold;
mod full;
mod harness;
mod netlist;
mod nextpnr;
mod peer;
mod peers;
mod regression;
mod report;
mod table;
mod target;
mod yosys;

/// Do the tests run that need the tools?
fn is_full() -> bool {
    std::env::var_os("IMOGENE_FULL").is_some_and(|value| value == "1")
}
