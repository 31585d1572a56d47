//! Tetrahedral patches: their Bernstein form, and their joints.

use super::*;
use imogene_algebra::rational::{fraction, from_decimal};
use imogene_testkit::Random;

type Point = [BigRational; 3];

fn random_rational(random: &mut Random) -> BigRational {
    let numerator = (random.signed() * 1000.0) as i64;
    fraction(numerator, (random.signed().abs() * 50.0) as i64 + 1)
}

/// The implicit quadric takes at every point the value of the Bernstein form at its barycentric coordinates.
#[test]
fn tetrahedral_patches_are_their_bernstein_form() {
    let mut random = Random(0x7e7a);
    for _ in 0..40 {
        let decimal = |random: &mut Random| (random.signed() * 1000.0).round() / 100.0;
        let corners: [[f64; 3]; 4] =
            std::array::from_fn(|_| std::array::from_fn(|_| decimal(&mut random)));
        let weights: [f64; 10] = std::array::from_fn(|_| decimal(&mut random));
        let shape = Shape::TetrahedronPatch {
            corners: corners.into(),
            weights: weights.into(),
        };
        let quadric = Quadric::from_shape(&shape).expect("a volume");
        for _ in 0..10 {
            let mut b: Vec<BigRational> = (0..3).map(|_| random_rational(&mut random)).collect();
            b.push(integer(1) - &b[0] - &b[1] - &b[2]);
            let point: Point = std::array::from_fn(|k| {
                let terms = corners.iter().zip(&b);
                terms.map(|(c, b)| from_decimal(c[k]) * b).sum()
            });
            let w = weights.map(from_decimal);
            let mut value = BigRational::zero();
            for i in 0..4 {
                value += &w[i] * &b[i] * &b[i];
            }
            let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
            for (w, (i, j)) in w[4..].iter().zip(pairs) {
                value += integer(2) * w * &b[i] * &b[j];
            }
            assert_eq!(quadric.value_at(&point[0], &point[1], &point[2]), value);
        }
    }
}

/// Two tetrahedra with a common face, opposite corner 1 of each and with equal weights, and other weights away from it.
fn pair(random: &mut Random, orthographic: bool) -> SceneFile {
    let mut file = file("tetrahedra");
    file.objects.truncate(2);
    let mut jog = |most: f64| (random.signed() * most * 1000.0).round() / 1000.0;
    // Corners 0, 2, 3 are common; the weights of them alone stand at 0, 2, 3, 5, 6, 9.
    let common: [[f64; 3]; 3] = [
        [jog(0.3), jog(0.3), jog(0.3)],
        [jog(0.3), 2.0 + jog(0.3), jog(0.3)],
        [jog(0.3), jog(0.3), 2.0 + jog(0.3)],
    ];
    let mut shared = [-1.2, 0.0, 2.8, 2.8, 0.0, -1.2, -1.2, 0.0, 0.0, -1.2];
    for k in [2, 3, 5, 6, 9] {
        shared[k] += jog(0.3);
    }
    for (object, side) in file.objects.iter_mut().zip([2.0, -2.0]) {
        let mut weights = shared;
        for (k, middle) in [(1, 3.0), (4, -1.2), (7, -1.2), (8, -1.2)] {
            weights[k] = middle + jog(0.3);
        }
        object.shape = Shape::TetrahedronPatch {
            corners: [common[0], [side, jog(0.3), jog(0.3)], common[1], common[2]].into(),
            weights: weights.into(),
        };
    }
    if orthographic {
        file.camera = parallel_view([jog(4.0), 3.0, 9.0]);
    }
    file
}

/// Pixels of the exact picture within two pixels of both objects 0 and 1, and not at the outline, where a joint ends.
fn joint(pictures: &Pictures) -> impl Iterator<Item = usize> {
    let id = |i| pictures.exact_face(i).0;
    let near = move |i, object| pictures.around(i, 2).any(|i| id(i) == object);
    let inside = move |i| pictures.around(i, 1).all(|i| id(i) >= 0);
    (0..pictures.exact.len()).filter(move |&i| near(i, 0) && near(i, 1) && inside(i))
}

/// The common face has one depth expression, kept on opposite sides, and no pixel of the joint is left out. The two
/// surfaces cross the face in one curve; a 16-bit depth word without guard bits may round both of them to the removed
/// side of it, at one pixel in a thousand.
#[test]
fn tetrahedra_join_without_a_crack() {
    let mut random = Random(0x10ad);
    let (mut joints, mut holes) = ([0; 2], [0; 2]);
    for case in 0..80 {
        let file = pair(&mut random, case % 2 == 1);
        let format = Format::new([16, 24, 28, 32][case / 2 % 4]).unwrap();
        let pictures = Pictures::of_file(&file, (160, 120), format);
        let face = |k: usize| pictures.prepared.objects[k].quadric().unwrap().words.planes[1];
        let (one, other) = (face(0), face(1));
        assert_eq!(one.depth, other.depth, "case {case}");
        let opposite = [one.kind, other.kind];
        let sides = [PlaneKind::Front, PlaneKind::Back];
        assert!(
            sides.iter().all(|side| opposite.contains(side)),
            "{opposite:?}"
        );
        let short = usize::from(format.depth == 16);
        for i in joint(&pictures) {
            joints[short] += 1;
            holes[short] += usize::from(pictures.golden.id[i] < 0);
        }
    }
    println!("{joints:?} pixels of joints, {holes:?} holes");
    assert!(joints[0] > 8000 && holes[0] == 0, "{joints:?} {holes:?}");
    assert!(joints[1] > 2000 && holes[1] <= 8, "{joints:?} {holes:?}");
}
