//! A design and its harness in a folder, measured with the tools of a target.

use crate::error::SynthError;
use crate::harness;
use crate::nextpnr;
use crate::report::{SeedResult, SynthReport, median};
use crate::target::{Family, Target};
use crate::tools::Programs;
use crate::yosys;
use imogene_rtl::emit::Emitted;
use imogene_tools::{read, write};
use rayon::prelude::*;
use std::path::Path;

/// Names of the netlists in the folder.
const UNIT_NETLIST: &str = "unit.json";
const HARNESS_NETLIST: &str = "harness.json";

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

    /// Resources of the design alone, and its clock in its harness with so many seeds; with none it is not measured.
    pub fn report(&self, seeds: usize) -> Result<SynthReport, SynthError> {
        let script = format!(
            "{}; {}; delete t:$scopeinfo; write_json {UNIT_NETLIST}; tee -q -o unit.stat {}",
            self.read,
            self.target.synthesis(self.top),
            self.target.statistics()
        );
        yosys::run(&self.programs.yosys, self.folder, &script)?;
        let mut statistics = yosys::parse_statistics(&read(&self.folder.join("unit.stat"))?)?;
        let folded = self.target.fold(&self.folder.join(UNIT_NETLIST))?;
        let own = folded.get(self.top).copied().unwrap_or_default();
        own.take_from(&mut statistics.cells);
        let family = self.target.family();
        let resources = yosys::resources(family, &statistics.cells);
        let counted = |count: u64| (family != Family::Gates).then_some(count);
        let [lut, ff, carry, dsp, bram] = resources.counts().map(counted);
        let mut report = SynthReport {
            unit: self.top.to_owned(),
            target: self.target.name().to_owned(),
            lut,
            ff,
            carry,
            dsp,
            bram,
            transistors: statistics.transistors,
            cells: statistics.cells,
            ..SynthReport::default()
        };
        self.clock(seeds, &mut report)?;
        Ok(report)
    }

    /// Packs the design alone, and places and routes it in its harness with every seed; nothing where the target has
    /// neither.
    fn clock(&self, seeds: usize, report: &mut SynthReport) -> Result<(), SynthError> {
        let (Some(router), Some(device)) = (&self.programs.router, self.target.place_and_route())
        else {
            return Ok(());
        };
        let run = |netlist, seed| nextpnr::run(router, &device, self.folder, netlist, seed);
        let packed = run(UNIT_NETLIST, None)?;
        let logic_cells = packed.utilisation.get(device.logic_cell);
        report.logic_cells = logic_cells.map(|cells| cells.0);
        if seeds == 0 {
            return Ok(());
        }
        report.goal_mhz = Some(device.goal_mhz);
        let script = format!(
            "{}; {}; delete t:$scopeinfo; write_json {HARNESS_NETLIST}",
            self.read_with_harness,
            self.target.synthesis(harness::TOP)
        );
        yosys::run(&self.programs.yosys, self.folder, &script)?;
        self.target.fold(&self.folder.join(HARNESS_NETLIST))?;
        report.does_not_fit = run(HARNESS_NETLIST, None)?.excess();
        if report.does_not_fit.is_some() {
            return Ok(());
        }
        let routed = |seed| {
            let report = run(HARNESS_NETLIST, Some(seed))?;
            let no_clock = || SynthError::report("nextpnr", "it has no clock");
            Ok::<_, SynthError>(SeedResult {
                seed,
                fmax_mhz: report.fmax_mhz.ok_or_else(no_clock)?,
                critical_path: report.critical_path,
            })
        };
        let seeds = (1..=seeds).into_par_iter();
        report.seeds = seeds.map(routed).collect::<Result<_, _>>()?;
        report.fmax_mhz = median(&report.seeds);
        Ok(())
    }
}
