//! `imogene board`.

mod choice;
mod film;
mod report;
mod tile;

use crate::arguments::{self, MACHINE_FILE};
use crate::failure::{Failure, Result};
use crate::output;
use choice::{command, hertz, machine, mode_of, rate_of, unknown_mode};
use film::{Film, views};
use imogene_board::{
    Board, Display, MODELS, Pll, Sources, Video, core_file, count, find_tools, page, route,
    simulate, sources, unpack, witness,
};
use imogene_contract::video::VideoMode;
use imogene_files::{Outputs, WriteError};
use imogene_rtl::emit::machine::emit_machine;
use imogene_studies::picture::Preview;
use imogene_verif::display::request::request_for;
use report::{BoardReport, SLACK, Shown, finish};
use std::path::PathBuf;

pub fn run(options: &arguments::Board, json: bool) -> Result {
    let board = Board::named(&options.board)?;
    check(options, &board)?;
    if board.tiles.is_some() {
        return tile::run(options, &board, json);
    }
    let views = views(&options.scene, options.animation)?;
    if !options.sources_only && !options.no_bitstream {
        find_tools(&board)?;
    }
    let machine = machine(options, &board)?;
    let (mode, rate) = mode_of(&board, &machine)?;
    let film = Film::of(views, options, &board, &machine, rate)?;
    let pll = Pll::of(&board, hertz(&mode, rate))?;
    let command = command(options);
    let emitted = emit_machine(&request_for(&machine, &film.tables, &command))?;
    let heading = format!("Made by: {command}");
    let display = Display {
        machine: &emitted,
        words: &film.words,
        stays: (film.stay - 1) as u8,
        heading: &heading,
    };
    let work = Work {
        options,
        sources: sources(&board, &pll, &display)?,
        film,
        board,
        mode,
        pll,
    };
    let mut files = output::files();
    files.add_text(&work.out(MACHINE_FILE), &machine.to_toml())?;
    files.add_text(&work.out("board.v"), &work.sources.verilog)?;
    if let Some((kind, text)) = &work.sources.constraints {
        files.add_text(&work.out(&format!("board.{kind}")), text)?;
    }
    work.add_pictures("golden", &work.film.pictures, &mut files)?;
    let mut report = BoardReport {
        board: &work.board,
        machine: &machine,
        pixel_hertz: work.pll.pixel_hertz.to_string(),
        pixel_deviation_percent: work.pll.deviation_percent(),
        fast_mhz: work.pll.fast_mhz(),
        words: work.film.words.len(),
        images: work.film.pictures.len(),
        frames_per_image: work.film.stay,
        pins: None,
        synthesised: None,
        routed: None,
        bitstream: None,
        netlist: None,
        command,
    };
    if !options.sources_only {
        if !options.no_simulation {
            let verilog = &work.sources.verilog;
            report.pins = Some(work.shown("pins", verilog, MODELS, &mut files)?);
        }
        work.bitstream(&mut report, &mut files)?;
    }
    files.add_text(&work.out("board.md"), &page(&work.board, &report)?)?;
    if let Some(text) = core_file(&work.board, &work.pll, &report.command)? {
        let name = format!("{}.core", work.board.name);
        files.add_text(&work.out(&name), &text)?;
    }
    let template = concat!(
        include_str!("board/pins.txt"),
        include_str!("board/board.txt")
    );
    finish(options, &work.board, &report, files, json, template)?;
    report.verdict()
}

/// Refuses what the board has not: a mode, or what an option is for.
fn check(options: &arguments::Board, board: &Board) -> Result {
    let is_tile = board.tiles.is_some();
    let is_dvi = matches!(board.video, Video::Tmds { .. });
    let mode = options.mode.as_ref();
    if let Some(mode) = mode.filter(|mode| rate_of(board, mode).is_none()) {
        return Err(unknown_mode(board, mode));
    }
    let unmeant = [
        (
            options.animation.is_some() && is_tile,
            "--animation is for boards with a memory; a tile moves by itself",
        ),
        (
            options.layout && !is_tile,
            "--layout is for a tile, as that of the board tinytapeout",
        ),
        (
            options.samples && !is_dvi,
            "--samples are those of DVI channels, which the board does not have",
        ),
    ];
    match unmeant.iter().find(|(is_given, _)| *is_given) {
        Some((_, problem)) => Err(Failure::Input(format!("{}: {problem}", board.name))),
        None => Ok(()),
    }
}

/// A board on its way.
struct Work<'a> {
    options: &'a arguments::Board,
    board: Board,
    mode: VideoMode,
    pll: Pll,
    sources: Sources,
    film: Film,
}

impl Work<'_> {
    fn out(&self, name: &str) -> PathBuf {
        self.options.out.join(name)
    }

    /// A picture, or an animated one: what the pins show of each image for the first time.
    fn add_pictures(
        &self,
        name: &str,
        pictures: &[impl AsRef<[u8]>],
        files: &mut Outputs,
    ) -> Result {
        let size = [self.mode.line, self.mode.frame].map(|span| span.active as usize);
        let path = self.out(&format!("{name}.png"));
        if let [picture] = pictures {
            return Ok(output::add_picture(files, &path, size, picture.as_ref())?);
        }
        let failed = |error| Failure::from(WriteError::at(&path)(error));
        let [width, height] = size.map(|side| side as u32);
        let file = files.open(&path)?;
        let seconds = self.film.stay as f64 / self.film.rate;
        let mut preview =
            Preview::new(file, (width, height), pictures.len() as u32).map_err(failed)?;
        for picture in pictures {
            preview.frame(picture.as_ref(), seconds).map_err(failed)?;
        }
        preview.finish().map_err(failed)
    }

    /// What the pins show in simulation of Verilog with models of its cells.
    fn shown(&self, name: &str, verilog: &str, models: &str, files: &mut Outputs) -> Result<Shown> {
        let frames = self.options.frames.map_or(self.film.frames(), u64::from);
        // Where the words of the first image come too late for the first frame, there is one more.
        let clocks = (1 + frames) * self.mode.clocks() + SLACK;
        let pins = simulate((&self.board, &self.mode), verilog, models, clocks)?;
        let pictures = &pins.shown.pictures;
        let is_late = pictures.first() != self.film.pictures.first();
        let golden = self.film.frames_behind(is_late.into());
        let golden: Vec<&[u8]> = golden.take(1 + frames as usize).collect();
        let shown = pictures.iter().skip(is_late.into());
        let firsts = shown.take(frames as usize).step_by(self.film.stay as usize);
        let firsts: Vec<_> = firsts.collect();
        self.add_pictures(name, &firsts, files)?;
        if self.options.samples {
            let samples = pins.samples();
            files.add(&self.out("pins.bin"), |out| {
                std::io::copy(&mut std::fs::File::open(&samples)?, out).map(|_| ())
            })?;
            let last = golden.iter().take(pictures.len()).next_back();
            let last = last.expect("the simulation shows a frame");
            files.add(&self.out("golden.rgb"), |out| out.write_all(last))?;
        }
        Ok(Shown::of(&pins, &golden, clocks))
    }

    /// Places and routes the board, packs its bitstream, and shows what that shows; or counts what it takes, where no
    /// open program places and routes it.
    fn bitstream(&self, report: &mut BoardReport, files: &mut Outputs) -> Result {
        if self.board.part.is_none() || self.options.no_bitstream {
            return Ok(());
        }
        if !self.board.has_bitstream() {
            report.synthesised = Some(count(&self.board, &self.sources)?);
            return Ok(());
        }
        let built = route(&self.board, &self.pll, &self.sources)?;
        let unpacked = unpack(&self.board, &self.sources, &built.bitstream)?;
        let path = self.out(&self.board.bitstream());
        files.add(&path, |out| out.write_all(&built.bitstream))?;
        if !self.options.no_simulation {
            let (name, shown) = match built.netlist {
                Some(_) => ("netlist", &mut report.netlist),
                None => ("bitstream", &mut report.bitstream),
            };
            let [verilog, models] = witness(&self.board, &self.sources, &built, &unpacked)?;
            files.add_text(&self.out(&format!("{name}.v")), &verilog)?;
            *shown = Some(self.shown(name, &verilog, &models, files)?);
        }
        report.routed = Some(built.routed);
        Ok(())
    }
}
