//! From the words of a prepared object or volume to the ports of its processor.

use imogene_contract::{Request, Unit};
use imogene_golden::format::{Format, wrap};
use imogene_golden::object::quadric::{PlaneWords, ScreenBox};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::VolumeWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::normal::NormalWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;

/// A processor with the words of a zone on its ports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loaded {
    /// Unit and parameters, one row of the root network per stage.
    pub request: Request,
    /// Values of the ports behind the raster's, in their order.
    pub words: Vec<i64>,
}

/// A unit with so many planes or sides.
fn loaded(unit: Unit, count: usize, writer: Writer) -> Loaded {
    let mut request = Request::of(unit, writer.format.depth);
    if unit.has_object_root() {
        request.root_form = writer.format.root_form;
    }
    match unit.has("sides") {
        true => request.sides = count as u32,
        false => request.planes = count as u32,
    }
    Loaded {
        request,
        words: writer.words,
    }
}

/// The processor of a slot; `None` if there is no hardware for it.
pub fn processor(words: &ProcessorWords, format: &Format) -> Option<Loaded> {
    let mut w = Writer {
        format,
        words: Vec::new(),
    };
    let (unit, count) = match words {
        ProcessorWords::Quadric(q) => {
            w.quadric(&q.f1, &q.f2, &q.normal, &q.screen_box);
            w.words.push(q.class as i64);
            w.planes(&q.planes);
            (Unit::QuadricProcessor, q.planes.len())
        }
        ProcessorWords::Patch(q) => {
            w.quadric(&q.f1, &q.f2, &q.normal, &q.screen_box);
            let planes = q.planes.iter();
            planes.for_each(|plane| w.plane(plane.kind, &plane.depth));
            (Unit::PatchProcessor, q.planes.len())
        }
        ProcessorWords::FirstGeneration(q) => {
            w.quadric(&q.f1, &q.f2, &q.normal, &q.screen_box);
            w.words.push(i64::from(q.patch));
            let planes = [&q.front, &q.back];
            planes.iter().for_each(|p| w.linear(&p.depth, format.plane));
            planes.iter().for_each(|p| w.quadratic(&p.conic));
            planes.iter().for_each(|p| w.linear(&p.polar, format.plane));
            w.vector(q.front.normal);
            (Unit::FirstGenerationProcessor, 0)
        }
        ProcessorWords::Polyhedron(p) => {
            w.screen_box(&p.screen_box);
            w.planes(&p.planes);
            (Unit::PolyhedronProcessor, p.planes.len())
        }
        ProcessorWords::Facet(f) => {
            w.screen_box(&f.screen_box);
            f.edges.iter().for_each(|side| w.linear(side, format.plane));
            w.linear(&f.depth, format.plane);
            let part = format.normal_linear;
            f.normal.iter().for_each(|n| w.linear(n, part));
            (Unit::FacetProcessor, f.edges.len())
        }
        ProcessorWords::CurvedFacet(f) => {
            w.screen_box(&f.screen_box);
            f.sides.iter().for_each(|side| w.quadratic(side));
            w.quadratic(&f.depth);
            f.normal.iter().for_each(|n| w.quadratic(n));
            (Unit::CurvedFacetProcessor, f.sides.len())
        }
        ProcessorWords::Sphere(s) => {
            w.screen_box(&s.screen_box);
            w.quadratic(&s.contour);
            w.quadratic(&s.front);
            w.word(s.sum.into(), format.sum);
            let part = format.normal_linear;
            s.normal.iter().for_each(|n| w.linear(n, part));
            w.quadratic(&s.normal_z);
            (Unit::SphereProcessor, 0)
        }
        ProcessorWords::Cylinder(c) => {
            w.screen_box(&c.screen_box);
            c.sides.iter().for_each(|side| w.linear(side, format.plane));
            c.discs.iter().for_each(|disc| w.quadratic(disc));
            w.quadratic(&c.body);
            c.normal.iter().for_each(|n| w.quadratic(n));
            w.linear(&c.disc, format.plane);
            w.vector(c.disc_normal);
            (Unit::CylinderProcessor, 0)
        }
        // What a member hands on depends on the others of its product.
        ProcessorWords::Quotient(_) | ProcessorWords::Member(_) => return None,
    };
    Some(loaded(unit, count, w))
}

/// The processor of a volume; the visible depth, its port before the words, is left to the caller.
pub fn volume(words: &VolumeWords, format: &Format) -> Loaded {
    let mut w = Writer {
        format,
        words: Vec::new(),
    };
    w.words.push(words.margin.into());
    if let Some(q) = &words.quadric {
        w.linear(&q.f1, format.sum);
        w.quadratic(&q.f2);
    }
    w.screen_box(&words.screen_box);
    for plane in &words.planes {
        w.plane(plane.kind, &plane.depth);
    }
    if let Some(q) = &words.quadric {
        w.words.extend([q.class as i64, q.shift.into()]);
    }
    let unit = match &words.quadric {
        Some(_) => Unit::QuadricVolume,
        None => Unit::PolyhedralVolume,
    };
    loaded(unit, words.planes.len(), w)
}

/// Writes words as their ports show them.
struct Writer<'a> {
    format: &'a Format,
    words: Vec<i64>,
}

impl Writer<'_> {
    fn word(&mut self, value: i128, width: u32) {
        self.words.push(wrap(value, width) as i64);
    }

    fn linear(&mut self, l: &Linear, width: u32) {
        for value in [l.a, l.b, l.c] {
            self.word(value, width);
        }
    }

    fn quadratic(&mut self, q: &Quadratic) {
        let width = self.format.quadratic;
        let p = q.preconditioned(width);
        for value in [p.a2, p.b2, p.c, p.i0, p.p0, p.f] {
            self.word(value, width);
        }
    }

    fn screen_box(&mut self, b: &ScreenBox) {
        let b = if b.is_empty() { &ScreenBox::EMPTY } else { b };
        self.words.extend([b.x0, b.x1, b.y0, b.y1]);
    }

    fn vector(&mut self, v: [i16; 3]) {
        self.words.extend(v.map(i64::from));
    }

    fn plane(&mut self, kind: PlaneKind, depth: &Linear) {
        self.words.push(kind as i64);
        self.linear(depth, self.format.plane);
    }

    /// Planes with their normals.
    fn planes(&mut self, planes: &[PlaneWords]) {
        for plane in planes {
            self.plane(plane.kind, &plane.depth);
            self.vector(plane.normal);
        }
    }

    fn quadric(&mut self, f1: &Linear, f2: &Quadratic, normal: &NormalWords, b: &ScreenBox) {
        self.linear(f1, self.format.sum);
        self.quadratic(f2);
        for g in &normal.g {
            self.linear(g, self.format.normal_linear);
        }
        self.vector(normal.k);
        self.screen_box(b);
        self.words.push(normal.shift.into());
    }
}
