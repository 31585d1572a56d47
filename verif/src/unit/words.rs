//! The words of a prepared object or volume on the ports of its processor.

use imogene_contract::{Request, Unit};
use imogene_golden::format::{Format, wrap};
use imogene_golden::object::polyhedron::PolyhedronWords;
use imogene_golden::object::quadric::{PlaneWords, ScreenBox};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::VolumeWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use std::collections::VecDeque;

/// A processor with the words of a zone on its ports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loaded {
    /// Unit and parameters, one row of the root network per stage.
    pub request: Request,
    /// Values of the ports behind the raster's, in their order.
    pub words: Vec<i64>,
}

/// A unit with so many planes or sides.
fn loaded(unit: Unit, count: usize, ports: Ports) -> Loaded {
    let mut request = Request::of(unit, ports.format.depth);
    if unit.has_object_root() {
        request.root_form = ports.format.root_form;
    }
    match unit.has("sides") {
        true => request.sides = count as u32,
        false => request.planes = count as u32,
    }
    Loaded {
        request,
        words: ports.written,
    }
}

/// The processor of a slot; `None` if there is no hardware for it.
pub fn processor(words: &ProcessorWords, format: &Format) -> Option<Loaded> {
    let (unit, count) = match words {
        ProcessorWords::Quadric(q) => (Unit::QuadricProcessor, q.planes.len()),
        ProcessorWords::Patch(q) => (Unit::PatchProcessor, q.planes.len()),
        ProcessorWords::FirstGeneration(_) => (Unit::FirstGenerationProcessor, 0),
        ProcessorWords::Polyhedron(p) => (Unit::PolyhedronProcessor, p.planes.len()),
        ProcessorWords::Facet(f) => (Unit::FacetProcessor, f.edges.len()),
        ProcessorWords::CurvedFacet(f) => (Unit::CurvedFacetProcessor, f.sides.len()),
        ProcessorWords::Sphere(_) => (Unit::SphereProcessor, 0),
        ProcessorWords::Cylinder(_) => (Unit::CylinderProcessor, 0),
        ProcessorWords::Quotient(q) if q.root.is_none() => {
            (Unit::QuotientProcessor, q.planes.len())
        }
        // What a member hands on depends on the others of its product.
        ProcessorWords::Quotient(_) | ProcessorWords::Member(_) => return None,
    };
    let mut ports = Ports::of(None, format);
    ports.processor(&mut words.clone());
    Some(loaded(unit, count, ports))
}

/// The processor of a volume; the visible depth, its port before the words, is left to the caller.
pub fn volume(words: &VolumeWords, format: &Format) -> Loaded {
    let mut ports = Ports::of(None, format);
    ports.volume(&mut words.clone());
    let unit = match &words.quadric {
        Some(_) => Unit::QuadricVolume,
        None => Unit::PolyhedralVolume,
    };
    loaded(unit, words.planes.len(), ports)
}

/// Words on ports, one after the other: those that the ports show, or those that they are to show.
pub(super) struct Ports {
    format: Format,
    /// What the ports show, from which words are read; without it words are written.
    shown: Option<VecDeque<i64>>,
    written: Vec<i64>,
    /// Column and line of the first pixel of the zone.
    pub origin: [i64; 2],
}

/// What ports show.
pub(super) fn read<T: Default>(shown: &[i64], format: &Format, of: fn(&mut Ports, &mut T)) -> T {
    let mut words = T::default();
    of(&mut Ports::of(Some(shown), format), &mut words);
    words
}

impl Ports {
    pub fn of(shown: Option<&[i64]>, format: &Format) -> Ports {
        Ports {
            format: *format,
            shown: shown.map(|words| words.iter().copied().collect()),
            written: vec![],
            origin: [0; 2],
        }
    }

    fn word(&mut self, value: &mut i128, width: u32) {
        match &mut self.shown {
            Some(words) => *value = words.pop_front().expect("a port for each word").into(),
            None => self.written.push(wrap(*value, width) as i64),
        }
    }

    /// A number that has a type of its own.
    pub fn number<T: Copy + Into<i128>>(&mut self, value: &mut T, of: fn(i128) -> T) {
        let mut word = (*value).into();
        self.word(&mut word, 64);
        *value = of(word);
    }

    fn linear(&mut self, l: &mut Linear, width: u32) {
        for word in [&mut l.a, &mut l.b, &mut l.c] {
            self.word(word, width);
        }
    }

    /// A depth or a side.
    pub fn line(&mut self, l: &mut Linear) {
        self.linear(l, self.format.plane);
    }

    fn normal_line(&mut self, l: &mut Linear) {
        self.linear(l, self.format.normal_linear);
    }

    /// The words on ports are preconditioned, modulo their width; halves of `a2` and `b2` are taken in one bit more.
    pub fn quadratic(&mut self, q: &mut Quadratic) {
        self.quadratic_of(q, self.format.quadratic);
    }

    fn quadratic_of(&mut self, q: &mut Quadratic, width: u32) {
        let mut p = q.preconditioned(width);
        let words = [&mut p.a2, &mut p.b2, &mut p.c, &mut p.i0, &mut p.p0];
        let words = words.into_iter().chain([&mut p.f]);
        words.for_each(|word| self.word(word, width));
        *q = Quadratic::of_preconditioned(&p);
    }

    fn screen_box(&mut self, b: &mut ScreenBox) {
        *b = b.or_empty();
        let [x, y] = self.origin;
        let edges = [&mut b.x0, &mut b.x1, &mut b.y0, &mut b.y1];
        for (edge, first) in edges.into_iter().zip([x, x, y, y]) {
            self.number(edge, |word| word as i64);
            *edge -= first;
        }
    }

    pub fn vector(&mut self, vector: &mut [i16; 3]) {
        for part in vector {
            self.number(part, |word| word as i16);
        }
    }

    /// One of so many, by its index.
    fn choice<T: Copy>(&mut self, mut index: i64, all: &[T]) -> T {
        self.number(&mut index, |word| word as i64);
        all[index as usize]
    }

    fn plane(&mut self, kind: &mut PlaneKind, depth: &mut Linear) {
        *kind = self.choice(*kind as i64, &PlaneKind::ALL);
        self.line(depth);
    }

    /// Planes with their normals.
    fn planes(&mut self, planes: &mut [PlaneWords]) {
        for plane in planes {
            self.plane(&mut plane.kind, &mut plane.depth);
            self.vector(&mut plane.normal);
        }
    }

    /// The words of the normal unit but for its shift.
    pub fn normal(&mut self, normal: &mut NormalWords) {
        normal.g.iter_mut().for_each(|g| self.normal_line(g));
        self.vector(&mut normal.k);
    }

    /// What quadrics of all kinds have.
    fn quadric(
        &mut self,
        f1: &mut Linear,
        f2: &mut Quadratic,
        normal: &mut NormalWords,
        screen_box: &mut ScreenBox,
    ) {
        self.linear(f1, self.format.sum);
        self.quadratic(f2);
        self.normal(normal);
        self.screen_box(screen_box);
        self.number(&mut normal.shift, |word| word as u8);
    }

    pub fn polyhedron(&mut self, p: &mut PolyhedronWords) {
        self.screen_box(&mut p.screen_box);
        self.planes(&mut p.planes);
    }

    pub fn processor(&mut self, words: &mut ProcessorWords) {
        match words {
            ProcessorWords::Quadric(q) => {
                self.quadric(&mut q.f1, &mut q.f2, &mut q.normal, &mut q.screen_box);
                q.class = self.choice(q.class as i64, &Class::ALL);
                self.planes(&mut q.planes);
            }
            ProcessorWords::Patch(q) => {
                self.quadric(&mut q.f1, &mut q.f2, &mut q.normal, &mut q.screen_box);
                for plane in &mut q.planes {
                    self.plane(&mut plane.kind, &mut plane.depth);
                }
            }
            ProcessorWords::FirstGeneration(q) => {
                self.quadric(&mut q.f1, &mut q.f2, &mut q.normal, &mut q.screen_box);
                self.number(&mut q.patch, |word| word != 0);
                let mut planes = [&mut q.front, &mut q.back];
                planes.iter_mut().for_each(|p| self.line(&mut p.depth));
                planes.iter_mut().for_each(|p| self.quadratic(&mut p.conic));
                planes.iter_mut().for_each(|p| self.line(&mut p.polar));
                self.vector(&mut q.front.normal);
            }
            ProcessorWords::Polyhedron(p) => self.polyhedron(p),
            ProcessorWords::Facet(f) => {
                self.screen_box(&mut f.screen_box);
                f.edges.iter_mut().for_each(|side| self.line(side));
                self.line(&mut f.depth);
                f.normal.iter_mut().for_each(|n| self.normal_line(n));
            }
            ProcessorWords::CurvedFacet(f) => {
                self.screen_box(&mut f.screen_box);
                f.sides.iter_mut().for_each(|side| self.quadratic(side));
                self.quadratic(&mut f.depth);
                f.normal.iter_mut().for_each(|n| self.quadratic(n));
            }
            ProcessorWords::Sphere(s) => {
                self.screen_box(&mut s.screen_box);
                self.quadratic(&mut s.contour);
                self.quadratic(&mut s.front);
                let mut sum = s.sum.into();
                self.word(&mut sum, self.format.sum);
                s.sum = sum as i64;
                s.normal.iter_mut().for_each(|n| self.normal_line(n));
                self.quadratic(&mut s.normal_z);
            }
            ProcessorWords::Cylinder(c) => {
                self.screen_box(&mut c.screen_box);
                c.sides.iter_mut().for_each(|side| self.line(side));
                c.discs.iter_mut().for_each(|disc| self.quadratic(disc));
                self.quadratic(&mut c.body);
                c.normal.iter_mut().for_each(|n| self.quadratic(n));
                self.line(&mut c.disc);
                self.vector(&mut c.disc_normal);
            }
            ProcessorWords::Quotient(q) => {
                let widths = q.widths(&self.format);
                self.quadratic_of(&mut q.numerator, widths.numerator);
                self.linear(&mut q.denominator, widths.denominator);
                self.normal(&mut q.normal);
                self.screen_box(&mut q.screen_box);
                self.number(&mut q.normal.shift, |word| word as u8);
                self.number(&mut q.solid, |word| word != 0);
                self.number(&mut q.normal_from, |word| word as i64);
                self.planes(&mut q.planes);
            }
            ProcessorWords::Member(_) => unreachable!("it has no hardware"),
        }
    }

    /// The words behind the visible depth.
    pub fn volume(&mut self, v: &mut VolumeWords) {
        self.number(&mut v.margin, |word| word as u32);
        if let Some(q) = &mut v.quadric {
            self.linear(&mut q.f1, self.format.sum);
            self.quadratic(&mut q.f2);
        }
        self.screen_box(&mut v.screen_box);
        for plane in &mut v.planes {
            self.plane(&mut plane.kind, &mut plane.depth);
        }
        if let Some(q) = &mut v.quadric {
            q.class = self.choice(q.class as i64, &Class::ALL);
            self.number(&mut q.shift, |word| word as u8);
        }
    }
}
