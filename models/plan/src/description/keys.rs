//! The keys of a description: what each accepts, and where it stands in a text.

use imogene_contract::video::VideoMode;
use imogene_contract::words::MOST_LAYERS;
use imogene_golden::format::{FittedError, Format};
use imogene_golden::machine::shader::MOST_LIGHTS;
use imogene_golden::object::quadric::MAX_PLANES;
use toml::de::DeTable;

pub(super) const MAX_ZONE_PIXELS: u32 = 1 << 14;

/// A key, and what it accepts beside the others of its machine.
pub type Key = (&'static str, String);

/// All keys in their order.
pub fn keys() -> [Key; 26] {
    let up_to = |most: usize| format!("0 to {most}");
    let depths = format!("{} to {}", Format::DEPTHS.start(), Format::DEPTHS.end());
    let zone = format!("{{ width = 32, height = 32 }}, of 1 to {MAX_ZONE_PIXELS} pixels");
    [
        ("machine", "\"beam\" or \"zone\"".into()),
        ("depth_word", depths),
        (
            "widths",
            "a table such as { root = 20, plane = 30, normal = 14, g1 = 2, g2 = 4, dropped = 1 }"
                .into(),
        ),
        ("root_form", "a text such as \"linear2\"".into()),
        (
            "rows_per_stage",
            "1 to the digits of the root that are computed".into(),
        ),
        ("objects", "1 to 256, or slots in its place".into()),
        ("planes", up_to(MAX_PLANES)),
        (
            "slots",
            "a text such as \"3,0,2:r14:p20,patch2,sphere\"".into(),
        ),
        ("products", "a text such as \"2-1,1-3\"".into()),
        (
            "decider",
            "\"tree\", \"chain\" or a text such as \"cards4\"".into(),
        ),
        ("layers", up_to(MOST_LAYERS as usize)),
        ("volumes", up_to(256)),
        ("volume_planes", up_to(MAX_PLANES)),
        ("lights", up_to(MOST_LIGHTS)),
        ("suns", "0 to the number of lights".into()),
        ("lit_sphere", SPHERE.into()),
        ("zone", zone),
        ("loader_words", "2 to 65536".into()),
        ("mode", modes()),
        ("output", "\"pins\" or \"stream\"".into()),
        ("pixels_per_clock", "1, 2 or 4".into()),
        ("modules", "1, 2 or 4".into()),
        ("interlaced", "true or false".into()),
        ("supersampling", "1, 2 or 4".into()),
        ("smoothing", "\"none\", \"2x2\" or \"3x3\"".into()),
        ("overlay", "true or false".into()),
    ]
}

pub(super) const SPHERE: &str = "{ side = 64, materials = 2 } with a side of 16, 32, 64 or 128, and 1 to 32 materials, of side 64 \
     to 8 and of 128 to 2; half as many for each of the lights, which is 0 where nothing casts a shadow; and if need be \
     nearest = true";

pub(super) fn modes() -> String {
    let names = VideoMode::ALL.map(|m| format!("\"{}x{}\"", m.line.active, m.frame.active));
    format!(
        "{}, or {{ columns = [shown, front, sync, back], lines = [..] }} with 1 to 4095 shown, a sync of 1 at least, \
         8192 in all, and if need be hsync_high = true, vsync_high = true",
        names.join(", ")
    )
}

pub(super) fn key(name: &str) -> Option<Key> {
    keys().into_iter().find(|(own, _)| *own == name)
}

pub(super) fn key_of(problem: &FittedError) -> &'static str {
    match problem {
        FittedError::Range(("depth word", ..)) => "depth_word",
        FittedError::Range((word, ..)) if word.contains(" part of a ") => "root_form",
        _ => "widths",
    }
}

/// Where the keys of a text and their values begin, in the order of the text.
pub(super) struct Places(Vec<(String, usize, usize)>);

impl Places {
    pub(super) fn of(table: &DeTable) -> Places {
        let places = table.iter().map(|(key, value)| {
            let name = key.get_ref().to_string();
            (name, key.span().start, value.span().start)
        });
        let mut places: Vec<(String, usize, usize)> = places.collect();
        places.sort_by_key(|(_, start, _)| *start);
        Places(places)
    }

    pub(super) fn value(&self, key: &str) -> Option<usize> {
        let place = self.0.iter().find(|(name, ..)| name == key);
        place.map(|(_, _, value)| *value)
    }

    /// The key that a byte belongs to.
    pub(super) fn around(&self, offset: usize) -> Option<&str> {
        let mut before = self.0.iter().rev();
        let place = before.find(|(_, start, _)| *start <= offset);
        place.map(|(name, ..)| name.as_str())
    }
}
