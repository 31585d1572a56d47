//! What a board is, as a TOML file in `boards/`.

use crate::error::BoardError;
use imogene_scene::{in_plain_words, line_and_column};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A board.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Board {
    /// The name, which is that of its file.
    #[serde(skip)]
    pub name: String,
    /// What it is, in one line.
    pub about: String,
    /// Where its pins and limits are from.
    pub sources: Vec<String>,
    /// The video modes that part and connector take.
    pub modes: Vec<BoardMode>,
    /// The command that writes a bitstream to it, without its file.
    #[serde(default)]
    pub programmer: Option<String>,
    /// Its part; none of a board that is only simulated.
    #[serde(default)]
    pub part: Option<Part>,
    /// The tiles of a shared chip; none of other boards.
    #[serde(default)]
    pub tiles: Option<Tiles>,
    /// Its clock.
    pub clock: Clock,
    /// Where its picture leaves.
    pub video: Video,
}

/// A video mode of a board: its name in machine descriptions, and behind an `@` the frames per second if they are not
/// 60.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct BoardMode {
    /// The name.
    pub name: String,
    /// Frames per second.
    pub rate: u32,
}

/// Frames per second of a mode without an `@`.
const USUAL_RATE: u32 = 60;

impl TryFrom<String> for BoardMode {
    type Error = String;

    fn try_from(text: String) -> Result<BoardMode, String> {
        let (name, rate) = match text.split_once('@') {
            Some((name, rate)) => (name, rate.parse()),
            None => (text.as_str(), Ok(USUAL_RATE)),
        };
        match rate {
            Ok(rate @ 1..=240) => Ok(BoardMode {
                name: name.into(),
                rate,
            }),
            _ => Err(format!(
                "the mode {text} does not end in @ and 1 to 240 frames per second"
            )),
        }
    }
}

impl From<BoardMode> for String {
    fn from(mode: BoardMode) -> String {
        match mode.rate {
            USUAL_RATE => mode.name,
            rate => format!("{}@{rate}", mode.name),
        }
    }
}

/// Families of parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Family {
    /// Lattice ECP5.
    Ecp5,
    /// Lattice iCE40.
    Ice40,
    /// Gowin GW1N and GW2A.
    Gowin,
    /// AMD 7 series, as sources alone: no open program places and routes it here.
    Xilinx7,
}

/// Kinds of cells that are counted of a part that is not placed and routed.
const CELLS: [&str; 4] = ["LUT", "FF", "RAMB36", "DSP48"];

/// A part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Its family.
    pub family: Family,
    /// Which one, as the place and route program names it.
    pub device: String,
    /// Its package; of a Gowin the whole number of the part.
    pub package: String,
    /// Its speed grade, where the family has one.
    #[serde(default)]
    pub speed: Option<String>,
    /// How many of a kind of cell it has, where no place and route program tells.
    #[serde(default)]
    pub cells: BTreeMap<String, u64>,
}

/// A place on a shared chip.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tiles {
    /// How many, as the project files name them.
    pub size: String,
    /// Width and height.
    pub micrometres: [f64; 2],
}

/// An oscillator of a board.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Clock {
    /// Its pin.
    pub pin: String,
    /// Its frequency.
    pub hertz: u64,
    /// Properties of the pin, in the words of the constraints of the family.
    #[serde(default)]
    pub io: String,
    /// The pin is the pad of the PLL of an iCE40, which no other cell can read.
    #[serde(default)]
    pub pad: bool,
}

/// Where a picture leaves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "output", rename_all = "snake_case", deny_unknown_fields)]
pub enum Video {
    /// Three DVI channels and their clock, each a pin whose opposite follows from the constraints, or of a Gowin both
    /// pins with a comma.
    Tmds {
        /// Pin of the blue channel.
        blue: String,
        /// Pin of the green channel.
        green: String,
        /// Pin of the red channel.
        red: String,
        /// Pin of the clock channel.
        clock: String,
        /// The pins are true differential pairs, of a Gowin that has some; of others the part drives both.
        #[serde(default)]
        true_pairs: bool,
        /// Properties of the pins.
        #[serde(default)]
        io: String,
    },
    /// The highest bits of each colour, with the synchronisation.
    Parallel {
        /// Pin of the synchronisation of the line.
        hsync: String,
        /// Pin of the synchronisation of the frame.
        vsync: String,
        /// Pins of the red bits, the lowest first.
        red: Vec<String>,
        /// Pins of the green bits.
        green: Vec<String>,
        /// Pins of the blue bits.
        blue: Vec<String>,
        /// Pin of data enable, where the connector has one.
        #[serde(default)]
        de: Option<String>,
        /// Pin of the clock of the pixels, where the connector has one.
        #[serde(default)]
        clock: Option<String>,
        /// Properties of the pins.
        #[serde(default)]
        io: String,
    },
}

macro_rules! boards {
    ($($name:literal)*) => {
        /// The boards by their names, with their files.
        const BOARDS: &[(&str, &str)] = &[
            $(($name, include_str!(concat!("../../../boards/", $name, ".toml")))),*
        ];
    };
}

boards! { "ulx3s-85" "ulx3s-45" "ulx3s-25" "ulx3s-12" "basys3" "hx8k-evb" "icebreaker" "tang-nano-9k" "tang-nano-20k" "simulation" "tinytapeout" }

impl Board {
    /// The names of all boards.
    pub fn names() -> Vec<&'static str> {
        BOARDS.iter().map(|(name, _)| *name).collect()
    }

    /// The board of a name. Fails when there is none; the error lists the names.
    pub fn named(name: &str) -> Result<Board, BoardError> {
        let found = BOARDS.iter().find(|(known, _)| *known == name);
        let (name, text) =
            found.ok_or_else(|| BoardError::Unknown(name.to_owned(), Board::names().join(", ")))?;
        Board::parse(text, name)
    }

    /// The board of a text of `boards/NAME.toml`. Fails when it is none.
    pub fn parse(text: &str, name: &str) -> Result<Board, BoardError> {
        let file = format!("boards/{name}.toml");
        let mut board: Board = toml::from_str(text).map_err(|error| {
            let start = error.span().map_or(0, |span| span.start);
            let (line, column) = line_and_column(text, start);
            let problem = in_plain_words(error.message());
            BoardError::Description(format!("{file}:{line}:{column}: {problem}"))
        })?;
        board.name = name.to_owned();
        board.check(&file)?;
        Ok(board)
    }

    fn check(&self, file: &str) -> Result<(), BoardError> {
        let refused = |key: &str, value: &dyn std::fmt::Display, accepted: &str| {
            let problem = format!("{file}: {key} is {value}; accepted: {accepted}");
            Err(BoardError::Description(problem))
        };
        if self.clock.hertz == 0 || self.clock.hertz > 1_000_000_000 {
            return refused("clock.hertz", &self.clock.hertz, "1 to 1 000 000 000");
        }
        let wanted = if self.serialises() { 2 } else { 1 };
        let is_wrong = |pin: &str| {
            let names = pin.split(',');
            names.filter(|name| !name.trim().is_empty()).count() != wanted
        };
        // The simulated board has no part and no pins.
        let is_checked = self.part.is_some() && matches!(self.video, Video::Tmds { .. });
        if is_checked
            && let Some((_, pin)) = self.video.pins().iter().find(|(_, pin)| is_wrong(pin))
        {
            let accepted = "both pins of a channel of a Gowin, one of others";
            return refused("the pin of a channel", pin, accepted);
        }
        let mut cells = self.part.iter().flat_map(|part| part.cells.keys());
        if let Some(kind) = cells.find(|kind| !CELLS.contains(&kind.as_str())) {
            return refused("part.cells", kind, &CELLS.join(", "));
        }
        if let Some(bits) = self.video.bits().filter(|bits| !(1..=8).contains(bits)) {
            return refused("the pins of a colour", &bits, "1 to 8, as many for each");
        }
        Ok(())
    }

    /// The name of its bitstream, whose ending tells programs that write it what it is.
    pub fn bitstream(&self) -> String {
        let ending = if self.serialises() { "fs" } else { "bit" };
        format!("{}.{ending}", self.name)
    }

    /// How its bitstream is read back, in words.
    pub fn read_back(&self) -> &'static str {
        match self.serialises() {
            true => "read back as Verilog",
            false => "unpacked and packed again to the same",
        }
    }

    /// A cell of the part sends the ten bits of a word of DVI; of others it sends pairs.
    pub(crate) fn serialises(&self) -> bool {
        matches!(&self.part, Some(part) if part.family == Family::Gowin)
    }

    /// The clock that pixels are sent with beside their own: five times as fast with two bits an edge, or none.
    pub fn fast_ratio(&self) -> u64 {
        match self.video {
            Video::Tmds { .. } => 5,
            Video::Parallel { .. } => 1,
        }
    }
}

impl Video {
    /// Bits of a level on parallel pins, 0 if colours differ; none of other pins.
    pub fn bits(&self) -> Option<usize> {
        let Video::Parallel {
            red, green, blue, ..
        } = self
        else {
            return None;
        };
        let alike = red.len() == green.len() && red.len() == blue.len();
        Some(if alike { red.len() } else { 0 })
    }

    /// The outputs of the top level with their pins.
    pub fn pins(&self) -> Vec<(String, &str)> {
        match self {
            Video::Tmds {
                blue,
                green,
                red,
                clock,
                ..
            } => numbered("channel", [blue, green, red, clock]).collect(),
            Video::Parallel {
                hsync,
                vsync,
                red,
                green,
                blue,
                de,
                clock,
                ..
            } => {
                let mut pins = vec![
                    ("hsync".to_owned(), hsync.as_str()),
                    ("vsync".to_owned(), vsync.as_str()),
                ];
                for (name, colour) in [("red", red), ("green", green), ("blue", blue)] {
                    pins.extend(numbered(name, colour));
                }
                for (name, pin) in [("de", de), ("pixel_clock_out", clock)] {
                    pins.extend(pin.iter().map(|pin| (name.to_owned(), pin.as_str())));
                }
                pins
            }
        }
    }

    /// Properties of its pins.
    pub fn io(&self) -> &str {
        match self {
            Video::Tmds { io, .. } | Video::Parallel { io, .. } => io,
        }
    }
}

/// The bits of an output with their pins.
fn numbered<'a>(
    name: &str,
    pins: impl IntoIterator<Item = &'a String>,
) -> impl Iterator<Item = (String, &'a str)> {
    let pins = pins.into_iter().enumerate();
    pins.map(move |(index, pin)| (format!("{name}_{index}"), pin.as_str()))
}
