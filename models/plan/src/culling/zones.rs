//! The zones that each object of a scene touches: by its screen box, by bounds, and in truth.

use super::part::{Matter, is_drawn, matter};
use crate::split::{Division, Piece};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{MAX_PLANES, QuadricWords, ScreenBox};
use imogene_golden::object::slot::{ProcessorWords, Slot};
use rayon::prelude::*;
use serde::Serialize;
use std::borrow::Cow;
use std::ops::AddAssign;

/// Loads of processors for zones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Touches {
    /// By the screen box.
    pub boxes: u64,
    /// Those that bounds cannot exclude.
    pub bounds: u64,
    /// Those in which a pixel is drawn.
    pub pixels: u64,
}

impl AddAssign for Touches {
    fn add_assign(&mut self, other: Touches) {
        self.boxes += other.boxes;
        self.bounds += other.bounds;
        self.pixels += other.pixels;
    }
}

/// Which objects each zone of a screen has.
#[derive(Clone, Debug)]
pub struct ZoneTouches {
    /// Of each object of the scene.
    pub objects: Vec<Touches>,
    /// Of each zone, line of zones by line of zones.
    pub zones: Vec<Touches>,
    /// The zones.
    pub pieces: Vec<Piece>,
}

impl ZoneTouches {
    /// Of these processors on a screen with square zones of `side` pixels, at least 1.
    pub fn of(
        slots: &[Slot],
        objects: usize,
        format: &Format,
        (width, height): (u32, u32),
        side: u32,
    ) -> ZoneTouches {
        let division = Division::Zones {
            width: side,
            height: side,
        };
        let pieces = division.pieces(width, height);
        let found = slots.par_iter();
        let found = found.map(|slot| touched(&slot.words, format, &pieces));
        let found: Vec<Vec<(usize, Touches)>> = found.collect();
        let mut touches = ZoneTouches {
            objects: vec![Touches::default(); objects],
            zones: vec![Touches::default(); pieces.len()],
            pieces,
        };
        for (slot, found) in slots.iter().zip(found) {
            for (zone, one) in found {
                touches.objects[slot.object] += one;
                touches.zones[zone] += one;
            }
        }
        touches
    }
}

fn touched(words: &ProcessorWords, format: &Format, pieces: &[Piece]) -> Vec<(usize, Touches)> {
    // As a quadric object it has bounds, if there is an equal one.
    let quadric = match words {
        ProcessorWords::Quadric(words) | ProcessorWords::Patch(words) => Some(Cow::Borrowed(words)),
        other => {
            let words = other.on_quadric_processor(format, MAX_PLANES);
            words.ok().map(Cow::Owned)
        }
    };
    let mut found = vec![];
    for (index, piece) in pieces.iter().enumerate() {
        let window = words.screen_box().shared(&window_of(piece));
        if window.is_empty() {
            continue;
        }
        let excluded = quadric.as_ref().is_some_and(|words: &Cow<QuadricWords>| {
            matter(words, &window, format) == Matter::Nothing
        });
        let drawn = !excluded && is_drawn(&piece.words(words), format);
        let touches = Touches {
            boxes: 1,
            bounds: u64::from(!excluded),
            pixels: u64::from(drawn),
        };
        found.push((index, touches));
    }
    found
}

/// The pixels of a zone on the screen.
pub fn window_of(piece: &Piece) -> ScreenBox {
    let [x0, y0, width, height] = [piece.x0, piece.y0, piece.width, piece.height].map(i64::from);
    ScreenBox::of([x0, x0 + width - 1], [y0, y0 + height - 1])
}

/// A picture of zones, each in a colour for its count: black for none, then from blue over green and yellow to red for
/// `most` and more.
pub fn map(pieces: &[Piece], counts: &[u64], most: u64, (width, height): (u32, u32)) -> Vec<u8> {
    let mut rgb = vec![0; 3 * width as usize * height as usize];
    for (piece, &count) in pieces.iter().zip(counts) {
        let colour = heat(count, most);
        for y in 0..piece.height as usize {
            for x in 0..piece.width as usize {
                // A dark line between zones.
                let inner = x + 1 < piece.width as usize && y + 1 < piece.height as usize;
                let at = 3 * piece.place(x, y, width as usize);
                rgb[at..at + 3].copy_from_slice(&if inner { colour } else { [24; 3] });
            }
        }
    }
    rgb
}

fn heat(count: u64, most: u64) -> [u8; 3] {
    const STOPS: [[f64; 3]; 5] = [
        [40.0, 60.0, 160.0],
        [40.0, 150.0, 190.0],
        [80.0, 190.0, 80.0],
        [240.0, 210.0, 60.0],
        [220.0, 50.0, 40.0],
    ];
    if count == 0 {
        return [0; 3];
    }
    let along = (count.min(most) as f64 / most.max(1) as f64) * (STOPS.len() - 1) as f64;
    let stop = (along as usize).min(STOPS.len() - 2);
    let part = along - stop as f64;
    std::array::from_fn(|k| (STOPS[stop][k] * (1.0 - part) + STOPS[stop + 1][k] * part) as u8)
}

/// Two pictures of the same height beside each other, with a light bar of `gap` pixels between them.
pub fn beside(
    left: &[u8],
    right: &[u8],
    (width, height): (usize, usize),
    gap: usize,
) -> (usize, Vec<u8>) {
    let total = 2 * width + gap;
    let mut rgb = Vec::with_capacity(3 * total * height);
    for (left, right) in left.chunks(3 * width).zip(right.chunks(3 * width)) {
        rgb.extend_from_slice(left);
        rgb.extend(std::iter::repeat_n(255, 3 * gap));
        rgb.extend_from_slice(right);
    }
    (total, rgb)
}
