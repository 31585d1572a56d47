//! The exact picture of a sweep's scene: depths and normals to more digits than any word has.
//!
//! [`imogene_analysis::exact::render`] gives depths with 20 fraction bits and takes gradients in floating point; where
//! a quadric all but degenerates that is not enough.

use imogene_algebra::matrix::image;
use imogene_algebra::whole::scaled;
use imogene_analysis::exact::render::View;
use imogene_golden::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE};
use imogene_scene::{FramedQuadric, FramedScene, Projection};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// Fraction bits of an exact depth in depth words.
pub const DEPTH_BITS: u32 = 40;
/// Fraction bits of the depth that a normal is taken at, in units of the full depth.
const POINT_BITS: u32 = 160;

/// What is truly seen at a pixel.
pub struct TruePixel {
    /// Depth in depth words with [`DEPTH_BITS`] fraction bits.
    pub depth: i128,
    /// Index of the visible object.
    pub id: usize,
    /// Number of the visible face.
    pub number: u8,
    /// Direction of the outward normal.
    pub normal: [f64; 3],
}

/// A scene of cut quadrics along its lines of sight.
pub struct Truth<'a> {
    scene: &'a FramedScene,
    view: View<'a>,
    objects: Vec<(&'a FramedQuadric, Gradient)>,
    greatest_depth: BigInt,
}

impl<'a> Truth<'a> {
    /// Sets up the rays; every object must be drawn by a quadric or patch processor.
    pub fn new(scene: &'a FramedScene, greatest_depth: i64) -> Truth<'a> {
        let objects = scene.objects.iter().map(|object| {
            let object = object.quadric().expect("sweeps draw quadrics alone");
            (object, Gradient::new(object, scene))
        });
        Truth {
            scene,
            view: View::new(scene),
            objects: objects.collect(),
            greatest_depth: BigInt::from(greatest_depth),
        }
    }

    /// What is seen at a pixel; the smaller id where two are exactly equal.
    pub fn at(&self, x: i64, y: i64) -> Option<TruePixel> {
        let (id, hit) = self.view.visible(x, y)?;
        let id = id as usize;
        let full = &self.greatest_depth;
        let depth = hit.w.fixed(full, full, DEPTH_BITS).to_i128();
        let one = BigInt::from(1);
        let (object, gradient) = &self.objects[id];
        let normal = match hit.number {
            FACE_NEAR_END => [0.0, 0.0, -1.0],
            number if number >= FACE_PLANE => {
                let plane = &object.planes[usize::from(number - FACE_PLANE)];
                scaled([&plane.a, &plane.b, &plane.c])
            }
            _ => {
                // Twice the pixel's place, so that the middle of an odd screen is whole.
                let place = [(x, self.scene.width), (y, self.scene.height)]
                    .map(|(at, size)| 2 * at - i64::from(size));
                gradient.at(place, &hit.w.fixed(&one, &one, POINT_BITS))
            }
        };
        Some(TruePixel {
            depth: depth.expect("visible depths lie in the depth word"),
            id,
            number: hit.number,
            normal,
        })
    }
}

struct Gradient {
    rows: [[BigInt; 4]; 3],
    full: BigRational,
    is_perspective: bool,
}

impl Gradient {
    fn new(object: &FramedQuadric, scene: &FramedScene) -> Gradient {
        let [x, y, z, _] = object.quadric.clone().primitive().matrix();
        let (full, is_perspective) = match &scene.projection {
            Projection::Perspective { distance } => (distance, true),
            Projection::Orthographic { half_depth } => (half_depth, false),
        };
        Gradient {
            rows: [x, y, z].map(|row| row.map(|value| value.to_integer())),
            full: full.clone(),
            is_perspective,
        }
    }

    /// The direction at twice a place of the screen plane and a depth in units of the full depth, with [`POINT_BITS`]
    /// fraction bits.
    fn at(&self, place: [i64; 2], depth: &BigInt) -> [f64; 3] {
        let one = BigInt::from(1) << POINT_BITS;
        // Homogeneous camera coordinates times 2 and the denominator of the full depth.
        let [x, y] = place.map(|at| BigInt::from(at) * self.full.denom() * &one);
        let z = self.full.numer() * depth * 2;
        let shrunk = if self.is_perspective {
            &one - depth
        } else {
            one
        };
        let t = shrunk * self.full.denom() * 2;
        let normal = image(&self.rows, &[x, y, z, t]);
        scaled(normal.map(BigRational::from_integer).each_ref())
    }
}
