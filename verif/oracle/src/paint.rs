//! Pictures for a person: where a comparison, a search for cracks or a repair found something.

use crate::compare::{Mark, about};
use imogene_golden::machine::frame::Frame;

/// An 8-bit colour.
pub type Colour = [u8; 3];

/// Alike but in the band.
pub const BAND: Colour = [70, 110, 190];
/// Different where that is allowed.
pub const ALLOWED: Colour = [255, 170, 0];
/// One of two faces that the words cannot tell apart.
pub const TIED: Colour = [90, 170, 110];
/// Different where it is not.
pub const FORBIDDEN: Colour = [255, 30, 30];
/// The same face beyond the bound of its depth.
pub const TOO_DEEP: Colour = [255, 60, 255];
/// The same faces in a colour beyond its bound.
pub const OTHER_COLOUR: Colour = [240, 240, 90];
const BACKGROUND: Colour = [24, 26, 32];

/// The picture in grey, nearer lighter, each object in a tone of its own.
fn grey(frame: &Frame, z_max: i64) -> Vec<Colour> {
    let pixels = frame.depth.iter().zip(&frame.id);
    let seen = pixels.clone().filter(|(_, id)| **id >= 0);
    let seen = seen.map(|(depth, _)| *depth);
    let least = seen.clone().min().unwrap_or(0);
    let most = seen.max().unwrap_or(z_max);
    let span = (most - least).max(1) as f64;
    let tone = |(depth, id): (&i64, &i32)| {
        if *id < 0 {
            return BACKGROUND;
        }
        let far = (depth - least) as f64 / span;
        let step = f64::from(id.rem_euclid(3)) * 8.0;
        [(170.0 - 90.0 * far - step) as u8; 3]
    };
    pixels.map(tone).collect()
}

/// A comparison: alike in grey, band in blue, tied in green, allowed and announced differences in orange and others in
/// red, depths in violet and colours in yellow, all as squares of three pixels.
pub fn comparison(frame: &Frame, z_max: i64, marks: &[Mark]) -> Vec<u8> {
    let mut picture = grey(frame, z_max);
    for (colour, mark) in picture.iter_mut().zip(marks) {
        match mark {
            Mark::Alike => {}
            Mark::Tied => *colour = TIED,
            _ => *colour = BAND,
        }
    }
    let spots = [
        (Mark::Inside, ALLOWED),
        (Mark::Announced, ALLOWED),
        (Mark::Depth, TOO_DEEP),
        (Mark::Colour, OTHER_COLOUR),
        (Mark::Outside, FORBIDDEN),
    ];
    for (mark, colour) in spots {
        let at = (0..marks.len()).filter(|&i| marks[i] == mark);
        spread(&mut picture, frame, at, colour);
    }
    picture.concat()
}

/// Pixels in one colour, over the picture in grey; `spread_out` makes each a square of three.
pub fn pixels(
    frame: &Frame,
    z_max: i64,
    marked: impl Iterator<Item = usize>,
    colour: Colour,
    spread_out: bool,
) -> Vec<u8> {
    let mut picture = grey(frame, z_max);
    if spread_out {
        spread(&mut picture, frame, marked, colour);
    } else {
        marked.for_each(|index| picture[index] = colour);
    }
    picture.concat()
}

fn spread(
    picture: &mut [Colour],
    frame: &Frame,
    marked: impl Iterator<Item = usize>,
    colour: Colour,
) {
    for index in marked {
        about(index, frame.width, frame.height).for_each(|index| picture[index] = colour);
    }
}
