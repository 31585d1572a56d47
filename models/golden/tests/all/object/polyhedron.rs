use crate::common::*;
use imogene_algebra::rational::{integer, round_half_up};
use imogene_golden::object::polyhedron::*;
use imogene_golden::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE};
use imogene_golden::unit::normal::NEAR_END_NORMAL;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// A half-space `a x + b y + c z + d <= 0` in pixels and depth words.
type HalfSpace = [i64; 4];

fn value([a, b, c, d]: &HalfSpace, x: i64, y: i64, z: &BigRational) -> BigRational {
    integer(a * x + b * y + d) + integer(*c) * z
}

/// The words of a half-space, its depth coefficients rounded to integers.
fn plane_words(h: &HalfSpace, normal: [i16; 3]) -> PlaneWords {
    let [a, b, c, d] = *h;
    let kind = match c.signum() {
        0 => PlaneKind::Perpendicular,
        1 => PlaneKind::Back,
        _ => PlaneKind::Front,
    };
    let scale = if c == 0 { 1 } else { c };
    let word = |n: i64| {
        let quotient = -integer(n) / integer(scale);
        round_half_up(&quotient).to_i128().unwrap()
    };
    PlaneWords::new(kind, Linear::new(word(a), word(b), word(d)), normal)
}

fn words(spaces: &[HalfSpace]) -> PolyhedronWords {
    let plane = |(i, h): (usize, &HalfSpace)| plane_words(h, [i as i16 + 1; 3]);
    PolyhedronWords {
        screen_box: ScreenBox::of([0, SIDE - 1], [0, SIDE - 1]),
        planes: spaces.iter().enumerate().map(plane).collect(),
    }
}

/// A half-space that holds the middle of the zone at depth 0 more often than not; `c` is -1, 0 or 1, so its words
/// are exact.
fn half_space() -> impl Strategy<Value = HalfSpace> {
    let slope = -60i64..=60;
    (slope.clone(), slope, -1i64..=1, -500i64..=100)
        .prop_map(|(a, b, c, d)| [a, b, c, d - (a + b) * SIDE / 2])
}

fn inside(spaces: &[HalfSpace], x: i64, y: i64, z: i64) -> bool {
    let z = integer(z);
    spaces.iter().all(|h| !value(h, x, y, &z).is_positive())
}

fn each_pixel(
    words: &PolyhedronWords,
    format: &Format,
    mut visit: impl FnMut(i64, i64, PolyhedronPixel),
) {
    for (x, y) in pixels() {
        visit(x, y, words.faces_at(x, y, format));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// With words that are not rounded the interval is exactly the set of depths inside all half-spaces.
    #[test]
    fn interval_is_the_intersection_of_the_half_spaces(
        spaces in prop::collection::vec(half_space(), 1..=12)
    ) {
        let format = Format::BASE;
        let mut failed = None;
        each_pixel(&words(&spaces), &format, |x, y, pixel| {
            let Interval { zf, zb, nf, nb } = pixel.interval;
            let present = pixel.interval.is_present(&format);
            let on_face = |number: u8, z: i64| {
                value(&spaces[usize::from(number - FACE_PLANE)], x, y, &integer(z)).is_zero()
            };
            let face = |number: u8, z: i64, end: i64, normal: [i16; 3], cap: [i16; 3]| {
                if number == FACE_NEAR_END {
                    z == end && normal == cap
                } else {
                    on_face(number, z) && normal == [i16::from(number) - 1; 3]
                }
            };
            let right = if present {
                inside(&spaces, x, y, zf)
                    && inside(&spaces, x, y, zb)
                    && (zf == format.z_low() || !inside(&spaces, x, y, zf - 1))
                    && (zb == format.z_max() || !inside(&spaces, x, y, zb + 1))
                    && face(nf, zf, format.z_low(), pixel.front_normal, NEAR_END_NORMAL)
                    && face(nb, zb, format.z_max(), pixel.back_normal, FAR_END_NORMAL)
            } else {
                // Depths are integers here, so an empty interval has no integer inside: the planes' own depths are
                // enough to try.
                let depths = spaces.iter().filter(|h| h[2] != 0).map(|[a, b, c, d]| -c * (a * x + b * y + d));
                let interval = Interval::absent(&format);
                pixel == PolyhedronPixel { interval, front_normal: [0; 3], back_normal: [0; 3] }
                    && depths.chain([0]).all(|z| !inside(&spaces, x, y, z))
            };
            if !right && failed.is_none() {
                failed = Some((x, y, pixel));
            }
        });
        prop_assert_eq!(failed, None);
    }

    /// Any slopes: the rounding of the words moves a plane by at most (x + y + 1) / 2 counts, and nothing else is
    /// lost.
    #[test]
    fn rounded_planes_are_within_their_bound(
        spaces in prop::collection::vec(half_space(), 2..=6),
        thickness in prop::collection::vec(2i64..=19, 6)
    ) {
        let format = Format::BASE;
        let spaces = spaces.iter().zip(thickness);
        let spaces = spaces.map(|(&[a, b, c, d], t)| [7 * a + 1, 5 * b - 1, c * t, 11 * d]);
        let spaces: Vec<HalfSpace> = spaces.collect();
        let mut failed = None;
        each_pixel(&words(&spaces), &format, |x, y, pixel| {
            let ends = [format.z_low(), format.z_max()].map(integer);
            let depth = |h: &HalfSpace| value(h, x, y, &BigRational::zero()) / integer(-h[2]);
            let of = |sign: i64| spaces.iter().filter(move |h| h[2].signum() == sign).map(depth);
            let front = of(-1).fold(ends[0].clone(), BigRational::max);
            let back = of(1).fold(ends[1].clone(), BigRational::min);
            let mut upright = spaces.iter().filter(|h| h[2] == 0);
            let kept = upright.all(|h| !value(h, x, y, &BigRational::zero()).is_positive());
            let bound = BigRational::new(BigInt::from(x + y + 1), BigInt::from(2));
            let gap = &back - &front;
            let near = |word: i64, exact: &BigRational| (integer(word) - exact).abs() <= bound;
            let right = if pixel.interval.is_present(&format) {
                kept && near(pixel.interval.zf, &front)
                    && near(pixel.interval.zb, &back)
                    && gap >= -(&bound + &bound)
            } else {
                !kept || gap <= &bound + &bound
            };
            if !right && failed.is_none() {
                failed = Some((x, y, pixel));
            }
        });
        prop_assert_eq!(failed, None);
    }
}

/// A prism that is the whole line of sight everywhere, cut by the same planes, is the same solid in the quadric
/// processor.
#[test]
fn equals_a_quadric_that_is_everywhere() {
    let cube = [
        [0, 3, -1, -60],
        [2, 0, -1, -40],
        [-5, -4, 1, -30],
        [0, -9, 1, -20],
        [1, 0, 0, -15],
        [-1, -1, 0, 7],
    ];
    let polyhedron = words(&cube);
    let quadric = QuadricWords {
        class: Class::Prism,
        screen_box: polyhedron.screen_box,
        f1: Linear::default(),
        f2: Quadratic::default(),
        normal: NormalWords::default(),
        planes: polyhedron.planes.clone(),
    };
    let format = Format::BASE;
    let mut present = 0;
    each_pixel(&polyhedron, &format, |x, y, pixel| {
        let theirs = quadric.at(x, y, &format);
        let ours = (pixel.interval.zf, pixel.interval.zb, pixel.front_normal);
        let theirs = (theirs.zf, theirs.zb, theirs.normal);
        assert_eq!(ours, theirs, "pixel ({x}, {y})");
        present += u32::from(pixel.interval.is_present(&format));
    });
    assert!((60..340).contains(&present), "{present}");
}

#[test]
fn six_planes_take_nine_clocks() {
    assert_eq!([1, 6, 12].map(latency), [6, 9, 10]);
}
