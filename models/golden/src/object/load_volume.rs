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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::object::quadric::ScreenBox;
    use crate::object::volume::VolumeKind;
    use crate::unit::cut_plane::PlaneKind;
    use crate::unit::depth_interval::Class;
    use crate::unit::pe1::Linear;

    #[test]
    fn words_stand_at_their_addresses() {
        let words = VolumeWords {
            kind: VolumeKind::Light,
            source: 5,
            screen_box: ScreenBox::of([1, 6], [2, 4]),
            margin: 77,
            quadric: Some(VolumeQuadric {
                class: Class::Front,
                f1: Linear::new(-1, 0, 9),
                shift: 8,
                ..VolumeQuadric::EVERYWHERE
            }),
            planes: vec![VolumePlane {
                kind: PlaneKind::Back,
                depth: Linear::new(3, -1, 4),
            }],
        };
        let list = load_volume(&words, &Format::BASE, 2);
        assert_eq!(list.len(), usize::from(FIRST_PLANE + 2 * PLANE_WORDS));
        assert!(
            list.iter()
                .enumerate()
                .all(|(i, w)| usize::from(w.address) == i)
        );
        let bits: Vec<u64> = list.iter().map(|w| w.bits).collect();
        assert_eq!(bits[..3], [(1 << 26) - 1, 0, 9]);
        assert_eq!(
            bits[9..13],
            [1 | 6 << 12, 2 | 4 << 12, 1 | 8 << 2 | 1 << 6 | 5 << 7, 77]
        );
        assert_eq!(bits[13..], [2, 3, (1 << 36) - 1, 4, 0, 0, 0, 0]);

        let planes_alone = VolumeWords {
            quadric: None,
            kind: VolumeKind::Shadow,
            ..words
        };
        let list = load_volume(&planes_alone, &Format::BASE, 2);
        assert!(list[..9].iter().all(|word| word.bits == 0));
        assert_eq!(list[11].bits, 3 | 5 << 7);
    }
}
