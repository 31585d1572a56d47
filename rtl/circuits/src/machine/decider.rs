//! The visible object of a pixel.

use crate::object::Normal;
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module, net};

bundles! {
    /// What an object says of a pixel.
    #[derive(Copy)]
    Candidate {
        depth: Int as "depth", "depth, the far end where it is absent";
        id: Bits as "id", "number of the object";
        number: Bits as "number", "number of the face";
        normal: Normal as "", "normal of the face";
    }
}

impl Candidate {
    /// One from outside of the design.
    pub fn input(depth: u32, normal: u32, id: u32) -> Candidate {
        Candidate {
            depth: Int::input(depth),
            id: Bits::input(id),
            number: Bits::input(4),
            normal: Normal::input(normal),
        }
    }
}

/// The nearer of two candidates, of two equally near the one with the smaller id. Latency 1.
pub fn visibility_node(at: &str, a: Candidate, b: Candidate) -> Candidate {
    module(
        "visibility_node",
        at,
        (("a", a), ("b", b)),
        |((_, a), (_, b))| {
            net! {
                let b_is_nearer = b.depth.less(a.depth);
                let depths_are_equal = b.depth.equals(a.depth);
                let b_wins = b_is_nearer | (depths_are_equal & b.id.less(a.id));
            }
            b_wins.select(b, a).registered()
        },
    )
}

/// A candidate one clock later: the odd one out of a level.
pub(super) fn visibility_register(at: &str, a: Candidate) -> Candidate {
    module("visibility_register", at, ("a", a), |(_, a)| a.registered())
}

/// The nearest of all candidates by a tree of nodes. Latency `ceil(log2 n)`. Section 6 of `docs/architecture.md`.
pub fn decider(at: &str, inputs: Vec<Candidate>) -> Candidate {
    module("decider", at, ("input", inputs), |(_, mut level)| {
        let (mut nodes, mut registers) = (0, 0);
        while level.len() > 1 {
            let mut next = vec![];
            for pair in level.chunks(2) {
                next.push(match pair {
                    [a, b] => {
                        nodes += 1;
                        visibility_node(&format!("nodes_{}", nodes - 1), *a, *b)
                    }
                    rest => {
                        registers += 1;
                        visibility_register(&format!("registers_{}", registers - 1), rest[0])
                    }
                });
            }
            level = next;
        }
        level[0]
    })
}
