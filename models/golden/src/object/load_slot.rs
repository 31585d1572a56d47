//! The load bus of processors of every kind: the words of an object as addresses and bits
//! ([`imogene_contract::object`]).

use super::first_generation::FirstGenerationWords;
use super::load::{KIND_WIDTH, List, LoadWord, load_words};
use super::quadric::PlaneWords;
use super::slot::ProcessorWords;
use crate::format::Format;
use crate::unit::normal::NormalWords;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use imogene_contract::slots::FittedSlot;

/// Bits of the shift of a root.
const SHIFT: u32 = 5;

/// All words of an object for the slot of its kind, by ascending address; planes and sides that it has not got are
/// written as those that cut nothing. Of a quotient those of one depth alone: others have no slot.
pub fn load_slot(words: &ProcessorWords, format: &Format, slot: &FittedSlot) -> Vec<LoadWord> {
    let count = slot.planes as usize;
    let mut list = List(Vec::new());
    match words {
        ProcessorWords::Quadric(words) => return load_words(words, format, count),
        ProcessorWords::Member(words) => return load_words(words.own(), format, count),
        ProcessorWords::Patch(words) => {
            list.window(&words.screen_box);
            list.quadric(&words.f1, &words.f2, &words.normal, format);
            for plane in padded(&words.planes, count) {
                list.push(plane.kind as i128, KIND_WIDTH);
                list.linear(&plane.depth, format.plane);
            }
        }
        ProcessorWords::FirstGeneration(words) => list.first_generation(words, format),
        ProcessorWords::Polyhedron(words) => {
            list.window(&words.screen_box);
            list.planes(&words.planes, count, format);
        }
        ProcessorWords::Facet(words) => {
            list.window(&words.screen_box);
            let sides: Vec<Linear> = padded(&words.edges, count);
            sides
                .iter()
                .for_each(|side| list.linear(side, format.plane));
            list.linear(&words.depth, format.plane);
            let normal = words.normal.iter();
            normal.for_each(|n| list.linear(n, format.normal_linear));
        }
        ProcessorWords::CurvedFacet(words) => {
            list.window(&words.screen_box);
            let sides: Vec<Quadratic> = padded(&words.sides, count);
            let all = sides.iter().chain([&words.depth]).chain(&words.normal);
            all.for_each(|word| list.quadratic(word, format.quadratic));
        }
        ProcessorWords::Sphere(words) => {
            list.window(&words.screen_box);
            list.quadratic(&words.contour, format.quadratic);
            list.quadratic(&words.front, format.quadratic);
            list.push(words.sum.into(), format.sum);
            let normal = words.normal.iter();
            normal.for_each(|n| list.linear(n, format.normal_linear));
            list.quadratic(&words.normal_z, format.quadratic);
        }
        ProcessorWords::Cylinder(words) => {
            list.window(&words.screen_box);
            let sides = words.sides.iter();
            sides.for_each(|side| list.linear(side, format.plane));
            let all = words.discs.iter().chain([&words.body]).chain(&words.normal);
            all.for_each(|word| list.quadratic(word, format.quadratic));
            list.linear(&words.disc, format.plane);
            list.vector(words.disc_normal, format);
        }
        ProcessorWords::Quotient(words) => {
            let widths = words.widths(format);
            list.window(&words.screen_box);
            list.quadratic(&words.numerator, widths.numerator);
            list.linear(&words.denominator, widths.denominator);
            list.normal(&words.normal, format);
            list.push(words.solid.into(), 1);
            list.push(words.normal_from.into(), format.depth);
            list.planes(&words.planes, count, format);
        }
    }
    list.0
}

fn padded<T: Clone + Default>(given: &[T], count: usize) -> Vec<T> {
    let mut all = given.to_vec();
    all.resize(count.max(given.len()), T::default());
    all
}

impl List {
    fn vector(&mut self, parts: [i16; 3], format: &Format) {
        parts
            .iter()
            .for_each(|part| self.push((*part).into(), format.normal));
    }

    fn quadric(&mut self, f1: &Linear, f2: &Quadratic, normal: &NormalWords, format: &Format) {
        self.linear(f1, format.pe1_width());
        self.quadratic(f2, format.pe2_width());
        self.normal(normal, format);
    }

    fn normal(&mut self, normal: &NormalWords, format: &Format) {
        let gradients = normal.g.iter();
        gradients.for_each(|g| self.linear(g, format.normal_linear));
        self.vector(normal.k, format);
        self.push(normal.shift.into(), SHIFT);
    }

    /// Planes with their normals.
    fn planes(&mut self, given: &[PlaneWords], count: usize, format: &Format) {
        for plane in padded(given, count) {
            self.push(plane.kind as i128, KIND_WIDTH);
            self.linear(&plane.depth, format.plane);
            self.vector(plane.normal, format);
        }
    }

    fn first_generation(&mut self, words: &FirstGenerationWords, format: &Format) {
        self.window(&words.screen_box);
        self.quadric(&words.f1, &words.f2, &words.normal, format);
        self.push(words.patch.into(), 1);
        let planes = [&words.front, &words.back];
        planes
            .iter()
            .for_each(|p| self.linear(&p.depth, format.plane));
        planes
            .iter()
            .for_each(|p| self.quadratic(&p.conic, format.quadratic));
        planes
            .iter()
            .for_each(|p| self.linear(&p.polar, format.plane));
        self.vector(words.front.normal, format);
    }
}
