//! The top level of a board: Verilog, and the constraints of its part.

use crate::description::{Board, Family, Part, Video};
use crate::error::BoardError;
use crate::pll::Pll;
use crate::tile::rendered;
use imogene_contract::{Request, Unit};
use imogene_golden::machine::zone::beat::Beat;
use imogene_rtl::emit::{Emitted, emit};
use minijinja::value::Serde;
use minijinja::{Value, context};

/// Words that a sequencer can address.
const MOST_WORDS: usize = 1 << 12;
/// The name of the top module.
pub(crate) const TOP: &str = "board_top";
/// The stated models of the cells of parts.
pub const MODELS: &str = include_str!("top/models.v");

/// What a board shows.
#[derive(Clone, Copy, Debug)]
pub struct Display<'a> {
    /// The beam machine with its screen.
    pub machine: &'a Emitted,
    /// The words of its images, one image after the other.
    pub words: &'a [Beat],
    /// How many frames of the screen show an image, less one.
    pub stays: u8,
    /// The line that the files begin with.
    pub heading: &'a str,
}

/// The files of a board, by their names.
#[derive(Clone, Debug)]
pub struct Sources {
    /// All Verilog, the top module last.
    pub verilog: String,
    /// Constraints of pins and of the clock, and the ending of their file; none without a part.
    pub constraints: Option<(&'static str, String)>,
}

/// The top level of a board that shows a scene. Fails when there are more words than a sequencer can address.
pub fn sources(board: &Board, pll: &Pll, display: &Display) -> Result<Sources, BoardError> {
    let mut verilog = display.machine.bundle();
    for unit in units(board) {
        verilog += &format!("\n{}", emit(&Request::new(*unit))?.bundle());
    }
    let mut add = |template: &str, values: Value| -> Result<(), BoardError> {
        verilog += "\n";
        verilog += &rendered(template, &values)?;
        Ok(())
    };
    add(include_str!("top/core.v"), core(board, display)?)?;
    let clock = match board.part.as_ref().map(|part| part.family) {
        Some(Family::Ecp5) => include_str!("top/clock_ecp5.v"),
        Some(Family::Ice40) => include_str!("top/clock_ice40.v"),
        Some(Family::Gowin) => include_str!("top/clock_gowin.v"),
        Some(Family::Xilinx7) => include_str!("top/clock_xilinx7.v"),
        None => include_str!("top/clock_none.v"),
    };
    add(clock, clocks(board, pll))?;
    match &board.video {
        Video::Tmds { true_pairs, .. } => add(
            match board.serialises() {
                true => include_str!("top/top_oser10.v"),
                false => include_str!("top/top_tmds.v"),
            },
            context! { about => board.about.clone(), true_pairs },
        )?,
        Video::Parallel { de, clock, .. } => {
            let names: Vec<String> = board.video.pins().into_iter().map(|pin| pin.0).collect();
            let clock_out = usize::from(clock.is_some());
            let mut data: Vec<String> = names[..names.len() - clock_out].to_vec();
            data.reverse();
            add(
                include_str!("top/top_parallel.v"),
                context! {
                    about => board.about.clone(), bits => board.video.bits(), outputs => names.join(", "),
                    pins_of => data.join(", "), has_de => usize::from(de.is_some()), has_clock => clock.is_some(),
                },
            )?;
        }
    }
    Ok(Sources {
        verilog,
        constraints: constraints(board, pll),
    })
}

/// The units that a board has beside its machine.
fn units(board: &Board) -> &'static [Unit] {
    match board.video {
        Video::Tmds { .. } if board.serialises() => &[Unit::SceneSequencer, Unit::TmdsEncoder],
        Video::Tmds { .. } => &[
            Unit::SceneSequencer,
            Unit::TmdsEncoder,
            Unit::TmdsSerialiser,
        ],
        Video::Parallel { .. } => &[Unit::SceneSequencer],
    }
}

/// Machine and words, for the template.
fn core(board: &Board, display: &Display) -> Result<Value, BoardError> {
    let count = display.words.len();
    if count > MOST_WORDS {
        let excess = format!("{count} words of images of {MOST_WORDS}");
        let remedy = "a scene of fewer objects, or fewer frames of an animation (--animation FIRST..LAST), may fit";
        return Err(BoardError::Excess(board.name.clone(), excess, remedy));
    }
    let mut ports = display.machine.ports.iter();
    let data = ports.find(|port| port.name == "s_tdata");
    let data = data.map_or(0, |port| port.width as u32);
    // From the lowest bits on; each field as wide as its greatest value.
    let field = |width: u32, of: fn(&Beat) -> u64| {
        let greatest = display.words.iter().map(of).max().unwrap_or(0);
        (width, (greatest.max(1).ilog2() + 1).min(width), of)
    };
    let fields = [
        field(data, |beat| beat.data),
        field(16, |beat| beat.address.into()),
        field(8, |beat| beat.unit.into()),
        field(4, |beat| beat.kind.into()),
        (1, 1, |beat| beat.last.into()),
    ];
    let bits: u32 = fields.iter().map(|(_, kept, _)| kept).sum();
    let word = |(index, beat): (usize, &Beat)| {
        let last = u128::from(index + 1 == count);
        let fields = fields.iter().rev();
        let word = fields.fold(last, |word, (_, kept, of)| {
            word << kept | u128::from(of(beat))
        });
        format!("{word:x}")
    };
    let words: Vec<String> = display.words.iter().enumerate().map(word).collect();
    let places = count.next_power_of_two().max(2);
    let mut low = 0;
    let [data, address, unit, kind, _] = fields.map(|(width, kept, _)| {
        low += kept;
        let part = format!("word[{}:{}]", low - 1, low - kept);
        match width - kept {
            0 => part,
            zeros => format!("{zeros}'d0, {part}"),
        }
    });
    Ok(context! {
        heading => display.heading, machine => display.machine.top.clone(), words, places,
        bits => bits + 1, address_bits => places.ilog2(), stays => display.stays,
        data, address, unit, kind, tmds => matches!(board.video, Video::Tmds { .. }), pairs => !board.serialises(),
    })
}

/// Dividers and clocks, for the templates.
fn clocks(board: &Board, pll: &Pll) -> Value {
    let decimal = |mhz: f64| {
        let text = format!("{mhz:.6}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    context! {
        pll => Value::from(Serde(&pll.dividers)), pad => board.clock.pad, series => board.part.as_ref().map(Part::series),
        input_mhz => decimal(pll.input_mhz()), fast => decimal(pll.fast_mhz()), pixel => decimal(pll.pixel_mhz()),
        period => format!("{:.3}", 1000.0 / pll.input_mhz()),
    }
}

/// The constraints of the part of a board, and the ending of their file.
fn constraints(board: &Board, pll: &Pll) -> Option<(&'static str, String)> {
    let family = board.part.as_ref()?.family;
    let line = |name: &str, pin: &str, io: &str| match family {
        Family::Ecp5 => {
            format!("LOCATE COMP \"{name}\" SITE \"{pin}\";\nIOBUF PORT \"{name}\" {io};\n")
        }
        Family::Ice40 => format!("set_io {name} {pin}\n"),
        Family::Gowin => format!("IO_LOC \"{name}\" {pin};\nIO_PORT \"{name}\" {io};\n"),
        Family::Xilinx7 => {
            format!("set_property -dict {{PACKAGE_PIN {pin} {io}}} [get_ports {name}]\n")
        }
    };
    let mut text = line("clock", &board.clock.pin, &board.clock.io);
    for (name, pins) in board.video.pins() {
        // Of a Gowin both pins of a channel.
        let opposite = name.replace('_', "_n_");
        for (name, pin) in [name, opposite].iter().zip(pins.split(',')) {
            text += &line(name, pin, board.video.io());
        }
    }
    let mhz = pll.input_mhz();
    let (ending, clock) = match family {
        Family::Ecp5 => ("lpf", format!("FREQUENCY PORT \"clock\" {mhz} MHZ;\n")),
        Family::Ice40 => ("pcf", format!("set_frequency clock {mhz}\n")),
        Family::Gowin => ("cst", String::new()),
        // The bank of the configuration pins has 3.3 V.
        Family::Xilinx7 => (
            "xdc",
            format!(
                "create_clock -period {:.3} [get_ports clock]\n\
                 set_property CFGBVS VCCO [current_design]\nset_property CONFIG_VOLTAGE 3.3 [current_design]\n",
                1000.0 / mhz
            ),
        ),
    };
    Some((ending, text + &clock))
}
