//! Coefficient registers as a processor holds them, and what their bits mean.

use super::beat::ID_ADDRESS;
use crate::format::{Format, wrap};
use crate::object::curved_facet::CurvedFacetWords;
use crate::object::cylinder::CylinderWords;
use crate::object::facet::FacetWords;
use crate::object::first_generation::{ContourPlane, FirstGenerationWords};
use crate::object::load_volume;
use crate::object::polyhedron::PolyhedronWords;
use crate::object::quadric::{PlaneWords, QuadricWords, ScreenBox};
use crate::object::quotient::{self, QuotientWords};
use crate::object::slot::ProcessorWords;
use crate::object::sphere::SphereWords;
use crate::object::volume::{VolumeKind, VolumePlane, VolumeQuadric, VolumeWords};
use crate::unit::cut_plane::PlaneKind;
use crate::unit::depth_interval::Class;
use crate::unit::normal::NormalWords;
use crate::unit::pe1::Linear;
use crate::unit::pe2::{PreconditionedWords, Quadratic};
use imogene_contract::object::Kind;
use imogene_contract::slots::FittedSlot;
use imogene_contract::volume;
use std::array;

/// Words of one processor; they hold until written again.
#[derive(Clone, Debug)]
pub struct Registers {
    /// The slot of an object processor; a volume processor has none.
    slot: Option<FittedSlot>,
    words: Vec<u64>,
    id: u64,
    /// The word that says that there is an object or a volume was written since the last pass that took it.
    present: bool,
}

impl Registers {
    /// Of an object processor.
    pub fn of_object(slot: &FittedSlot) -> Registers {
        Registers::new(Some(*slot), slot.kind.words(slot.planes as usize))
    }

    /// Of a volume processor.
    pub fn of_volume(planes: usize) -> Registers {
        Registers::new(None, volume::words(planes))
    }

    fn new(slot: Option<FittedSlot>, words: usize) -> Registers {
        Registers {
            slot,
            words: vec![0; words],
            id: 0,
            present: false,
        }
    }

    /// Writes a word; false if there is none at this address.
    pub fn write(&mut self, address: u16, data: u64) -> bool {
        if self.slot.is_some() && address == ID_ADDRESS {
            self.id = data & ((1 << super::ID_BITS) - 1);
            return true;
        }
        let Some(word) = self.words.get_mut(usize::from(address)) else {
            return false;
        };
        *word = data;
        let tells = match &self.slot {
            Some(slot) => slot.kind.presence() as u16,
            None => load_volume::CONTROL.into(),
        };
        self.present |= address == tells;
        true
    }

    /// Was there an object or a volume since this was asked last?
    pub fn take(&mut self) -> bool {
        std::mem::take(&mut self.present)
    }

    /// Id of the object.
    pub fn id(&self) -> u16 {
        self.id as u16
    }

    fn reader<'a>(&'a self, format: &'a Format) -> Reader<'a> {
        Reader {
            words: self.words.iter(),
            format,
        }
    }

    /// The object.
    ///
    /// # Panics
    ///
    /// When it is a volume processor.
    pub fn object(&self, format: &Format) -> ProcessorWords {
        let slot = self.slot.expect("the slot of an object");
        self.reader(format).object(&slot)
    }

    /// The volume.
    pub fn volume(&self, format: &Format) -> VolumeWords {
        self.reader(format).volume()
    }
}

/// The words of a processor, by ascending address.
struct Reader<'a> {
    words: std::slice::Iter<'a, u64>,
    format: &'a Format,
}

impl Reader<'_> {
    fn object(mut self, slot: &FittedSlot) -> ProcessorWords {
        let planes = slot.planes as usize;
        match slot.kind {
            Kind::Quadric => ProcessorWords::Quadric(self.quadric(planes)),
            Kind::Patch => ProcessorWords::Patch(self.patch(planes)),
            Kind::Polyhedron => ProcessorWords::Polyhedron(PolyhedronWords {
                screen_box: self.screen_box(),
                planes: self.planes(planes),
            }),
            Kind::Facet => ProcessorWords::Facet(FacetWords {
                screen_box: self.screen_box(),
                edges: self.many(planes, Self::plane),
                depth: self.plane(),
                normal: array::from_fn(|_| self.linear(self.format.normal_linear)),
            }),
            Kind::CurvedFacet => ProcessorWords::CurvedFacet(CurvedFacetWords {
                screen_box: self.screen_box(),
                sides: self.many(planes, Self::conic),
                depth: self.conic(),
                normal: array::from_fn(|_| self.conic()),
            }),
            Kind::Sphere => ProcessorWords::Sphere(SphereWords {
                screen_box: self.screen_box(),
                contour: self.conic(),
                front: self.conic(),
                sum: self.number(self.format.sum) as i64,
                normal: array::from_fn(|_| self.linear(self.format.normal_linear)),
                normal_z: self.conic(),
            }),
            Kind::Cylinder => ProcessorWords::Cylinder(CylinderWords {
                screen_box: self.screen_box(),
                sides: array::from_fn(|_| self.plane()),
                discs: array::from_fn(|_| self.conic()),
                body: self.conic(),
                normal: array::from_fn(|_| self.conic()),
                disc: self.plane(),
                disc_normal: self.vector(),
            }),
            Kind::FirstGeneration => ProcessorWords::FirstGeneration(self.first_generation()),
            Kind::Quotient => ProcessorWords::Quotient(self.quotient(planes)),
        }
    }

    fn quadric(&mut self, planes: usize) -> QuadricWords {
        let f1 = self.linear(self.format.pe1_width());
        let f2 = self.quadratic(self.format.pe2_width());
        let g = array::from_fn(|_| self.linear(self.format.normal_linear));
        let k = self.vector();
        let screen_box = self.screen_box();
        let control = self.bits(7);
        QuadricWords {
            class: class(control),
            screen_box,
            f1,
            f2,
            normal: NormalWords {
                g,
                k,
                shift: (control >> 2) as u8,
            },
            planes: self.planes(planes),
        }
    }

    /// The class and the normals of planes are not among the words.
    fn patch(&mut self, planes: usize) -> QuadricWords {
        let (screen_box, f1, f2, normal) = self.surface();
        let plane = |reader: &mut Self| PlaneWords {
            kind: reader.plane_kind(),
            depth: reader.plane(),
            ..PlaneWords::default()
        };
        QuadricWords {
            class: Class::Patch,
            screen_box,
            f1,
            f2,
            normal,
            planes: self.many(planes, plane),
        }
    }

    fn first_generation(&mut self) -> FirstGenerationWords {
        let (screen_box, f1, f2, normal) = self.surface();
        let patch = self.bits(1) == 1;
        let depths: [Linear; 2] = array::from_fn(|_| self.plane());
        let conics: [Quadratic; 2] = array::from_fn(|_| self.conic());
        let polars: [Linear; 2] = array::from_fn(|_| self.plane());
        let plane = |index: usize, normal| ContourPlane {
            depth: depths[index],
            conic: conics[index],
            polar: polars[index],
            normal,
        };
        FirstGenerationWords {
            patch,
            screen_box,
            f1,
            f2,
            normal,
            front: plane(0, self.vector()),
            back: plane(1, [0; 3]),
        }
    }

    /// One of one depth.
    fn quotient(&mut self, planes: usize) -> QuotientWords {
        let widths = quotient::widths(self.format, false);
        QuotientWords {
            screen_box: self.screen_box(),
            numerator: self.quadratic(widths.numerator),
            denominator: self.linear(widths.denominator),
            root: None,
            normal: self.normal(),
            solid: self.bits(1) == 1,
            normal_from: self.number(self.format.depth) as i64,
            planes: self.planes(planes),
        }
    }

    fn volume(mut self) -> VolumeWords {
        let f1 = self.linear(self.format.pe1_width());
        let f2 = self.quadratic(self.format.pe2_width());
        let screen_box = self.screen_box();
        let control = self.bits(load_volume::CONTROL_WIDTH);
        let margin = self.bits(self.format.depth) as u32;
        let planes = self.words.len() / volume::PLANE_WORDS as usize;
        let plane = |reader: &mut Self| VolumePlane {
            kind: reader.plane_kind(),
            depth: reader.plane(),
        };
        VolumeWords {
            kind: match control >> 6 & 1 {
                1 => VolumeKind::Light,
                _ => VolumeKind::Shadow,
            },
            source: (control >> 7) as u8,
            screen_box,
            margin,
            quadric: Some(VolumeQuadric {
                class: class(control),
                f1,
                f2,
                shift: (control >> 2 & 15) as u8,
            }),
            planes: self.many(planes, plane),
        }
    }

    /// Screen box, f1, f2 and normal of kinds that have a quadric.
    fn surface(&mut self) -> (ScreenBox, Linear, Quadratic, NormalWords) {
        let screen_box = self.screen_box();
        let f1 = self.linear(self.format.pe1_width());
        let f2 = self.quadratic(self.format.pe2_width());
        (screen_box, f1, f2, self.normal())
    }

    /// The normal of kinds that have its shift behind it.
    fn normal(&mut self) -> NormalWords {
        NormalWords {
            g: array::from_fn(|_| self.linear(self.format.normal_linear)),
            k: self.vector(),
            shift: self.bits(5) as u8,
        }
    }

    /// Planes with their normals.
    fn planes(&mut self, count: usize) -> Vec<PlaneWords> {
        self.many(count, |reader| PlaneWords {
            kind: reader.plane_kind(),
            depth: reader.plane(),
            normal: reader.vector(),
        })
    }

    fn many<T>(&mut self, count: usize, mut one: impl FnMut(&mut Self) -> T) -> Vec<T> {
        (0..count).map(|_| one(self)).collect()
    }

    fn screen_box(&mut self) -> ScreenBox {
        let [x, y] = array::from_fn(|_| self.bits(Format::BOX_WORD));
        let side = |word: u64, from: u32| (word >> from & 0xfff) as i64;
        ScreenBox::of([side(x, 0), side(x, 12)], [side(y, 0), side(y, 12)])
    }

    fn plane_kind(&mut self) -> PlaneKind {
        PlaneKind::ALL[self.bits(2) as usize]
    }

    /// A word of a plane or side of first degree.
    fn plane(&mut self) -> Linear {
        self.linear(self.format.plane)
    }

    /// An expression of second degree without guard bits.
    fn conic(&mut self) -> Quadratic {
        self.quadratic(self.format.quadratic)
    }

    fn vector(&mut self) -> [i16; 3] {
        array::from_fn(|_| self.number(self.format.normal) as i16)
    }

    fn linear(&mut self, width: u32) -> Linear {
        let [a, b, c] = array::from_fn(|_| self.number(width));
        Linear::new(a, b, c)
    }

    fn quadratic(&mut self, width: u32) -> Quadratic {
        let [a2, b2, c, i0, p0, f] = array::from_fn(|_| self.number(width));
        Quadratic::of_preconditioned(&PreconditionedWords {
            a2,
            b2,
            c,
            i0,
            p0,
            f,
        })
    }

    fn number(&mut self, width: u32) -> i128 {
        wrap(self.word().into(), width)
    }

    fn bits(&mut self, width: u32) -> u64 {
        self.word() & (u64::MAX >> (64 - width))
    }

    fn word(&mut self) -> u64 {
        *self.words.next().expect("a word for each address")
    }
}

fn class(control: u64) -> Class {
    Class::ALL[(control & 3) as usize]
}
