//! The pins of a board in Verilator: of its sources, of a netlist, or of what comes out of a bitstream.

use crate::description::{Board, Video};
use crate::error::BoardError;
use crate::screen::{Screen, Shown, Tick};
use crate::tmds::{Channels, Decoder};
use imogene_contract::video::VideoMode;
use imogene_tools::{FileError, ICARUS, ToolError, VERILATOR, VVP, call, scratch, write};
use minijinja::{Environment, context};
use std::io::{BufRead, Read};
use std::path::PathBuf;
use std::process::Command;
use tempfile::TempDir;

const BENCH: &str = include_str!("top/bench.v");
const SAMPLES: &str = "pins.bin";
const DRIVER: &str = include_str!("top/bench.cpp");
const GATES: &str = include_str!("top/gates.v");
const OPTIONS: &str = "--cc --exe --build -j 2 -O3 --x-assign fast --x-initial fast -Wno-fatal -Wno-lint -Wno-style \
    --top-module board_bench --Mdir cpp -MAKEFLAGS OPT_SLOW=-O0 bench.v design.v models.v bench.cpp";
/// Clocks in which a program that is compiled quickly is as soon done as one that runs quickly.
const QUICK: u64 = 3_000_000;

/// What the pins of a board have shown.
#[derive(Debug)]
pub struct Pins {
    /// What a screen makes of them.
    pub shown: Shown,
    /// What was found on DVI channels; none of parallel pins.
    pub channels: Option<Channels>,
    folder: TempDir,
}

impl Pins {
    /// A byte for each bit of the DVI channels: bits 0 to 3 are blue, green, red and their clock. Of parallel pins four
    /// bytes for each pixel.
    pub fn samples(&self) -> PathBuf {
        self.folder.path().join(SAMPLES)
    }
}

/// Simulates a board for so many clocks of the pixels. `models` are those of the cells that the Verilog instantiates.
/// Fails when Verilator is missing or refuses the Verilog, the pins carry no words, or they are against the mode.
pub fn simulate(
    (board, mode): (&Board, &VideoMode),
    verilog: &str,
    models: &str,
    clocks: u64,
) -> Result<Pins, BoardError> {
    let folder = bench(board, verilog, models)?;
    write(&folder.path().join("bench.cpp"), DRIVER)?;
    let clocks = clocks * board.fast_ratio();
    let level = format!("OPT_FAST=-O{}", u8::from(clocks >= QUICK));
    let options = OPTIONS.split_whitespace().chain(["-MAKEFLAGS", &level]);
    VERILATOR.run(options, folder.path())?;
    // The levels of all pins: after both edges of the fast clock, or once a pixel.
    let [edges, bytes] = match board.video {
        Video::Tmds { .. } => ["2", "1"],
        Video::Parallel { .. } => ["1", "4"],
    };
    let program = folder.path().join("cpp/Vboard_bench");
    let mut command = Command::new(&program);
    command.args([&clocks.to_string(), edges, bytes, SAMPLES]);
    let said = call(command.current_dir(folder.path())).map_err(FileError::at(program))?;
    if !said.succeeded() {
        let (program, message) = (VERILATOR.name, said.all());
        return Err(ToolError::Refused { program, message }.into());
    }
    seen(board, mode, folder)
}

/// Simulates a board of gates with the delays of their models for so many clocks, from unknown states on. Fails when
/// Icarus Verilog is missing or refuses the Verilog, or the pins are against the mode.
pub fn simulate_gates(
    (board, mode): (&Board, &VideoMode),
    verilog: &str,
    models: &str,
    clocks: u64,
) -> Result<Pins, BoardError> {
    let folder = bench(board, verilog, models)?;
    let half = format!("{:.2}", 5e8 / board.clock.hertz as f64);
    let gates = Environment::new().render_str(GATES, context! { clocks, half })?;
    write(&folder.path().join("gates.v"), &gates)?;
    let options =
        "-g2005 -gspecify -T typ -s board_gates -o gates.vvp gates.v bench.v design.v models.v";
    ICARUS.run(options.split_whitespace(), folder.path())?;
    VVP.run(["gates.vvp"], folder.path())?;
    seen(board, mode, folder)
}

/// What a screen makes of samples in a folder.
fn seen(board: &Board, mode: &VideoMode, folder: TempDir) -> Result<Pins, BoardError> {
    let path = folder.path().join(SAMPLES);
    let file = std::fs::File::open(&path).map_err(FileError::at(&path))?;
    let mut file = std::io::BufReader::with_capacity(1 << 16, file);
    let mut screen = Screen::new(mode);
    let is_serial = matches!(board.video, Video::Tmds { .. });
    let mut decoder = is_serial.then(Decoder::default);
    let mut sample = [0; 4];
    let bytes = &mut sample[..if is_serial { 1 } else { 4 }];
    while !file.fill_buf().map_err(FileError::at(&path))?.is_empty() {
        file.read_exact(bytes).map_err(FileError::at(&path))?;
        let tick = match &mut decoder {
            Some(decoder) => decoder.see(bytes[0])?,
            None => {
                let pins = bytes.iter().rev();
                let pins = pins.fold(0, |pins, byte| pins << 8 | u32::from(*byte));
                Some(tick(board, pins))
            }
        };
        if let Some(tick) = tick {
            screen.see(&tick)?;
        }
    }
    Ok(Pins {
        channels: decoder.map(Decoder::found).transpose()?,
        shown: screen.shown()?,
        folder,
    })
}

/// A folder with a board, the models of its cells, and its pins side by side.
fn bench(board: &Board, verilog: &str, models: &str) -> Result<TempDir, BoardError> {
    let folder = scratch()?;
    let pins = board.video.pins();
    let names: Vec<String> = pins.into_iter().map(|(name, _)| name).collect();
    let bench = Environment::new().render_str(BENCH, context! { names })?;
    for (name, text) in [
        ("bench.v", bench.as_str()),
        ("design.v", verilog),
        ("models.v", models),
    ] {
        write(&folder.path().join(name), text)?;
    }
    Ok(folder)
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
