//! How far a golden depth may be from the true one at a pixel where both see the same face, by the kind of processor.
//!
//! Quadric and patch processors have bounds that are proven pixel by pixel ([`depth_bound`]); the first generation has
//! the depth words of the quadric processor. The others follow from what their words round.

use crate::body::Body;
use imogene_algebra::rational::to_f64;
use imogene_analysis::bounds::{constant_normal_bound, depth_bound, normal_bound};
use imogene_golden::format::Format;
use imogene_prepare::error::PrepareError;
use imogene_prepare::{PreparedObject, PreparedQuadric, PreparedScene, prepare};
use imogene_scene::{FramedObject, FramedScene};

/// Greatest distance of a sphere from its paraboloid, in radii.
const PARABOLOID: f64 = 0.2946;
/// A floor, and the rounding of coefficients that have guard bits.
const GUARDED: f64 = 2.0;

/// The bounds of a prepared scene.
pub struct Bounds {
    objects: Vec<Bound>,
    format: Format,
    /// The greatest depth word.
    pub z_max: f64,
}

enum Bound {
    /// Proven at each pixel from its f2; the normals as well, if these are the words that are drawn.
    Proven(Box<PreparedQuadric>, bool),
    /// The same at every pixel of a face: of number 0, and of any other; and whether its normals are rounded planes.
    Level([f64; 2], bool),
    /// By facet, its slope in depth words for a pixel across and a pixel down: a corner is off by up to a 32nd pixel.
    Facets(Vec<(u32, f64)>),
}

impl Bounds {
    /// The bounds of `prepared`, which must come from `scene`; `bodies` are those of the tracer.
    pub fn new(
        scene: &FramedScene,
        prepared: &PreparedScene,
        bodies: &[(u32, Body)],
    ) -> Result<Bounds, PrepareError> {
        let quadrics = as_quadrics(scene, prepared)?;
        let scale = to_f64(&prepared.depth_scale);
        let of = |(id, object): (usize, &FramedObject)| -> Bound {
            if let Some(quadric) = quadrics[id].clone() {
                return Bound::Proven(Box::new(quadric), prepared.objects[id].quadric().is_some());
            }
            let level = |of| Bound::Level(of, matches!(object, FramedObject::Polyhedron(_)));
            let round = |radius| PARABOLOID * to_f64(radius) * scale + GUARDED;
            match object {
                FramedObject::Mesh(_) => Bound::Facets(facets(id, bodies, &prepared.format)),
                FramedObject::Sphere(s) | FramedObject::CurvedSphere(s) => {
                    level([round(&s.radius); 2])
                }
                FramedObject::Cylinder(c) => level([round(&(&c.radius / &c.level)), GUARDED]),
                FramedObject::Unseen(_) => level([0.0; 2]),
                // Polyhedra and quotients state their own.
                _ => match &prepared.objects[id] {
                    PreparedObject::Parts(p) => level([p.depth_bound.unwrap_or(GUARDED); 2]),
                    _ => unreachable!("prepared for its processor"),
                },
            }
        };
        Ok(Bounds {
            objects: scene.objects.iter().enumerate().map(of).collect(),
            format: prepared.format,
            z_max: prepared.format.z_max() as f64,
        })
    }

    /// Whether an object is drawn by facet processors.
    pub fn is_of_facets(&self, object: u32) -> bool {
        matches!(self.objects[object as usize], Bound::Facets(_))
    }

    /// The bound at a pixel, in depth words.
    pub fn at(&self, object: u32, number: u8, part: u32, (x, y): (i64, i64)) -> f64 {
        match &self.objects[object as usize] {
            Bound::Proven(quadric, _) => {
                let f2 = quadric.words.f2_at(x, y, &self.format);
                depth_bound(quadric, number, f2)
            }
            Bound::Level(of, _) => of[usize::from(number != 0)],
            Bound::Facets(facets) => {
                slope_of(facets, part).map_or(f64::INFINITY, |slope| slope / 32.0 + GUARDED)
            }
        }
    }

    /// Greatest angle in radians between the golden normal of a face at a pixel and the true one, if it is known.
    pub fn normal(
        &self,
        object: u32,
        number: u8,
        (x, y): (i64, i64),
        golden: [i16; 3],
    ) -> Option<f64> {
        let degrees = match &self.objects[object as usize] {
            Bound::Proven(quadric, true) => {
                let f2 = quadric.words.f2_at(x, y, &self.format);
                normal_bound(quadric, number, f2, golden)
            }
            Bound::Level(_, true) => constant_normal_bound(golden),
            // Normals of corners of facets, or of another surface than the true one.
            _ => return None,
        };
        Some(degrees.to_radians())
    }

    /// Most that a golden depth of a facet may differ from the true one at a pixel beside it; `None` for no facet.
    pub fn one_pixel_on(&self, object: u32, part: u32) -> Option<f64> {
        match &self.objects[object as usize] {
            Bound::Facets(facets) => {
                slope_of(facets, part).map(|slope| slope * (1.0 + 1.0 / 32.0) + GUARDED)
            }
            _ => None,
        }
    }
}

/// Objects of the first generation are prepared again for the quadric processor, which has their depth words.
fn as_quadrics(
    scene: &FramedScene,
    prepared: &PreparedScene,
) -> Result<Vec<Option<PreparedQuadric>>, PrepareError> {
    let of_first = |o: &FramedObject| matches!(o, FramedObject::FirstGeneration(_));
    let own = |prepared: &PreparedScene| -> Vec<Option<PreparedQuadric>> {
        let objects = prepared.objects.iter();
        objects.map(|o| o.quadric().cloned()).collect()
    };
    if !scene.objects.iter().any(of_first) {
        return Ok(own(prepared));
    }
    let mut other = scene.clone();
    for object in &mut other.objects {
        if let FramedObject::FirstGeneration(quadric) = object {
            *object = FramedObject::Quadric(quadric.clone());
        }
    }
    Ok(own(&prepare(&other, prepared.format)?))
}

fn slope_of(facets: &[(u32, f64)], part: u32) -> Option<f64> {
    let found = facets.binary_search_by_key(&part, |facet| facet.0);
    found.ok().map(|index| facets[index].1)
}

fn facets(id: usize, bodies: &[(u32, Body)], format: &Format) -> Vec<(u32, f64)> {
    let z_max = format.z_max() as f64;
    let mut bounds: Vec<(u32, f64)> = vec![];
    for (_, body) in bodies.iter().filter(|(object, _)| *object as usize == id) {
        let Body::Facet(facet) = body else { continue };
        if bounds.last().is_none_or(|(part, _)| *part != facet.part) {
            let slope: f64 = facet.depth_slope().iter().sum();
            bounds.push((facet.part, slope * z_max));
        }
    }
    bounds
}
