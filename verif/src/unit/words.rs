//! From the words of a prepared object or volume to the ports of its processor.

use super::Parameters;
use imogene_models::format::{Format, wrap};
use imogene_models::object::first_generation::ContourPlane;
use imogene_models::object::quadric::{QuadricWords, ScreenBox};
use imogene_models::object::slot::ProcessorWords;
use imogene_models::object::volume::VolumeWords;
use imogene_models::unit::cut_plane::PlaneKind;
use imogene_models::unit::pe1::Linear;
use imogene_models::unit::pe2::Quadratic;

/// A processor with the words of a zone on its ports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loaded {
    /// Unit.
    pub unit: &'static str,
    /// Its cut planes, or none if it has no such parameter.
    pub planes: Option<usize>,
    /// Its sides, if it is a facet.
    pub sides: Option<usize>,
    /// Values of the ports behind the raster's, in the order of the unit's subject.
    pub words: Vec<i64>,
}

impl Loaded {
    /// The parameters of the unit.
    pub fn parameters(&self, format: &Format, rows_per_stage: usize) -> Parameters {
        Parameters {
            depth_word: format.depth,
            planes: self.planes.unwrap_or(0),
            rows_per_stage,
            sides: self.sides,
            lights: None,
            ..Parameters::default()
        }
    }
}

/// The processor of a slot; nothing if there is no hardware for it.
pub fn processor(words: &ProcessorWords, format: &Format) -> Option<Loaded> {
    let mut w = Writer {
        format,
        words: Vec::new(),
    };
    let (mut planes, mut sides) = (None, None);
    let unit = match words {
        ProcessorWords::Quadric(q) => {
            w.quadric(q);
            // The class stands between the box and the shift.
            let shift = w.words.len() - 1;
            w.words.insert(shift, q.class as i64);
            for plane in &q.planes {
                w.plane(plane.kind, &plane.depth);
                w.vector(plane.normal);
            }
            planes = Some(q.planes.len());
            "quadric_processor"
        }
        ProcessorWords::Patch(q) => {
            w.quadric(q);
            for plane in &q.planes {
                w.plane(plane.kind, &plane.depth);
            }
            planes = Some(q.planes.len());
            "patch_processor"
        }
        ProcessorWords::FirstGeneration(q) => {
            w.quadric(&QuadricWords {
                class: Default::default(),
                screen_box: q.screen_box,
                f1: q.f1,
                f2: q.f2,
                normal: q.normal,
                planes: vec![],
            });
            w.words.push(i64::from(q.patch));
            w.contour_plane(&q.front);
            w.contour_plane(&q.back);
            "first_generation_processor"
        }
        ProcessorWords::Polyhedron(p) => {
            w.screen_box(&p.screen_box);
            for plane in &p.planes {
                w.plane(plane.kind, &plane.depth);
                w.vector(plane.normal);
            }
            planes = Some(p.planes.len());
            "polyhedron_processor"
        }
        ProcessorWords::Facet(f) => {
            w.screen_box(&f.screen_box);
            f.edges.iter().for_each(|side| w.linear(side, format.plane));
            w.linear(&f.depth, format.plane);
            let part = format.normal_linear;
            f.normal.iter().for_each(|n| w.linear(n, part));
            sides = Some(f.edges.len());
            "facet_processor"
        }
        ProcessorWords::CurvedFacet(f) => {
            w.screen_box(&f.screen_box);
            f.sides.iter().for_each(|side| w.quadratic(side));
            w.quadratic(&f.depth);
            f.normal.iter().for_each(|n| w.quadratic(n));
            sides = Some(f.sides.len());
            "curved_facet_processor"
        }
        ProcessorWords::Sphere(s) => {
            w.screen_box(&s.screen_box);
            w.quadratic(&s.contour);
            w.quadratic(&s.front);
            w.word(s.sum.into(), format.sum);
            let part = format.normal_linear;
            s.normal.iter().for_each(|n| w.linear(n, part));
            w.quadratic(&s.normal_z);
            "sphere_processor"
        }
        ProcessorWords::Cylinder(c) => {
            w.screen_box(&c.screen_box);
            c.sides.iter().for_each(|side| w.linear(side, format.plane));
            c.discs.iter().for_each(|disc| w.quadratic(disc));
            w.quadratic(&c.body);
            c.normal.iter().for_each(|n| w.quadratic(n));
            w.linear(&c.disc, format.plane);
            w.vector(c.disc_normal);
            "cylinder_processor"
        }
        ProcessorWords::Quotient(_) => return None,
    };
    Some(Loaded {
        unit,
        planes,
        sides,
        words: w.words,
    })
}

/// The processor of a volume; its last port, the visible depth, is left to the caller.
pub fn volume(words: &VolumeWords, format: &Format) -> Loaded {
    let mut w = Writer {
        format,
        words: Vec::new(),
    };
    let unit = match &words.quadric {
        Some(q) => {
            w.linear(&q.f1, format.sum);
            w.quadratic(&q.f2);
            w.words.push(q.class as i64);
            w.words.push(q.shift.into());
            "quadric_volume"
        }
        None => "polyhedral_volume",
    };
    w.screen_box(&words.screen_box);
    w.words.push(words.margin.into());
    for plane in &words.planes {
        w.plane(plane.kind, &plane.depth);
    }
    Loaded {
        unit,
        planes: Some(words.planes.len()),
        sides: None,
        words: w.words,
    }
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

    /// f1, f2, the normal, the box and the shift.
    fn quadric(&mut self, q: &QuadricWords) {
        self.linear(&q.f1, self.format.sum);
        self.quadratic(&q.f2);
        for g in &q.normal.g {
            self.linear(g, self.format.normal_linear);
        }
        self.vector(q.normal.k);
        self.screen_box(&q.screen_box);
        self.words.push(q.normal.shift.into());
    }

    fn contour_plane(&mut self, p: &ContourPlane) {
        self.linear(&p.depth, self.format.plane);
        self.quadratic(&p.conic);
        self.linear(&p.polar, self.format.plane);
        self.vector(p.normal);
    }
}
