//! The load bus of a volume processor with a quadric: a volume's coefficient words as addresses and bits
//! (`docs/zone-machine.md`).

use super::load::{KIND_WIDTH, List, LoadWord};
use super::volume::{VolumePlane, VolumeQuadric, VolumeWords};
use crate::format::Format;
use imogene_contract::volume;

/// Address of the first word of plane 0.
pub const FIRST_PLANE: u8 = volume::PLANES as u8;
/// Words of one plane.
pub const PLANE_WORDS: u8 = volume::PLANE_WORDS as u8;
/// Address of the columns of the screen box.
pub const BOX_COLUMNS: u8 = volume::BOX_COLUMNS as u8;
/// Address of the control word.
pub const CONTROL: u8 = volume::CONTROL as u8;
/// Width of the control word: class, shift, kind, source.
pub const CONTROL_WIDTH: u32 = 11;

/// All words of a volume for one zone, by ascending address; absent planes up to `planes` are written as kind none. A
/// volume of planes alone gets a quadric that is everywhere.
pub fn load_volume(words: &VolumeWords, format: &Format, planes: usize) -> Vec<LoadWord> {
    let quadric = words.quadric.unwrap_or(VolumeQuadric::EVERYWHERE);
    let mut list = List(Vec::new());
    list.linear(&quadric.f1, format.pe1_width());
    list.quadratic(&quadric.f2, format.pe2_width());
    list.window(&words.screen_box);
    let control = quadric.class as i128
        | i128::from(quadric.shift) << 2
        | (words.kind as i128) << 6
        | i128::from(words.source) << 7;
    list.push(control, CONTROL_WIDTH);
    list.push(words.margin.into(), format.depth);
    let none = VolumePlane::default();
    for index in 0..planes {
        let plane = words.planes.get(index).unwrap_or(&none);
        list.push(plane.kind as i128, KIND_WIDTH);
        list.linear(&plane.depth, format.plane);
    }
    list.0
}
