//! The cost of a whole machine from the costs of its modules.
//!
//! Machines that differ in one word share most of their units. Each distinct unit is synthesised once, and what holds
//! units with these as black boxes; the cells are kept by the digest of the text, and a machine costs the sum over its
//! instances. Nothing is optimised across modules, so the sum is somewhat more than a synthesis of the flat machine;
//! `docs/fit.md` compares the two.

pub mod estimate;
pub mod modules;

use crate::bench::Bench;
use crate::cache::{digest, kept};
use crate::error::SynthError;
use crate::harness;
use crate::target::{Family, Target};
use crate::tools::Programs;
use crate::yosys::{self, Resources};
use imogene_rtl::emit::Emitted;
use imogene_tools::{read, scratch, write};
pub use modules::Parts;
use modules::{Module, below, is_of, modules, ports};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering::Relaxed;

/// What a machine takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MachineCost {
    /// All but the clock and the cells.
    #[serde(flatten)]
    pub resources: Resources,
    /// Logic cells: look-up tables and those that carry cells take.
    pub cells: u64,
    /// Clock of its slowest unit, placed and routed alone; none if it was not asked for, one of them does not fit, or
    /// the target is not placed.
    pub fmax_mhz: Option<f64>,
}

/// Units that can be the slowest; `square_root` stands for the whole network.
const CRITICAL: [&str; 14] = [
    "pe2",
    "square_root",
    "square_root_non_restoring",
    "square_root_linear",
    "square_root_quadratic",
    "square_root_leading",
    "patch_decider",
    "contour_choice",
    "half_spaces",
    "half_space_node",
    "decider",
    "shading_processor",
    "lit_sphere",
    "lit_sphere_nearest",
];

/// The kind of result that depends on Yosys alone.
const OWN_CELLS: &str = "own cells of parts";

/// The costs of machines, in their order, as sums of such parts; `done` is called with how many of how many modules
/// and clocks are known. Fails when a tool is missing or fails, or its report cannot be read.
pub fn machine_costs(
    machines: &[Emitted],
    parts: Parts,
    target: Target,
    with_clock: bool,
    done: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<MachineCost>, SynthError> {
    let known = Knowledge::gather(machines, parts, target, with_clock, done)?;
    Ok(machines.iter().map(|machine| known.cost(machine)).collect())
}

/// What is kept of one module.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Own {
    resources: Resources,
}

/// Costs by the digest of a module, or of a unit with all below it.
struct Knowledge {
    parts: Parts,
    target: Target,
    own: HashMap<String, Resources>,
    clocks: HashMap<String, f64>,
}

impl Knowledge {
    fn gather(
        machines: &[Emitted],
        parts: Parts,
        target: Target,
        with_clock: bool,
        done: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Knowledge, SynthError> {
        let yosys = Programs::find_yosys()?;
        // Cells depend on Yosys alone, clocks on the router too.
        let of_cells = format!("{:?}", yosys.versions());
        let programs = match with_clock {
            true => Programs::find(target)?,
            false => yosys,
        };
        let all = format!("{:?}{}", programs.versions(), target.steps());
        let key = |kind: &str, digest: &str| {
            let versions = if kind == OWN_CELLS { &of_cells } else { &all };
            kept(&[
                kind,
                digest,
                target.name(),
                &target.synthesis_of_part("top"),
                target.steps(),
                versions,
            ])
        };
        let mut own = HashMap::new();
        // Missing modules of each machine, which are read together.
        let mut missing: Vec<(&Emitted, Vec<Module>)> = Vec::new();
        let mut wanted = HashSet::new();
        for machine in machines {
            let mut of_machine = modules(machine, parts);
            of_machine.retain(|module| {
                let is_new = wanted.insert(module.digest.clone());
                let kept = key(OWN_CELLS, &module.digest);
                let kept: Option<Own> = is_new.then(|| kept.load()).flatten();
                own.extend(kept.map(|kept| (module.digest.clone(), kept.resources)));
                is_new && kept.is_none()
            });
            if !of_machine.is_empty() {
                missing.push((machine, of_machine));
            }
        }
        let units: BTreeMap<String, Emitted> = match with_clock {
            true => machines.iter().flat_map(critical).collect(),
            false => BTreeMap::new(),
        };
        let count = wanted.len() + units.len();
        let finished = AtomicUsize::new(own.len());
        let tell = |more: usize| done(finished.fetch_add(more, Relaxed) + more, count);
        let found: Vec<Vec<(String, Resources)>> = missing
            .par_iter()
            .map(|(machine, batch)| {
                let resources = synthesise_apart(machine, parts, batch, &programs, target)?;
                let digests = batch.iter().map(|module| module.digest.clone());
                let results: Vec<(String, Resources)> = digests.zip(resources).collect();
                for &(ref digest, resources) in &results {
                    key(OWN_CELLS, digest).store(&Own { resources })?;
                }
                tell(batch.len());
                Ok(results)
            })
            .collect::<Result<_, SynthError>>()?;
        own.extend(found.into_iter().flatten());
        let clock = |(digest, unit): (String, Emitted)| {
            // None if the unit, placed and routed alone, does not fit.
            let clock: Option<f64> = key("clock, 1 seed", &digest).or_made(|| {
                let (folder, harness) = (scratch()?, harness::verilog(&unit));
                let bench = Bench::of(&programs, target, folder.path(), &unit, &harness)?;
                Ok::<_, SynthError>(bench.report(1)?.fmax_mhz)
            })?;
            tell(1);
            Ok(clock.map(|clock| (digest, clock)))
        };
        let clocks: Result<Vec<_>, SynthError> = units.into_par_iter().map(clock).collect();
        Ok(Knowledge {
            parts,
            target,
            own,
            clocks: clocks?.into_iter().flatten().collect(),
        })
    }

    fn cost(&self, machine: &Emitted) -> MachineCost {
        let own = modules(machine, self.parts).into_iter();
        let own = own.map(|module| (module.instances, self.own[&module.digest]));
        let units = critical(machine).into_iter();
        // One that does not fit has no clock, nor has the machine then.
        let clocks: Option<Vec<f64>> = units
            .map(|(digest, _)| self.clocks.get(&digest).copied())
            .collect();
        MachineCost {
            fmax_mhz: clocks.and_then(|clocks| clocks.into_iter().reduce(f64::min)),
            ..MachineCost::of(own, self.target)
        }
    }
}

impl MachineCost {
    /// The sum of the resources of modules, each as often as it stands in the machine.
    fn of(modules: impl Iterator<Item = (u64, Resources)>, target: Target) -> MachineCost {
        let mut sum = [0; 5];
        for (times, own) in modules {
            for (sum, own) in sum.iter_mut().zip(own.counts()) {
                *sum += times * own;
            }
        }
        let sum = Resources::of(sum);
        // A carry cell of ECP5 takes two logic cells; one of iCE40 lies in the cell of its look-up table.
        let per_carry = match target.family() {
            Family::Ecp5 => 2,
            _ => 0,
        };
        MachineCost {
            resources: sum,
            cells: sum.lut + per_carry * sum.carry,
            fmax_mhz: None,
        }
    }
}

/// Name of the netlist of a machine in its folder.
const NETLIST: &str = "machine.json";

/// The own cells of modules of one machine. What holds other parts is read whole, so that everything is below the top;
/// no other part is, unless its cells are asked for.
fn synthesise_apart(
    machine: &Emitted,
    parts: Parts,
    asked: &[Module],
    programs: &Programs,
    target: Target,
) -> Result<Vec<Resources>, SynthError> {
    let folder = scratch()?;
    write(&folder.path().join("machine.v"), &machine.bundle())?;
    let mut script = String::from("read_verilog machine.v");
    for module in modules(machine, parts) {
        let is_read =
            !module.children.is_empty() || asked.iter().any(|one| one.name == module.name);
        script += &match is_read {
            true => format!("; setattr -mod -set keep_hierarchy 1 {}", module.name),
            false => format!("; blackbox {}", module.name),
        };
    }
    script += &format!("; {}", target.synthesis_of_part(&machine.top));
    for Module { name, .. } in asked {
        script += &format!("; tee -q -o {name}.stat {} {name}", target.statistics());
    }
    script += &format!("; write_json {NETLIST}");
    yosys::run(&programs.yosys, folder.path(), &script)?;
    let folded = target.fold(&folder.path().join(NETLIST))?;
    let read = |module: &Module| {
        let text = read(&folder.path().join(format!("{}.stat", module.name)))?;
        let mut cells = yosys::parse_statistics(&text)?.cells;
        let own = folded.get(&module.name).copied().unwrap_or_default();
        own.take_from(&mut cells);
        Ok(yosys::resources(target.family(), &cells))
    };
    asked.iter().map(read).collect()
}

/// The units of a machine that can be the slowest, as designs of their own behind their digests: of variants, the
/// largest.
fn critical(machine: &Emitted) -> Vec<(String, Emitted)> {
    let largest = |kind: &&str| {
        let modules = machine.modules.iter();
        let variants = modules.filter(|(name, _)| is_of(name, kind));
        // Texts of one length differ in their widths.
        variants.max_by_key(|(_, text)| (text.len(), text))
    };
    let found = CRITICAL.iter().filter_map(largest);
    let units = found.map(|(name, _)| unit(machine, name));
    units.map(|unit| (unit_digest(&unit), unit)).collect()
}

/// One module of a machine and all below it.
fn unit(machine: &Emitted, name: &str) -> Emitted {
    let modules: Vec<(String, String)> = below(machine, name).cloned().collect();
    let own = modules.iter().find(|(module, _)| module == name);
    Emitted {
        top: name.to_owned(),
        header: String::new(),
        ports: own.map_or_else(Vec::new, |(_, text)| ports(text)),
        modules,
        latency: 0,
    }
}

/// What tells a unit from others of another clock. In a shading processor of directional lights the depth word is in
/// its own text alone, and the slowest paths are below it: it is routed once for all depth words.
fn unit_digest(unit: &Emitted) -> String {
    match unit.modules.split_last() {
        Some((_, below)) if is_of(&unit.top, "shading_processor") => {
            let texts: Vec<&str> = below.iter().map(|(_, text)| &**text).collect();
            digest(&texts.concat())
        }
        _ => digest(&unit.bundle()),
    }
}
