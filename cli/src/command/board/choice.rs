//! What a board shows a scene with: the machine and the mode.

use crate::arguments::{self, Fit, Size, lit_sphere, option};
use crate::command::fit;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_board::{Board, Family};
use imogene_contract::video::VideoMode;
use imogene_plan::description::{MachineDescription, MachineKind, Mode, Output};
use imogene_studies::fit::budget::CountLimit;
use imogene_synth::Target;

/// What a fitted machine may show wrongly: a part of the picture in percent, and levels of a colour.
const PERCENT: f64 = 0.1;
const LEVELS: f64 = 2.0;

/// The machine: the one that is given, or one that is fitted to the scene.
pub(super) fn machine(options: &arguments::Board, board: &Board) -> Result<MachineDescription> {
    let Some(path) = &options.machine else {
        return fitted(options, board);
    };
    let machine = MachineDescription::read(path)?;
    if machine.machine != MachineKind::Beam || machine.output != Output::Pins {
        let problem = "a board takes a beam machine with the pins of a screen: machine = \"beam\", output = \"pins\"";
        return Err(Failure::at(path, problem));
    }
    Ok(machine)
}

fn fitted(options: &arguments::Board, board: &Board) -> Result<MachineDescription> {
    let fit = Fit {
        scenes: vec![options.scene.clone()],
        out: options.out.clone(),
        size: Some(screen(options, board)?),
        max_silhouette_errors: Some(CountLimit::Percent(PERCENT)),
        max_face_errors: Some(CountLimit::Percent(PERCENT)),
        // A tile has a light of its own, which the fit does not know.
        max_colour_error: (!options.flat && board.tiles.is_none()).then_some(LEVELS),
        machine: Some(MachineKind::Beam),
        target: target(board).name().to_owned(),
        lit_sphere: options.lit_sphere,
        no_cost: true,
        ..Fit::default()
    };
    let mut machine = fit::smallest(&fit)?;
    if options.flat {
        (machine.lights, machine.suns) = (0, 0);
    }
    Ok(machine)
}

/// A device of the family of a board's part; of a board without a part any that is made of gates.
fn target(board: &Board) -> Target {
    match board.part.as_ref().map(|part| part.family) {
        Some(Family::Ecp5) => Target::Ecp5With45k,
        Some(Family::Ice40) => Target::Ice40Hx8k,
        Some(Family::Gowin) => Target::Gowin,
        Some(Family::Xilinx7) => Target::Xilinx7,
        None => Target::Transistors,
    }
}

/// Columns and lines of the mode that is asked for, or else the first of the board.
pub(super) fn screen(options: &arguments::Board, board: &Board) -> Result<Size> {
    let name = options.mode.as_ref().unwrap_or(&board.modes[0].name);
    let size = arguments::pair(name, 'x');
    size.ok_or_else(|| unknown_mode(board, name))
}

/// The mode of a machine and its frames per second, if it is one of the board; any blanking where there is no
/// connector.
pub(super) fn mode_of(board: &Board, machine: &MachineDescription) -> Result<(VideoMode, u32)> {
    let mode = machine.video_mode();
    let name = match (&machine.mode, mode) {
        (Mode::Own(_), Some(mode)) if board.part.is_none() => {
            format!("{}x{}", mode.line.active, mode.frame.active)
        }
        (Mode::Own(_), _) => "of its own".into(),
        (Mode::Named(name), _) => name.clone(),
    };
    let mode = mode.zip(rate_of(board, &name));
    mode.ok_or_else(|| unknown_mode(board, &name))
}

/// Frames per second of a mode of the board.
pub(super) fn rate_of(board: &Board, name: &str) -> Option<u32> {
    let mut modes = board.modes.iter();
    modes.find(|mode| mode.name == name).map(|mode| mode.rate)
}

pub(super) fn unknown_mode(board: &Board, name: &str) -> Failure {
    Failure::Input(format!(
        "mode {name} is none of the board {}; it has {}",
        board.name,
        output::joined(board.modes.iter().map(|mode| &mode.name), ", ")
    ))
}

/// The clock of the pixels of a mode: the published one, or that of its frames per second.
pub(super) fn hertz(mode: &VideoMode, rate: u32) -> u64 {
    match *mode {
        VideoMode::VGA => 25_175_000,
        mode => u64::from(rate) * mode.clocks(),
    }
}

pub(super) fn command(options: &arguments::Board) -> String {
    let scene = options.scene.display();
    let machine = options.machine.as_ref().map(|path| path.display());
    [
        format!("imogene board {} {scene}", options.board),
        option("machine", machine),
        option("mode", options.mode.as_ref()),
        if options.flat { " --flat" } else { "" }.to_owned(),
        lit_sphere(options.lit_sphere),
        option("animation", options.animation),
        option("frames", options.frames),
        option("out", Some("DIR")),
    ]
    .concat()
}
