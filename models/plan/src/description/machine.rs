//! What a machine with a screen is made of.

use imogene_contract::object::ProductSlots;
use imogene_contract::slots::{FittedSlot, Products, Slots};
use imogene_contract::video::{Span, VideoMode};
use imogene_contract::{DeciderForm, MachineWords, RootForm, volume};
use imogene_golden::format::{FittedError, Format};
use imogene_golden::machine::post_filter::Kernel;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::unit::lattice::Lattice;
use imogene_golden::widths::OwnWidths;
use imogene_prepare::lit_sphere::{SphereForm, most_tables};
use imogene_scene::{is_default, number, text_or_table};
use serde::{Deserialize, Deserializer, Serialize};

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

/// Entries along each side of the smallest tables.
pub(crate) const SMALLEST_SIDE: u32 = 16;

/// Shading by tables of the direction of the normal (`docs/architecture.md`, section 8.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct LitSphere {
    /// Entries along each side of a table: 16, 32, 64 or 128.
    pub side: u32,
    /// Materials, each with a table, and with twice as many for each light of the machine.
    pub materials: usize,
    /// The nearest entry is the colour, and nothing stands between entries.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub nearest: bool,
}

impl LitSphere {
    /// Bits of a coordinate in a table.
    pub fn places(&self) -> u32 {
        self.side.max(1).ilog2()
    }

    /// What its tables are like.
    pub fn form(&self) -> SphereForm {
        SphereForm {
            places: self.places(),
            nearest: self.nearest,
        }
    }

    /// Tables of this side at most.
    pub fn most_tables(&self) -> u32 {
        most_tables(self.places())
    }

    /// True if there are tables for its materials and the flags of so many lights.
    pub fn has_room(&self, lights: usize) -> bool {
        let most = self.most_tables().checked_shr(lights as u32);
        self.materials <= most.unwrap_or(0) as usize
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
    /// Graphics modules of a beam machine, 1, 2 or 4: of n modules each draws every n-th line.
    #[serde(default = "number::<_, 1>", skip_serializing_if = "is_one")]
    pub modules: u32,
    /// A picture of a beam machine is two frames, its even lines and its odd ones.
    #[serde(default, skip_serializing_if = "is_default")]
    pub interlaced: bool,
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

fn is_one(value: &u32) -> bool {
    *value == 1
}

impl MachineDescription {
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
    /// Fails when a width is out of its range, which no description has that was checked.
    pub fn format(&self) -> Result<Format, FittedError> {
        Format::fitted(&self.words())
    }

    /// Columns and lines of the samples that it draws; none if its mode is not one.
    pub fn drawn_size(&self) -> Option<(u32, u32)> {
        let mode = self.video_mode()?;
        let size = |pixels: u64| pixels as u32 * self.supersampling;
        Some((size(mode.line.active), size(mode.frame.active)))
    }

    /// The pixels of each frame of a picture: all of them, or those of both fields.
    pub fn fields(&self) -> Vec<Lattice> {
        match self.interlaced {
            false => vec![Lattice::zone(0, 0)],
            true => [0, 1].map(|first| Lattice::lines(2, first)).to_vec(),
        }
    }

    /// Pixels that leave a machine that streams on a clock.
    pub fn pixels_at_once(&self) -> u32 {
        self.pixels_per_clock * self.modules
    }

    /// The pixels of each graphics module in a frame.
    pub(crate) fn lines_of_modules(&self, frame: &Lattice) -> Vec<Lattice> {
        let modules = i64::from(self.modules);
        let lines = |module: i64| Lattice {
            y0: frame.y0 + module * frame.dy,
            dy: modules * frame.dy,
            ..*frame
        };
        (0..modules).map(lines).collect()
    }

    /// Columns and lines of a frame as it leaves; none if its mode is not one.
    pub fn frame_size(&self) -> Option<(u64, u64)> {
        let mode = self.video_mode()?;
        Some((
            mode.line.active,
            mode.frame.active >> u32::from(self.interlaced),
        ))
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
        let of_slot = |slot: &FittedSlot| slot.kind.words(slot.planes as usize) + 1 + 4;
        let objects: usize = self.slots().iter().map(of_slot).sum();
        let volumes = self.volumes * volume::words(self.volume_planes);
        let words = objects + volumes + 8 + 16 * self.lights;
        let words = words.next_power_of_two() * self.modules as usize;
        self.loader_words.unwrap_or(words)
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
    /// The machine with tables of this form in the place of its lights.
    pub fn lit_by_tables(self, form: SphereForm) -> MachineDescription {
        MachineDescription {
            lights: 0,
            suns: 0,
            lit_sphere: Some(LitSphere {
                side: 1 << form.places,
                materials: 1,
                nearest: form.nearest,
            }),
            ..self
        }
    }
}

pub(super) fn most_planes(slots: &[FittedSlot]) -> usize {
    let planes = slots.iter().map(|slot| slot.planes as usize);
    planes.max().unwrap_or(0)
}
