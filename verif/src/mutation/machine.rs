//! Every mutant of what a machine is made of beside its units: its control, its buffers, and the ways between them.
//!
//! A mutant runs with the same host, receiver and scoreboard as the machine itself: its pins are compared with the
//! golden pictures until the first difference. A module's mutant that the first run does not kill is judged with the
//! instances inside left out, so that the proof is as small as the module.

use super::score::{Fate, MutationError, MutationReport};
use crate::display::pins::{PinsRun, run_in};
use crate::display::request::{mode, request_for};
use crate::engine::circuit::{Circuit, Compiled};
use crate::engine::machine::MachineDesign;
use crate::engine::{Engine, design::DesignError};
use crate::random::generator;
use crate::report::Report;
use imogene_contract::Unit;
use imogene_faults::{Around, Controls, Judge, Known, Mutant, Site, Verdict};
use imogene_faults::{alone, power_up, sites};
use imogene_golden::machine::overlay::OverlayPlane;
use imogene_hdl::{Design, Module};
use imogene_plan::description::MachineDescription;
use imogene_plan::display::Image;
use proptest::prelude::Rng;
use rayon::prelude::*;
use std::sync::Arc;
use std::time::Instant;

/// Modules that keep words as the unit `coefficient_store` does, which is run by itself.
const STORES: [&str; 2] = ["volume_store", "coefficient_hold"];

/// Clocks for which a machine may be idle before the host begins.
const IDLE: usize = 500;

/// Sites that one compilation serves.
const GROUP: usize = 24;

/// A machine, and the pictures that it is to show.
pub struct Shown<'a> {
    /// The machine.
    pub machine: &'a MachineDescription,
    /// Words and golden pictures, one after the other.
    pub images: &'a [Image],
    /// Runs that a mutant is tried in at most: the first without a stall, in each other one host and receiver stall
    /// where its seed says so.
    pub runs: u64,
    /// Conflicts after which the solver gives a mutant up.
    pub effort: u64,
}

/// The circuit of a machine that shows these images.
pub fn design(machine: &MachineDescription, images: &[Image]) -> Result<Design, MutationError> {
    let tables = images.first().map_or(&[][..], |image| &image.tables);
    let design = request_for(machine, tables, "").design();
    Ok(design.map_err(DesignError::from)?)
}

/// How many mutants the modules of a machine have that are no units and in none.
pub fn count(design: &Design) -> u64 {
    let own = Own::of(design);
    let all = [own.sites.concat(), own.power_up].concat();
    Controls::new(design, &all).mutants().len() as u64
}

/// Runs every mutant of a machine's own modules; `on_done` is called once for each, from any thread.
pub fn run(
    shown: &Shown,
    design: &Design,
    mut report: MutationReport,
    on_done: impl Fn() + Sync,
) -> Result<MutationReport, MutationError> {
    let started = Instant::now();
    let ends = shown.ends(design, &report.unit)?;
    let own = Own::of(design);
    let around = Around::of(design);
    let of_sites = own.modules.par_iter().zip(&own.sites);
    let of_sites = of_sites.flat_map_iter(|(module, sites)| {
        let module_alone = alone(module);
        let known = Known::new(&module_alone, &around.contract(module));
        let known = known.with_effort(shown.effort);
        let groups = sites.chunks(GROUP).map(|sites| {
            let controls = Controls::new(design, sites);
            let alone = alone_judge(&module_alone, &known, sites);
            Group::new(&controls, Some(alone)).fates(shown, &ends, &on_done)
        });
        groups.collect::<Vec<_>>()
    });
    let of_sites = of_sites.collect::<Result<Vec<_>, _>>()?;
    let controls = Controls::new(design, &own.power_up);
    let of_power_up = Group::new(&controls, None).fates(shown, &ends, &on_done)?;
    for (fate, mutant) in of_sites.into_iter().flatten().chain(of_power_up) {
        report.count(fate, 0, || mutant.clone());
    }
    Ok(report.ended(started))
}

impl Shown<'_> {
    /// The clock with which each run of a machine that shows the golden pictures as it is is given up: what takes much
    /// longer than the machine itself hangs.
    fn ends(&self, design: &Design, name: &str) -> Result<Vec<u64>, MutationError> {
        let bare = Compiled::of(design, &[]);
        let ends = (0..self.runs).map(|run| {
            let report = self.report(design, &bare, run, u64::MAX)?;
            let (stimulus, clock) = (run as usize, report.cycles as usize);
            match report.mismatches {
                0 => Ok(2 * report.cycles),
                _ => Err(MutationError::Baseline(name.to_owned(), stimulus, clock)),
            }
        });
        ends.collect()
    }

    /// What comes of a run, which goes on to the first difference or to the clock with which it is given up.
    fn report(
        &self,
        design: &Design,
        compiled: &Compiled,
        run: u64,
        end: u64,
    ) -> Result<Report, MutationError> {
        let plane = self.machine.overlay.then(|| self.plane(run));
        let options = PinsRun {
            overlay: plane.as_ref(),
            stalls: (run > 0).then_some(run),
            late: 37 * run,
            stops: Some(end),
            ..PinsRun::plain(Engine::BuiltIn)
        };
        let hardware = MachineDesign::of(design, compiled.clone().design());
        Ok(run_in(&hardware, self.machine, self.images, &options, || ())?.report)
    }

    /// A plane for a run: pixels and colour drawn by its number; every second one has what the one before has not.
    fn plane(&self, run: u64) -> OverlayPlane {
        let mode = mode(self.machine);
        let mut random = generator(run / 2);
        let other = if run % 2 == 1 { u32::MAX } else { 0 };
        let mut word = || random.next_u32() ^ other;
        let [red, green, blue, _] = word().to_le_bytes();
        let pixels = 0..mode.line.active * mode.frame.active;
        let pixels: Vec<bool> = pixels.map(|_| word() & 1 == 1).collect();
        OverlayPlane::new(&pixels, [red, green, blue])
    }
}

/// The modules of a machine that are no units and in none, and their sites.
struct Own {
    modules: Vec<Arc<Module>>,
    sites: Vec<Vec<Site>>,
    /// What their registers hold at power-up.
    power_up: Vec<Site>,
}

impl Own {
    fn of(design: &Design) -> Own {
        let mut modules: Vec<Arc<Module>> = vec![];
        collect(&design.top, &mut modules);
        let all = design.top.all();
        let sites = sites(design);
        let of = |module: &Arc<Module>| {
            let own = sites.iter();
            let own = own.filter(|site| Arc::ptr_eq(&all[site.module], module));
            own.copied().collect()
        };
        let mut power_up = power_up(design);
        let is_own = |place: usize| modules.iter().any(|own| Arc::ptr_eq(own, &all[place]));
        power_up.retain(|site| is_own(site.module));
        Own {
            sites: modules.iter().map(of).collect(),
            power_up,
            modules,
        }
    }
}

fn collect(module: &Arc<Module>, found: &mut Vec<Arc<Module>>) {
    let name = &module.name[..];
    let is_unit = Unit::ALL.into_iter().any(|unit| unit.name() == name) || STORES.contains(&name);
    if is_unit || found.iter().any(|other| Arc::ptr_eq(other, module)) {
        return;
    }
    found.push(module.clone());
    for instance in &module.instances {
        collect(&instance.module, found);
    }
}

/// The judge of a module alone, and its mutants in the order in which each instance of the module has them.
type Alone = (Judge, Vec<Mutant>);

fn alone_judge(alone: &Design, known: &Known, sites: &[Site]) -> Alone {
    let sites = sites.iter().map(|site| Site { module: 0, ..*site });
    let controls = Controls::new(alone, &sites.collect::<Vec<_>>());
    (Judge::new(&controls, known), controls.mutants())
}

/// Mutants of one compilation.
struct Group<'a> {
    controls: &'a Controls,
    compiled: Compiled,
    mutants: Vec<Mutant>,
    /// None of mutants at power-up.
    alone: Option<Alone>,
}

impl Group<'_> {
    fn new(controls: &Controls, alone: Option<Alone>) -> Group<'_> {
        Group {
            compiled: Compiled::of(&controls.design, &[]),
            mutants: controls.mutants(),
            controls,
            alone,
        }
    }

    /// What became of each mutant, with its description.
    fn fates(
        &self,
        shown: &Shown,
        ends: &[u64],
        on_done: &(impl Fn() + Sync),
    ) -> Result<Vec<(Fate, String)>, MutationError> {
        let mutants = self.mutants.par_iter().enumerate();
        let fates = mutants.map(|(place, mutant)| {
            let fate = self.fate(place, shown, ends)?;
            on_done();
            Ok((fate, self.controls.describe(mutant)))
        });
        fates.collect()
    }

    fn fate(&self, place: usize, shown: &Shown, ends: &[u64]) -> Result<Fate, MutationError> {
        let mutant = self.compiled.upset(&self.mutants[place].upsets);
        let killed = |run: u64| {
            let (design, end) = (&self.controls.design, ends[run as usize]);
            let report = shown.report(design, &mutant, run, end)?;
            let kill = (run as usize, report.cycles as usize);
            Ok::<_, MutationError>((report.mismatches > 0).then_some(Fate::Killed(kill)))
        };
        if let Some(fate) = killed(0)? {
            return Ok(fate);
        }
        let judge = |(judge, mutants): &Alone| judge.judge(&mutants[place % mutants.len()].upsets);
        let reason = match self.alone.as_ref().map(judge) {
            None if is_forgotten(&self.compiled, &mutant) => return Ok(Fate::Forgotten),
            None => "It begins otherwise, and no run shows it",
            Some(Verdict::Equivalent) => return Ok(Fate::Equivalent),
            Some(Verdict::Differs) => "Its module can differ, and no run shows it",
            Some(Verdict::Undecided) => "Undecided: no run shows it, and the solver gave up",
        };
        for run in 1..shown.runs {
            if let Some(fate) = killed(run)? {
                return Ok(fate);
            }
        }
        Ok(Fate::Survived(reason.to_owned()))
    }
}

/// Does a machine that begins otherwise come to hold the same, while the host does nothing?
fn is_forgotten(good: &Compiled, bad: &Compiled) -> bool {
    let [mut good, mut bad] = [good, bad].map(Circuit::new);
    (0..IDLE).any(|_| {
        good.idle();
        bad.idle();
        good.is_like(&bad)
    })
}
