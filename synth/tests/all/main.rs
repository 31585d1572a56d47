//! All tests of the crate that need it from outside, as one program.

mod full;
mod harness;
mod peers;

/// Do the tests run that need the tools?
fn is_full() -> bool {
    std::env::var_os("IMOGENE_FULL").is_some_and(|value| value == "1")
}
