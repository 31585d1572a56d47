//! The files with which a test bench of a user's own drives a machine: beats, shading words, expected pixels, their
//! description, and a bench that is ready to run.

use super::request::mode;
use imogene_contract::object::Kind;
use imogene_golden::machine::overlay::OverlayPlane;
use imogene_golden::machine::zone::beat::{Beat, kind};
use imogene_golden::object::quotient;
use imogene_golden::unit::lattice::Lattice;
use imogene_plan::description::{MachineDescription, MachineKind, Output};
use imogene_plan::display::Image;
use minijinja::{Environment, context};
use serde_json::{Value, json};
use std::fmt::Write;

const TEMPLATE: &str = include_str!("bench/bench.v");

const BEATS: &str = "beats.hex";
const SHADING: &str = "shading.hex";
const PIXELS: &str = "pixels.hex";
const OVERLAY: &str = "overlay.hex";
const BENCH: &str = "bench.v";
const DESCRIPTION: &str = "bench.json";

/// A frame that a bench sends, and what it expects then.
pub struct BenchFrame<'a> {
    /// The scene, with the options of its view.
    pub scene: &'a str,
    /// Words, and picture without an overlay.
    pub image: &'a Image,
}

/// What a bench is for.
pub struct Bench<'a> {
    /// The machine.
    pub machine: &'a MachineDescription,
    /// Its top module; the file of its Verilog is named after it.
    pub top: &'a str,
    /// The frames, one after the other.
    pub frames: &'a [BenchFrame<'a>],
    /// The plane over all of them.
    pub overlay: Option<&'a OverlayPlane>,
}

/// A part of a line, the first in the high bits: name, bits that are not always zero, where it goes and its meaning.
type Field = (&'static str, usize, &'static str);

/// Hexadecimal digits of a field.
fn digits((_, bits, _): &Field) -> usize {
    bits.div_ceil(4)
}

/// A file of words: one a line, its fields joined by underscores, which `$readmemh` passes over as it does comments.
struct Words<'a> {
    file: &'static str,
    what: &'static str,
    fields: &'a [Field],
    /// Each group of lines with the comment above it.
    groups: Vec<(String, Vec<Vec<u64>>)>,
}

impl Words<'_> {
    fn text(&self) -> String {
        let names: Vec<&str> = self.fields.iter().map(|field| field.0).collect();
        let mut text = format!("// {}: {}\n", self.what, names.join("_"));
        for (comment, lines) in &self.groups {
            // A name may hold a line break; what follows one would be read as words.
            let _ = writeln!(text, "// {}", comment.replace(['\n', '\r'], " "));
            for words in lines {
                let words = words.iter().zip(self.fields.iter().map(digits));
                let words = words.map(|(word, digits)| format!("{word:0digits$x}"));
                text += &words.collect::<Vec<_>>().join("_");
                text.push('\n');
            }
        }
        text
    }

    fn count(&self) -> usize {
        self.groups.iter().map(|(_, lines)| lines.len()).sum()
    }

    fn description(&self) -> Value {
        let mut above = self.fields.iter().map(digits).sum::<usize>() * 4;
        let fields = self.fields.iter().map(|field| {
            let (name, bits, meaning) = field;
            let digits = digits(field);
            above -= digits * 4;
            json!({ "name": name, "digits": digits, "low_bit": above, "bits": bits, "meaning": meaning })
        });
        let fields: Vec<Value> = fields.collect();
        json!({ "file": self.file, "what": self.what, "count": self.count(), "fields": fields })
    }
}

impl Bench<'_> {
    /// The files, each with its name.
    pub fn files(&self) -> Vec<(&'static str, String)> {
        let format = self.machine.format();
        let format = format.expect("a description that was checked");
        let slots = self.machine.slots();
        let numerator = match slots.iter().any(|slot| slot.kind == Kind::Quotient) {
            true => quotient::widths(&format, false).numerator,
            false => 0,
        };
        // Bits of a beat's data: those of the widest word, at least the 32 of the shading processor.
        let data = format.bus().max(numerator).max(32) as usize;
        let beat = beat_fields(data);
        let words = self.words(&beat);
        let files = words.iter().map(|words| (words.file, words.text()));
        let mut files: Vec<_> = files.collect();
        let description = serde_json::to_string_pretty(&self.description(&words));
        let description = description.expect("every key is a string");
        files.push((DESCRIPTION, description + "\n"));
        files.push((BENCH, self.bench(data, words[0].count())));
        files
    }

    fn is_beam(&self) -> bool {
        self.machine.machine == MachineKind::Beam
    }

    fn frame_size(&self) -> (u64, u64) {
        let size = self.machine.frame_size();
        size.expect("a description that was checked")
    }

    fn has_pins(&self) -> bool {
        self.machine.output == Output::Pins
    }

    fn words<'a>(&self, beat: &'a [Field]) -> Vec<Words<'a>> {
        let line = |b: &Beat| {
            let (unit, address) = (b.unit.into(), b.address.into());
            vec![b.last.into(), b.kind.into(), unit, address, b.data]
        };
        let is_shading = |beat: &&Beat| beat.kind == kind::SHADING;
        let shading = |beat: &Beat| vec![beat.address.into(), beat.data];
        let mut words = vec![
            Words {
                file: BEATS,
                what: "beats of the host",
                fields: beat,
                groups: self.groups(|frame| frame.image.beats.iter().map(line).collect()),
            },
            Words {
                file: SHADING,
                what: "words of the shading processor, which are among the beats",
                fields: &SHADING_FIELDS,
                groups: self.groups(|frame| {
                    let beats = frame.image.beats.iter();
                    beats.filter(is_shading).map(shading).collect()
                }),
            },
            Words {
                file: PIXELS,
                what: "expected pixels",
                fields: &PIXEL_FIELDS,
                groups: self.groups(|frame| {
                    let over = self.overlay.map(|plane| plane.over(&frame.image.picture));
                    let picture = over.as_ref().unwrap_or(&frame.image.picture);
                    let colour = |colour: &[u8]| colour.iter().copied().map(u64::from).collect();
                    let Lattice { y0, dy, .. } = frame.image.pixels;
                    let lines = picture.chunks_exact(3 * mode(self.machine).line.active as usize);
                    let lines = lines.skip(y0 as usize).step_by(dy as usize);
                    let pixels = lines.flat_map(|line| line.chunks_exact(3));
                    pixels.map(colour).collect()
                }),
            },
        ];
        words.extend(self.overlay.map(|plane| Words {
            file: OVERLAY,
            what: "words of the overlay",
            fields: &OVERLAY_FIELDS,
            groups: vec![(
                "over every frame".into(),
                plane.words.iter().map(|&word| vec![word.into()]).collect(),
            )],
        }));
        words
    }

    fn groups(&self, lines: impl Fn(&BenchFrame) -> Vec<Vec<u64>>) -> Vec<(String, Vec<Vec<u64>>)> {
        let frames = self.frames.iter().enumerate();
        let group = |(number, frame): (usize, &BenchFrame)| {
            (format!("frame {number}: {}", frame.scene), lines(frame))
        };
        frames.map(group).collect()
    }

    fn description(&self, words: &[Words]) -> Value {
        let (width, height) = self.frame_size();
        let mut first = vec![0; 3];
        let mut frame = |number: usize, frame: &BenchFrame| {
            let mut entry = json!({ "scene": frame.scene });
            for (words, first) in words.iter().zip(&mut first) {
                let lines = words.groups[number].1.len();
                entry[words.file] = json!({ "first_word": *first, "words": lines });
                *first += lines;
            }
            entry
        };
        let frames = self.frames.iter().enumerate();
        let frames: Vec<Value> = frames.map(|(number, each)| frame(number, each)).collect();
        json!({
            "top": self.top,
            "verilog": format!("{}.v", self.top),
            "bench": BENCH,
            "run": self.run(),
            "width": width,
            "height": height,
            "clock": "clock, rising edge; no reset: registers start from their initial values",
            "handshake": self.handshake(),
            "words": words.iter().map(Words::description).collect::<Vec<_>>(),
            "word_lines": "one word a line, hexadecimal; the first field is in the high bits; underscores and lines that begin with // mean nothing",
            "frames": frames,
        })
    }

    fn run(&self) -> String {
        let top = self.top;
        format!("iverilog -g2005 -s bench -o bench.vvp {BENCH} {top}.v && vvp -n bench.vvp")
    }

    /// What the two sides of every stream and the pins do, one rule a line.
    fn handshake(&self) -> Vec<&'static str> {
        let rules = match (self.is_beam(), self.has_pins()) {
            (true, true) => [HOST, BEAM, BEAM_PINS, PINS],
            (true, false) if self.machine.pixels_at_once() > 1 => {
                [HOST, BEAM, BEAM_STREAM, STREAM_OF_SEVERAL]
            }
            (true, false) => [HOST, BEAM, BEAM_STREAM, STREAM],
            (false, true) => [HOST, ZONE, ZONE_PINS, PINS],
            (false, false) => [HOST, ZONE, ZONE_STREAM, STREAM],
        };
        rules.concat()
    }

    fn bench(&self, data: usize, beats: usize) -> String {
        let (mode, (width, height)) = (mode(self.machine), self.frame_size());
        let zone = self.machine.zone;
        let zone = zone.map_or(0, |zone| u64::from(zone.width * zone.height));
        let colour = self.overlay.map(|plane| plane.colour);
        let colour = colour.map(|[r, g, b]| format!("{r:02x}{g:02x}{b:02x}"));
        let text = Environment::new().render_str(TEMPLATE, context! {
            top => self.top,
            run => self.run(),
            files => context! { beats => BEATS, pixels => PIXELS, overlay => OVERLAY, description => DESCRIPTION },
            beats,
            frames => self.frames.len(),
            width,
            height,
            data,
            padded => data.next_multiple_of(4),
            patience => 4 * (mode.clocks() + zone + 1000),
            beam => self.is_beam(),
            pins => self.has_pins(),
            lanes => self.machine.pixels_at_once(),
            overlay => self.overlay.map(|plane| plane.words.len()),
            overlay_colour => colour,
        });
        text.expect("the template has these names alone") + "\n"
    }
}

#[rustfmt::skip]
fn beat_fields(data: usize) -> [Field; 5] {
    [
        ("last", 1, "1 in the last beat of a frame: s_tlast of a beam machine"),
        ("kind", 4, "s_tdest: 0 word of an object processor, 1 of a volume processor, 2 of the shading processor, 3 material of an object, 4 command: of several modules, address 5 chooses those that the words behind it are for"),
        ("unit", 8, "s_tuser, bits 23..16: the processor"),
        ("address", 16, "s_tuser, bits 15..0: address of the word, object of the material, or the command"),
        ("data", data, "s_tdata: the word, in its low bits"),
    ]
}

#[rustfmt::skip]
const SHADING_FIELDS: [Field; 2] = [
    ("address", 16, "0 to 4 picture, view and background; 16 (j + 1) on light j; 4096 + 4 m on material m, with its share of the ambient light (section 8.1 of docs/architecture.md)"),
    ("data", 32, "the word"),
];
#[rustfmt::skip]
const PIXEL_FIELDS: [Field; 3] = [
    ("red", 8, "red"),
    ("green", 8, "green"),
    ("blue", 8, "blue; line by line from the top, each from the left"),
];
const OVERLAY_FIELDS: [Field; 1] = [(
    "pixels",
    32,
    "overlay_data of address 0, 1, ..: 32 pixels, line by line, the first in bit 0",
)];

const HOST: &[&str] = &[
    "a beat is taken at a rising edge of clock at which s_tvalid and s_tready are 1; it stays until then",
    "s_tvalid may be 0 on any clock and for any time; s_tready does not depend on it",
];
const BEAM: &[&str] = &[
    "s_tlast is 1 with the last beat of a frame; from then on the machine takes none until the words are at work",
    "words stay until they are written again; a volume takes part in a frame if its word 11 is among the beats",
    "refused is 1 if a frame has more words than the machine keeps: it is forgotten",
];
const ZONE: &[&str] = &[
    "there is no s_tlast: a frame ends with the show command of its last zone",
    "the beats of the next frame may follow at once",
];
const BEAM_PINS: &[&str] = &[
    "swapped is 1 for a clock when the words of a frame are at work; the next frame that begins on the pins is theirs",
];
const ZONE_PINS: &[&str] = &[
    "swapped is 1 for a clock when a frame is drawn; the next frame that begins on the pins is that one",
];
const PINS: &[&str] = &[
    "red, green, blue are a pixel on every clock with de = 1, line by line from the top, each from the left",
    "hsync and vsync are the synchronisation of the mode; frames follow each other for ever",
    "the overlay ports are 0 if there is no overlay; a word of it is written on every clock with overlay_write = 1",
];
const STREAM: &[&str] = &[
    "a pixel leaves at a rising edge at which m_tvalid and m_tready are 1; until then it stays; m_tvalid does not depend on m_tready",
    "m_tdata is red in bits 23..16, green in 15..8, blue in 7..0",
];
const STREAM_OF_SEVERAL: &[&str] = &[
    "pixels leave at a rising edge at which m_tvalid and m_tready are 1; until then they stay; m_tvalid does not depend on m_tready",
    "m_tdata_0 is the leftmost of as many neighbours as there are: red in bits 23..16, green in 15..8, blue in 7..0",
    "m_tuser and m_tlast are of all pixels of a clock: the first and the last pixel are among them",
];
const BEAM_STREAM: &[&str] = &[
    "swapped is 1 for a clock when the words of a frame are at work; the next frame that begins is theirs, and is repeated until new words come",
    "pixels come line by line; m_tuser is 1 with the first pixel of a frame, m_tlast with the last of each line",
];
const ZONE_STREAM: &[&str] = &[
    "every frame comes once, pixel by pixel in the order of the zones",
    "m_tuser is the line in bits 23..12 and the column in 11..0; m_tlast is 1 with the last pixel of a frame",
];
