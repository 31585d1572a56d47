//! What a machine description may say.

use super::error::DescriptionError;
use super::keys::{MAX_ZONE_PIXELS, SPHERE, key_of, modes};
use super::machine::{MachineDescription, MachineKind, Output, Smoothing, ZoneSize, most_planes};
use imogene_contract::object::Kind;
use imogene_contract::slots::{FittedSlot, Slots};
use imogene_contract::video::VideoMode;
use imogene_contract::words::{LANES_LATENCY, MOST_LAYERS};
use imogene_golden::format::Format;
use imogene_golden::machine::shader::MOST_LIGHTS;
use imogene_golden::machine::zone::{MAX_PICTURE, SAMPLES};
use imogene_golden::object::quadric::{MAX_PLANES, after_root};

const MAX_SCREEN_PIXELS: u64 = 1 << 22;
/// Pixels of a line at most that a smoothing filter keeps.
const MAX_FILTERED_LINE: u64 = 2048;

/// Clocks that a quotient begins later than a root.
const QUOTIENT_CLOCKS: u32 = 2;

/// Key, value and what would be accepted.
type Refusal = (&'static str, String, String);

type Checked = Result<(), Refusal>;

fn refuse(key: &'static str, value: impl ToString, accepted: impl Into<String>) -> Checked {
    Err((key, value.to_string(), accepted.into()))
}

/// Refuses a value unless it is right.
fn check(
    is_right: bool,
    key: &'static str,
    value: impl ToString,
    accepted: impl Into<String>,
) -> Checked {
    match is_right {
        true => Ok(()),
        false => refuse(key, value, accepted),
    }
}

fn range(key: &'static str, value: usize, least: usize, most: usize) -> Checked {
    let is_right = (least..=most).contains(&value);
    check(is_right, key, value, format!("{least} to {most}"))
}

impl MachineDescription {
    /// Fails when a value is out of its range; `file` is the name that messages give the description.
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
        checks().map_err(|(key, value, accepted)| DescriptionError::Value {
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
        for slot in slots {
            match slot.refused(&format.widths()) {
                None => {}
                Some((.., 0)) => {
                    let accepted =
                        "no bits of its own in a slot of another kind than quadrics and patches";
                    return refuse("slots", slot, accepted);
                }
                Some((word, _, least, most)) => {
                    return refuse("slots", slot, format!("{word} of {least} to {most} bits"));
                }
            }
        }
        let counted = |key, value, counted| {
            let accepted = format!("{counted}, as slots has, or none given");
            check(value == counted, key, value, accepted)
        };
        counted("objects", self.objects, slots.len())?;
        counted("planes", self.planes, most_planes(slots))
    }

    fn check_products(&self) -> Checked {
        range("layers", self.layers, 0, MOST_LAYERS as usize)?;
        let (members, layers, slots) = (self.slots_of_products(), self.layers, self.slots());
        let accepted = format!(
            "fewer than the {} slots, one of which at least is opaque",
            slots.len()
        );
        check(layers < slots.len(), "layers", layers, accepted)?;
        let others = slots.len() - layers;
        let text = String::from(self.products.clone());
        let accepted = format!("products of {others} slots in all, as there are");
        check(members <= others, "products", text, accepted)?;
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
        let (side, materials) = (sphere.side, sphere.materials);
        let nearest = match sphere.nearest {
            true => ", nearest = true",
            false => "",
        };
        let text = format!("{{ side = {side}, materials = {materials}{nearest} }}");
        let is_side = [16, 32, 64, 128].contains(&side);
        let is_right = is_side && materials > 0 && sphere.has_room(self.lights);
        check(is_right, "lit_sphere", text, SPHERE)
    }

    fn check_mode(&self) -> Result<VideoMode, Refusal> {
        let Some(mode) = self.video_mode() else {
            let given = toml::Value::try_from(&self.mode).expect("a name or a table of numbers");
            return Err(("mode", given.to_string(), modes()));
        };
        let pixels = mode.line.active * mode.frame.active;
        let accepted = format!("screens of up to {MAX_SCREEN_PIXELS} pixels");
        let is_right = pixels <= MAX_SCREEN_PIXELS;
        check(is_right, "mode", format!("{pixels} pixels"), accepted)?;
        Ok(mode)
    }

    fn check_samples(&self, mode: &VideoMode) -> Checked {
        let samples = self.supersampling;
        let check = |is_right, accepted: &str| check(is_right, "supersampling", samples, accepted);
        check(SAMPLES.contains(&samples), "1, 2 or 4")?;
        check(
            self.machine == MachineKind::Zone || samples == 1,
            "1 in a beam machine; a zone machine has the memory for more",
        )?;
        let most = u64::from(MAX_PICTURE / samples);
        check(
            mode.line.active.max(mode.frame.active) <= most,
            &format!("on a screen of up to {most} x {most} pixels"),
        )
    }

    /// True for a beam machine that streams its picture: it may draw as slowly or as fast as it is built for.
    fn is_beam_stream(&self) -> bool {
        self.machine == MachineKind::Beam && self.output == Output::Stream
    }

    fn check_root_form(&self) -> Checked {
        let is_serial = self.words().clocks_per_pixel() > 1;
        let accepted = "another form, or output = \"stream\" in a beam machine of one pixel per clock: \
                        an iterative root takes a clock for each digit";
        let is_right = !is_serial || self.pixels_per_clock <= 1 && self.is_beam_stream();
        check(is_right, "root_form", self.root_form, accepted)
    }

    /// Of a count of 1, 2 or 4, more than one of which a beam machine that streams has alone.
    fn check_parallel(&self, key: &'static str, count: u32) -> Checked {
        check([1, 2, 4].contains(&count), key, count, "1, 2 or 4")?;
        let accepted = "1, or output = \"stream\" in a beam machine";
        check(count == 1 || self.is_beam_stream(), key, count, accepted)
    }

    fn check_lanes(&self, mode: &VideoMode, format: &Format) -> Checked {
        let (key, lanes) = ("pixels_per_clock", self.pixels_per_clock);
        self.check_parallel(key, lanes)?;
        let width = mode.line.active;
        let least = u64::from(lanes * self.longest_processor(format));
        let accepted = format!(
            "on lines of a multiple of {lanes} pixels, and {least} at least: all processors have begun a line before \
             the next one begins"
        );
        let fits = width.is_multiple_of(u64::from(lanes)) && width >= least;
        check(lanes == 1 || fits, key, lanes, accepted)
    }

    fn check_modules(&self, mode: &VideoMode) -> Checked {
        let modules = self.modules;
        self.check_parallel("modules", modules)?;
        let (width, height) = (mode.line.active, mode.frame.active);
        let at_once = u64::from(modules * self.pixels_per_clock);
        let lines = u64::from(modules) * self.fields().len() as u64;
        let accepted = format!(
            "on lines of a multiple of {at_once} pixels, more than {at_once}, and a multiple of {lines} lines"
        );
        let fits = width.is_multiple_of(at_once) && width >= 2 * at_once;
        let fits = fits && height.is_multiple_of(lines);
        check(modules == 1 || fits, "modules", modules, accepted)
    }

    fn check_fields(&self, mode: &VideoMode) -> Checked {
        if !self.interlaced {
            return Ok(());
        }
        let (key, lines) = ("interlaced", mode.frame.active);
        let accepted = "false, or output = \"stream\" in a beam machine";
        check(self.is_beam_stream(), key, true, accepted)?;
        let value = format!("on {lines} lines");
        check(
            lines.is_multiple_of(2),
            key,
            value,
            "an even number of lines",
        )
    }

    /// Clocks that no processor takes more of, with those from the line to its lanes.
    fn longest_processor(&self, format: &Format) -> u32 {
        let is_quotient = |slot: &FittedSlot| slot.kind == Kind::Quotient;
        let slots = self.slots();
        let digits = match slots.iter().any(is_quotient) {
            true => format.depth.div_ceil(self.rows_per_stage),
            false => 0,
        };
        let root = format.root_latency(self.rows_per_stage).max(digits);
        let planes = most_planes(&slots).max(self.volume_planes);
        LANES_LATENCY + root + QUOTIENT_CLOCKS + after_root(planes)
    }

    fn check_output(&self, mode: &VideoMode) -> Checked {
        let (width, is_smoothed) = (mode.line.active, self.smoothing != Smoothing::None);
        let value = format!("on lines of {width} pixels");
        let accepted = format!("lines of up to {MAX_FILTERED_LINE} pixels");
        let fits = width <= MAX_FILTERED_LINE || !is_smoothed;
        check(fits, "smoothing", value, accepted)?;
        let is_plain = !is_smoothed && !self.overlay;
        let accepted = "neither smoothing nor overlay, or output = \"pins\"";
        let fits = self.output == Output::Pins || is_plain;
        check(fits, "output", "stream", accepted)
    }

    fn check_kind(&self) -> Checked {
        match (self.machine, self.zone, self.loader_words) {
            (MachineKind::Zone, Some(ZoneSize { width, height }), None) => {
                let pixels = width.saturating_mul(height);
                let accepted = format!("zones of 1 to {MAX_ZONE_PIXELS} pixels");
                let fits = (1..=MAX_ZONE_PIXELS).contains(&pixels);
                check(fits, "zone", format!("{width} x {height}"), accepted)
            }
            (MachineKind::Zone, None, _) => {
                let accepted = "zone = { width = 32, height = 32 }, in a zone machine";
                refuse("zone", "missing", accepted)
            }
            (MachineKind::Zone, _, Some(_)) => {
                let accepted = "loader_words in a beam machine alone";
                refuse("loader_words", "given", accepted)
            }
            (MachineKind::Beam, Some(_), _) => {
                refuse("zone", "given", "a zone in a zone machine alone")
            }
            (MachineKind::Beam, None, _) => range("loader_words", self.loader_words(), 2, 65_536),
        }
    }
}
