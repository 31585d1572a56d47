//! The cost of a machine without its synthesis, from that of machines with modules of the same kinds.

use super::modules::{Module, Parts, kind_of, modules};
use super::{Knowledge, MachineCost};
use crate::error::SynthError;
use crate::target::Target;
use crate::yosys::Resources;
use imogene_rtl::emit::Emitted;
use std::collections::BTreeMap;

/// Modules of a kind, by the bits that they declare.
type Kin = BTreeMap<u64, Resources>;

/// The costs of machines, in their order, from the modules of `known` ones, which are synthesised: each module from the
/// next smaller and the next larger one of its kind, in proportion of the bits that they declare. A module whose kind
/// the known machines have not got counts nothing. Known machines have the same rows to a stage, and are of all forms.
///
/// # Errors
///
/// As [`machine_costs`](super::machine_costs).
pub fn estimated_costs(
    known: &[Emitted],
    machines: &[Emitted],
    parts: Parts,
    target: Target,
    done: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<MachineCost>, SynthError> {
    let knowledge = Knowledge::gather(known, parts, target, false, done)?;
    let mut kinds: BTreeMap<String, Kin> = BTreeMap::new();
    for module in known.iter().flat_map(|machine| modules(machine, parts)) {
        let kin = kinds.entry(kind_of(&module.name).to_owned()).or_default();
        kin.insert(module.bits, knowledge.own[&module.digest]);
    }
    let own = |module: Module| {
        let synthesised = knowledge.own.get(&module.digest).copied();
        let kin = || kinds.get(kind_of(&module.name));
        let estimated = || kin().map(|kin| between(kin, module.bits));
        let own = synthesised.or_else(estimated).unwrap_or_default();
        (module.instances, own)
    };
    let cost = |machine| MachineCost::of(modules(machine, parts).into_iter().map(own), target);
    Ok(machines.iter().map(cost).collect())
}

/// What a module of so many bits takes, from the nearest ones of its kind; beyond all of them on the line through the
/// last two.
fn between(kin: &Kin, bits: u64) -> Resources {
    let below = kin.range(..=bits).next_back();
    let above = kin.range(bits..).next();
    let (first, last) = match (below, above) {
        (Some(below), Some(above)) => (below, above),
        (Some(last), None) => (kin.range(..last.0).next_back().unwrap_or(last), last),
        (None, Some(first)) => (first, kin.range(first.0 + 1..).next().unwrap_or(first)),
        (None, None) => return Resources::default(),
    };
    let part = match last.0 - first.0 {
        0 => 0.0,
        span => (bits as f64 - *first.0 as f64) / span as f64,
    };
    let [first, last] = [first.1, last.1].map(Resources::counts);
    Resources::of(std::array::from_fn(|index| {
        let [first, last] = [first[index] as f64, last[index] as f64];
        (first + part * (last - first)).round().max(0.0) as u64
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(lut: u64) -> Resources {
        Resources {
            lut,
            ff: 7,
            ..Resources::default()
        }
    }

    #[test]
    fn a_module_lies_between_the_nearest_of_its_kind() {
        let kin = Kin::from([(10, of(100)), (20, of(300)), (40, of(400))]);
        let luts = [5, 10, 15, 20, 30, 50].map(|bits| between(&kin, bits).lut);
        assert_eq!(luts, [0, 100, 200, 300, 350, 450]);
        assert_eq!(between(&kin, 33).ff, 7);
        // One alone says all that is known.
        assert_eq!(between(&Kin::from([(10, of(100))]), 99).lut, 100);
    }
}
