//! Coefficient registers as a processor holds them, and what their bits mean.

use super::beat::{ID_ADDRESS, OBJECT_PLANES, VOLUME_PLANES};
use crate::format::{Format, wrap};
use crate::object::load;
use crate::object::load_volume;
use crate::object::quadric::{PlaneWords, QuadricWords, ScreenBox};
use crate::object::volume::{VolumeKind, VolumePlane, VolumeQuadric, VolumeWords};
use crate::unit::cut_plane::PlaneKind;
use crate::unit::depth_interval::Class;
use crate::unit::normal::NormalWords;
use crate::unit::pe1::Linear;
use crate::unit::pe2::{PreconditionedWords, Quadratic};

/// Words of one processor; they hold until written again.
#[derive(Clone, Debug)]
pub struct Registers {
    words: Vec<u64>,
    id: u64,
    control: u16,
    has_id: bool,
    /// The control word was written since the last pass that took it.
    present: bool,
}

impl Registers {
    /// Of an object processor.
    pub fn of_object(planes: usize) -> Registers {
        Registers::new(OBJECT_PLANES, planes, load::CONTROL, true)
    }

    /// Of a volume processor.
    pub fn of_volume(planes: usize) -> Registers {
        Registers::new(VOLUME_PLANES, planes, load_volume::CONTROL, false)
    }

    fn new([first, each]: [u8; 2], planes: usize, control: u8, has_id: bool) -> Registers {
        Registers {
            words: vec![0; usize::from(first) + usize::from(each) * planes],
            id: 0,
            control: control.into(),
            has_id,
            present: false,
        }
    }

    /// Writes a word; false if there is none at this address.
    pub fn write(&mut self, address: u16, data: u64) -> bool {
        if self.has_id && address == ID_ADDRESS {
            self.id = data & ((1 << super::ID_BITS) - 1);
            return true;
        }
        let Some(word) = self.words.get_mut(usize::from(address)) else {
            return false;
        };
        *word = data;
        self.present |= address == self.control;
        true
    }

    /// Was the control word written since this was asked last?
    pub fn take(&mut self) -> bool {
        std::mem::take(&mut self.present)
    }

    /// Id of the object.
    pub fn id(&self) -> u16 {
        self.id as u16
    }

    /// The object.
    pub fn object(&self, format: &Format) -> QuadricWords {
        let [first, each] = OBJECT_PLANES.map(usize::from);
        let planes = self.words[first..].chunks(each).map(|words| PlaneWords {
            kind: plane_kind(words[0]),
            depth: linear(&words[1..4], format.plane),
            normal: vector(&words[4..7], format),
        });
        let control = self.words[usize::from(load::CONTROL)];
        QuadricWords {
            class: class(control),
            screen_box: window(&self.words[21..23]),
            f1: linear(&self.words[0..3], format.pe1_width()),
            f2: quadratic(&self.words[3..9], format.pe2_width()),
            normal: NormalWords {
                g: [9, 12, 15].map(|at| linear(&self.words[at..at + 3], format.normal_linear)),
                k: vector(&self.words[18..21], format),
                shift: (control >> 2 & 31) as u8,
            },
            planes: planes.collect(),
        }
    }

    /// The volume.
    pub fn volume(&self, format: &Format) -> VolumeWords {
        let [first, each] = VOLUME_PLANES.map(usize::from);
        let planes = self.words[first..].chunks(each).map(|words| VolumePlane {
            kind: plane_kind(words[0]),
            depth: linear(&words[1..4], format.plane),
        });
        let control = self.words[usize::from(load_volume::CONTROL)];
        VolumeWords {
            kind: if control >> 6 & 1 == 1 {
                VolumeKind::Light
            } else {
                VolumeKind::Shadow
            },
            source: (control >> 7 & 15) as u8,
            screen_box: window(&self.words[9..11]),
            margin: (self.words[12] & ((1 << format.depth) - 1)) as u32,
            quadric: Some(VolumeQuadric {
                class: class(control),
                f1: linear(&self.words[0..3], format.pe1_width()),
                f2: quadratic(&self.words[3..9], format.pe2_width()),
                shift: (control >> 2 & 15) as u8,
            }),
            planes: planes.collect(),
        }
    }
}

fn signed(word: u64, width: u32) -> i128 {
    wrap(word.into(), width)
}

fn vector(words: &[u64], format: &Format) -> [i16; 3] {
    [0, 1, 2].map(|k| signed(words[k], format.normal) as i16)
}

fn linear(words: &[u64], width: u32) -> Linear {
    let [a, b, c] = [0, 1, 2].map(|k| signed(words[k], width));
    Linear::new(a, b, c)
}

fn quadratic(words: &[u64], width: u32) -> Quadratic {
    let word = |index: usize| signed(words[index], width);
    Quadratic::of_preconditioned(&PreconditionedWords {
        a2: word(0),
        b2: word(1),
        c: word(2),
        i0: word(3),
        p0: word(4),
        f: word(5),
    })
}

fn window(words: &[u64]) -> ScreenBox {
    let [x, y] = [words[0], words[1]];
    let side = |word: u64, from: u32| (word >> from & 0xfff) as i64;
    ScreenBox::of([side(x, 0), side(x, 12)], [side(y, 0), side(y, 12)])
}

fn class(word: u64) -> Class {
    Class::ALL[(word & 3) as usize]
}

fn plane_kind(word: u64) -> PlaneKind {
    PlaneKind::ALL[(word & 3) as usize]
}
