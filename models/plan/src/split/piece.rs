//! One piece of the screen, drawn by itself.

use super::division::Piece;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::ALL_SOURCES;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::volume::{VolumeKind, VolumeWords};
use imogene_golden::object::words::{Object, Words};
use imogene_prepare::PreparedScene;
use serde::Serialize;

/// Work of a piece, of a worker, or of a whole picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Work {
    /// Processors that are loaded: each counts once for each piece that its object's screen box touches.
    pub loads: u64,
    /// Pixels that object processors visit: those of the boxes.
    pub object_pixels: u64,
    /// Volumes that are loaded.
    pub volume_loads: u64,
    /// Pixels that volume processors visit.
    pub volume_pixels: u64,
}

impl Work {
    /// Pixels that are visited.
    pub fn pixels(&self) -> u64 {
        self.object_pixels + self.volume_pixels
    }
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Work) {
        self.loads += other.loads;
        self.object_pixels += other.object_pixels;
        self.volume_loads += other.volume_loads;
        self.volume_pixels += other.volume_pixels;
    }
}

/// What a worker knows of a piece when it is done.
pub(super) struct DrawnPiece {
    piece: Piece,
    frame: Frame,
    flags: Vec<u16>,
    pub work: Work,
}

impl DrawnPiece {
    pub(super) fn draw(
        piece: Piece,
        slots: &[Slot],
        volumes: &[&VolumeWords],
        scene: &PreparedScene,
    ) -> DrawnPiece {
        let (width, height) = (piece.width as usize, piece.height as usize);
        let mut drawn = DrawnPiece {
            piece,
            frame: Frame::background(width, height, scene.format.z_max()),
            flags: vec![ALL_SOURCES; width * height],
            work: Work::default(),
        };
        // In order, so that a strict comparison leaves ties with the first one.
        for slot in slots {
            if !piece.part_of(slot.words.screen_box()).is_empty() {
                drawn.draw_object(slot.object, &piece.words(&slot.words), &scene.format);
            }
        }
        for words in volumes {
            drawn.apply_volume(words, &scene.format);
        }
        drawn
    }

    fn draw_object(&mut self, object: usize, words: &ProcessorWords, format: &Format) {
        let window = *words.screen_box();
        let frame = &mut self.frame;
        for y in window.y0..=window.y1 {
            for x in window.x0..=window.x1 {
                let pixel = words.at(x, y, format);
                let at = y as usize * frame.width + x as usize;
                if pixel.zf < frame.depth[at] {
                    frame.depth[at] = pixel.zf;
                    frame.id[at] = object as i32;
                    frame.number[at] = pixel.number;
                    frame.normal[at] = pixel.normal;
                }
            }
        }
        self.work.loads += 1;
        self.work.object_pixels += window.pixels();
    }

    fn apply_volume(&mut self, words: &VolumeWords, format: &Format) {
        let window = self.piece.part_of(&words.screen_box);
        let inside = self.inside(words, window, format);
        // Outside of a light is dark, also outside its box.
        if words.kind == VolumeKind::Light {
            for (at, flags) in self.flags.iter_mut().enumerate() {
                let (x, y) = (at % self.frame.width, at / self.frame.width);
                if !window.contains(x as i64, y as i64) {
                    *flags = words.after(*flags, false);
                }
            }
        }
        for (at, inside) in inside {
            self.flags[at] = words.after(self.flags[at], inside);
        }
    }

    /// The pixels of the volume's box, and whether the visible point there is inside.
    fn inside(
        &mut self,
        words: &VolumeWords,
        window: ScreenBox,
        format: &Format,
    ) -> Vec<(usize, bool)> {
        if window.is_empty() {
            return vec![];
        }
        let own = self.piece.words(words);
        let mut found = Vec::with_capacity(window.pixels() as usize);
        for y in window.y0..=window.y1 {
            for x in window.x0..=window.x1 {
                let at = y as usize * self.frame.width + x as usize;
                found.push((at, own.holds(x, y, self.frame.depth[at], format)));
            }
        }
        self.work.volume_loads += 1;
        self.work.volume_pixels += window.pixels();
        found
    }

    /// Copies the piece to its place on the screen.
    pub(super) fn put_into(&self, screen: &mut Frame, flags: &mut [u16]) {
        let width = self.frame.width;
        for y in 0..self.frame.height {
            let from = y * width..(y + 1) * width;
            let first = self.piece.place(0, y, screen.width);
            let to = first..first + width;
            screen.depth[to.clone()].copy_from_slice(&self.frame.depth[from.clone()]);
            screen.id[to.clone()].copy_from_slice(&self.frame.id[from.clone()]);
            screen.number[to.clone()].copy_from_slice(&self.frame.number[from.clone()]);
            screen.normal[to.clone()].copy_from_slice(&self.frame.normal[from.clone()]);
            flags[to].copy_from_slice(&self.flags[from]);
        }
    }
}
