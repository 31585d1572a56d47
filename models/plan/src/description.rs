//! Machine descriptions: what a machine with a screen is made of, as a TOML file (`docs/machines.md`).

pub mod keys;
mod lit_sphere;
mod validation;

use imogene_contract::object::ProductSlots;
use imogene_contract::slots::{FittedSlot, Products, Slots};
use imogene_contract::video::{Span, VideoMode};
use imogene_contract::{DeciderForm, MachineWords, RootForm, volume};
use imogene_golden::format::{FittedError, Format};
use imogene_golden::machine::post_filter::Kernel;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::widths::OwnWidths;
use imogene_scene::{in_plain_words, line_and_column, text_or_table};
use keys::{Places, key};
pub use lit_sphere::LitSphere;
pub(crate) use lit_sphere::SMALLEST_SIDE;
use serde::{Deserialize, Deserializer, Serialize};
use std::path::Path;
use thiserror::Error;
use toml::de::DeTable;

/// Which machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MachineKind {
    /// A processor for each object, no frame memory.
    Beam,
    /// Processors shared by the objects of one zone after another, two frames of memory.
    Zone,
}

/// Smoothing of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Smoothing {
    /// None.
    #[default]
    #[serde(rename = "none")]
    None,
    /// Mean of 2 x 2 pixels.
    #[serde(rename = "2x2")]
    Box,
    /// Binomial of 3 x 3 pixels.
    #[serde(rename = "3x3")]
    Binomial,
}

impl Smoothing {
    /// The filter.
    pub fn kernel(self) -> Kernel {
        match self {
            Smoothing::None => Kernel::Pass,
            Smoothing::Box => Kernel::Box,
            Smoothing::Binomial => Kernel::Binomial,
        }
    }
}

/// Where the pixels go.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Output {
    /// To the pins of a screen, with its synchronisation.
    #[default]
    Pins,
    /// Over AXI4-Stream, as fast as they are taken.
    Stream,
}

/// Columns and lines of a zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct ZoneSize {
    /// Columns.
    pub width: u32,
    /// Lines.
    pub height: u32,
}

/// A mode of one's own: shown, front porch, synchronisation, back porch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OwnMode {
    /// Of a line, in clocks.
    pub columns: [u64; 4],
    /// Of a frame, in lines.
    pub lines: [u64; 4],
    /// `hsync` is high in the synchronisation.
    #[serde(default)]
    pub hsync_high: bool,
    /// `vsync` is high in the synchronisation.
    #[serde(default)]
    pub vsync_high: bool,
}

/// The video mode.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Mode {
    /// One of the published modes, as `640x480`.
    Named(String),
    /// Numbers of one's own.
    Own(OwnMode),
}

impl<'de> Deserialize<'de> for Mode {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Mode, D::Error> {
        let wanted = "the name of a mode or a table of its numbers";
        text_or_table(input, wanted, Mode::Named, Mode::Own)
    }
}

/// A machine with a screen.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MachineDescription {
    /// Which machine.
    pub machine: MachineKind,
    /// Depth word.
    #[serde(default = "number::<_, 24>")]
    pub depth_word: u32,
    /// Widths that do not follow from it.
    #[serde(default, skip_serializing_if = "OwnWidths::is_none")]
    pub widths: OwnWidths,
    /// How the roots are taken.
    #[serde(default, skip_serializing_if = "RootForm::is_usual")]
    pub root_form: RootForm,
    /// Rows of the root networks between registers.
    #[serde(default = "number::<_, 1>")]
    pub rows_per_stage: u32,
    /// Object processors; in a beam machine one for each part of an object.
    #[serde(default)]
    pub objects: usize,
    /// Cut planes of each.
    #[serde(default)]
    pub planes: usize,
    /// Object processors that are not all alike, in place of `objects` and `planes`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slots: Option<Slots>,
    /// Products of solids; the last object processors are theirs, product by product.
    #[serde(default, skip_serializing_if = "is_default")]
    pub products: Products,
    /// How the nearest object is chosen.
    #[serde(default, skip_serializing_if = "DeciderForm::is_usual")]
    pub decider: DeciderForm,
    /// Transparent objects: its last slots, behind those of products, are theirs.
    #[serde(default, skip_serializing_if = "is_default")]
    pub layers: usize,
    /// Volume processors; in a beam machine one for each volume.
    #[serde(default)]
    pub volumes: usize,
    /// Planes of each.
    #[serde(default = "number::<_, 4>")]
    pub volume_planes: usize,
    /// Lights of the shading processor; with tables those whose flags number them.
    #[serde(default = "number::<_, 1>")]
    pub lights: usize,
    /// Of these, the last ones that are directional alone.
    #[serde(default, skip_serializing_if = "is_default")]
    pub suns: usize,
    /// Shading by tables in the place of a shading processor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lit_sphere: Option<LitSphere>,
    /// Zone of a zone machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub zone: Option<ZoneSize>,
    /// Words that a beam machine keeps for the next frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loader_words: Option<usize>,
    /// Video mode; of a machine that streams its shown part alone counts.
    pub mode: Mode,
    /// Where the pixels go.
    #[serde(default)]
    pub output: Output,
    /// Pixels of a line that a beam machine draws at once: 1, 2 or 4.
    #[serde(default = "number::<_, 1>", skip_serializing_if = "is_one")]
    pub pixels_per_clock: u32,
    /// Samples of a pixel along each side, in a zone machine: the mean of 1, 2 x 2 or 4 x 4 is shown.
    #[serde(default = "number::<_, 1>")]
    pub supersampling: u32,
    /// Smoothing.
    #[serde(default)]
    pub smoothing: Smoothing,
    /// An overlay plane.
    #[serde(default)]
    pub overlay: bool,
}

fn number<T: From<u8>, const N: u8>() -> T {
    N.into()
}

fn is_one(value: &u32) -> bool {
    *value == 1
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// Why a description is refused.
#[derive(Debug, Error)]
pub enum DescriptionError {
    /// The file cannot be read.
    #[error(
        "{file}: the machine description cannot be read ({source}); give the path of a readable TOML file"
    )]
    Unreadable {
        /// Path as given.
        file: String,
        /// The system's reason.
        source: std::io::Error,
    },
    /// Not a description.
    #[error("{file}:{line}:{column}: {problem}")]
    Syntax {
        /// Path as given.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What the parser says.
        problem: String,
    },
    /// A width out of its range.
    #[error("{place}: {key}: {problem}")]
    Widths {
        /// Path as given, with line and column of the value if that stands in it.
        place: String,
        /// Key.
        key: &'static str,
        /// Which, and what would be accepted.
        problem: FittedError,
    },
    /// A value out of its range.
    #[error("{place}: {key} is {value}; accepted: {accepted}")]
    Value {
        /// Path as given, with line and column of the value if that stands in it.
        place: String,
        /// Key.
        key: &'static str,
        /// Value.
        value: String,
        /// What would be accepted.
        accepted: String,
    },
}

fn most_planes(slots: &[FittedSlot]) -> usize {
    let planes = slots.iter().map(|slot| slot.planes as usize);
    planes.max().unwrap_or(0)
}

/// A key that has to be given, and is not.
fn missing(name: &str, file: &str) -> Option<DescriptionError> {
    let (key, accepted) = key(name)?;
    Some(DescriptionError::Value {
        place: file.into(),
        key,
        value: "missing".into(),
        accepted,
    })
}

/// What the reader says of a text, with the key that it speaks of and what that accepts where its value is of another
/// type.
fn unread(
    error: &toml::de::Error,
    text: &str,
    file: &str,
    places: Option<&Places>,
) -> DescriptionError {
    let start = error.span().map_or(0, |span| span.start);
    let (line, column) = line_and_column(text, start);
    let said =
        in_plain_words(error.message()).replace("wanted string or table", "expected a string");
    let around = || key(places?.around(start)?);
    let named = said.strip_prefix("missing field `");
    let named = named.and_then(|rest| rest.strip_suffix('`'));
    let of_file = named.filter(|_| start == 0);
    if let Some(missing) = of_file.and_then(|name| missing(name, file)) {
        return missing;
    }
    let mut of_types = ["invalid", "missing", "expected"].into_iter();
    let is_of_type = of_types.any(|word| said.starts_with(word));
    DescriptionError::Syntax {
        file: file.into(),
        line,
        column,
        problem: match around() {
            Some((key, accepted)) if is_of_type => format!("{key}: {said}; accepted: {accepted}"),
            Some((key, _)) => format!("{key}: {said}"),
            None => said,
        },
    }
}

/// Most bytes of a description, which has a dozen lines.
const MAX_BYTES: u64 = 1 << 20;

impl MachineDescription {
    /// Reads and checks a description.
    ///
    /// # Errors
    ///
    /// When the file cannot be read, is no description, or a value is out of its range.
    pub fn read(path: &Path) -> Result<MachineDescription, DescriptionError> {
        let file = path.display().to_string();
        let text = imogene_files::read_text(path, MAX_BYTES).map_err(|source| {
            DescriptionError::Unreadable {
                file: file.clone(),
                source,
            }
        })?;
        Self::parse(&text, &file)
    }

    /// The same of a text; `file` is the name that messages give it.
    pub fn parse(text: &str, file: &str) -> Result<MachineDescription, DescriptionError> {
        let table = DeTable::parse(text).map_err(|error| unread(&error, text, file, None))?;
        let places = Places::of(table.get_ref());
        let mut description = Self::deserialize(toml::Deserializer::from(table))
            .map_err(|error| unread(&error, text, file, Some(&places)))?;
        if places.value("objects").is_none() && description.slots.is_none() {
            return Err(missing("objects", file).expect("a key"));
        }
        description.count_slots();
        description.check_at(&|key| match places.value(key) {
            Some(start) => {
                let (line, column) = line_and_column(text, start);
                format!("{file}:{line}:{column}")
            }
            None => file.to_owned(),
        })?;
        Ok(description)
    }

    /// The text of the description.
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("a description is a table of plain values")
    }

    /// Counts objects and planes where they are not given.
    fn count_slots(&mut self) {
        let Some(Slots(slots)) = &self.slots else {
            return;
        };
        if self.objects == 0 {
            self.objects = slots.len();
        }
        if self.planes == 0 {
            self.planes = most_planes(slots);
        }
    }

    /// Its object processors.
    pub fn slots(&self) -> Vec<FittedSlot> {
        let alike = FittedSlot::quadric(self.planes as u32);
        match &self.slots {
            Some(Slots(slots)) => slots.clone(),
            None => vec![alike; self.objects],
        }
    }

    /// How many of its object processors are of no product and of no transparent object.
    pub fn slots_alone(&self) -> usize {
        let others = self.slots_of_products() + self.layers;
        self.slots().len().saturating_sub(others)
    }

    /// How many are of products.
    pub fn slots_of_products(&self) -> usize {
        self.products.0.iter().map(ProductSlots::count).sum()
    }

    /// All its words.
    pub fn words(&self) -> MachineWords {
        MachineWords {
            root_form: self.root_form,
            ..self.widths.beside(self.depth_word)
        }
    }

    /// The format of its words.
    ///
    /// # Errors
    ///
    /// When a width is out of its range, which no description has that was checked.
    pub fn format(&self) -> Result<Format, FittedError> {
        Format::fitted(&self.words())
    }

    /// Columns and lines of the samples that it draws; none if its mode is not one.
    pub fn drawn_size(&self) -> Option<(u32, u32)> {
        let mode = self.video_mode()?;
        let size = |pixels: u64| pixels as u32 * self.supersampling;
        Some((size(mode.line.active), size(mode.frame.active)))
    }

    /// The numbers of the video mode; none if it is not a mode.
    pub fn video_mode(&self) -> Option<VideoMode> {
        match &self.mode {
            Mode::Named(name) => {
                let mut modes = VideoMode::ALL.into_iter();
                modes.find(|m| *name == format!("{}x{}", m.line.active, m.frame.active))
            }
            Mode::Own(own) => {
                let span = |[active, front, sync, back]: [u64; 4]| {
                    let shown = active.checked_add(front)?;
                    let total = shown.checked_add(sync)?.checked_add(back)?;
                    let is_mode = (1..4096).contains(&active) && sync >= 1 && total <= 8192;
                    is_mode.then_some(Span {
                        active,
                        front,
                        sync,
                        back,
                    })
                };
                Some(VideoMode {
                    line: span(own.columns)?,
                    frame: span(own.lines)?,
                    hsync_high: own.hsync_high,
                    vsync_high: own.vsync_high,
                })
            }
        }
    }

    /// Words that the loader of a beam machine keeps: if not given, enough for all its processors and their tables.
    pub fn loader_words(&self) -> usize {
        let slots = self.slots();
        let words = slots
            .iter()
            .map(|slot| slot.kind.words(slot.planes as usize));
        let objects: usize = words.map(|words| words + 1 + 4).sum();
        let volumes = self.volumes * volume::words(self.volume_planes);
        let words = objects + volumes + 8 + 16 * self.lights;
        self.loader_words.unwrap_or(words.next_power_of_two())
    }

    /// The deciding part of a zone machine.
    pub fn zone_machine(&self) -> ZoneMachine {
        let zone = self.zone.unwrap_or(ZoneSize {
            width: 1,
            height: 1,
        });
        let mut slots = self.slots();
        ZoneMachine {
            layers: slots.split_off(slots.len() - self.layers),
            slots,
            products: self.products.0.clone(),
            volume_processors: self.volumes,
            volume_planes: self.volume_planes,
            zone_width: zone.width,
            zone_height: zone.height,
            samples: self.supersampling,
        }
    }
}
