//! Parameters of units besides the format: option, symbol, range and default.

use crate::shading::MOST_TABLES;
use crate::video::VideoMode;
use crate::words::{MOST_LAYERS, MOST_LIGHTS, MOST_MEMBERS, MOST_OBJECTS, MOST_PLANES, MOST_SIDES};

/// A parameter of a unit.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Option of the command line.
    pub option: &'static str,
    /// Symbol in formulas.
    pub symbol: &'static str,
    /// What it counts, for which units, and its legal values.
    pub meaning: &'static str,
    /// Least legal value.
    pub least: u32,
    /// Greatest legal value; none where it is the depth word.
    pub most: Option<u32>,
    /// What it is if nobody asks for another value; none where it is half the depth word.
    pub default: Option<u32>,
}

impl Parameter {
    /// Its legal values: `1 to W`.
    pub fn range(&self) -> String {
        let most = self.most.map_or("W".to_owned(), |most| most.to_string());
        format!("{} to {most}", self.least)
    }
}

/// The table of all parameters, for the macro that makes them and the one that makes a request of them.
macro_rules! with_parameters {
    ($take:ident) => {
        $take! {
            PLANES: "planes" "N" planes, 0 to Some(MOST_PLANES), Some(3),
                "Cut planes of an object, 0 to 12; faces of a polyhedron, 1 to 12 [default: 3; 4 of patches and volumes, 6 of polyhedra]";
            ROWS: "rows-per-stage" "R" rows_per_stage, 1 to None, Some(1),
                "Rows of the root network per register stage, 1 to W [default: 1]";
            OBJECTS: "objects" "M" objects, 1 to Some(MOST_OBJECTS), Some(4),
                "Object slots of a machine, inputs of a decider or volumes of a shadow stage, 1 to 256; processors on a card of card_decider [default: 4]";
            // Half of them, as in the experiment of section B.10.
            DIGITS: "digits" "D" digits, 1 to None, None,
                "Digits that square_root_rows and square_root_leading keep, 1 to W [default: W / 2]";
            CORRECTIONS: "corrections" "C" corrections, 0 to Some(2), Some(1),
                "Corrections of square_root_linear (default 2) and square_root_quadratic (default 1), 0 to 2";
            SIDES: "sides" "E" sides, 3 to Some(MOST_SIDES), Some(3),
                "Sides of a facet, 3 or 4, of a non-planar facet 1 to 4 [default: 3]";
            MODE: "mode" "V" mode, 0 to Some(VideoMode::ALL.len() as u32 - 1), Some(0),
                "Video mode of video_timing: 0 is 160 x 120 for simulation, 1 640 x 480, 2 1280 x 720, 3 1920 x 1080 [default: 0]";
            CARDS: "cards" "K" cards, 1 to Some(64), Some(2),
                "Cards of card_decider, 1 to 64, with as many processors each as --objects says [default: 2]";
            LAYERS: "layers" "T" layers, 1 to Some(MOST_LAYERS), Some(2),
                "Layers of transparency_pipeline, 1 to 8 [default: 2]";
            INTERSECTED: "intersected" "I" intersected, 1 to Some(MOST_MEMBERS), Some(2),
                "Objects that csg_product intersects, 1 to 16 [default: 2]";
            SUBTRACTED: "subtracted" "J" subtracted, 0 to Some(MOST_MEMBERS), Some(2),
                "Objects that csg_product takes away, 0 to 16 [default: 2]";
            LIGHTS: "lights" "Q" lights, 1 to Some(MOST_LIGHTS), Some(1),
                "Lights of the shading processor, 1 to 16 [default: 1]";
            SUNS: "suns" "U" suns, 0 to Some(MOST_LIGHTS), Some(0),
                "Of its lights, the last ones that are directional alone, 0 to all [default: 0]";
            TABLE_PLACES: "table-places" "B" table_places, 4 to Some(7), Some(6),
                "Bits of a coordinate in the tables of lit_sphere and lit_sphere_nearest, 4 to 7: 2^B by 2^B entries [default: 6]";
            TABLES: "tables" "Z" tables, 1 to Some(MOST_TABLES), Some(1),
                "Tables of lit_sphere and lit_sphere_nearest, 1 to 32: at most 2^15 entries in all [default: 1]";
        }
    };
}
pub(crate) use with_parameters;

macro_rules! constants {
    ($($name:ident: $option:literal $symbol:literal $field:ident, $least:literal to $most:expr, $default:expr, $meaning:literal;)*) => {
        $(pub(crate) const $name: Parameter = Parameter {
            option: $option,
            symbol: $symbol,
            meaning: $meaning,
            least: $least,
            most: $most,
            default: $default,
        };)*

        /// Every parameter, each once.
        pub const PARAMETERS: &[Parameter] = &[$($name),*];
    };
}

with_parameters!(constants);

/// Planes of a patch or volume; the source has four.
pub(crate) const FOUR_PLANES: Parameter = Parameter {
    default: Some(4),
    ..PLANES
};
/// Faces of a polyhedron; a cube has six.
pub(crate) const FACES: Parameter = Parameter {
    least: 1,
    default: Some(6),
    ..PLANES
};
/// Sides of a facet that is not flat.
pub(crate) const CURVED_SIDES: Parameter = Parameter { least: 1, ..SIDES };
/// The fewest corrections of straight lines that stay under 1 % (section 4.1.2).
pub(crate) const TWO_CORRECTIONS: Parameter = Parameter {
    default: Some(2),
    ..CORRECTIONS
};
