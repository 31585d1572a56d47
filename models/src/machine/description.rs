//! Machine descriptions: what a machine with a screen is made of, as a TOML file (`docs/machines.md`).

use super::post_filter::Kernel;
use super::video_timing::{MODES, Span, VideoMode};
use super::zone::{MAX_PICTURE, SAMPLES, ZoneMachine};
use crate::object::quadric::MAX_PLANES;
use crate::scene::{in_plain_words, line_and_column};
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;
use std::path::Path;
use thiserror::Error;

/// Pixels of a zone at most.
pub const MAX_ZONE_PIXELS: u32 = 1 << 14;
/// Pixels of a screen at most.
pub const MAX_SCREEN_PIXELS: u64 = 1 << 22;

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
#[serde(deny_unknown_fields)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Mode {
    /// One of the published modes, as `640x480`.
    Named(String),
    /// Numbers of one's own.
    Own(OwnMode),
}

/// A machine with a screen.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MachineDescription {
    /// Which machine.
    pub machine: MachineKind,
    /// Depth word, of the catalogue of formats.
    #[serde(default = "base_depth_word")]
    pub depth_word: u32,
    /// Rows of the root networks between registers.
    #[serde(default = "one")]
    pub rows_per_stage: u32,
    /// Object processors; in a beam machine one for each part of an object.
    pub objects: usize,
    /// Cut planes of each.
    pub planes: usize,
    /// Volume processors; in a beam machine one for each volume.
    #[serde(default)]
    pub volumes: usize,
    /// Planes of each.
    #[serde(default = "volume_planes")]
    pub volume_planes: usize,
    /// Lights of the shading processor.
    #[serde(default = "one_light")]
    pub lights: usize,
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
    /// Samples of a pixel along each side, in a zone machine: the mean of 1, 2 x 2 or 4 x 4 is shown.
    #[serde(default = "one")]
    pub supersampling: u32,
    /// Smoothing.
    #[serde(default)]
    pub smoothing: Smoothing,
    /// An overlay plane.
    #[serde(default)]
    pub overlay: bool,
}

fn base_depth_word() -> u32 {
    24
}

fn one() -> u32 {
    1
}

fn one_light() -> usize {
    1
}

fn volume_planes() -> usize {
    4
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
    /// A value out of its range.
    #[error("{file}: {key} is {value}; accepted: {accepted}")]
    Value {
        /// Path as given.
        file: String,
        /// Key.
        key: &'static str,
        /// Value.
        value: String,
        /// What would be accepted.
        accepted: String,
    },
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
    ///
    /// # Errors
    ///
    /// As [`Self::read`].
    pub fn parse(text: &str, file: &str) -> Result<MachineDescription, DescriptionError> {
        let description: Self = toml::from_str(text).map_err(|error| {
            let start = error.span().map_or(0, |span| span.start);
            let (line, column) = line_and_column(text, start);
            DescriptionError::Syntax {
                file: file.into(),
                line,
                column,
                problem: in_plain_words(error.message()),
            }
        })?;
        description.check(file)?;
        Ok(description)
    }

    /// Checks that every value is in its range; `file` is the name that messages give the description.
    pub(super) fn check(&self, file: &str) -> Result<(), DescriptionError> {
        let value = |key, value: String, accepted: String| DescriptionError::Value {
            file: file.into(),
            key,
            value,
            accepted,
        };
        let range = |key, given: usize, accepted: RangeInclusive<usize>| {
            if accepted.contains(&given) {
                return Ok(());
            }
            let accepted = format!("{} to {}", accepted.start(), accepted.end());
            Err(value(key, given.to_string(), accepted))
        };
        if !crate::format::Format::CATALOGUE.contains(&self.depth_word) {
            let accepted = crate::format::Format::CATALOGUE.map(|word| word.to_string());
            return Err(value(
                "depth_word",
                self.depth_word.to_string(),
                accepted.join(", "),
            ));
        }
        range(
            "rows_per_stage",
            self.rows_per_stage as usize,
            1..=self.depth_word as usize,
        )?;
        range("objects", self.objects, 1..=256)?;
        range("planes", self.planes, 0..=MAX_PLANES)?;
        range("volumes", self.volumes, 0..=256)?;
        range("volume_planes", self.volume_planes, 0..=MAX_PLANES)?;
        range("lights", self.lights, 1..=super::shader::MOST_LIGHTS)?;
        let Some(mode) = self.video_mode() else {
            let names = MODES.map(|m| format!("\"{}x{}\"", m.line.active, m.frame.active));
            let accepted = format!(
                "{}, or {{ columns = [shown, front, sync, back], lines = [..] }} with 1 to 4095 shown, a sync of 1 at least, 8192 in all",
                names.join(", ")
            );
            return Err(value("mode", format!("{:?}", self.mode), accepted));
        };
        let pixels = mode.line.active * mode.frame.active;
        if pixels > MAX_SCREEN_PIXELS {
            let accepted = format!("screens of up to {MAX_SCREEN_PIXELS} pixels");
            return Err(value("mode", format!("{pixels} pixels"), accepted));
        }
        self.check_samples(&mode, &value)?;
        if mode.line.active > 2048 && self.smoothing != Smoothing::None {
            let accepted = "lines of up to 2048 pixels".into();
            return Err(value(
                "smoothing",
                format!("on lines of {} pixels", mode.line.active),
                accepted,
            ));
        }
        if self.output == Output::Stream && (self.smoothing != Smoothing::None || self.overlay) {
            let accepted = "neither smoothing nor overlay, or output = \"pins\"".into();
            return Err(value("output", "stream".into(), accepted));
        }
        match (self.machine, self.zone, self.loader_words) {
            (MachineKind::Zone, Some(zone), None) => {
                let fits = zone.width >= 1
                    && zone.height >= 1
                    && zone.width.saturating_mul(zone.height) <= MAX_ZONE_PIXELS;
                let accepted = format!("zones of 1 to {MAX_ZONE_PIXELS} pixels");
                fits.then_some(()).ok_or_else(|| {
                    value(
                        "zone",
                        format!("{} x {}", zone.width, zone.height),
                        accepted,
                    )
                })
            }
            (MachineKind::Zone, None, _) => Err(value(
                "zone",
                "missing".into(),
                "zone = { width = 32, height = 32 }, in a zone machine".into(),
            )),
            (MachineKind::Zone, _, Some(_)) => Err(value(
                "loader_words",
                "given".into(),
                "loader_words in a beam machine alone".into(),
            )),
            (MachineKind::Beam, Some(_), _) => Err(value(
                "zone",
                "given".into(),
                "a zone in a zone machine alone".into(),
            )),
            (MachineKind::Beam, None, _) => range("loader_words", self.loader_words(), 2..=65_536),
        }
    }

    fn check_samples(
        &self,
        mode: &VideoMode,
        value: &impl Fn(&'static str, String, String) -> DescriptionError,
    ) -> Result<(), DescriptionError> {
        let refuse = |accepted: String| {
            Err(value(
                "supersampling",
                self.supersampling.to_string(),
                accepted,
            ))
        };
        if !SAMPLES.contains(&self.supersampling) {
            return refuse("1, 2 or 4".into());
        }
        if self.machine == MachineKind::Beam && self.supersampling != 1 {
            return refuse("1 in a beam machine; a zone machine has the memory for more".into());
        }
        let most = u64::from(MAX_PICTURE / self.supersampling);
        if mode.line.active.max(mode.frame.active) > most {
            return refuse(format!("on a screen of up to {most} x {most} pixels"));
        }
        Ok(())
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
            Mode::Named(name) => MODES
                .into_iter()
                .find(|m| *name == format!("{}x{}", m.line.active, m.frame.active)),
            Mode::Own(own) => {
                let span = |[active, front, sync, back]: [u64; 4]| {
                    let total = active
                        .checked_add(front)?
                        .checked_add(sync)?
                        .checked_add(back)?;
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
        let objects = self.objects * (24 + 7 * self.planes + 1 + 4);
        let volumes = self.volumes * (13 + 4 * self.volume_planes);
        let words = objects + volumes + 8 + 16 * self.lights;
        self.loader_words.unwrap_or(words.next_power_of_two())
    }

    /// The deciding part of a zone machine.
    pub fn zone_machine(&self) -> ZoneMachine {
        let zone = self.zone.unwrap_or(ZoneSize {
            width: 1,
            height: 1,
        });
        ZoneMachine {
            object_processors: self.objects,
            planes: self.planes,
            volume_processors: self.volumes,
            volume_planes: self.volume_planes,
            zone_width: zone.width,
            zone_height: zone.height,
            samples: self.supersampling,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEAM: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = \"640x480\"\n";

    fn refusal(text: &str) -> String {
        MachineDescription::parse(text, "m.toml")
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn a_description_needs_little() {
        let beam = MachineDescription::parse(BEAM, "m.toml").unwrap();
        assert_eq!(
            (beam.depth_word, beam.rows_per_stage, beam.lights),
            (24, 1, 1)
        );
        assert_eq!(beam.loader_words(), 1024);
        assert_eq!(beam.video_mode().unwrap().clocks(), 800 * 525);
        let own = BEAM.replace(
            "\"640x480\"",
            "{ columns = [160, 4, 4, 4], lines = [120, 2, 2, 12] }",
        );
        let own = MachineDescription::parse(&own, "m.toml").unwrap();
        assert_eq!(own.video_mode().unwrap().clocks(), 172 * 136);
    }

    #[test]
    fn what_is_refused_names_the_key_and_what_is_accepted() {
        let refused = |old: &str, new: &str| refusal(&BEAM.replace(old, new));
        assert!(refused("10", "0").contains("objects is 0; accepted: 1 to 256"));
        assert!(refused("640x480", "640x481").contains("\"1280x720\""));
        assert!(refused("beam", "zone").contains("zone is missing"));
        assert!(refused("planes", "plans").starts_with("m.toml:3:1: unknown field `plans`"));
        assert!(
            refusal(&format!("{BEAM}output = \"stream\"\noverlay = true\n"))
                .contains("output is stream")
        );
        assert!(refused("= 3", "= 13").contains("0 to 12"));
        assert!(refusal(&format!("{BEAM}depth_word = 23\n")).contains("16, 20, 24, 28, 32"));
        assert!(
            refusal(&format!("{BEAM}zone = {{ width = 8, height = 8 }}\n"))
                .contains("zone machine alone")
        );
        assert!(refusal(&format!("{BEAM}loader_words = 1\n")).contains("2 to 65536"));
        assert!(refusal(&format!("{BEAM}supersampling = 2\n")).contains("1 in a beam machine"));
        let zone = BEAM.replace("beam", "zone") + "zone = { width = 8, height = 8 }\n";
        assert!(refusal(&format!("{zone}supersampling = 3\n")).contains("1, 2 or 4"));
        let wide = zone.replace("640x480", "1280x720");
        assert!(refusal(&format!("{wide}supersampling = 4\n")).contains("up to 1024 x 1024"));
    }
}
