//! The visible object of a pixel.

use crate::object::Normal;
use crate::tree::tree;
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, join, module, net};

bundles! {
    /// What an object says of a pixel.
    #[derive(Copy)]
    Candidate(depth: u32, normal: u32, id: u32) {
        depth: Int(depth) as "depth", "depth; 2^(W-1) - 1, the far end, where it is absent";
        id: Bits(id) as "id", "number of the object";
        number: Bits(4) as "number", "number of its visible face";
        normal: Normal(normal) as "", "visible face";
    }
}

/// The nearer of two candidates, of two equally near the one with the smaller id. Latency 1.
pub fn visibility_node(at: &str, a: Candidate, b: Candidate) -> Candidate {
    let inputs = (("a", a, "object a"), ("b", b, "object b"));
    module("visibility_node", at, inputs, |(a, b)| {
        net! { let b_wins = is_before((b.depth, b.id), (a.depth, a.id)); }
        ("", b_wins.select(b, a).registered(), NEAREST)
    })
}

/// 1 where one depth and id are nearer than another one, or as near with the smaller id: one comparison of numbers
/// whose low bits are the id.
pub(super) fn is_before((depth, id): (Int, Bits), (other_depth, other_id): (Int, Bits)) -> Bits {
    net! {
        let rank = join([depth.bits(), id]).int();
        let other_rank = join([other_depth.bits(), other_id]).int();
    }
    rank.less(other_rank)
}

/// What a decider gives.
pub(super) const NEAREST: &str = "nearest object";

/// The register in the place of a node.
pub(super) const REGISTER: &str = "visibility_register";

/// The nearest of all candidates by a tree of nodes. Latency `ceil(log2 n)`. Section 6 of `docs/architecture.md`.
pub fn decider(at: &str, inputs: Vec<Candidate>) -> Candidate {
    let inputs = ("input", inputs, "object on input #");
    module("decider", at, inputs, |inputs| {
        ("", tree(inputs, visibility_node, REGISTER), NEAREST)
    })
}
