//! The images that a board shows, and for how long.

use crate::arguments::{self, FrameRange, View};
use crate::command::machine::{frames_of, images_of};
use crate::command::read_scene;
use crate::failure::Result;
use imogene_board::{Board, stays};
use imogene_contract::slots::FittedSlot;
use imogene_golden::machine::zone::beat::{Beat, kind};
use imogene_golden::machine::zone::decode::presence;
use imogene_plan::description::MachineDescription;
use std::collections::HashMap;
use std::iter::repeat_n;
use std::path::Path;

/// Images one after the other, again and again.
pub(super) struct Film {
    /// The words of the first image, and of each other one those that change.
    pub(super) words: Vec<Beat>,
    /// The entries of the tables of its machine.
    pub(super) tables: Vec<u64>,
    /// Red, green, blue of every pixel of each, in the bits that the pins have.
    pub(super) pictures: Vec<Vec<u8>>,
    /// Frames of the screen that show an image.
    pub(super) stay: u64,
    /// Frames of the screen per second.
    pub(super) rate: f64,
    /// What is shown where the words of the first image come too late for the first frame.
    black: Vec<u8>,
}

impl Film {
    /// What a machine shows of a scene.
    pub(super) fn of(
        views: Vec<(View, f64)>,
        options: &arguments::Board,
        board: &Board,
        machine: &MachineDescription,
        rate: u32,
    ) -> Result<Film> {
        let scene = options.scene.as_path();
        let rate = rate.into();
        let (views, seconds): (Vec<View>, Vec<f64>) = views.into_iter().unzip();
        let (stay, counts) = stays(&seconds, rate);
        let repeated = views.into_iter().zip(counts);
        let views = repeated.flat_map(|(view, count)| repeat_n((scene, view), count));
        let views: Vec<(&Path, View)> = views.collect();
        let described = options.machine.as_deref().unwrap_or(scene);
        let images = images_of(&views, machine, described)?;
        let beats = images.iter().map(|image| image.beats.as_slice());
        let pictures = images.iter().map(|image| seen(board, &image.picture));
        Ok(Film {
            black: vec![0; images[0].picture.len()],
            tables: images[0].tables.clone(),
            words: changes(beats, &machine.slots()),
            pictures: pictures.collect(),
            stay,
            rate,
        })
    }

    /// Frames of the screen from the first image to the first again.
    pub(super) fn frames(&self) -> u64 {
        self.pictures.len() as u64 * self.stay
    }

    /// What the frames of the screen show, behind so many black ones.
    pub(super) fn frames_behind(&self, black: usize) -> impl Iterator<Item = &[u8]> {
        let pictures = self.pictures.iter().map(Vec::as_slice);
        let pictures = pictures.flat_map(|picture| repeat_n(picture, self.stay as usize));
        repeat_n(self.black.as_slice(), black).chain(pictures.cycle())
    }
}

/// All words of the first of some images, and of each other one those that the machine does not hold: that an object or
/// a volume is there is not held, and the last word ends the image.
fn changes<'a>(images: impl Iterator<Item = &'a [Beat]>, slots: &[FittedSlot]) -> Vec<Beat> {
    let mut held = HashMap::new();
    let words = images.flatten().filter(|beat| {
        let is_presence = match beat.kind {
            kind::OBJECT => beat.address == presence(slots.get(usize::from(beat.unit))),
            kind::VOLUME => beat.address == presence(None),
            _ => false,
        };
        let place = (beat.kind, beat.unit, beat.address);
        let is_held = held.insert(place, beat.data) == Some(beat.data);
        is_presence || beat.last || !is_held
    });
    words.copied().collect()
}

/// The frames of an animated scene, or the scene as it is written, each for so many seconds.
pub(super) fn views(scene: &Path, range: Option<FrameRange>) -> Result<Vec<(View, f64)>> {
    let as_written = View::default();
    let is_still = range.is_none() && read_scene(scene, &as_written)?.images.is_empty();
    if is_still {
        return Ok(vec![(as_written, 0.0)]);
    }
    frames_of(scene, &as_written, range.unwrap_or_default())
}

/// A picture in the bits that the pins of a board have.
fn seen(board: &Board, picture: &[u8]) -> Vec<u8> {
    let bits = board.video.bits().unwrap_or(8);
    let mask = 0xff << (8 - bits);
    picture.iter().map(|level| level & mask as u8).collect()
}
