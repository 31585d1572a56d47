//! One piece of the screen, drawn by itself.

use super::division::Piece;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::ALL_SOURCES;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::volume::{VolumeKind, VolumeWords};
use imogene_golden::object::words::Object;
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
        for (x, y) in window.each() {
            let pixel = words.at(x, y, format);
            let at = y as usize * frame.width + x as usize;
            if pixel.zf < frame.depth[at] {
                frame.depth[at] = pixel.zf;
                frame.id[at] = object as i32;
                frame.number[at] = pixel.number;
                frame.normal[at] = pixel.normal;
            }
        }
        self.work.loads += 1;
        self.work.object_pixels += window.pixels();
    }

    fn apply_volume(&mut self, words: &VolumeWords, format: &Format) {
        let own = self.piece.words(words);
        let window = own.screen_box;
        let told = match words.kind {
            VolumeKind::Shadow => window,
            // Outside of a light is dark, also outside its box.
            VolumeKind::Light => ScreenBox::of_screen(self.piece.width, self.piece.height),
        };
        for (x, y) in told.each() {
            let at = y as usize * self.frame.width + x as usize;
            let is_inside = window.contains(x, y) && own.holds(x, y, self.frame.depth[at], format);
            self.flags[at] = words.after(self.flags[at], is_inside);
        }
        self.work.volume_loads += u64::from(!window.is_empty());
        self.work.volume_pixels += window.pixels();
    }

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
