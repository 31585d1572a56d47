//! What a unit is made of, counted in its hierarchy.

use super::collect::Scope;
use super::{Collect, EmitError, EmitRequest, emit, with_block};
use std::collections::BTreeMap;

/// Parts of a unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

/// Counts the parts of a unit as it is emitted.
///
/// # Errors
///
/// When a parameter is out of its legal range.
pub fn census(request: &EmitRequest) -> Result<Census, EmitError> {
    let mut instances = BTreeMap::new();
    count(&with_block(request, Collect)?, &mut instances);
    let of = |name: &str| instances.get(name).copied().unwrap_or(0);
    // Every product of this crate stands in a module of its own kind, whose instances have its products.
    let modules = emit(request)?.modules;
    let products = modules
        .iter()
        .map(|(name, text)| text.matches(" * ").count() * of(name));
    Ok(Census {
        pe1: of("pe1"),
        pe2: of("pe2"),
        roots: of("square_root"),
        multipliers: products.sum(),
    })
}

fn count(scope: &Scope, instances: &mut BTreeMap<String, usize>) {
    if let Some(unit) = scope.unit() {
        *instances.entry(unit.to_owned()).or_default() += 1;
    }
    scope
        .children
        .iter()
        .for_each(|child| count(child, instances));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::Unit;

    #[test]
    fn parts_of_the_quadric_processor() {
        let parts = census(&EmitRequest::new(Unit::QuadricProcessor)).unwrap();
        let expected = Census {
            pe1: 1 + 3 + 3,
            pe2: 1,
            roots: 1,
            multipliers: 3,
        };
        assert_eq!(parts, expected);
        let machine = census(&EmitRequest::new(Unit::Beam)).unwrap();
        assert_eq!((machine.pe1, machine.roots), (28, 4));
    }
}
