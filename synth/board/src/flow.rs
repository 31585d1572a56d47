//! From the sources of a board to its bitstream.

use crate::description::{Board, Family, Part};
use crate::error::BoardError;
use crate::netlist::routed_verilog;
use crate::pll::Pll;
use crate::top::{Sources, TOP};
use imogene_synth::tools::{NEXTPNR_ECP5, NEXTPNR_GOWIN, NEXTPNR_ICE40, Tool, YOSYS};
use imogene_synth::{
    FOLDS, RouteReport, SynthError, TIMING_WEIGHT, digest, fold, kept, parse_report, run_yosys,
};
use imogene_tools::{FileError, Program, read, scratch, write};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

const NETLIST: &str = "board.json";
const TEXT: &str = "board.text";
const REPORT: &str = "report.json";
const ROUTED: &str = "routed.json";
/// Seeds of the router, one after the other until every clock is reached.
const SEEDS: [&str; 4] = ["1", "2", "3", "4"];

/// Keeps registers behind multipliers out of their cells. Yosys 0.70 puts the sum of two products, each with a
/// register, into one cell of an iCE40 and leaves out the second product, which the pins of the bitstream showed.
const KEPT_PRODUCTS: &str =
    "flatten; opt_clean; setattr -set keep 1 t:$mul %co1:+[Y] %co1:+[D] %co1:+[Q] w:* %i";

/// A clock of a routed board, in MHz.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClockReport {
    /// The net of the clock.
    pub clock: String,
    /// What it reaches.
    pub achieved_mhz: f64,
    /// What was asked for.
    pub wanted_mhz: f64,
}

/// A board that was placed and routed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Routed {
    /// Cells used and available, by type.
    pub utilisation: BTreeMap<String, (u64, u64)>,
    /// The seed of the router.
    pub seed: String,
    /// Its clocks; each reaches what was asked for.
    pub clocks: Vec<ClockReport>,
    /// The longest path in ns from a rising edge of one clock to one of another.
    pub crossings: Vec<(String, String, f64)>,
    /// Versions of the tools.
    pub tools: BTreeMap<String, String>,
    /// Bytes of the bitstream.
    pub bytes: usize,
}

impl Part {
    pub(crate) fn name(&self) -> String {
        format!("{} {}", self.device, self.package)
    }

    /// What leads to a bitstream; none where no open program places and routes.
    pub(crate) fn tools(&self) -> Option<Tools> {
        let (router, [option, packer, unpacker]) = match self.family {
            Family::Gowin => (NEXTPNR_GOWIN, ["--write", "gowin_pack", "gowin_unpack"]),
            Family::Ecp5 => (NEXTPNR_ECP5, ["--textcfg", "ecppack", "ecpunpack"]),
            Family::Ice40 => (NEXTPNR_ICE40, ["--asc", "icepack", "iceunpack"]),
            Family::Xilinx7 => return None,
        };
        Some(Tools {
            router,
            option,
            packer,
            unpacker,
        })
    }

    /// The number of a 7 series part.
    pub(crate) fn number(&self) -> String {
        let speed = self.speed.as_deref().unwrap_or_default();
        format!("{}{}-{speed}", self.device, self.package)
    }

    /// The series of a Gowin with the size of its die: `GW1NR-9C` of `GW1N-9C` in `GW1NR-LV9QN88PC6/I5`.
    pub(crate) fn series(&self) -> String {
        let before = |text: &str| text.split('-').next().unwrap_or_default().to_owned();
        self.device
            .replacen(&before(&self.device), &before(&self.package), 1)
    }

    pub(crate) fn arguments(&self) -> Vec<String> {
        if self.family == Family::Gowin {
            let family = format!("family={}", self.device);
            let arguments = ["--device", &self.package, "--vopt", &family];
            return arguments.map(str::to_owned).to_vec();
        }
        let device = format!("--{}", self.device);
        let mut arguments = vec![device, "--package".into(), self.package.clone()];
        if self.family == Family::Ecp5 {
            // The first router rips up three arcs of four of a whole machine, and comes to no end.
            arguments.extend(["--router".into(), "router2".into()]);
            arguments.extend(TIMING_WEIGHT.map(str::to_owned));
        }
        if let Some(speed) = &self.speed {
            arguments.extend(["--speed".into(), speed.clone()]);
        }
        arguments
    }

    /// An iCE40 UltraPlus, alone of its family.
    pub(crate) fn has_multipliers(&self) -> bool {
        self.device.starts_with("up")
    }

    pub(crate) fn synthesis(&self) -> &'static str {
        match self.family {
            // Why without wide tables: docs/synthesis.md.
            Family::Ecp5 => "synth_ecp5 -nowidelut",
            // Eight cells of a tile share one enable: that of a single word goes into the tables beside its bits, for
            // nextpnr finds no place for so many enables in a part that is nearly full.
            Family::Ice40 if self.has_multipliers() => {
                "synth_ice40 -device u -dsp -dffe_min_ce_use 32"
            }
            Family::Ice40 => "synth_ice40",
            // The contents of block memories and the modes of multipliers cannot be read back out of a bitstream.
            Family::Gowin => "synth_gowin -nobram -nodsp",
            Family::Xilinx7 => "synth_xilinx -family xc7 -flatten",
        }
    }

    /// What Yosys does. On an ECP5 each object processor is synthesised by itself: else one flag, the same in all of
    /// them, would become one register that reaches across the part.
    fn script(&self) -> String {
        let synthesis = self.synthesis();
        match self.family {
            Family::Ecp5 => format!(
                "read_verilog board.v; setattr -mod -set keep_hierarchy 1 *_processor *_processor_*; {synthesis} -top {TOP}; \
                 setattr -mod -unset keep_hierarchy A:keep_hierarchy; flatten; opt_clean; write_json {NETLIST}"
            ),
            _ => {
                let products = match self.family {
                    Family::Xilinx7 => "opt_clean",
                    Family::Ice40 if self.has_multipliers() => KEPT_PRODUCTS,
                    // Why by Booth's recoding: docs/synthesis.md.
                    _ => "booth",
                };
                format!(
                    "read_verilog board.v; hierarchy -top {TOP}; proc; {products}; \
                     {synthesis} -top {TOP} -json {NETLIST}"
                )
            }
        }
    }

    /// The file that a bitstream is made of: the text of place and route, of a Gowin the routed netlist.
    fn text(&self) -> &'static str {
        match self.family {
            Family::Gowin => ROUTED,
            _ => TEXT,
        }
    }
}

/// What leads from a netlist to a bitstream, and back.
pub(crate) struct Tools {
    /// Place and route.
    router: Program,
    /// Its option for the text that a bitstream is made of.
    option: &'static str,
    /// The program beside it that makes a bitstream of a text.
    packer: &'static str,
    /// The one that makes the text of a bitstream.
    unpacker: &'static str,
}

impl Tools {
    pub(crate) fn unpacker(&self) -> Result<Tool, SynthError> {
        Tool::beside(self.router, self.unpacker)
    }
}

impl Board {
    /// Its part, and what leads to a bitstream of it. Panics when it is a board without a bitstream.
    pub(crate) fn routed(&self) -> (&Part, Tools) {
        let part = self.part.as_ref();
        let routed = part.and_then(|part| Some((part, part.tools()?)));
        routed.expect("a board whose part is placed and routed")
    }

    /// Open programs place and route its part.
    pub fn has_bitstream(&self) -> bool {
        self.part.as_ref().and_then(Part::tools).is_some()
    }
}

/// Finds what leads from the sources of the board to its bitstream, and back to the text of place and route. Fails
/// when a tool is missing.
pub fn find_tools(board: &Board) -> Result<(), BoardError> {
    let Some(part) = &board.part else {
        return Ok(());
    };
    if let Some(tools) = part.tools() {
        Tool::beside(tools.router, tools.packer)?;
        tools.unpacker()?;
        Tool::find(tools.router)?;
    }
    Tool::find(YOSYS)?;
    Ok(())
}

/// What may fit in the place of what does not.
const REMEDY: &str = "a smaller machine (--machine), tables of colours in it (--lit-sphere) or plain ones (--flat) may fit";

/// The part has too little of something.
pub(crate) fn too_little(part: &Part, excess: String) -> BoardError {
    BoardError::Excess(part.name(), excess, REMEDY)
}

/// What place and route made of a board.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Built {
    /// What it takes and reaches.
    pub routed: Routed,
    /// Its bitstream.
    pub bitstream: Vec<u8>,
    /// Of an ECP5 the routed netlist as Verilog, or the cell of which there is no model.
    pub netlist: Option<Result<String, String>>,
}

/// Synthesises, places, routes and packs a board. Every clock has to reach what is asked for. What was made of the
/// same sources with the same tools is kept. Fails when a tool is missing or fails, the part has too little, or a
/// clock is not reached. Panics when the board has no part that is placed and routed here.
pub fn route(board: &Board, pll: &Pll, sources: &Sources) -> Result<Built, BoardError> {
    let (part, tools) = board.routed();
    let (yosys, router) = (Tool::find(YOSYS)?, Tool::find(tools.router)?);
    let (kind, constraints) = sources.constraints.as_ref().expect("constraints of a part");
    let pins = format!("pins.{kind}");
    let script = part.script();
    let mut arguments = part.arguments();
    arguments.extend(match part.family {
        Family::Gowin => ["--vopt".to_owned(), format!("{kind}={pins}")],
        _ => [format!("--{kind}"), pins.clone()],
    });
    let common = ["--json", NETLIST, "-q", "--report", REPORT];
    arguments.extend(common.map(str::to_owned));
    // The clock of the pixels is derived from that of the board; where nothing is derived it is asked for.
    arguments.extend(["--freq".to_owned(), format!("{:.6}", pll.pixel_mhz())]);
    let place = kept(&[
        &digest(&sources.verilog),
        constraints,
        &script,
        &arguments.join(" "),
        FOLDS,
        // What there is a model of decides what is kept.
        &digest(include_str!("netlist.rs")),
        &SEEDS.join(" "),
        &yosys.version,
        &router.version,
    ]);
    place.or_made(|| {
        let folder = scratch()?;
        let folder = folder.path();
        write(&folder.join("board.v"), &sources.verilog)?;
        write(&folder.join(&pins), constraints)?;
        run_yosys(&yosys, folder, &script)?;
        if part.family == Family::Ecp5 {
            fold(&folder.join(NETLIST))?;
        }
        // Packed first, to say what the part has too little of.
        let packing = [&arguments[..], &["--pack-only".to_owned()]].concat();
        router.run(&packing, folder)?;
        if let Some(excess) = parse_report(&read(&folder.join(REPORT))?)?.excess() {
            return Err(too_little(part, excess));
        }
        if part.text() == TEXT {
            arguments.extend([tools.option, TEXT].map(str::to_owned));
        }
        let (seed, report) = placed(part, pll, &router, (&arguments, folder))?;
        let bitstream = packed_text(board, part.text(), folder)?;
        let netlist = match part.family {
            Family::Ecp5 => Some(routed_verilog(&yosys, folder, ROUTED)?),
            _ => None,
        };
        let clocks = report.clocks.into_iter();
        let clocks = clocks.map(|(clock, routed)| ClockReport {
            clock,
            achieved_mhz: routed.achieved,
            wanted_mhz: routed.constraint,
        });
        let crossings = report.crossings.into_iter();
        let routed = Routed {
            utilisation: report.utilisation,
            seed: seed.to_owned(),
            clocks: clocks.collect(),
            crossings: crossings.map(|((from, to), ns)| (from, to, ns)).collect(),
            tools: [&yosys, &router].map(Tool::named_version).into(),
            bytes: bitstream.len(),
        };
        Ok(Built {
            routed,
            bitstream,
            netlist,
        })
    })
}

/// Places and routes the design with the first seed that finds a place for all and reaches every clock; the seed, or
/// the error of the last one.
fn placed(
    part: &Part,
    pll: &Pll,
    router: &Tool,
    (arguments, folder): (&[String], &Path),
) -> Result<(&'static str, RouteReport), BoardError> {
    let mut seeds = SEEDS.into_iter();
    loop {
        let seed = seeds.next().expect("an end by its error");
        let routed = placed_once(part, router, (arguments, folder), seed)
            .and_then(|report| cross_in_time(part, pll, &report).map(|()| report));
        match routed {
            Ok(report) => return Ok((seed, report)),
            Err(BoardError::Slow(_) | BoardError::Crowded(..)) if seeds.len() > 0 => (),
            Err(error) => return Err(error),
        }
    }
}

fn placed_once(
    part: &Part,
    router: &Tool,
    (arguments, folder): (&[String], &Path),
    seed: &str,
) -> Result<RouteReport, BoardError> {
    let report = folder.join(REPORT);
    std::fs::remove_file(&report).map_err(FileError::at(&report))?;
    let own = ["--seed", seed, "--write", ROUTED].map(str::to_owned);
    let outcome = router.run(&[arguments, &own].concat(), folder);
    // A clock that is not reached ends the router with an error, behind its report.
    let Ok(text) = read(&report) else {
        let error = outcome.err();
        let error = error.unwrap_or_else(|| SynthError::tool(router.name, ""));
        let said = error.to_string();
        return Err(match unplaced(&said) {
            Some(kind) => too_little(part, format!("more cells {kind} than find a place")),
            None if is_crowded(&said) => BoardError::Crowded(part.name(), REMEDY),
            None => error.into(),
        });
    };
    let report = parse_report(&text)?;
    let mut clocks = report.clocks.iter();
    if let Some((name, clock)) = clocks.find(|(_, clock)| clock.achieved < clock.constraint) {
        let (part, achieved, wanted) = (part.name(), clock.achieved, clock.constraint);
        return Err(BoardError::Slow(format!(
            "the clock {name} reaches {achieved:.2} MHz on {part}, {wanted:.2} MHz are asked for"
        )));
    }
    outcome?;
    Ok(report)
}

/// The kind of cell that the router says it finds no place for, though the part has as many.
pub fn unplaced(said: &str) -> Option<&str> {
    let (_, cell) = said.split_once("Unable to find legal placement for cell")?;
    let (_, kind) = cell.split_once("of type '")?;
    Some(kind.split_once('\'')?.0)
}

/// Does the router say that it finds no place for all cells together? With another seed it may.
pub fn is_crowded(said: &str) -> bool {
    said.contains("Unable to find legal placement for all cells")
}

/// The bitstream of a text in the folder.
pub(crate) fn packed_text(board: &Board, text: &str, folder: &Path) -> Result<Vec<u8>, BoardError> {
    let (part, tools) = board.routed();
    let packer = Tool::beside(tools.router, tools.packer)?;
    let name = format!("{text}.bit");
    match part.family {
        Family::Gowin => packer.run(&["-d", &part.device, "-o", &name, text], folder)?,
        _ => packer.run(&[text, &name], folder)?,
    }
    let path = folder.join(name);
    Ok(std::fs::read(&path).map_err(FileError::at(&path))?)
}

/// Checks the paths from the clock of the pixels to that of the pairs: a word is taken three clocks behind the edge
/// that changes it, or two where that edge comes a little early.
fn cross_in_time(part: &Part, pll: &Pll, report: &RouteReport) -> Result<(), BoardError> {
    let most = 2000.0 / pll.fast_mhz();
    match report.crossings.iter().find(|(_, length)| **length > most) {
        Some(((from, to), length)) => Err(BoardError::Slow(format!(
            "a path from {from} to {to} takes {length:.2} ns on {}, {most:.2} ns are between their edges",
            part.name()
        ))),
        None => Ok(()),
    }
}
