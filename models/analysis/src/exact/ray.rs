//! One object along one line of sight, in exact integers.
//!
//! The ray parameter `w` grows with the depth and is the same in both projections: `z_p = full * (1 + w)`, visible for
//! -2 <= w < 0. In perspective `w = -1/t` for the point `eye + t (pixel - eye)`; in an orthographic view `z =
//! half_depth (1 + w)`.

use super::number::{Ball, Number, SurdReal, exponent, order};
use imogene_algebra::matrix::{Matrix4, symmetric};
use imogene_algebra::whole::{common_denominator, common_divisor};
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE};
use imogene_scene::{FramedQuadric, FramedScene, Projection, Surface};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// The first point of an object along a ray.
#[derive(Clone, Debug)]
pub struct Hit {
    /// Ray parameter.
    pub w: SurdReal,
    /// Number of the face that is met, numbered as in the hardware.
    pub number: u8,
    /// Index of the facet of a mesh; 0 for any other object.
    pub part: usize,
    /// It is the back of an object that a solid takes away, whose normal is turned.
    pub is_back: bool,
}

impl Hit {
    pub(super) fn new(w: SurdReal, number: u8) -> Hit {
        Hit {
            w,
            number,
            part: 0,
            is_back: false,
        }
    }
}

/// An object's equation along the rays of a screen: polynomials in pixel column and line with integer coefficients.
#[derive(Clone, Debug)]
pub struct RayObject {
    pub(crate) surface: Surface,
    /// Factors of w^2, w and 1, each `a x^2 + b y^2 + c xy + d x + e y + f`, over a common positive denominator.
    pub(crate) along: [[BigInt; 6]; 3],
    /// The same, divided by a power of two, near enough to tell most of the pixels at which there is no root.
    near: [[Ball; 6]; 3],
    /// Per plane the factors of w and 1, each `a x + b y + c`; kept where their sum is not positive.
    pub(crate) planes: Vec<[[BigInt; 3]; 2]>,
}

/// A homogeneous camera coordinate of a point of the ray as a first-degree expression in (x, y).
pub(super) type Affine = [BigInt; 3];

impl RayObject {
    /// Sets up the rays of a scene's screen.
    pub fn new(object: &FramedQuadric, scene: &FramedScene) -> RayObject {
        let (constant, slope) = ray_points(scene);
        let (coefficients, _) = common_denominator(object.quadric.coefficients());
        let matrix = symmetric(coefficients.each_ref());
        let along = [
            bilinear(&matrix, &slope, &slope),
            bilinear(&matrix, &constant, &slope).map(|c| c * 2),
            bilinear(&matrix, &constant, &constant),
        ];
        let planes = object.planes.iter().map(|p| {
            let (factors, _) = common_denominator(p.coefficients());
            coprime([dot(&factors, &slope), dot(&factors, &constant)])
        });
        let along = coprime(along);
        let exponent = exponent(along.iter().flatten());
        let near = |p: &[BigInt; 6]| p.each_ref().map(|c| Ball::scaled(c, exponent));
        RayObject {
            surface: object.surface,
            near: along.each_ref().map(near),
            along,
            planes: planes.collect(),
        }
    }

    pub(super) fn polynomial(&self, x: i64, y: i64) -> [BigInt; 3] {
        self.along.each_ref().map(|p| second_degree(p, x, y))
    }

    /// True only if the line of sight never meets the quadric, nor is within it.
    fn is_missed(&self, x: i64, y: i64) -> bool {
        let powers = [x * x, y * y, x * y, x, y, 1].map(|power| Ball::new(power as f64, 0.0));
        let [a, b, c] = self.near.map(|p| {
            let terms = p.iter().zip(&powers).map(|(c, power)| c.product(power));
            terms
                .reduce(|sum, term| sum.plus(&term))
                .expect("six terms")
        });
        let product = a.product(&c).product(&Ball::new(4.0, 0.0));
        let has_no_root = b.product(&b).minus(&product).known_sign() == Some(Ordering::Less);
        let is_outside = || c.known_sign() == Some(Ordering::Greater);
        has_no_root && (self.surface == Surface::Patch || is_outside())
    }

    /// The first visible point of the object at a pixel.
    pub fn first_hit(&self, x: i64, y: i64) -> Option<Hit> {
        if self.is_missed(x, y) {
            return None;
        }
        match self.surface {
            Surface::Solid => self.solid_hit(x, y),
            Surface::Patch => {
                let kept = |w: &SurdReal| is_visible(w) && self.planes_keep(w, x, y);
                first_of(&self.polynomial(x, y), kept)
            }
        }
    }

    pub(super) fn planes_keep(&self, w: &SurdReal, x: i64, y: i64) -> bool {
        self.planes.iter().all(|plane| {
            let [slope, constant] = plane.each_ref().map(|p| first_degree(p, x, y));
            if slope.is_zero() {
                return !constant.is_positive();
            }
            // slope * w + constant <= 0
            w.cmp_ratio(&(-&constant * slope.signum()), &slope.abs()) != order(&slope)
        })
    }

    /// A solid: the planes leave an interval of the ray; the solid begins at its start if that is inside the quadric,
    /// else where the ray next enters the quadric.
    fn solid_hit(&self, x: i64, y: i64) -> Option<Hit> {
        let [low, high] = self.kept_interval(x, y)?;
        let ((start, number), (end, _)) = (&low, &high);
        let polynomial = self.polynomial(x, y);
        if at_ratio(&polynomial, start) <= Ordering::Equal {
            let w = SurdReal::ratio(start.0.clone(), start.1.clone());
            return Some(Hit::new(w, *number));
        }
        let kept = |w: &SurdReal| {
            w.cmp_ratio(&start.0, &start.1) != Ordering::Less
                && w.cmp_ratio(&end.0, &end.1) != Ordering::Greater
                && w.signum() == Ordering::Less
        };
        first_of(&polynomial, kept)
    }

    /// The start and the end of what planes, near end and far end leave of the ray, each with its face.
    pub(super) fn kept_interval(&self, x: i64, y: i64) -> Option<[End; 2]> {
        let end = |w: i32| ((BigInt::from(w), BigInt::one()), FACE_NEAR_END);
        let [mut low, mut high] = [-2, 0].map(end);
        for (i, plane) in self.planes.iter().enumerate() {
            let [slope, constant] = plane.each_ref().map(|p| first_degree(p, x, y));
            if slope.is_zero() {
                if constant.is_positive() {
                    return None;
                }
                continue;
            }
            let w = (-&constant * slope.signum(), slope.abs());
            let number = FACE_PLANE + i as u8;
            if slope.is_positive() {
                if less(&w, &high.0) {
                    high = (w, number);
                }
            } else if less(&low.0, &w) {
                low = (w, number);
            }
        }
        // The end is closed at a plane and open at infinity.
        let zero = (BigInt::zero(), BigInt::one());
        (!less(&high.0, &low.0) && less(&low.0, &zero)).then_some([low, high])
    }
}

/// Between the near and the far end.
pub(super) fn is_visible(w: &SurdReal) -> bool {
    w.cmp_ratio(&BigInt::from(-2), &BigInt::one()) != Ordering::Less && w.signum() == Ordering::Less
}

pub(super) type Ratio = (BigInt, BigInt);

/// An end of what is left of a ray, and the face that bounds it.
pub(super) type End = (Ratio, u8);

fn less(a: &Ratio, b: &Ratio) -> bool {
    &a.0 * &b.1 < &b.0 * &a.1
}

fn at_ratio([a, b, c]: &[BigInt; 3], w: &Ratio) -> Ordering {
    let value = (a * &w.0 + b * &w.1) * &w.0 + c * &w.1 * &w.1;
    value.cmp(&BigInt::zero())
}

/// The first root of `a w^2 + b w + c` that is kept. What a line of sight meets once, such as a non-planar facet, has a
/// near face alone, and is entered there.
fn first_of(polynomial: &[BigInt; 3], kept: impl Fn(&SurdReal) -> bool) -> Option<Hit> {
    let [a, b, c] = polynomial;
    let roots = match a.is_zero() && !b.is_zero() {
        true => vec![SurdReal::ratio(-c, b.clone())],
        false => ordered_roots(polynomial)?.to_vec(),
    };
    let mut faces = roots.into_iter().zip([FACE_NEAR, FACE_FAR]);
    let (w, number) = faces.find(|(w, _)| kept(w))?;
    Some(Hit::new(w, number))
}

/// The real roots of `a w^2 + b w + c` in ascending order; none if there are no two (or one double).
pub(super) fn ordered_roots([a, b, c]: &[BigInt; 3]) -> Option<[SurdReal; 2]> {
    if a.is_zero() {
        return None;
    }
    let discriminant = b * b - BigInt::from(4) * a * c;
    if discriminant.is_negative() {
        return None;
    }
    let double = BigInt::from(2) * a;
    let first = if a.is_positive() { -1 } else { 1 };
    let root = |s: i32| SurdReal::new(-b, s, discriminant.clone(), double.clone());
    Some([root(first), root(-first)])
}

/// Homogeneous points of the ray, `constant + w * slope`, each of the four coordinates `a x + b y + c` in pixel column
/// and line, with one positive factor that makes all of them whole.
pub(super) fn ray_points(scene: &FramedScene) -> ([Affine; 4], [Affine; 4]) {
    let full = scene.projection.full();
    // Of the half of a pixel and of the depth.
    let unit: BigInt = full.denom() * 2;
    let middle = |n: u32| full.denom() * -i64::from(n);
    let zero = || [(); 3].map(|()| BigInt::zero());
    let only = |c: BigInt| [BigInt::zero(), BigInt::zero(), c];
    let column = [unit.clone(), BigInt::zero(), middle(scene.width)];
    let line = [BigInt::zero(), unit.clone(), middle(scene.height)];
    let depth = || only(full.numer() * 2);
    let (constant, slope) = match &scene.projection {
        // (eye + t direction) / t with 1/t = -w: direction (x, y, D, 0), eye (0, 0, -D, 1).
        Projection::Perspective { .. } => (zero(), only(-unit)),
        Projection::Orthographic { .. } => (only(unit), zero()),
    };
    let constant = [column, line, depth(), constant];
    (constant, [zero(), zero(), depth(), slope])
}

/// u' M v as `a x^2 + b y^2 + c xy + d x + e y + f`.
fn bilinear(matrix: &Matrix4<BigInt>, u: &[Affine; 4], v: &[Affine; 4]) -> [BigInt; 6] {
    let mut sum = [(); 6].map(|()| BigInt::zero());
    for (row, p) in matrix.iter().zip(u) {
        let q = dot(row, v);
        let product = [
            &p[0] * &q[0],
            &p[1] * &q[1],
            &p[0] * &q[1] + &p[1] * &q[0],
            &p[0] * &q[2] + &p[2] * &q[0],
            &p[1] * &q[2] + &p[2] * &q[1],
            &p[2] * &q[2],
        ];
        for (total, term) in sum.iter_mut().zip(product) {
            *total += term;
        }
    }
    sum
}

pub(super) fn dot(factors: &[BigInt; 4], point: &[Affine; 4]) -> Affine {
    std::array::from_fn(|k| factors.iter().zip(point).map(|(f, p)| f * &p[k]).sum())
}

/// Divides expressions by what all their coefficients have in common.
pub(super) fn coprime<const N: usize, const M: usize>(forms: [[BigInt; N]; M]) -> [[BigInt; N]; M] {
    let each = forms.each_ref().map(|form| common_divisor(form.each_ref()));
    let divisor = common_divisor(each.each_ref());
    if divisor.is_zero() || divisor.is_one() {
        return forms;
    }
    forms.map(|form| form.map(|c| c / &divisor))
}

/// The value of a second-degree expression at a pixel.
pub(crate) fn second_degree(p: &[BigInt; 6], x: i64, y: i64) -> BigInt {
    (&p[0] * x + &p[2] * y + &p[3]) * x + (&p[1] * y + &p[4]) * y + &p[5]
}

pub(super) fn first_degree(p: &[BigInt; 3], x: i64, y: i64) -> BigInt {
    &p[0] * x + &p[1] * y + &p[2]
}
