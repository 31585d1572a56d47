//! Objects as a line of sight meets them: each in a frame in which its quadric has small whole coefficients.
//!
//! The parameter of a line is the same in every frame, so hits of different objects compare. The frame of a
//! tetrahedral patch is barycentric: its weights are its matrix, its faces are where a coordinate is zero.

use crate::camera::{Affine, Sight};
use crate::facet::{Triangle, triangles};
use crate::interval::{Interval, about_all};
use crate::transform::{Matrix, Vector, apply, diagonal, inverse, placement, times};
use imogene_algebra::rational::{from_decimal, integer};
use imogene_scene::{Object, Processor, Shape, Surface};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// A homogeneous vector in whole numbers.
pub type Whole = [BigInt; 4];

/// An object along the lines of sight of a picture, or a facet of one.
#[derive(Clone, Debug)]
pub enum Body {
    /// A quadric bounded by planes, or planes alone.
    Cut(Box<CutBody>),
    /// A flat facet of a mesh.
    Facet(Box<Triangle>),
}

/// A quadric bounded by planes.
#[derive(Clone, Debug)]
pub struct CutBody {
    /// Volume or surface.
    pub surface: Surface,
    /// Whether lines of sight meet in the eye.
    pub perspective: bool,
    /// Exactly.
    pub exact: Lines<BigInt>,
    /// In intervals.
    pub quick: Lines<Interval>,
    /// From scene coordinates to its own.
    pub frame: [[Interval; 4]; 4],
    /// Number of the face of each plane; those of the quadric are 0 and 1, the near end is 15.
    pub numbers: Vec<u8>,
}

/// Lines of sight in the frame of an object, and the object; inside where nothing is positive.
#[derive(Clone, Debug)]
pub struct Lines<T> {
    /// Factors of X, Y and 1 of the beginning of a line.
    pub from: [[T; 4]; 3],
    /// The same of its direction.
    pub along: [[T; 4]; 3],
    /// The matrix of the quadric; nothing for planes alone.
    pub form: Option<[[T; 4]; 4]>,
    /// The planes.
    pub planes: Vec<[T; 4]>,
}

impl Body {
    /// The bodies of an object of a scene that was read and checked: one, or the facets of a mesh.
    pub fn of(object: &Object, sight: &Sight) -> Vec<Body> {
        match &object.shape {
            Shape::Mesh(mesh) => {
                let facets = triangles(mesh, &placement(&object.place), sight).into_iter();
                facets.map(|one| Body::Facet(Box::new(one))).collect()
            }
            _ => vec![Body::Cut(Box::new(CutBody::new(object, sight)))],
        }
    }
}

impl CutBody {
    fn new(object: &Object, sight: &Sight) -> CutBody {
        let (frame, form, planes) = canonical(object);
        let from_scene = inverse(&placement(&object.place)).expect("checked: no scale is zero");
        let to_own = times(&frame, &from_scene);
        let own = |affine: &Affine| affine.each_ref().map(|v| apply(&to_own, v));
        let (from, along) = (own(&sight.from), own(&sight.along));
        let quick = Lines {
            from: from.each_ref().map(about_all),
            along: along.each_ref().map(about_all),
            form: form.as_ref().map(|m| m.each_ref().map(about_all)),
            planes: planes.iter().map(about_all).collect(),
        };
        // Beginning and direction have one common factor, which leaves the parameter as it is.
        let ([x, y, start], [u, v, ahead]) = (&from, &along);
        let [x, y, start, u, v, ahead] = whole([x, y, start, u, v, ahead]);
        let exact = Lines {
            from: [x, y, start],
            along: [u, v, ahead],
            form: form.map(|form| whole(form.each_ref())),
            planes: planes.iter().flat_map(|plane| whole([plane])).collect(),
        };
        // Of the cylinder processor's two discs only the front one is seen, and it has the number 2.
        let discs = matches!(object.drawn_by(), Some(Processor::Paraboloid));
        let number = |k| if discs { 2 } else { 2 + k };
        CutBody {
            frame: to_own.each_ref().map(about_all),
            surface: object.mode,
            perspective: sight.perspective,
            numbers: (0..planes.len() as u8).map(number).collect(),
            exact,
            quick,
        }
    }
}

/// From local coordinates to a frame of an object's own, and its quadric and planes there.
type Canonical = (Matrix, Option<Matrix>, Vec<Vector>);

fn canonical(object: &Object) -> Canonical {
    if let Shape::TetrahedronPatch { corners, weights } = &object.shape {
        return tetrahedron(corners, weights);
    }
    let (radii, form) = form(&object.shape);
    let radii = radii.map(from_decimal);
    let plane = |cut: &imogene_scene::Cut| {
        let [normal, point] = [cut.normal, cut.point].map(|v| v.map(from_decimal));
        let constant: BigRational = (0..3).map(|k| -&normal[k] * &point[k]).sum();
        let [x, y, z] = [0, 1, 2].map(|k| &normal[k] * &radii[k]);
        [x, y, z, constant]
    };
    let frame = diagonal(radii.each_ref().map(BigRational::recip));
    (frame, form, object.cuts.iter().map(plane).collect())
}

/// The radii that make the quadric of a family canonical, and its matrix; no matrix for a polyhedron.
fn form(shape: &Shape) -> ([f64; 3], Option<Matrix>) {
    let none = [0, 0, 0];
    let (radii, form) = match *shape {
        Shape::Ellipsoid(radii) => (radii, twice([1, 1, 1], none, -1)),
        Shape::Sphere { radius } => ([radius; 3], twice([1, 1, 1], none, -1)),
        Shape::EllipticCylinder([a, c]) => ([a, 1.0, c], twice([1, 0, 1], none, -1)),
        Shape::HyperbolicCylinder([a, c]) => ([a, 1.0, c], twice([1, 0, -1], none, -1)),
        Shape::ParabolicCylinder([a, c]) => ([a, 1.0, c], twice([1, 0, 0], [0, 0, -1], 0)),
        Shape::Cone(radii) => (radii, twice([1, -1, 1], none, 0)),
        Shape::HyperboloidOneSheet(radii) => (radii, twice([1, -1, 1], none, -1)),
        Shape::HyperboloidTwoSheets(radii) => (radii, twice([1, -1, 1], none, 1)),
        Shape::EllipticParaboloid(radii) => (radii, twice([1, 0, 1], [0, -1, 0], 0)),
        Shape::HyperbolicParaboloid(radii) => (radii, twice([1, 0, -1], [0, -1, 0], 0)),
        Shape::Quadric { coefficients } => ([1.0; 3], symmetric(coefficients.map(from_decimal))),
        Shape::Polyhedron | Shape::Mesh(_) | Shape::TetrahedronPatch { .. } => {
            return ([1.0; 3], None);
        }
    };
    (radii, Some(form))
}

/// Twice the canonical quadric: squares of x, y, z, the linear term of y or of z, and the constant.
fn twice([a, b, c]: [i64; 3], [g, h, i]: [i64; 3], constant: i64) -> Matrix {
    let numbers = [2 * a, 2 * b, 2 * c, 0, 0, 0, g, h, i, 2 * constant];
    symmetric(numbers.map(integer))
}

/// The symmetric matrix of ten numbers in the order of the coefficients of a quadric.
fn symmetric(numbers: [BigRational; 10]) -> Matrix {
    let [a, b, c, d, e, f, g, h, i, j] = &numbers;
    let rows = [[a, d, e, g], [d, b, f, h], [e, f, c, i], [g, h, i, j]];
    rows.map(|row| row.map(BigRational::clone))
}

/// The barycentric frame: the corners are the unit vectors.
fn tetrahedron(corners: &[[f64; 3]; 4], weights: &[f64; 10]) -> Canonical {
    let rows: Matrix = std::array::from_fn(|row| {
        std::array::from_fn(|corner| match row {
            3 => BigRational::one(),
            _ => from_decimal(corners[corner][row]),
        })
    });
    // Of the corners, then of the edges 01, 02, 03, 12, 13 and 23.
    let order = [0, 1, 2, 4, 5, 7, 6, 8, 9, 3];
    let form = symmetric(order.map(|k| from_decimal(weights[k])));
    // Coordinate i is not negative on the inner side of the face opposite corner i.
    let face = |i: usize| std::array::from_fn(|k| integer(-i64::from(k == i)));
    let frame = inverse(&rows).expect("checked: the corners are not in a plane");
    (frame, Some(form), (0..4).map(face).collect())
}

/// Vectors times one factor, which makes all their numbers whole and leaves them no common divisor.
fn whole<const N: usize>(vectors: [&Vector; N]) -> [Whole; N] {
    let all = || vectors.iter().copied().flatten();
    let unit = all().fold(BigInt::one(), |lcm, v| lcm.lcm(v.denom()));
    let scaled = |v: &BigRational| v.numer() * (&unit / v.denom());
    let divisor = all().fold(BigInt::zero(), |gcd, v| gcd.gcd(&scaled(v)));
    // All may be zero.
    let divisor = divisor.max(BigInt::one());
    vectors.map(|vector| vector.each_ref().map(|v| scaled(v) / &divisor))
}
