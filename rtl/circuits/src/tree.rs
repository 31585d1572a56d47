//! Trees whose levels are clocks.

use crate::rows::numbered;
use imogene_hdl::{Plain, module};

/// Levels of a tree of so many inputs.
pub fn levels(inputs: usize) -> u32 {
    inputs.next_power_of_two().ilog2()
}

/// What nodes with two branches make of all inputs; the odd one out of a level passes a register.
///
/// Latency `ceil(log2 n)`.
pub fn tree<B: Plain + Copy>(
    mut level: Vec<B>,
    node: fn(&str, B, B) -> B,
    register_name: &str,
) -> B {
    let mut nodes = numbered("nodes", 0..);
    let mut registers = numbered("registers", 0..);
    let next = |row: &mut dyn Iterator<Item = (String, u32)>| row.next().expect("no end").0;
    while level.len() > 1 {
        let branch = |pair: &[B]| match pair {
            [a, b] => node(&next(&mut nodes), *a, *b),
            rest => register(register_name, &next(&mut registers), rest[0]),
        };
        level = level.chunks(2).map(branch).collect();
    }
    level[0]
}

/// A branch one clock later.
pub fn register<B: Plain>(name: &str, at: &str, branch: B) -> B {
    module(name, at, ("a", branch), |branch| branch.registered())
}
