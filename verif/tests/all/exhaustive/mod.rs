//! Runs that leave nothing out: every radicand, every coefficient word of a small width, every order and tie of cut
//! planes.
//!
//! The runs of minutes are made when the environment variable `IMOGENE_FULL` is 1; otherwise the same checks run over a
//! smaller set. Each test prints what it counted (`cargo test -- --nocapture`).

mod cut_sequence;
mod cut_single;
mod elementary;
mod roots;

use std::time::Instant;

fn is_full_run() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

/// Prints how much was checked and how fast.
fn account(what: &str, count: u64, started: Instant) {
    let seconds = started.elapsed().as_secs_f64();
    let rate = count as f64 / seconds / 1e6;
    println!("{what}: {count} checked in {seconds:.1} s, {rate:.2} million a second, 0 wrong");
}
