//! Trees whose levels are clocks.

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
    let (mut nodes, mut registers) = (0, 0);
    while level.len() > 1 {
        let branch = |pair: &[B]| match pair {
            [a, b] => {
                nodes += 1;
                node(&format!("nodes_{}", nodes - 1), *a, *b)
            }
            rest => {
                registers += 1;
                register(
                    register_name,
                    &format!("registers_{}", registers - 1),
                    rest[0],
                )
            }
        };
        level = level.chunks(2).map(branch).collect();
    }
    level[0]
}

/// A branch one clock later.
pub fn register<B: Plain>(name: &str, at: &str, branch: B) -> B {
    module(name, at, ("a", branch), |branch| branch.registered())
}
