//! The shape of a binary tree whose levels are pipeline stages; an odd one out of a level passes a register.

use crate::kernel::*;

/// Where the blocks of the tree take their inputs and put their outputs. A branch is an input of the tree or the output
/// of a block; branches are numbered level by level, the root of the tree last.
pub(crate) struct Tree {
    /// Two inputs and an output each.
    pub nodes: Vec<[usize; 3]>,
    /// An input and an output each.
    pub registers: Vec<[usize; 2]>,
    /// Count.
    pub branches: usize,
}

impl Tree {
    /// The tree over so many inputs, at least one.
    pub fn new(inputs: usize) -> Self {
        let mut tree = Self {
            nodes: Vec::new(),
            registers: Vec::new(),
            branches: inputs,
        };
        let mut first = 0;
        let mut level = inputs;
        while level > 1 {
            for pair in 0..level / 2 {
                let input = first + 2 * pair;
                tree.nodes.push([input, input + 1, tree.branches]);
                tree.branches += 1;
            }
            if level % 2 == 1 {
                tree.registers.push([first + level - 1, tree.branches]);
                tree.branches += 1;
            }
            first += level;
            level = level.div_ceil(2);
        }
        tree
    }
}

/// A column of the tree's tables as constants.
pub(crate) fn table<const N: usize>(rows: &[[usize; N]], column: usize) -> Vec<Constant<Word<16>>> {
    rows.iter()
        .map(|row| constant(row[column] as u64))
        .collect()
}
