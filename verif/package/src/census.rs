//! What a unit is made of, counted in its hierarchy.

use imogene_contract::{Request, RequestError};
use imogene_hdl::{Binary, Module, Op};
use imogene_rtl::emit::design;
use serde::Serialize;

/// Parts of a unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Census {
    /// First-degree elementary processors.
    pub pe1: usize,
    /// Second-degree elementary processors.
    pub pe2: usize,
    /// Square root networks.
    pub roots: usize,
    /// Multipliers.
    pub multipliers: usize,
}

/// Counts the parts of a unit as it is emitted; refuses a parameter out of its legal range.
pub fn census(request: &Request) -> Result<Census, RequestError> {
    let mut parts = Census::default();
    count(&design(request)?.top, &mut parts);
    Ok(parts)
}

fn count(module: &Module, parts: &mut Census) {
    // In several widths it is called after them.
    let (kind, _) = module.name.split_once("_w").unwrap_or((&module.name, ""));
    match kind {
        "pe1" => parts.pe1 += 1,
        "pe2" => parts.pe2 += 1,
        "square_root" => parts.roots += 1,
        _ => {}
    }
    let is_product = |op: &Op| matches!(op, Op::Binary(Binary::Mul, ..));
    let products = module.nodes.iter().filter(|node| is_product(&node.op));
    parts.multipliers += products.count();
    for instance in &module.instances {
        count(&instance.module, parts);
    }
}
