//! What is truly seen of an object at a pixel: the equation of the exact reference along the line of sight, in ranges
//! of `f64`, and in integers where the ranges overlap.
//!
//! Processors other than those of quadrics and patches have words for which no bound is worked out beforehand. Their
//! pictures are held against the truth at every pixel, which costs a few dozen operations in `f64`; what it finds is
//! proven, since ranges are rounded outwards.

pub mod interval;

use super::depth::Range;
use super::verdict::{Bounded, Pixel, Verdict};
use crate::exact::facet::{RayFacet, RayMesh};
use crate::exact::ray::{Hit, RayObject};
use crate::exact::render::DEPTH_FRACTION;
use imogene_golden::format::Format;
use imogene_golden::object::facet::FACE_FACET;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_scene::{FramedObject, FramedScene, Surface};
use interval::{Conic, Line, conic, excess, line};
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};

/// The face that is truly seen, if there is one.
pub(super) type True = Option<Bounded>;

pub(super) type Columns = std::ops::RangeInclusive<i64>;

pub(super) struct Truth {
    shape: Shape,
    full: i64,
}

enum Shape {
    Cut(Box<CutShape>),
    Mesh(MeshShape),
}

impl Truth {
    pub fn new(object: &FramedObject, scene: &FramedScene, format: &Format) -> Truth {
        let shape = match (object, object.cut_quadric()) {
            (_, Some(cut)) => Shape::Cut(Box::new(CutShape::new(RayObject::new(&cut, scene)))),
            (FramedObject::Mesh(mesh), None) => {
                let mesh = RayMesh::new(mesh, scene);
                Shape::Mesh(MeshShape::new(mesh, scene.height.into()))
            }
            _ => unreachable!("only a mesh is no cut quadric"),
        };
        Truth {
            shape,
            full: format.z_max(),
        }
    }

    /// Indices of the first plane that keeps what is behind it, and of the first that keeps what is before it.
    pub fn front_and_back(&self) -> [Option<usize>; 2] {
        let Shape::Cut(cut) = &self.shape else {
            return [None; 2];
        };
        // In either projection the slope is the same for all lines of sight.
        let first = |is: fn(&BigInt) -> bool| cut.ray.planes.iter().position(|p| is(&p[0][2]));
        [first(BigInt::is_negative), first(BigInt::is_positive)]
    }

    /// The box beyond which nothing is seen of it, if that is not the one of its words.
    pub fn window(&self) -> Option<ScreenBox> {
        match &self.shape {
            Shape::Cut(_) => None,
            Shape::Mesh(mesh) => Some(mesh.window),
        }
    }

    /// What is seen on a line, at the columns asked for.
    pub fn line(&self, y: i64, columns: Columns) -> Vec<True> {
        match &self.shape {
            Shape::Cut(cut) => columns.map(|x| cut.at(x, y, self.full)).collect(),
            Shape::Mesh(mesh) => mesh.line(y, columns, self.full),
        }
    }
}

/// The depth of the parameter w, in words.
fn depth(w: Range, full: i64) -> Range {
    Range::point(full as f64) * (Range::point(1.0) + w)
}

/// The same of an exact hit.
fn exact(hit: Option<Hit>, full: i64) -> True {
    let (hit, full) = (hit?, BigInt::from(full));
    let fixed = hit.w.fixed(&full, &full, DEPTH_FRACTION);
    let at = fixed.to_f64().expect("a depth word");
    let unit = Range::point((-f64::from(DEPTH_FRACTION)).exp2());
    Some((hit.number, Range::new(at - 2.0, at + 2.0) * unit))
}

/// A quadric with planes, or planes alone: `a w^2 + b w + c` and the planes' `slope w + constant`.
struct CutShape {
    ray: RayObject,
    /// Sign of a, which is the same for all lines of sight, and its value.
    a: (i8, Range),
    b: Line,
    b_is_zero: bool,
    c: Conic,
    discriminant: Conic,
    planes: Vec<PlaneShape>,
}

/// A plane along the lines of sight: kept where `slope w + constant` is not positive.
struct PlaneShape {
    /// `None` if the plane is along every line of sight.
    slope: Option<Line>,
    constant: Line,
}

impl PlaneShape {
    fn new([slope, constant]: &[[BigInt; 3]; 2]) -> PlaneShape {
        let shorter = excess(slope.iter().chain(constant));
        let crosses = slope.iter().any(|factor| !factor.is_zero());
        PlaneShape {
            slope: crosses.then(|| line(slope, shorter)),
            constant: line(constant, shorter),
        }
    }

    /// How it lies to the line of sight, and its depth or value; `None` if it is nearly along it.
    fn at(&self, at: [Range; 2], full: i64) -> Option<(PlaneKind, Range)> {
        let constant = self.constant.at(at);
        let Some(slope) = &self.slope else {
            return Some((PlaneKind::Perpendicular, -constant));
        };
        let slope = slope.at(at);
        let kind = [PlaneKind::Front, PlaneKind::Back][usize::from(slope.sign()? > 0)];
        Some((kind, depth(-constant / slope, full)))
    }
}

impl CutShape {
    fn new(ray: RayObject) -> CutShape {
        let [a, b, c] = &ray.along;
        let discriminant = discriminant(&a[5], b, c);
        let shorter = excess([&a[5]].into_iter().chain(b).chain(c));
        let b_line = [b[3].clone(), b[4].clone(), b[5].clone()];
        let constant = line(&[BigInt::ZERO, BigInt::ZERO, a[5].clone()], shorter);
        CutShape {
            a: (
                a[5].signum().to_i8().expect("a sign"),
                constant.at(at(0, 0)),
            ),
            b: line(&b_line, shorter),
            b_is_zero: b_line.iter().all(Zero::is_zero),
            c: conic(c, shorter),
            // Over the square of what the others are over.
            discriminant: conic(&discriminant, 2 * shorter),
            planes: ray.planes.iter().map(PlaneShape::new).collect(),
            ray,
        }
    }

    fn at(&self, x: i64, y: i64, full: i64) -> True {
        match self.pixel(at(x, y), full).map(|pixel| pixel.decide()) {
            Some(Verdict::Absent) => None,
            Some(Verdict::Face(number, depth)) => Some((number, depth)),
            Some(Verdict::Undecided { .. }) | None => exact(self.ray.first_hit(x, y), full),
        }
    }

    /// All that is compared at a pixel; `None` if a plane or a single root is nearly along the line of sight.
    fn pixel(&self, at: [Range; 2], full: i64) -> Option<Pixel> {
        let planes = self.planes.iter().map(|plane| plane.at(at, full));
        let (class, seen, [near, far]) = self.roots(at)?;
        Some(Pixel {
            class,
            seen,
            near: depth(near, full),
            far: depth(far, full),
            planes: planes.collect::<Option<_>>()?,
            near_end: -full as f64,
            far_end: full as f64,
        })
    }

    /// How the quadric lies along the line of sight, whether that meets it, and where.
    fn roots(&self, at: [Range; 2]) -> Option<(Class, Option<bool>, [Range; 2])> {
        let is_patch = self.ray.surface == Surface::Patch;
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY].map(Range::point);
        let (c, b) = (self.c.at(at), self.b.at(at));
        if self.a.0 == 0 {
            if self.b_is_zero {
                // The quadric does not depend on the depth; as a surface it is seen edge-on.
                let inside = if is_patch {
                    Some(false)
                } else {
                    (-c).not_negative()
                };
                return Some((Class::Prism, inside, everywhere));
            }
            let sign = b.sign()?;
            let only = -c / b;
            let [before, behind] = everywhere;
            // Meeting it once, a surface has a near face alone.
            return Some(match (is_patch, sign) {
                (true, _) => (Class::Patch, Some(true), [only, behind]),
                (false, 1) => (Class::Side, Some(true), [before, only]),
                (false, _) => (Class::Side, Some(true), [only, behind]),
            });
        }
        let discriminant = self.discriminant.at(at);
        let class = match (is_patch, self.a.0) {
            (true, _) => Class::Patch,
            (false, 1) => Class::Side,
            (false, _) => Class::Front,
        };
        let roots = self.two_roots(b, c, discriminant.root());
        Some((class, discriminant.not_negative(), roots))
    }

    /// `(-b -+ root) / 2a` in ascending order; the one in which terms of one sign are added gives the other by c.
    fn two_roots(&self, b: Range, c: Range, root: Range) -> [Range; 2] {
        let (sign, a) = self.a;
        let double = a + a;
        let towards = |s: i8| if s > 0 { root } else { -root };
        match b.sign() {
            Some(of_b) => {
                let sum = -(b + towards(of_b));
                let (one, other) = (sum / double, (c + c) / sum);
                if of_b == sign {
                    [one, other]
                } else {
                    [other, one]
                }
            }
            None => [-sign, sign].map(|s| (towards(s) - b) / double),
        }
    }
}

fn at(x: i64, y: i64) -> [Range; 2] {
    [x, y].map(|v| Range::point(v as f64))
}

/// `b^2 - 4 a c` for a constant a and a first-degree b.
fn discriminant(a: &BigInt, b: &[BigInt; 6], c: &[BigInt; 6]) -> [BigInt; 6] {
    let [_, _, _, d, e, f] = b;
    let square = [d * d, e * e, d * e * 2, d * f * 2, e * f * 2, f * f];
    std::array::from_fn(|k| &square[k] - a * &c[k] * 4)
}

struct MeshShape {
    window: ScreenBox,
    facets: Vec<FacetShape>,
    by_line: Vec<Vec<usize>>,
}

struct FacetShape {
    ray: RayFacet,
    edges: Vec<Line>,
    plane: [Line; 2],
}

impl MeshShape {
    fn new(mesh: RayMesh, height: i64) -> MeshShape {
        let facet = |ray: RayFacet| {
            let shorter = excess(ray.plane.iter().flatten());
            FacetShape {
                edges: ray.edges.iter().map(|e| line(e, excess(e))).collect(),
                plane: ray.plane.each_ref().map(|form| line(form, shorter)),
                ray,
            }
        };
        let facets: Vec<FacetShape> = mesh.facets.into_iter().map(facet).collect();
        let mut by_line = vec![vec![]; height as usize];
        let mut window = ScreenBox::EMPTY;
        for (index, facet) in facets.iter().enumerate() {
            let own = &facet.ray.window;
            window = window.around(own);
            for y in own.y0.max(0)..=own.y1.min(height - 1) {
                by_line[y as usize].push(index);
            }
        }
        MeshShape {
            window,
            facets,
            by_line,
        }
    }

    fn line(&self, y: i64, columns: Columns, full: i64) -> Vec<True> {
        let (first, last) = (*columns.start(), *columns.end());
        let mut seen = vec![None; (last - first + 1).max(0) as usize];
        for &index in &self.by_line[y as usize] {
            let facet = &self.facets[index];
            let window = &facet.ray.window;
            for x in window.x0.max(first)..=window.x1.min(last) {
                let nearest: &mut True = &mut seen[(x - first) as usize];
                if let Some((number, found)) = facet.at(x, y, full) {
                    let least = nearest.map_or(found, |(_, before)| before.min(&found));
                    *nearest = Some((number, least));
                }
            }
        }
        seen
    }
}

impl FacetShape {
    fn at(&self, x: i64, y: i64, full: i64) -> True {
        let place = at(x, y);
        let edges = || self.edges.iter().map(|edge| edge.at(place));
        if edges().any(|edge| edge.high < 0.0) {
            return None;
        }
        let is_inside = edges().all(|edge| edge.low >= 0.0);
        let [slope, constant] = self.plane.map(|form| form.at(place));
        let w = -constant / slope;
        let is_drawn = w.low >= -2.0 && w.high < 0.0;
        if is_inside && is_drawn {
            return Some((FACE_FACET, depth(w, full)));
        }
        if w.high < -2.0 || w.low >= 0.0 {
            return None;
        }
        exact(self.ray.hit(x, y), full)
    }
}
