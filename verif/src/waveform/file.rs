//! The files of a trace: the same names and changes as VCD or as FST, and the save file of GTKWave.

use super::{Group, Sample, Trace};
use crate::signal::Signal;
use fst_writer::{
    FstFileType, FstHeaderWriter, FstInfo, FstScopeType, FstSignalType, FstVarDirection,
    FstVarType, FstWriteError,
};
use imogene_files::{Outputs, WriteError};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::iter::repeat;
use std::path::{Path, PathBuf};
use vcd::{SimulationCommand, TimescaleUnit, Value, VarType};

/// Time units of one clock in the trace; the edge is in the middle.
const PERIOD: u64 = 10;

/// Bytes of changes after which a block of an FST is written.
const FST_BLOCK: usize = 1 << 26;

/// A line of the hierarchy of names.
enum Line<'a> {
    Scope(&'a str),
    ScopeEnds,
    Variable(&'a str, &'a Signal),
}

/// What a file is told of the clocks: the time, and a new value of a variable, by its number in the hierarchy.
enum Change<'a> {
    Time(u64),
    Value(usize, &'a [u8]),
}

impl Group {
    fn variables(&self) -> Vec<(String, Signal)> {
        let mut list = vec![("mismatch".to_owned(), Signal::new("mismatch", 1, false))];
        for (scope, signals) in [
            ("stimulus.", &self.stimulus),
            ("hardware.", &self.compared),
            ("golden.", &self.compared),
            ("", &self.observed),
        ] {
            let path = |signal: &Signal| (format!("{scope}{}", signal.name), signal.clone());
            list.extend(signals.iter().map(path));
        }
        (list.iter_mut()).for_each(|(path, _)| *path = format!("imogene.{}.{path}", self.name));
        list
    }

    fn values(&self, sample: &Sample) -> impl Iterator<Item = Option<i64>> {
        let differs = i64::from(sample.differs());
        let given = [differs].into_iter().chain(sample.stimulus.iter().copied());
        let outputs = sample.hardware.iter().chain(&sample.golden);
        let observed = outputs.chain(&sample.observed).copied();
        let count = 1 + self.stimulus.len() + 2 * self.compared.len() + self.observed.len();
        let all = given.map(Some).chain(observed);
        all.chain(repeat(None)).take(count)
    }
}

/// The hierarchy of variables, of which those of a scope stand together.
fn declare<E>(
    variables: &[(String, Signal)],
    mut tell: impl FnMut(Line) -> Result<(), E>,
) -> Result<(), E> {
    let mut open: Vec<&str> = vec![];
    for (path, signal) in variables {
        let mut scopes: Vec<&str> = path.split('.').collect();
        let name = scopes.pop().unwrap_or_default();
        let common = (open.iter().zip(&scopes)).take_while(|(a, b)| a == b);
        let common = common.count();
        (common..open.len()).try_for_each(|_| tell(Line::ScopeEnds))?;
        (scopes[common..].iter()).try_for_each(|scope| tell(Line::Scope(scope)))?;
        tell(Line::Variable(name, signal))?;
        open = scopes;
    }
    open.iter().try_for_each(|_| tell(Line::ScopeEnds))
}

/// The range of a vector as it stands behind its name.
fn range_of(signal: &Signal) -> String {
    match signal.width {
        1 => String::new(),
        width => format!("[{}:0]", width - 1),
    }
}

impl Trace {
    /// Writes `path`, FST if its name ends in `.fst` and VCD otherwise, and the save file beside it; returns both.
    pub fn write(&self, path: &Path) -> Result<Vec<PathBuf>, WriteError> {
        let mut files = Outputs::new();
        self.add_to(&mut files, path)?;
        files.finish()
    }

    /// Adds both to other files of a run.
    pub fn add_to(&self, files: &mut Outputs, path: &Path) -> Result<(), WriteError> {
        let ending = path.extension();
        if ending.is_some_and(|ending| ending.eq_ignore_ascii_case("fst")) {
            let written = self.write_fst(BufWriter::new(files.open(path)?));
            let written = written.map_err(|error| match error {
                FstWriteError::Io(error) => error,
                other => io::Error::other(other),
            });
            written.map_err(WriteError::at(path))?;
        } else {
            files.add(path, |out| self.write_vcd(out))?;
        }
        files.add_text(&save_path(path), &self.save_file(path))
    }

    /// The clock, then the variables of all groups.
    fn variables(&self) -> Vec<(String, Signal)> {
        let clock = ("imogene.clock".to_owned(), Signal::new("clock", 1, false));
        let groups = self.groups.iter().flat_map(Group::variables);
        [clock].into_iter().chain(groups).collect()
    }

    /// Tells all changes of the variables.
    fn changes<E>(
        &self,
        variables: &[(String, Signal)],
        mut tell: impl FnMut(Change) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut before: Option<&Vec<Sample>> = None;
        let mut bits = vec![];
        for (clock, samples) in &self.clocks {
            tell(Change::Time(clock * PERIOD))?;
            tell(Change::Value(0, b"1"))?;
            let values = |samples| {
                let groups = self.groups.iter().zip(samples);
                groups.flat_map(|(group, sample)| group.values(sample))
            };
            let mut old = before.into_iter().flat_map(values);
            let new = values(samples);
            for (number, (value, (_, signal))) in (1..).zip(new.zip(&variables[1..])) {
                if old.next() != Some(value) {
                    set_bits(&mut bits, signal, value);
                    tell(Change::Value(number, &bits))?;
                }
            }
            tell(Change::Time(clock * PERIOD + PERIOD / 2))?;
            tell(Change::Value(0, b"0"))?;
            before = Some(samples);
        }
        let end = self.clocks.last();
        end.map_or(Ok(()), |(clock, _)| {
            tell(Change::Time((clock + 1) * PERIOD))
        })
    }

    fn write_vcd(&self, out: impl Write) -> io::Result<()> {
        let mut writer = vcd::Writer::new(out);
        writer.timescale(1, TimescaleUnit::NS)?;
        let variables = self.variables();
        let mut ids = vec![];
        declare(&variables, |line| match line {
            Line::Scope(name) => writer.add_module(name),
            Line::ScopeEnds => writer.upscope(),
            Line::Variable(name, s) => {
                let range = vcd::ReferenceIndex::Range(s.width as i32 - 1, 0);
                let range = (s.width > 1).then_some(range);
                let id = writer.add_var(VarType::Wire, s.width, name, range);
                id.map(|id| ids.push(id))
            }
        })?;
        writer.enddefinitions()?;
        writer.begin(SimulationCommand::Dumpvars)?;
        writer.end()?;
        self.changes(&variables, |change| match change {
            Change::Time(time) => writer.timestamp(time),
            Change::Value(number, &[bit]) => writer.change_scalar(ids[number], level(&bit)),
            Change::Value(number, bits) => {
                writer.change_vector(ids[number], bits.iter().map(level))
            }
        })
    }

    fn write_fst(&self, out: BufWriter<File>) -> Result<(), FstWriteError> {
        let start = self.clocks.first().map_or(0, |(clock, _)| clock * PERIOD);
        let info = FstInfo {
            start_time: start,
            timescale_exponent: -9,
            version: "imogene".into(),
            // None, so that a run that is repeated gives the same file.
            date: String::new(),
            file_type: FstFileType::Verilog,
        };
        let mut header = FstHeaderWriter::new(out, &info)?;
        let variables = self.variables();
        let mut ids = vec![];
        declare(&variables, |line| match line {
            Line::Scope(name) => header.scope(name, "", FstScopeType::Module),
            Line::ScopeEnds => header.up_scope(),
            Line::Variable(name, s) => {
                let name = format!("{name} {}", range_of(s));
                let (kind, way) = (FstVarType::Wire, FstVarDirection::Implicit);
                let word = FstSignalType::bit_vec(s.width);
                let id = header.var(name.trim_end(), word, kind, way, None);
                id.map(|id| ids.push(id))
            }
        })?;
        let mut body = header.finish()?;
        self.changes(&variables, |change| match change {
            Change::Time(time) => {
                if body.size() > FST_BLOCK {
                    body.flush()?;
                }
                body.time_change(time)
            }
            Change::Value(number, bits) => body.signal_change(ids[number], bits),
        })?;
        Ok(body.finish()?.flush()?)
    }
}

/// The bits of a value as letters, the high one first.
fn set_bits(bits: &mut Vec<u8>, signal: &Signal, value: Option<i64>) {
    let letter = |index: u32| match value {
        None => b'x',
        Some(value) => b'0' + (signal.bits(value) >> index & 1) as u8,
    };
    bits.clear();
    bits.extend((0..signal.width).rev().map(letter));
}

fn level(letter: &u8) -> Value {
    match letter {
        b'0' => Value::V0,
        b'1' => Value::V1,
        _ => Value::X,
    }
}

/// Pixels of a character in GTKWave's font, and of the slanted edges on both sides of a value.
const CHARACTER: usize = 8;
const EDGES: usize = 16;

/// The save file of a file of waveforms.
pub fn save_path(waveforms: &Path) -> PathBuf {
    waveforms.with_extension("gtkw")
}

impl Trace {
    fn save_file(&self, path: &Path) -> String {
        let file = path.file_name().unwrap_or_default();
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
            for signal in &group.observed {
                text += &entry(&format!("imogene.{name}"), signal, &signal.name);
            }
        }
        text
    }

    /// The zoom that gives a clock room for every digit: GTKWave shows 2^-zoom time units on 200 pixels.
    fn zoom(&self) -> f64 {
        let compared = self.groups.iter().flat_map(|group| &group.compared);
        let characters = compared.map(characters).max().unwrap_or(1);
        let clock = (CHARACTER * characters + EDGES) as f64;
        -(200.0 * PERIOD as f64 / clock).log2()
    }

    /// Pixels of the column of names.
    fn names_width(&self) -> usize {
        let signals = |group: &Group| {
            let pairs = group.stimulus.iter().chain(&group.compared);
            let pairs = pairs.map(|signal| signal.name.len() + " hardware".len());
            let observed = group.observed.iter().map(|signal| signal.name.len());
            pairs.chain(observed).max()
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

/// A signal of the save file under a name of its own: signed decimal (420), decimal (24), or binary (28) for bits.
fn entry(scope: &str, signal: &Signal, shown: &str) -> String {
    let format = match (signal.width, signal.signed) {
        (1, _) => "@28",
        (_, true) => "@420",
        (_, false) => "@24",
    };
    let range = range_of(signal);
    format!("{format}\n+{{{shown}}} {scope}.{}{range}\n", signal.name)
}
