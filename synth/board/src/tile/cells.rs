//! The cells of a tile.

use super::Tile;
use crate::error::BoardError;
use imogene_synth::tools::{Tool, YOSYS};
use imogene_synth::{SynthError, parse_statistics, run_yosys};
use imogene_tools::{read, scratch, write};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Areas and functions of cells, without times.
const SKY130: &str = include_str!("sky130_fd_sc_hd.lib");
/// Where Debian has the cells of 180 nm.
const OSU018: &str = "/usr/share/qflow/tech/osu018";
/// The package that has them.
const OSU018_PACKAGE: &str = "qflow-tech-osu018";

/// A library of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Library {
    /// The cells of the shuttle, 130 nm: what they are and how large.
    Sky130,
    /// OSU, 180 nm, with times and layouts.
    Osu018,
}

/// A tile in the cells of a library.
#[derive(Clone, Debug, Serialize)]
pub struct Mapped {
    /// The library.
    pub library: Library,
    /// Cells by type.
    pub cells: BTreeMap<String, u64>,
    /// Sum of their areas in square micrometres.
    pub area: f64,
    /// The cells and their nets.
    #[serde(skip)]
    pub verilog: String,
}

impl Mapped {
    /// All cells.
    pub fn count(&self) -> u64 {
        self.cells.values().sum()
    }
}

impl Library {
    /// Puts a tile into the cells of the library. Fails when Yosys or the library is missing, or Yosys fails.
    pub fn map(self, tile: &Tile) -> Result<Mapped, BoardError> {
        let folder = scratch()?;
        let path = |name: &str| folder.path().join(name);
        let liberty = match self {
            Library::Sky130 => SKY130.to_owned(),
            Library::Osu018 => osu018("osu018_stdcells.lib")?,
        };
        write(&path("cells.lib"), &liberty)?;
        write(&path("tile.v"), &tile.verilog)?;
        let script = format!(
            "read_verilog tile.v; synth -flatten -top {}; dfflibmap -liberty cells.lib; abc -liberty cells.lib; \
             splitnets; opt_clean -purge; tee -o stat.json stat -json -liberty cells.lib; \
             write_verilog -noattr -noexpr netlist.v",
            tile.top
        );
        run_yosys(&Tool::find(YOSYS)?, folder.path(), &script)?;
        let counted = parse_statistics(&read(&path("stat.json"))?)?;
        let no_area = || SynthError::report("yosys", "no area");
        Ok(Mapped {
            library: self,
            cells: counted.cells,
            area: counted.area.ok_or_else(no_area)?,
            verilog: read(&path("netlist.v"))?,
        })
    }
}

/// Verilog models of the 180 nm cells, with their delays. Fails when the library is missing.
pub fn cell_delays() -> Result<String, BoardError> {
    osu018("osu018_stdcells.v")
}

/// A file of the 180 nm library.
fn osu018(name: &str) -> Result<String, BoardError> {
    let path = PathBuf::from(OSU018).join(name);
    if !path.exists() {
        return Err(BoardError::Library(path, OSU018_PACKAGE));
    }
    Ok(read(&path)?)
}
