//! A design and its harness in a folder, measured with the tools of a target.

use crate::error::SynthError;
use crate::harness;
use crate::nextpnr::{self, RouteReport, Run};
use crate::report::{SeedResult, median};
use crate::target::Target;
use crate::tools::Programs;
use crate::yosys::{self, Resources, Statistics};
use imogene_rtl::emit::Emitted;
use imogene_tools::{read, write};
use rayon::prelude::*;
use std::path::Path;

/// Names of the netlists in the folder.
const UNIT_NETLIST: &str = "unit.json";
const HARNESS_NETLIST: &str = "harness.json";

/// How a synthesis is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Seeds of place and route, from 1; with 0 the clock is not measured.
    pub seeds: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { seeds: 3 }
    }
}

/// A folder with a design and its harness, and how Yosys reads them.
pub(crate) struct Bench<'a> {
    pub programs: &'a Programs,
    pub target: Target,
    pub folder: &'a Path,
    /// Module of the design.
    pub top: &'a str,
    /// Commands that read the design.
    pub read: &'a str,
    /// Commands that read the design and its harness.
    pub read_with_harness: &'a str,
}

/// What packing, placing and routing tell; nothing where the target has neither.
#[derive(Debug, Default)]
pub(crate) struct Clock {
    pub logic_cells: Option<u64>,
    pub goal_mhz: Option<u32>,
    pub does_not_fit: Option<String>,
    pub seeds: Vec<SeedResult>,
    pub fmax_mhz: Option<f64>,
}

impl<'a> Bench<'a> {
    /// An emitted unit and its harness, whose texts are written into the folder.
    pub fn of(
        programs: &'a Programs,
        target: Target,
        folder: &'a Path,
        unit: &'a Emitted,
        harness: &str,
    ) -> Result<Self, SynthError> {
        write(&folder.join("unit.v"), &unit.bundle())?;
        write(&folder.join("harness.v"), harness)?;
        Ok(Self {
            programs,
            target,
            folder,
            top: &unit.top,
            read: "read_verilog unit.v",
            read_with_harness: "read_verilog unit.v harness.v",
        })
    }

    /// Resources of the design alone; its netlist stays in the folder.
    pub fn resources(&self) -> Result<(Statistics, Resources), SynthError> {
        let script = format!(
            "{}; {}; delete t:$scopeinfo; write_json {UNIT_NETLIST}; tee -q -o unit.stat {}",
            self.read,
            self.target.synthesis(self.top),
            self.target.statistics()
        );
        yosys::run(&self.programs.yosys, self.folder, &script)?;
        let statistics = yosys::parse_statistics(&read(&self.folder.join("unit.stat"))?)?;
        let resources = yosys::resources(self.target.family(), &statistics.cells);
        Ok((statistics, resources))
    }

    /// Packs the design alone, after its resources, and places and routes it in its harness with every seed.
    pub fn clock(&self, options: &Options) -> Result<Clock, SynthError> {
        let (Some(router), Some(device)) = (&self.programs.router, self.target.place_and_route())
        else {
            return Ok(Clock::default());
        };
        let run = |netlist, run| nextpnr::run(router, &device, self.folder, netlist, run);
        let packed = run(UNIT_NETLIST, Run::Pack)?;
        let logic_cells = packed.utilisation.get(device.logic_cell);
        let mut clock = Clock {
            logic_cells: logic_cells.map(|cells| cells.0),
            ..Clock::default()
        };
        if options.seeds == 0 {
            return Ok(clock);
        }
        clock.goal_mhz = Some(device.goal_mhz);
        self.synthesise_harness()?;
        clock.does_not_fit = run(HARNESS_NETLIST, Run::Pack)?.excess();
        if clock.does_not_fit.is_some() {
            return Ok(clock);
        }
        let seeds = (1..=options.seeds).into_par_iter();
        clock.seeds = seeds
            .map(|seed| seed_result(seed, run(HARNESS_NETLIST, Run::Route { seed })?))
            .collect::<Result<_, _>>()?;
        clock.fmax_mhz = median(&clock.seeds);
        Ok(clock)
    }

    fn synthesise_harness(&self) -> Result<(), SynthError> {
        let script = format!(
            "{}; {}; delete t:$scopeinfo; write_json {HARNESS_NETLIST}",
            self.read_with_harness,
            self.target.synthesis(harness::TOP)
        );
        yosys::run(&self.programs.yosys, self.folder, &script)
    }
}

fn seed_result(seed: usize, report: RouteReport) -> Result<SeedResult, SynthError> {
    let fmax_mhz = report.fmax_mhz.ok_or_else(|| SynthError::Report {
        tool: "nextpnr",
        problem: "it has no clock".into(),
    })?;
    Ok(SeedResult {
        seed,
        fmax_mhz,
        critical_path: report.critical_path,
    })
}
