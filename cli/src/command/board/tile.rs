//! A tile of a shared chip that shows a scene.

use super::choice::{command, machine, mode_of, screen};
use super::report::{SLACK, Shown, finish};
use crate::arguments::{self, MACHINE_FILE, Size, View};
use crate::command::{frame_in, read_scene};
use crate::failure::{Failure, Result};
use crate::output;
use imogene_board::{
    About, Board, Layout, Library, Mapped, Pins, Tile, cell_delays, lay_out, simulate,
    simulate_gates,
};
use imogene_contract::tile::{PIN_BITS, TileWords};
use imogene_contract::video::VideoMode;
use imogene_files::Outputs;
use imogene_files::text::counted;
use imogene_golden::format::Format;
use imogene_golden::machine::tile::Tile as Golden;
use imogene_plan::description::MachineDescription;
use imogene_plan::tile::{only_solid, tile_words};
use imogene_prepare::{Framing, prepare_for_roots};
use serde::Serialize;
use std::path::PathBuf;

/// Bits of a component of the normals that the light is found from.
const NORMAL: u32 = 16;

/// What of a tile place and route fills at most, in percent: the template of the shuttle says so.
const FULL: f64 = 80.0;

/// Frames that are drawn and compared, unless others are asked for.
const FRAMES: u16 = 3;

/// A tile and what it shows; the keys are stable.
#[derive(Serialize)]
struct TileReport<'a> {
    board: &'a Board,
    machine: &'a MachineDescription,
    /// Columns and lines that the object is drawn in.
    window: [u64; 2],
    /// Cells of the shuttle, and the part of the tiles that they fill, in percent.
    cells: Option<Mapped>,
    percent_of_tiles: Option<f64>,
    /// What the pins show in simulation of the sources.
    pins: Option<Shown>,
    /// Cells of 180 nm, and what their pins show with their delays, from unknown states on.
    gates: Option<Mapped>,
    gate_pins: Option<Shown>,
    /// Their layout, and what its netlist shows.
    layout: Option<Layout>,
    layout_pins: Option<Shown>,
    command: String,
}

pub fn run(options: &arguments::Board, board: &Board, json: bool) -> Result {
    if options.machine.is_none() {
        refuse_early(options, screen(options, board)?)?;
    }
    let machine = machine(options, board)?;
    let (mode, _) = mode_of(board, &machine)?;
    let words = words(options, &machine, mode)?;
    let command = command(options);
    // The name of the scene as a part of that of a module.
    let stem = options.scene.file_stem().unwrap_or_default();
    let plain = |c: char| match c.is_ascii_alphanumeric() {
        true => c.to_ascii_lowercase(),
        false => '_',
    };
    let name: String = stem.to_string_lossy().chars().map(plain).collect();
    let frames = options.frames.unwrap_or(FRAMES);
    let about = About {
        title: format!("imogene: {name}"),
        name,
        command: command.clone(),
        frames: usize::from(frames),
    };
    let tile = Tile::new(board, &words, &about)?;
    let mut golden = Golden::new(&words)?;
    let work = Work {
        options,
        board,
        mode,
        golden: (0..frames).map(|_| golden.frame()).collect(),
        tile,
    };
    let mut files = output::files();
    files.add_text(&work.out(MACHINE_FILE), &machine.to_toml())?;
    files.add_text(&work.out("src/project.v"), &work.tile.verilog)?;
    for (place, text) in &work.tile.files {
        files.add_text(&work.out(place), text)?;
    }
    for (number, picture) in work.golden.iter().enumerate() {
        let name = format!("test/reference/frame{number}.png");
        work.add_picture(&name, picture, &mut files)?;
    }
    let mut report = TileReport {
        board,
        machine: &machine,
        window: words.window,
        cells: None,
        percent_of_tiles: None,
        pins: None,
        gates: None,
        gate_pins: None,
        layout: None,
        layout_pins: None,
        command,
    };
    if !options.sources_only {
        work.check(&mut report, &mut files)?;
    }
    let template = concat!(include_str!("pins.txt"), include_str!("tile.txt"));
    finish(options, board, &report, files, json, template)?;
    report.verdict()
}

/// Refuses what no words make a tile of, ahead of the fit, which takes seconds. What the words decide is left to it.
fn refuse_early(options: &arguments::Board, (width, height): Size) -> Result {
    let file = read_scene(&options.scene, &View::default())?;
    let framed = file.frame(width, height).ok();
    let prepared = framed.and_then(|framed| prepare_for_roots(&framed, Format::BASE).ok());
    match prepared.as_ref().map(only_solid) {
        Some(Err(error)) => Err(Failure::at(&options.scene, error)),
        _ => Ok(()),
    }
}

/// The words of a scene that is framed for the whole screen.
fn words(
    options: &arguments::Board,
    machine: &MachineDescription,
    mode: VideoMode,
) -> Result<TileWords> {
    let file = read_scene(&options.scene, &View::default())?;
    let mut widths = machine.words();
    widths.normal = NORMAL;
    let format = Format::fitted(&widths)?;
    let (framed, prepared) = frame_in(&file, machine.drawn_size(), format)?;
    tile_words(&framed, &prepared, mode).map_err(Failure::in_file(&options.scene))
}

/// A tile on its way.
struct Work<'a> {
    options: &'a arguments::Board,
    board: &'a Board,
    mode: VideoMode,
    tile: Tile,
    /// The first frames, in the bits of the pins.
    golden: Vec<Vec<u8>>,
}

impl Work<'_> {
    fn out(&self, name: &str) -> PathBuf {
        self.options.out.join(name)
    }

    /// A picture of levels as the pins have them.
    fn add_picture(&self, name: &str, levels: &[u8], files: &mut Outputs) -> Result {
        let size = [self.mode.line, self.mode.frame].map(|span| span.active as usize);
        let most = (1 << PIN_BITS) - 1;
        let pixels: Vec<u8> = levels.iter().map(|level| level * (255 / most)).collect();
        Ok(output::add_picture(files, &self.out(name), size, &pixels)?)
    }

    fn check(&self, report: &mut TileReport, files: &mut Outputs) -> Result {
        let clocks = self.golden.len() as u64 * self.mode.clocks() + SLACK;
        let is_shown = !self.options.no_simulation;
        let (tile, board) = (&self.tile, self.board);
        if is_shown {
            let sources = format!("{}\n{}", tile.verilog, tile.bench);
            let pins = simulate((board, &self.mode), &sources, "", clocks)?;
            report.pins = Some(self.shown("pins", &pins, clocks, files)?);
        }
        if self.options.no_bitstream {
            return Ok(());
        }
        let cells = Library::Sky130.map(tile)?;
        let tiles = board.tiles.as_ref().expect("a board of tiles");
        let area = tiles.micrometres.iter().product::<f64>();
        report.percent_of_tiles = Some(100.0 * cells.area / area);
        report.cells = Some(cells);
        let gates = Library::Osu018.map(tile)?;
        files.add_text(&self.out("gates.v"), &gates.verilog)?;
        let on_pins = |name: &str, netlist: &str, files: &mut Outputs| -> Result<Shown> {
            let (netlist, board) = (format!("{netlist}\n{}", tile.bench), (board, &self.mode));
            let pins = simulate_gates(board, &netlist, &cell_delays()?, clocks)?;
            self.shown(name, &pins, clocks, files)
        };
        if is_shown {
            report.gate_pins = Some(on_pins("gates", &gates.verilog, files)?);
        }
        if self.options.layout {
            let (layout, texts) = lay_out(tile, &gates)?;
            files.add_text(&self.out("layout.v"), &texts.verilog)?;
            files.add_text(&self.out("layout.def"), &texts.def)?;
            report.layout = Some(layout);
            if is_shown {
                report.layout_pins = Some(on_pins("layout", &texts.verilog, files)?);
            }
        }
        report.gates = Some(gates);
        Ok(())
    }

    fn shown(&self, name: &str, pins: &Pins, clocks: u64, files: &mut Outputs) -> Result<Shown> {
        let spare = 8 - PIN_BITS;
        let golden = self.golden.iter();
        let golden = golden.map(|levels| levels.iter().map(|level| level << spare).collect());
        let golden: Vec<Vec<u8>> = golden.collect();
        for (number, picture) in pins.shown.pictures.iter().take(golden.len()).enumerate() {
            let levels: Vec<u8> = picture.iter().map(|level| level >> spare).collect();
            self.add_picture(&format!("{name}{number}.png"), &levels, files)?;
        }
        Ok(Shown::of(pins, &golden, clocks))
    }
}

impl TileReport<'_> {
    /// Fails where pins do not show the golden frames, or the layout is none.
    fn verdict(&self) -> Result {
        let shown = [&self.pins, &self.gate_pins, &self.layout_pins].into_iter();
        let differing: usize = shown.flatten().map(|shown| shown.differing).sum();
        let of = |layout: &Layout| layout.unrouted + layout.differences;
        let unsound = self.layout.as_ref().map_or(0, of);
        let percent = self.percent_of_tiles.unwrap_or(0.0);
        match (differing, unsound) {
            (0, 0) if percent > FULL => Err(Failure::Check(format!(
                "the cells fill {percent:.1} % of the tiles, and {FULL} % is what place and route can fill; fewer cut \
                 planes or shorter words (--machine) would do"
            ))),
            (0, 0) => Ok(()),
            (0, count) => Err(Failure::Check(format!(
                "{} of the layout to its netlist",
                counted(count, "difference")
            ))),
            (count, _) => Err(Failure::Check(format!(
                "{} on the pins of the tile; please report the command: {}",
                counted(count as u64, "differing pixel"),
                self.command
            ))),
        }
    }
}
