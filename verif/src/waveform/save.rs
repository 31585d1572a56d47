//! The GTKWave save file of a trace.

use super::file::range_of;
use super::{Group, PERIOD, Sample, Trace};
use crate::signal::Signal;
use std::path::{Path, PathBuf};

/// Pixels of a character in GTKWave's font, and of the slanted edges on both sides of a value.
const CHARACTER: usize = 8;
const EDGES: usize = 16;

/// The save file of a file of waveforms.
pub fn save_path(waveforms: &Path) -> PathBuf {
    waveforms.with_extension("gtkw")
}

impl Trace {
    pub(super) fn save_file(&self, path: &Path) -> String {
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

/// A signal of the save file under a name of its own: decimal for numbers, binary for bits. 420 is signed decimal, 24
/// decimal, 28 binary.
fn entry(scope: &str, signal: &Signal, shown: &str) -> String {
    let format = match (signal.width, signal.signed) {
        (1, _) => "@28",
        (_, true) => "@420",
        (_, false) => "@24",
    };
    let range = range_of(signal);
    format!("{format}\n+{{{shown}}} {scope}.{}{range}\n", signal.name)
}
