//! The cost of a machine without its synthesis, from that of machines with modules of the same kinds.

use super::modules::{Module, Parts, kind_of, modules};
use super::{Knowledge, MachineCost};
use crate::error::SynthError;
use crate::target::Target;
use crate::yosys::Resources;
use imogene_rtl::emit::Emitted;
use std::collections::BTreeMap;

/// Modules of a kind, by the bits that they declare.
pub type Kin = BTreeMap<u64, Resources>;

/// The costs of machines, in their order, from the modules of `known` ones, which are synthesised: each module from
/// the next smaller and the next larger one of its kind, in proportion of the bits that they declare. A module whose
/// kind the known machines have not got counts nothing. Known machines have the same rows to a stage, and are of all
/// forms. Fails as [`machine_costs`](super::machine_costs) does.
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
pub fn between(kin: &Kin, bits: u64) -> Resources {
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
