//! Runs that leave nothing out: every radicand, every coefficient word of a small width, every order and tie of cut
//! planes.
//!
//! The runs of minutes are made when the environment variable `IMOGENE_FULL` is 1; otherwise the same checks run over a
//! smaller set. Each test prints what it counted (`cargo test -- --nocapture`).

pub(crate) mod cut_sequence;
pub(crate) mod cut_single;
mod elementary;
mod roots;

use crate::{compiled, unit, verilog};
use imogene_verif::engine::verilator::Model;
use std::time::Instant;

/// The emitted Verilog of a unit in Verilator, and its latency.
fn compile(name: &str, depth_word: u32) -> (Model, usize) {
    let unit = unit(name, depth_word);
    let model = compiled(&unit, &verilog(name, depth_word));
    (model.expect("Verilator compiles the unit"), unit.latency)
}

/// Prints how much was checked and how fast.
fn account(what: &str, count: u64, started: Instant) {
    let seconds = started.elapsed().as_secs_f64();
    let rate = count as f64 / seconds / 1e6;
    println!("{what}: {count} checked in {seconds:.1} s, {rate:.2} million a second, 0 wrong");
}
