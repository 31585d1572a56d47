//! What a machine description may say.

use super::error::DescriptionError;
use super::keys::{MAX_ZONE_PIXELS, SPHERE, key_of, modes};
use super::machine::{MachineDescription, MachineKind, Output, Smoothing, most_planes};
use imogene_contract::object::Kind;
use imogene_contract::slots::{FittedSlot, Slots};
use imogene_contract::video::VideoMode;
use imogene_contract::words::{LANES_LATENCY, MOST_LAYERS};
use imogene_golden::format::Format;
use imogene_golden::machine::shader::MOST_LIGHTS;
use imogene_golden::machine::zone::{MAX_PICTURE, SAMPLES};
use imogene_golden::object::quadric::{MAX_PLANES, after_root};
use imogene_golden::unit::root::Method;

/// Pixels of a screen at most.
const MAX_SCREEN_PIXELS: u64 = 1 << 22;
/// Pixels of a line at most that a smoothing filter keeps.
const MAX_FILTERED_LINE: u64 = 2048;

/// Key, value and what would be accepted.
struct Refusal(&'static str, String, String);

/// Clocks that a quotient begins later than a root.
const QUOTIENT_CLOCKS: u32 = 2;

type Checked = Result<(), Refusal>;

fn refuse(key: &'static str, value: impl ToString, accepted: impl Into<String>) -> Checked {
    Err(Refusal(key, value.to_string(), accepted.into()))
}

fn range(key: &'static str, value: usize, least: usize, most: usize) -> Checked {
    match (least..=most).contains(&value) {
        true => Ok(()),
        false => refuse(key, value, format!("{least} to {most}")),
    }
}

impl MachineDescription {
    /// Checks that every value is in its range; `file` is the name that messages give the description.
    ///
    /// # Errors
    ///
    /// When one is not.
    pub fn check(&self, file: &str) -> Result<(), DescriptionError> {
        self.check_at(&|_| file.to_owned())
    }

    /// The same; `place` tells of a key where it stands.
    pub(super) fn check_at(&self, place: &dyn Fn(&str) -> String) -> Result<(), DescriptionError> {
        let format = self.format().map_err(|problem| {
            let key = key_of(&problem);
            DescriptionError::Widths {
                place: place(key),
                key,
                problem,
            }
        })?;
        let checks = || {
            self.check_counts(format.root_rows() as usize)?;
            let mode = self.check_mode()?;
            self.check_slots(&format)?;
            self.check_sphere()?;
            self.check_products()?;
            self.check_samples(&mode)?;
            self.check_root_form()?;
            self.check_lanes(&mode, &format)?;
            self.check_fields(&mode)?;
            self.check_modules(&mode)?;
            self.check_output(&mode)?;
            self.check_kind()
        };
        checks().map_err(|Refusal(key, value, accepted)| DescriptionError::Value {
            place: place(key),
            key,
            value,
            accepted,
        })
    }

    fn check_counts(&self, rows: usize) -> Checked {
        range("rows_per_stage", self.rows_per_stage as usize, 1, rows)?;
        range("objects", self.objects, 1, 256)?;
        range("planes", self.planes, 0, MAX_PLANES)?;
        range("volumes", self.volumes, 0, 256)?;
        range("volume_planes", self.volume_planes, 0, MAX_PLANES)?;
        range("lights", self.lights, 0, MOST_LIGHTS)?;
        range("suns", self.suns, 0, self.lights.min(MOST_LIGHTS))
    }

    fn check_slots(&self, format: &Format) -> Checked {
        let Some(Slots(slots)) = &self.slots else {
            return Ok(());
        };
        let is_short = |slot: &&FittedSlot| slot.root.or(slot.plane).is_some();
        let is_shared = self.machine == MachineKind::Zone;
        let members = slots.iter().rev().skip(self.layers);
        let mut members = members.take(self.slots_of_products());
        if let Some(short) = members.find(is_short).filter(|_| is_shared) {
            let accepted = "no bits of its own in a slot of a product of a zone machine";
            return refuse("slots", short, accepted);
        }
        let is_other = |slot: &&FittedSlot| !matches!(slot.kind, Kind::Quadric | Kind::Patch);
        let other = slots.iter().find(is_other);
        if let Some(other) = other.filter(|_| !format.follows_depth_word()) {
            let accepted = "of the widths g1 and g2 alone, beside slots of other kinds than quadrics and patches";
            return refuse("slots", other.kind.name(), accepted);
        }
        let widths = format.widths();
        let mut each = slots.iter();
        let refused = each.find_map(|slot| Some((slot, slot.refused(&widths)?)));
        if let Some((slot, (word, _, least, most))) = refused {
            let accepted = match most {
                0 => {
                    "no bits of its own in a slot of another kind than quadrics and patches".into()
                }
                _ => format!("{word} of {least} to {most} bits"),
            };
            return refuse("slots", slot, accepted);
        }
        let counted = |key, value, counted| match value == counted {
            true => Ok(()),
            false => refuse(
                key,
                value,
                format!("{counted}, as slots has, or none given"),
            ),
        };
        counted("objects", self.objects, slots.len())?;
        counted("planes", self.planes, most_planes(slots))
    }

    fn check_products(&self) -> Checked {
        range("layers", self.layers, 0, MOST_LAYERS as usize)?;
        let (members, layers, slots) = (self.slots_of_products(), self.layers, self.slots());
        let text = || String::from(self.products.clone());
        if layers >= slots.len() {
            let accepted = format!(
                "fewer than the {} slots, one of which at least is opaque",
                slots.len()
            );
            return refuse("layers", layers, accepted);
        }
        let others = slots.len() - layers;
        if members > others {
            let accepted = format!("products of {others} slots in all, as there are");
            return refuse("products", text(), accepted);
        }
        let own = &slots[others - members..others];
        match own.iter().find(|slot| slot.kind != Kind::Quadric) {
            Some(other) => {
                let accepted = "slots of quadrics alone in products";
                refuse("slots", other.kind.name(), accepted)
            }
            None => Ok(()),
        }
    }

    fn check_sphere(&self) -> Checked {
        let Some(sphere) = self.lit_sphere else {
            return Ok(());
        };
        let nearest = if sphere.nearest {
            ", nearest = true"
        } else {
            ""
        };
        let (side, materials) = (sphere.side, sphere.materials);
        let text = format!("{{ side = {side}, materials = {materials}{nearest} }}");
        let is_side = [16, 32, 64, 128].contains(&sphere.side);
        match is_side && sphere.materials > 0 && sphere.has_room(self.lights) {
            true => Ok(()),
            false => refuse("lit_sphere", text, SPHERE),
        }
    }

    fn check_mode(&self) -> Result<VideoMode, Refusal> {
        let Some(mode) = self.video_mode() else {
            let given = toml::Value::try_from(&self.mode).expect("a name or a table of numbers");
            return Err(Refusal("mode", given.to_string(), modes()));
        };
        let pixels = mode.line.active * mode.frame.active;
        if pixels > MAX_SCREEN_PIXELS {
            let accepted = format!("screens of up to {MAX_SCREEN_PIXELS} pixels");
            return Err(Refusal("mode", format!("{pixels} pixels"), accepted));
        }
        Ok(mode)
    }

    fn check_samples(&self, mode: &VideoMode) -> Checked {
        let samples = self.supersampling;
        let refuse = |accepted: &str| refuse("supersampling", samples, accepted);
        if !SAMPLES.contains(&samples) {
            return refuse("1, 2 or 4");
        }
        if self.machine == MachineKind::Beam && samples != 1 {
            return refuse("1 in a beam machine; a zone machine has the memory for more");
        }
        let most = u64::from(MAX_PICTURE / samples);
        if mode.line.active.max(mode.frame.active) > most {
            return refuse(&format!("on a screen of up to {most} x {most} pixels"));
        }
        Ok(())
    }

    /// True for a beam machine that streams its picture: it may draw as slowly or as fast as it is built for.
    fn is_beam_stream(&self) -> bool {
        self.machine == MachineKind::Beam && self.output == Output::Stream
    }

    fn check_root_form(&self) -> Checked {
        let is_serial = self.words().clocks_per_pixel() > 1;
        if is_serial && (self.pixels_per_clock > 1 || !self.is_beam_stream()) {
            let accepted = "another form, or output = \"stream\" in a beam machine of one pixel per clock: \
                            an iterative root takes a clock for each digit";
            return refuse("root_form", self.root_form, accepted);
        }
        Ok(())
    }

    fn check_lanes(&self, mode: &VideoMode, format: &Format) -> Checked {
        let (lanes, width) = (self.pixels_per_clock, mode.line.active);
        let refuse = |accepted: &str| refuse("pixels_per_clock", lanes, accepted);
        if ![1, 2, 4].contains(&lanes) {
            return refuse("1, 2 or 4");
        }
        if lanes == 1 {
            return Ok(());
        }
        if !self.is_beam_stream() {
            return refuse("1, or output = \"stream\" in a beam machine");
        }
        let least = u64::from(lanes * self.longest_processor(format));
        if !width.is_multiple_of(u64::from(lanes)) || width < least {
            return refuse(&format!(
                "on lines of a multiple of {lanes} pixels, and {least} at least: all processors have begun a line before \
                 the next one begins"
            ));
        }
        Ok(())
    }

    fn check_modules(&self, mode: &VideoMode) -> Checked {
        let modules = self.modules;
        let refuse = |accepted: &str| refuse("modules", modules, accepted);
        if ![1, 2, 4].contains(&modules) {
            return refuse("1, 2 or 4");
        }
        if modules == 1 {
            return Ok(());
        }
        if !self.is_beam_stream() {
            return refuse("1, or output = \"stream\" in a beam machine");
        }
        let (width, height) = (mode.line.active, mode.frame.active);
        let at_once = u64::from(modules * self.pixels_per_clock);
        let lines = u64::from(modules) * self.fields().len() as u64;
        if !width.is_multiple_of(at_once) || width < 2 * at_once || !height.is_multiple_of(lines) {
            return refuse(&format!(
                "on lines of a multiple of {at_once} pixels, more than {at_once}, and a multiple of {lines} lines"
            ));
        }
        Ok(())
    }

    fn check_fields(&self, mode: &VideoMode) -> Checked {
        match (
            self.interlaced,
            self.is_beam_stream(),
            mode.frame.active.is_multiple_of(2),
        ) {
            (false, ..) | (true, true, true) => Ok(()),
            (true, false, _) => {
                let accepted = "false, or output = \"stream\" in a beam machine";
                refuse("interlaced", true, accepted)
            }
            (true, true, false) => {
                let lines = mode.frame.active;
                let accepted = "an even number of lines";
                refuse("interlaced", format!("on {lines} lines"), accepted)
            }
        }
    }

    /// Clocks that no processor takes more of, with those from the line to its lanes.
    fn longest_processor(&self, format: &Format) -> u32 {
        let is_quotient = |slot: &FittedSlot| slot.kind == Kind::Quotient;
        let slots = self.slots();
        let digits = match slots.iter().any(is_quotient) {
            true => format.depth.div_ceil(self.rows_per_stage),
            false => 0,
        };
        let root = Method::of(format.root_form).latency(format.root_rows(), self.rows_per_stage);
        let root = root.max(digits);
        let planes = most_planes(&slots).max(self.volume_planes);
        LANES_LATENCY + root + QUOTIENT_CLOCKS + after_root(planes)
    }

    fn check_output(&self, mode: &VideoMode) -> Checked {
        let (width, is_smoothed) = (mode.line.active, self.smoothing != Smoothing::None);
        if width > MAX_FILTERED_LINE && is_smoothed {
            let accepted = format!("lines of up to {MAX_FILTERED_LINE} pixels");
            return refuse("smoothing", format!("on lines of {width} pixels"), accepted);
        }
        if self.output == Output::Stream && (is_smoothed || self.overlay) {
            let accepted = "neither smoothing nor overlay, or output = \"pins\"";
            return refuse("output", "stream", accepted);
        }
        Ok(())
    }

    fn check_kind(&self) -> Checked {
        match (self.machine, self.zone, self.loader_words) {
            (MachineKind::Zone, Some(zone), None) => {
                let pixels = zone.width.saturating_mul(zone.height);
                if (1..=MAX_ZONE_PIXELS).contains(&pixels) {
                    return Ok(());
                }
                let accepted = format!("zones of 1 to {MAX_ZONE_PIXELS} pixels");
                refuse(
                    "zone",
                    format!("{} x {}", zone.width, zone.height),
                    accepted,
                )
            }
            (MachineKind::Zone, None, _) => {
                let accepted = "zone = { width = 32, height = 32 }, in a zone machine";
                refuse("zone", "missing", accepted)
            }
            (MachineKind::Zone, _, Some(_)) => refuse(
                "loader_words",
                "given",
                "loader_words in a beam machine alone",
            ),
            (MachineKind::Beam, Some(_), _) => {
                refuse("zone", "given", "a zone in a zone machine alone")
            }
            (MachineKind::Beam, None, _) => range("loader_words", self.loader_words(), 2, 65_536),
        }
    }
}
