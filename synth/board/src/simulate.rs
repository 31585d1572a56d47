//! The pins of a board in Verilator: of its sources, of a netlist, or of what comes out of a bitstream.

use crate::description::{Board, Video};
use crate::error::BoardError;
use crate::screen::Tick;
use crate::tmds::{Channels, decode};
use imogene_tools::{FileError, VERILATOR, scratch, write};
use minijinja::{Environment, context};
use std::path::Path;

const BENCH: &str = include_str!("top/bench.v");
const DRIVER: &str = include_str!("top/bench.cpp");
const OPTIONS: &str = "--cc --exe --build -j 2 -O3 --x-assign fast --x-initial fast -Wno-fatal -Wno-lint -Wno-style \
    --top-module board_bench --Mdir cpp -CFLAGS -O1 bench.v design.v models.v bench.cpp";

/// What the pins of a board have shown.
#[derive(Clone, Debug)]
pub struct Pins {
    /// Each clock of the pixels.
    pub ticks: Vec<Tick>,
    /// What was found on DVI channels, without its ticks; none of parallel pins.
    pub channels: Option<Channels>,
    /// Each bit of the DVI channels: bits 0 to 3 are blue, green, red and their clock; none of parallel pins.
    pub samples: Vec<u8>,
}

/// Simulates a board for so many clocks of the pixels. `models` are those of the cells that the Verilog instantiates.
///
/// # Errors
///
/// When Verilator is missing or refuses the Verilog, or the pins carry no words.
pub fn simulate(
    board: &Board,
    verilog: &str,
    models: &str,
    clocks: u64,
) -> Result<Pins, BoardError> {
    let samples = samples(board, verilog, models, clocks)?;
    let Video::Tmds { .. } = board.video else {
        let ticks = samples.into_iter().map(|pins| tick(board, pins));
        return Ok(Pins {
            ticks: ticks.collect(),
            channels: None,
            samples: vec![],
        });
    };
    let samples: Vec<u8> = samples.into_iter().map(|pins| pins as u8).collect();
    let mut channels = decode(&samples)?;
    Ok(Pins {
        ticks: std::mem::take(&mut channels.ticks),
        channels: Some(channels),
        samples,
    })
}

/// The levels of all pins, the first in bit 0: after both edges of the fast clock, or once a pixel.
fn samples(
    board: &Board,
    verilog: &str,
    models: &str,
    clocks: u64,
) -> Result<Vec<u32>, BoardError> {
    let folder = scratch()?;
    let path = |name: &str| folder.path().join(name);
    let pins = board.video.pins();
    let names: Vec<String> = pins.into_iter().map(|(name, _)| name).collect();
    let bench = Environment::new().render_str(BENCH, context! { names })?;
    for (name, text) in [
        ("bench.v", bench.as_str()),
        ("design.v", verilog),
        ("models.v", models),
        ("bench.cpp", DRIVER),
    ] {
        write(&path(name), text)?;
    }
    VERILATOR.run(OPTIONS.split_whitespace(), folder.path())?;
    let edges = if board.fast_ratio() > 1 { "2" } else { "1" };
    let count = (clocks * board.fast_ratio()).to_string();
    run(
        &path("cpp/Vboard_bench"),
        &[&count, edges, "pins.bin"],
        folder.path(),
    )?;
    let bytes = std::fs::read(path("pins.bin")).map_err(FileError::at(path("pins.bin")))?;
    let words = bytes.chunks_exact(4);
    Ok(words
        .map(|word| u32::from_ne_bytes(word.try_into().expect("four bytes")))
        .collect())
}

fn run(program: &Path, arguments: &[&str], folder: &Path) -> Result<(), BoardError> {
    let mut command = std::process::Command::new(program);
    let said = imogene_tools::call(command.args(arguments).current_dir(folder));
    let said = said.map_err(FileError::at(program))?;
    match said.succeeded() {
        true => Ok(()),
        false => Err(imogene_tools::ToolError::Refused {
            program: VERILATOR.name,
            message: said.all(),
        }
        .into()),
    }
}

/// What parallel pins show; levels have the bits of the pins, in the highest places of eight.
fn tick(board: &Board, pins: u32) -> Tick {
    let bits = board.video.bits().unwrap_or(8) as u32;
    let level = |place: u32| (pins >> (2 + place * bits) & ((1 << bits) - 1)) << (8 - bits);
    let has_de = matches!(&board.video, Video::Parallel { de: Some(_), .. });
    Tick {
        hsync: pins & 1 == 1,
        vsync: pins & 2 == 2,
        de: has_de.then_some(pins >> (2 + 3 * bits) & 1 == 1),
        colour: [0, 1, 2].map(|place| level(place) as u8),
    }
}
