//! Waveforms: a VCD with hardware and golden signals side by side, and a GTKWave save file that opens it grouped.

use crate::signal::Signal;
use imogene_files::{Outputs, WriteError};
use std::collections::VecDeque;
use std::io::Write;
use std::path::{Path, PathBuf};
use vcd::{IdCode, SimulationCommand, TimescaleUnit, Value, VarType};

/// Time units of one clock in the trace; the edge is in the middle.
const PERIOD: u64 = 10;

/// Pixels of a character in GTKWave's font, and of the slanted edges on both sides of a value.
const CHARACTER: usize = 8;
const EDGES: usize = 16;

/// A group of signals that belong together, such as one unit.
#[derive(Clone, Debug)]
pub struct Group {
    /// Name of the unit.
    pub name: String,
    /// Stimulus: signals that both sides are given.
    pub stimulus: Vec<Signal>,
    /// Signals that both sides produce.
    pub compared: Vec<Signal>,
}

/// One clock of one group.
#[derive(Clone, Debug, Default)]
pub struct Sample {
    /// Values of the stimulus.
    pub stimulus: Vec<i64>,
    /// Values of the hardware after the edge; `None` where a bit is undefined.
    pub hardware: Vec<Option<i64>>,
    /// Values of the golden model; `None` where it states nothing.
    pub golden: Vec<Option<i64>>,
}

/// Clocks kept before a late window opens, so that a mismatch is seen with what led to it.
const BEFORE_WINDOW: usize = 60;

/// A recorded trace: groups, and one sample per group for each recorded clock.
#[derive(Clone, Debug)]
pub struct Trace {
    groups: Vec<Group>,
    clocks: Vec<(u64, Vec<Sample>)>,
    recent: VecDeque<(u64, Vec<Sample>)>,
}

/// One group's variables: in the order of [`Sample::values`], and whether the sides differ.
struct Variables {
    values: Vec<(Signal, IdCode)>,
    mismatch: IdCode,
}

/// The save file of a VCD.
pub fn save_path(vcd: &Path) -> PathBuf {
    vcd.with_extension("gtkw")
}

impl Trace {
    /// An empty trace of these groups.
    pub fn new(groups: Vec<Group>) -> Trace {
        Trace {
            groups,
            clocks: Vec::new(),
            recent: VecDeque::new(),
        }
    }

    /// Records a clock: a sample per group, in the order of the groups.
    pub fn record(&mut self, clock: u64, samples: Vec<Sample>) {
        self.clocks.extend(self.recent.drain(..));
        self.clocks.push((clock, samples));
    }

    /// Keeps a clock only in case the next one is recorded.
    pub fn remember(&mut self, clock: u64, samples: Vec<Sample>) {
        if self.recent.len() == BEFORE_WINDOW {
            self.recent.pop_front();
        }
        self.recent.push_back((clock, samples));
    }

    /// Drops what is kept in case: what is recorded next begins by itself.
    pub fn forget(&mut self) {
        self.recent.clear();
    }

    /// Clocks recorded.
    pub fn len(&self) -> usize {
        self.clocks.len()
    }

    /// True if nothing was recorded.
    pub fn is_empty(&self) -> bool {
        self.clocks.is_empty()
    }

    /// Writes `path` (VCD) and the save file beside it; returns both paths.
    pub fn write(&self, path: &Path) -> Result<Vec<PathBuf>, WriteError> {
        let mut files = Outputs::new();
        self.add_to(&mut files, path)?;
        files.finish()
    }

    /// Adds both to other files of a run.
    pub fn add_to(&self, files: &mut Outputs, path: &Path) -> Result<(), WriteError> {
        files.add(path, |mut out| self.write_vcd(&mut out))?;
        let save = self.save_file(path);
        files.add_text(&save_path(path), &save)
    }

    fn write_vcd(&self, out: &mut impl Write) -> std::io::Result<()> {
        let mut writer = vcd::Writer::new(out);
        writer.timescale(1, TimescaleUnit::NS)?;
        writer.add_module("imogene")?;
        let clock = writer.add_wire(1, "clock")?;
        let mut variables = Vec::new();
        for group in &self.groups {
            variables.push(declare(&mut writer, group)?);
        }
        writer.upscope()?;
        writer.enddefinitions()?;
        writer.begin(SimulationCommand::Dumpvars)?;
        writer.end()?;
        let mut before: Vec<Option<Sample>> = vec![None; self.groups.len()];
        for (number, samples) in &self.clocks {
            writer.timestamp(number * PERIOD)?;
            writer.change_scalar(clock, Value::V1)?;
            for (index, sample) in samples.iter().enumerate() {
                change(&mut writer, &variables[index], &before[index], sample)?;
                before[index] = Some(sample.clone());
            }
            writer.timestamp(number * PERIOD + PERIOD / 2)?;
            writer.change_scalar(clock, Value::V0)?;
        }
        match self.clocks.last() {
            Some((number, _)) => writer.timestamp((number + 1) * PERIOD),
            None => Ok(()),
        }
    }

    fn save_file(&self, vcd_path: &Path) -> String {
        let file = vcd_path.file_name().unwrap_or_default();
        let file = file.to_string_lossy();
        let start = self.clocks.first().map_or(0, |(clock, _)| clock * PERIOD);
        let mut text = format!(
            "[dumpfile] \"{file}\"\n[timestart] {start}\n[size] 1600 1000\n[signals_width] {}\n*{:.6} ",
            self.names_width(),
            self.zoom()
        );
        // The marker stands at the first mismatch; -1 is no marker.
        let differs = |samples: &[Sample]| samples.iter().any(Sample::differs);
        let first = self.clocks.iter().find(|(_, samples)| differs(samples));
        text += &first.map_or("-1".to_string(), |(clock, _)| (clock * PERIOD).to_string());
        text += " -1 -1\n@28\nimogene.clock\n";
        for group in &self.groups {
            let name = &group.name;
            text += &format!("@200\n-{name}\n@28\nimogene.{name}.mismatch\n");
            for signal in &group.stimulus {
                text += &entry(&format!("imogene.{name}.stimulus"), signal, &signal.name);
            }
            for signal in &group.compared {
                for side in ["hardware", "golden"] {
                    let shown = format!("{} {side}", signal.name);
                    text += &entry(&format!("imogene.{name}.{side}"), signal, &shown);
                }
            }
        }
        text
    }

    /// The zoom at which a clock has room for every digit of what changes in each: GTKWave shows 2^-zoom time units
    /// on 200 pixels.
    fn zoom(&self) -> f64 {
        let compared = self.groups.iter().flat_map(|group| &group.compared);
        let characters = compared.map(characters).max().unwrap_or(1);
        let clock = (CHARACTER * characters + EDGES) as f64;
        -(200.0 * PERIOD as f64 / clock).log2()
    }

    /// Pixels of the column of names.
    fn names_width(&self) -> usize {
        let signals = |group: &Group| {
            let all = group.stimulus.iter().chain(&group.compared);
            all.map(|signal| signal.name.len() + " hardware".len())
                .max()
        };
        let longest = self.groups.iter().filter_map(signals).max().unwrap_or(0);
        // Room for the range in brackets, and for GTKWave's margins.
        CHARACTER * (longest + "[00:0]".len()) + 2 * EDGES
    }
}

/// Characters of the longest value of a signal, as [`entry`] shows it.
fn characters(signal: &Signal) -> usize {
    let magnitude = signal.width - u32::from(signal.signed);
    let digits = (1u128 << magnitude).to_string().len();
    digits + usize::from(signal.signed)
}

impl Sample {
    /// All values: those of the stimulus, then of each signal the hardware's and the golden one.
    fn values(&self) -> impl Iterator<Item = Option<i64>> {
        let compared = self.hardware.iter().zip(&self.golden);
        let compared = compared.flat_map(|(hardware, golden)| [*hardware, *golden]);
        self.stimulus.iter().copied().map(Some).chain(compared)
    }

    /// True if a stated golden value differs from the hardware's.
    pub fn differs(&self) -> bool {
        self.hardware
            .iter()
            .zip(&self.golden)
            .any(|(hardware, golden)| golden.is_some() && golden != hardware)
    }
}

/// A signal of the save file under a name of its own: decimal for numbers, binary for bits. 420 is signed decimal, 24
/// decimal, 28 binary.
fn entry(scope: &str, signal: &Signal, shown: &str) -> String {
    let format = match (signal.width, signal.signed) {
        (1, _) => "@28",
        (_, true) => "@420",
        (_, false) => "@24",
    };
    let range = if signal.width > 1 {
        format!("[{}:0]", signal.width - 1)
    } else {
        String::new()
    };
    format!("{format}\n+{{{shown}}} {scope}.{}{range}\n", signal.name)
}

fn declare(writer: &mut vcd::Writer<impl Write>, group: &Group) -> std::io::Result<Variables> {
    writer.add_module(&group.name)?;
    let mismatch = writer.add_wire(1, "mismatch")?;
    let mut scope = |name: &str, signals: &[Signal]| {
        writer.add_module(name)?;
        let mut variables = Vec::new();
        for s in signals {
            let id = writer.add_var(VarType::Wire, s.width, &s.name, range_of(s))?;
            variables.push((s.clone(), id));
        }
        writer.upscope()?;
        std::io::Result::Ok(variables)
    };
    let mut values = scope("stimulus", &group.stimulus)?;
    let hardware = scope("hardware", &group.compared)?;
    let golden = scope("golden", &group.compared)?;
    values.extend(hardware.into_iter().zip(golden).flat_map(<[_; 2]>::from));
    writer.upscope()?;
    Ok(Variables { values, mismatch })
}

fn range_of(signal: &Signal) -> Option<vcd::ReferenceIndex> {
    (signal.width > 1).then_some(vcd::ReferenceIndex::Range(signal.width as i32 - 1, 0))
}

/// Writes the values that changed since the last clock.
fn change(
    writer: &mut vcd::Writer<impl Write>,
    variables: &Variables,
    before: &Option<Sample>,
    now: &Sample,
) -> std::io::Result<()> {
    let mut before_values = before.iter().flat_map(Sample::values);
    for ((signal, id), value) in variables.values.iter().zip(now.values()) {
        if before_values.next() != Some(value) {
            write_value(writer, *id, signal, value)?;
        }
    }
    let differs = now.differs();
    if before.as_ref().map(Sample::differs) != Some(differs) {
        writer.change_scalar(variables.mismatch, Value::from(differs))?;
    }
    Ok(())
}

fn write_value(
    writer: &mut vcd::Writer<impl Write>,
    id: IdCode,
    signal: &Signal,
    value: Option<i64>,
) -> std::io::Result<()> {
    let bit = |index: u32| match value {
        None => Value::X,
        Some(v) => Value::from((signal.bits(v) >> index) & 1 == 1),
    };
    if signal.width == 1 {
        writer.change_scalar(id, bit(0))
    } else {
        writer.change_vector(id, (0..signal.width).rev().map(bit))
    }
}
