//! The load bus of processors of every kind: the words of an object as addresses and bits
//! ([`imogene_contract::object`]).

use super::load::{Bus, LoadWord};
use super::quadric::QuadricWords;
use super::slot::ProcessorWords;
use crate::format::Format;
use crate::unit::depth_interval::Class;
use imogene_contract::object::Kind;
use imogene_contract::slots::FittedSlot;

/// All words of an object for the slot of its kind, by ascending address; planes and sides that it has not got are
/// written as those that cut nothing. Of a quotient those of one depth alone: others have no slot.
pub fn load_slot(words: &ProcessorWords, format: &Format, slot: &FittedSlot) -> Vec<LoadWord> {
    let mut words = words.clone();
    words.take_planes(slot.planes as usize);
    let mut bus = Bus::sending(format);
    bus.object(&mut words);
    bus.words
}

/// The object whose words a slot holds, one for each address.
pub fn held(words: &[u64], format: &Format, slot: &FittedSlot) -> ProcessorWords {
    let mut object = blank(slot.kind);
    object.take_planes(slot.planes as usize);
    Bus::receiving(format, words).object(&mut object);
    object
}

fn blank(kind: Kind) -> ProcessorWords {
    match kind {
        Kind::Quadric => ProcessorWords::Quadric(Default::default()),
        Kind::Patch => ProcessorWords::Patch(QuadricWords {
            class: Class::Patch,
            ..QuadricWords::default()
        }),
        Kind::Polyhedron => ProcessorWords::Polyhedron(Default::default()),
        Kind::Facet => ProcessorWords::Facet(Default::default()),
        Kind::CurvedFacet => ProcessorWords::CurvedFacet(Default::default()),
        Kind::Sphere => ProcessorWords::Sphere(Default::default()),
        Kind::Cylinder => ProcessorWords::Cylinder(Default::default()),
        Kind::FirstGeneration => ProcessorWords::FirstGeneration(Default::default()),
        Kind::Quotient => ProcessorWords::Quotient(Default::default()),
    }
}

impl ProcessorWords {
    /// Gets planes or sides that cut nothing until there are so many.
    fn take_planes(&mut self, count: usize) {
        fn fill<T: Clone + Default>(list: &mut Vec<T>, count: usize) {
            list.resize(count.max(list.len()), T::default());
        }
        match self {
            Self::Quadric(words) | Self::Patch(words) => fill(&mut words.planes, count),
            Self::Member(words) => fill(&mut words.own_mut().planes, count),
            Self::Polyhedron(words) => fill(&mut words.planes, count),
            Self::Quotient(words) => fill(&mut words.planes, count),
            Self::Facet(words) => fill(&mut words.edges, count),
            Self::CurvedFacet(words) => fill(&mut words.sides, count),
            Self::Sphere(_) | Self::Cylinder(_) | Self::FirstGeneration(_) => {}
        }
    }
}

impl Bus<'_> {
    fn object(&mut self, words: &mut ProcessorWords) {
        match words {
            ProcessorWords::Quadric(words) => self.quadric(words),
            ProcessorWords::Member(words) => self.quadric(words.own_mut()),
            // The class and the normals of planes are not among the words.
            ProcessorWords::Patch(words) => {
                self.window(&mut words.screen_box);
                self.depths(&mut words.f1, &mut words.f2);
                self.normal(&mut words.normal);
                for plane in &mut words.planes {
                    self.plane(&mut plane.kind, &mut plane.depth);
                }
            }
            ProcessorWords::FirstGeneration(words) => {
                self.window(&mut words.screen_box);
                self.depths(&mut words.f1, &mut words.f2);
                self.normal(&mut words.normal);
                self.flag(&mut words.patch);
                let [front, back] = [&mut words.front, &mut words.back];
                self.planes_of([&mut front.depth, &mut back.depth]);
                self.conics([&mut front.conic, &mut back.conic]);
                self.planes_of([&mut front.polar, &mut back.polar]);
                self.vector(&mut front.normal);
            }
            ProcessorWords::Polyhedron(words) => {
                self.window(&mut words.screen_box);
                self.planes(&mut words.planes);
            }
            ProcessorWords::Facet(words) => {
                self.window(&mut words.screen_box);
                self.planes_of(words.edges.iter_mut().chain([&mut words.depth]));
                self.gradients(&mut words.normal);
            }
            ProcessorWords::CurvedFacet(words) => {
                self.window(&mut words.screen_box);
                let sides = words.sides.iter_mut();
                self.conics(sides.chain([&mut words.depth]).chain(&mut words.normal));
            }
            ProcessorWords::Sphere(words) => {
                self.window(&mut words.screen_box);
                self.conics([&mut words.contour, &mut words.front]);
                words.sum = self.number(words.sum.into(), self.format.sum) as i64;
                self.gradients(&mut words.normal);
                self.conics([&mut words.normal_z]);
            }
            ProcessorWords::Cylinder(words) => {
                self.window(&mut words.screen_box);
                self.planes_of(&mut words.sides);
                let discs = words.discs.iter_mut();
                self.conics(discs.chain([&mut words.body]).chain(&mut words.normal));
                self.planes_of([&mut words.disc]);
                self.vector(&mut words.disc_normal);
            }
            ProcessorWords::Quotient(words) => {
                self.window(&mut words.screen_box);
                let widths = words.widths(self.format);
                self.quadratic(&mut words.numerator, widths.numerator);
                self.linear(&mut words.denominator, widths.denominator);
                self.normal(&mut words.normal);
                self.flag(&mut words.solid);
                words.normal_from = self.number(words.normal_from.into(), self.format.depth) as i64;
                self.planes(&mut words.planes);
            }
        }
    }
}
