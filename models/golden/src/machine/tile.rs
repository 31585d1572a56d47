//! Frames of a tile: one quadric with its cut planes in a window that goes to and fro (`docs/boards.md`).

use crate::format::{FittedError, Format};
use crate::unit::cut_plane::{PlaneKind, cut};
use crate::unit::depth_interval::{Class, FACE_PLANE, Interval, halves};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::plane_depth::saturate;
use crate::unit::quadric_pe::QuadricDepths;
use imogene_contract::tile::{
    FACTOR, LIGHT, LIGHT_FRACTION, LIGHT_LINEAR, PIN_BITS, THRESHOLD, TileWords,
};

/// A tile between two frames.
#[derive(Clone, Debug)]
pub struct Tile<'a> {
    words: &'a TileWords,
    format: Format,
    /// Column and line of the window on the screen.
    pub place: [u64; 2],
    /// The window went towards greater columns, and towards greater lines.
    ahead: [bool; 2],
    /// The depth that the first plane has gained.
    drifted: i64,
}

fn linear([a, b, c]: [i64; 3]) -> Linear {
    Linear::new(a.into(), b.into(), c.into())
}

/// The threshold of a pixel: each pair of pixels, lines and pairs of them is divided as evenly as can be.
fn threshold(x: u64, y: u64) -> u64 {
    let pair = |place: u64| {
        let [x, y] = [x >> place & 1, y >> place & 1];
        (x ^ y) << 1 | y
    };
    pair(0) << 2 | pair(1)
}

impl<'a> Tile<'a> {
    /// A tile after its reset.
    /// Fails when there are no words of its widths.
    pub fn new(words: &'a TileWords) -> Result<Tile<'a>, FittedError> {
        Ok(Tile {
            format: Format::fitted(&words.widths)?,
            words,
            place: words.start,
            ahead: [true; 2],
            drifted: 0,
        })
    }

    /// The next frame: red, green, blue of every pixel in the bits of the pins.
    ///
    /// At an edge of the screen the window turns. Between frames it goes one pixel along the line and one line.
    pub fn frame(&mut self) -> Vec<u8> {
        let TileWords { mode, window, .. } = self.words;
        let screen = [mode.line.active, mode.frame.active];
        for axis in 0..2 {
            let last = screen[axis] - window[axis];
            self.ahead[axis] = match self.place[axis] {
                0 => true,
                place if place == last => false,
                _ => self.ahead[axis],
            };
        }
        let pixels = (0..screen[1]).flat_map(|y| (0..screen[0]).map(move |x| (x, y)));
        let picture = pixels.flat_map(|(x, y)| self.pixel(x, y)).collect();
        for (place, ahead) in self.place.iter_mut().zip(self.ahead) {
            *place = if ahead { *place + 1 } else { *place - 1 };
        }
        let drift = self.words.drift;
        self.drifted += if self.ahead[0] { drift } else { -drift };
        picture
    }

    fn pixel(&self, x: u64, y: u64) -> [u8; 3] {
        let [left, top] = self.place;
        let [width, height] = self.words.window;
        let in_window = (left..left + width).contains(&x) && (top..top + height).contains(&y);
        let light = in_window.then(|| self.light((x - left) as i64, (y - top) as i64));
        let lit = |light| self.words.colour.map(|factor| (light * factor) >> FACTOR);
        let levels = light.flatten().map_or(self.words.background, lit);
        let threshold = threshold(x, y);
        levels.map(|level| ((level + threshold) >> THRESHOLD) as u8 & ((1 << PIN_BITS) - 1))
    }

    /// The light of the face that is seen at a pixel of the window; none where there is none.
    fn light(&self, x: i64, y: i64) -> Option<u64> {
        let (words, format) = (self.words, &self.format);
        let f2 = Quadratic::new(words.f2.map(i128::from));
        let depths = QuadricDepths::at(&linear(words.f1), &f2, x, y, format);
        let (whole, _) = halves(Class::Side, depths.near, depths.far, depths.f2 < 0, format);
        let planes = (FACE_PLANE..).zip(&words.planes);
        let seen = planes.fold(whole, |left: Interval, (number, plane)| {
            let [a, b, c] = plane.depth;
            // The first plane drifts.
            let drifted = i64::from(number == FACE_PLANE) * self.drifted;
            let depth = linear([a, b, c + drifted]).wrapped_at(x, y, format.plane) as i64;
            let kind = match plane.kind {
                1 => PlaneKind::Front,
                2 => PlaneKind::Back,
                _ => PlaneKind::Perpendicular,
            };
            cut(left, kind, saturate(depth, format), number, false, format)
        });
        if !seen.is_present(format) {
            return None;
        }
        let plane = seen.nf.checked_sub(FACE_PLANE).map(usize::from);
        if let Some(plane) = plane.and_then(|plane| words.planes.get(plane)) {
            return Some(plane.light);
        }
        let light = &words.light;
        let still = linear(light.linear).wrapped_at(x, y, LIGHT_LINEAR) >> LIGHT_FRACTION;
        let turned = i128::from(light.factor * depths.root) >> light.shift;
        let most = (1 << LIGHT) - 1;
        Some((still + turned).clamp(light.ambient.into(), most) as u64)
    }
}
