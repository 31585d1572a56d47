//! Shadow and light volumes against exact membership, and shadows against the rays to the light.

use imogene_algebra::rational::{integer, round_half_up};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::volume::{VolumeKind, VolumePlane, VolumeQuadric, VolumeWords};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_scene::Beam;
use imogene_testkit::scene_file;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use proptest::prelude::*;

/// Planes of a quadric volume: the shadow of a quadric with three cut planes needs four (the polar plane of the source,
/// and one through the source for each cut plane).
const QUADRIC_PLANES: usize = 4;
/// Planes of the shadow of a three-sided facet: its own and one through the source for each side.
const FACET_PLANES: usize = 4;
/// Planes of the shadow of a polyhedron of six faces.
const POLYHEDRON_PLANES: usize = 10;

const SIDE: i64 = 16;
const F: Format = Format::BASE;

fn words(quadric: Option<VolumeQuadric>, planes: Vec<VolumePlane>, margin: u32) -> VolumeWords {
    VolumeWords {
        kind: VolumeKind::Shadow,
        source: 0,
        screen_box: ScreenBox {
            x0: 0,
            x1: SIDE - 1,
            y0: 0,
            y1: SIDE - 1,
        },
        margin,
        quadric,
        planes,
    }
}

/// Calls `visit(x, y, z, inside)` for every pixel with each of the depths.
fn each_point(words: &VolumeWords, depths: &[i64], mut visit: impl FnMut(i64, i64, i64, bool)) {
    for &z in depths {
        for y in 0..SIDE {
            for x in 0..SIDE {
                visit(x, y, z, words.holds(x, y, z, &F));
            }
        }
    }
}

fn linear(most: i128) -> impl Strategy<Value = Linear> {
    let slope = -most..=most;
    (slope.clone(), slope, -12 * most..=12 * most).prop_map(|(a, b, c)| Linear::new(a, b, c))
}

fn plane() -> impl Strategy<Value = VolumePlane> {
    let kind = prop_oneof![
        Just(PlaneKind::None),
        Just(PlaneKind::Front),
        Just(PlaneKind::Back),
        Just(PlaneKind::Perpendicular),
    ];
    (kind, linear(20)).prop_map(|(kind, depth)| VolumePlane { kind, depth })
}

fn half_space_exact(plane: &VolumePlane, x: i64, y: i64, z: i64, margin: i64) -> bool {
    let depth = plane.depth.exact_at(x, y);
    match plane.kind {
        PlaneKind::None => true,
        PlaneKind::Front => depth <= BigInt::from(z - margin),
        PlaneKind::Back => BigInt::from(z) <= depth,
        PlaneKind::Perpendicular => !depth.is_negative(),
    }
}

/// `(z - f1)^2 <= f2`, without a root, with the margin on the near side only; from inside, `(|z - f1| + 1)^2 > f2`: the
/// volume begins at the
/// depth that the quadric is drawn at, the integer below its root.
fn quadric_exact(q: &VolumeQuadric, x: i64, y: i64, z: i64, margin: i64) -> bool {
    let f2 = q.f2.exact_at(x, y);
    let middle = q.f1.exact_at(x, y);
    // Both faces are compared in the unit of the quadric, the point downwards.
    let entered: BigInt = &middle - ((z - margin) >> q.shift);
    let left: BigInt = (z >> q.shift) - &middle;
    match q.class {
        Class::Side => {
            let before_end = !left.is_positive() || &left * &left <= f2;
            let after_start = !entered.is_positive() || &entered * &entered <= f2;
            !f2.is_negative() && before_end && after_start
        }
        Class::Front => {
            let beyond = |distance: BigInt| {
                !distance.is_negative() && (&distance + 1) * (&distance + 1) > f2
            };
            f2.is_negative() || beyond(-left) || beyond(-entered)
        }
        Class::Prism => !f2.is_negative(),
        Class::Patch => false,
    }
}

fn quadric() -> impl Strategy<Value = VolumeQuadric> {
    let class = prop_oneof![Just(Class::Side), Just(Class::Front), Just(Class::Prism)];
    let factors = (-300i128..=40, -300i128..=40, -40i128..=40, 0i128..30_000);
    (class, linear(20), factors, 0u8..=3).prop_map(|(class, f1, (a, b, c, f), shift)| {
        VolumeQuadric {
            class,
            f1,
            f2: Quadratic {
                a,
                b,
                c,
                d: i128::from(-SIDE) * a,
                e: i128::from(-SIDE) * b,
                f,
            },
            shift,
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn quadric_volume_holds_what_is_exactly_inside(
        quadric in quadric(),
        planes in prop::collection::vec(plane(), 0..=QUADRIC_PLANES),
        margin in 0u32..4,
        depths in prop::collection::vec(-300i64..300, 6)
    ) {
        let words = words(Some(quadric), planes.clone(), margin);
        let m = i64::from(margin);
        let mut wrong = None;
        each_point(&words, &depths, |x, y, z, inside| {
            let exact = quadric_exact(&quadric, x, y, z, m)
                && planes.iter().all(|p| half_space_exact(p, x, y, z, m));
            if inside != exact {
                wrong = Some((x, y, z));
            }
        });
        prop_assert_eq!(wrong, None);
    }

    #[test]
    fn polyhedral_volume_holds_what_is_exactly_inside(
        planes in prop_oneof![
            prop::collection::vec(plane(), FACET_PLANES),
            prop::collection::vec(plane(), POLYHEDRON_PLANES)
        ],
        margin in 0u32..4,
        depths in prop::collection::vec(-300i64..300, 6)
    ) {
        let words = words(None, planes.clone(), margin);
        let mut wrong = None;
        each_point(&words, &depths, |x, y, z, inside| {
            let exact = planes.iter().all(|p| half_space_exact(p, x, y, z, margin.into()));
            if inside != exact {
                wrong = Some((x, y, z));
            }
        });
        prop_assert_eq!(wrong, None);
    }
}

#[test]
fn the_background_and_what_is_outside_the_box_are_in_no_volume() {
    let mut everything = words(None, vec![], 0);
    everything.screen_box.x1 = 3;
    each_point(
        &everything,
        &[F.z_low(), 0, F.z_max() - 1],
        |x, _, _, inside| {
            assert_eq!(inside, x <= 3);
        },
    );
    each_point(&everything, &[F.z_max()], |_, _, _, inside| {
        assert!(!inside);
    });
}

type Vector = [i64; 3];

fn minus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

fn dot(a: Vector, b: Vector) -> i64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

/// Depth words per pixel of depth.
const SCALE: i64 = 4096;

/// The half-space `n . (p - through) <= 0` as the words of a plane, in an orthographic view.
fn half_space(n: Vector, through: Vector) -> VolumePlane {
    let offset = dot(n, through);
    let word = |value: i64, scale: i64, by: i64| {
        round_half_up(&(integer(value * scale) / integer(by)))
            .to_i128()
            .unwrap()
    };
    let (kind, scale, by) = match n[2].signum() {
        0 => (PlaneKind::Perpendicular, 1, -1),
        1 => (PlaneKind::Back, SCALE, -n[2]),
        _ => (PlaneKind::Front, SCALE, -n[2]),
    };
    VolumePlane {
        kind,
        depth: Linear::new(
            word(n[0], scale, by),
            word(n[1], scale, by),
            word(-offset, scale, by),
        ),
    }
}

/// The shadow of a facet from a light at a point: beyond the facet's plane, within the planes through its sides and the
/// light.
fn facet_shadow(corners: [Vector; 3], light: Vector) -> Vec<VolumePlane> {
    let normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
    let lit = dot(normal, minus(light, corners[0])).signum();
    let away = |n: Vector, sign: i64| n.map(|c| c * sign);
    let mut planes = vec![half_space(away(normal, lit), corners[0])];
    for i in 0..3 {
        let (a, b, c) = (corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]);
        let n = cross(minus(a, light), minus(b, light));
        let inner = dot(n, minus(c, light)).signum();
        planes.push(half_space(away(n, -inner), light));
    }
    planes
}

/// Does the segment from the point (x, y, z / SCALE) to the light cross the facet; none if `slack` counts of depth more
/// or less settle it neither way. Each sign is that of a plane, which rounding moves by itself.
fn facet_shades(
    corners: [Vector; 3],
    light: Vector,
    [x, y, z]: Vector,
    slack: i64,
) -> Option<bool> {
    // All in units of 1 / SCALE pixel; volumes of tetrahedra in 128 bits.
    let wide = |v: Vector| v.map(|c| i128::from(c) * i128::from(SCALE));
    let volume = |a: [i128; 3], b: [i128; 3], c: [i128; 3], d: [i128; 3]| {
        let [u, v, w]: [[i128; 3]; 3] = [b, c, d].map(|p| std::array::from_fn(|k| p[k] - a[k]));
        u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0])
    };
    let [a, b, c] = corners.map(wide);
    let light = wide(light);
    let signs = |z: i64| {
        let point = [x * SCALE, y * SCALE, z].map(i128::from);
        let ends = volume(a, b, c, point).signum() * volume(a, b, c, light).signum();
        let sides = [(a, b), (b, c), (c, a)];
        let [ab, bc, ca] = sides.map(|(from, to)| volume(light, point, from, to).signum());
        [ends, ab, bc, ca]
    };
    // They are linear in the depth.
    let (near, far) = (signs(z - slack), signs(z + slack));
    let settled = |k: usize| (near[k] == far[k] && near[k] != 0).then_some(near[k]);
    let sides: Vec<i128> = (1..4).filter_map(settled).collect();
    let differ = sides.iter().any(|sign| *sign != sides[0]);
    match settled(0) {
        Some(1) => Some(false),
        _ if differ => Some(false),
        Some(_) if sides.len() == 3 => Some(true),
        _ => None,
    }
}

fn corner() -> impl Strategy<Value = Vector> {
    (-4..SIDE + 4, -4..SIDE + 4, -10i64..10).prop_map(|(x, y, z)| [x, y, z])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Golden shadow = a ray to the light meets the facet, wherever 40 counts of depth more or less do not change it.
    #[test]
    fn facet_shadow_is_what_the_facet_hides_from_the_light(
        corners in [corner(), corner(), corner()],
        light in (-20i64..40, -20i64..40, -40i64..40).prop_map(|(x, y, z)| [x, y, z]),
        depths in prop::collection::vec(-15 * SCALE..15 * SCALE, 4)
    ) {
        let normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
        prop_assume!(dot(normal, minus(light, corners[0])) != 0);
        let planes = facet_shadow(corners, light);
        prop_assert_eq!(planes.len(), FACET_PLANES);
        let mut wrong = None;
        each_point(&words(None, planes, 1), &depths, |x, y, z, inside| {
            if facet_shades(corners, light, [x, y, z], 40).is_some_and(|shade| shade != inside) {
                wrong = Some((x, y, z));
            }
        });
        prop_assert_eq!(wrong, None);
    }

    /// The shadow of a sphere from a light at infinity: the tangent cylinder beyond the polar plane.
    #[test]
    fn sphere_shadow_is_what_the_sphere_hides_from_the_light(
        centre in (0..SIDE, 0..SIDE, -6i64..6).prop_map(|(x, y, z)| [x, y, z]),
        radius in 2i64..7,
        towards in (-5i64..=5, -5i64..=5, -5i64..=5).prop_map(|(x, y, z)| [x, y, z]),
        depths in prop::collection::vec(-20 * SCALE..20 * SCALE, 4)
    ) {
        prop_assume!(towards[0] != 0 || towards[1] != 0);
        let volume = sphere_shadow(centre, radius, towards);
        let mut wrong = None;
        each_point(&volume, &depths, |x, y, z, inside| {
            let exact = sphere_shades(centre, radius, towards, [x, y, z], 90);
            if exact.is_some_and(|shade| shade != inside) {
                wrong = Some((x, y, z));
            }
        });
        prop_assert_eq!(wrong, None);
    }
}

/// `Ks = (s'Qs) Q - (Qs)(Qs)'` for the sphere and s = (towards, 0), kept beyond the polar plane `Qs`.
fn sphere_shadow(c: Vector, radius: i64, s: Vector) -> VolumeWords {
    let length = dot(s, s);
    let across = |i: usize, j: usize| i64::from(i == j) * length - s[i] * s[j];
    // Ks = sum across_ij (p - c)_i (p - c)_j - length radius^2, with u = x - cx, v = y - cy, w = z - cz.
    let [a, b, cc] = [0, 1, 2].map(|k| integer(across(k, k)));
    let [d, e, f] = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| integer(across(i, j)));
    let k = integer(length * radius * radius);
    let scale = integer(SCALE);
    let (ku, kv) = (-&e / &cc, -&f / &cc);
    let [cx, cy, cz] = c.map(integer);
    let word = |value: BigRational| round_half_up(&value).to_i128().unwrap();
    let f1 = Linear::new(
        word(&ku * &scale),
        word(&kv * &scale),
        word((&cz - &ku * &cx - &kv * &cy) * &scale),
    );
    // f2 = ((e^2 - a c) u^2 + (f^2 - b c) v^2 + 2 (e f - d c) u v + k c) / c^2
    let square = &cc * &cc / (&scale * &scale);
    let uu = (&e * &e - &a * &cc) / &square;
    let vv = (&f * &f - &b * &cc) / &square;
    let uv = integer(2) * (&e * &f - &d * &cc) / &square;
    let one = &k * &cc / &square;
    let two = integer(2);
    let f2 = Quadratic {
        a: word(uu.clone()),
        b: word(vv.clone()),
        c: word(uv.clone()),
        d: word(-(&two * &uu * &cx + &uv * &cy)),
        e: word(-(&two * &vv * &cy + &uv * &cx)),
        f: word(&uu * &cx * &cx + &vv * &cy * &cy + &uv * &cx * &cy + one),
    };
    let quadric = VolumeQuadric {
        class: Class::Side,
        f1,
        f2,
        shift: 0,
    };
    words(Some(quadric), vec![half_space(s, c)], 1)
}

/// Does the ray from the point towards the light meet the sphere; none for a point inside it, and if `slack` counts of
/// depth more or less settle it neither way. The tangent cylinder and the polar plane are each rounded by itself.
fn sphere_shades(c: Vector, radius: i64, s: Vector, [x, y, z]: Vector, slack: i64) -> Option<bool> {
    let s = s.map(i128::from);
    let dot = |a: [i128; 3], b: [i128; 3]| (0..3).map(|k| a[k] * b[k]).sum::<i128>();
    let at = |z: i64| {
        let p = [(x - c[0]) * SCALE, (y - c[1]) * SCALE, z - c[2] * SCALE].map(i128::from);
        let outside = dot(p, p) - i128::from(radius * SCALE).pow(2);
        let along = dot(p, s);
        (outside, along, along * along - dot(s, s) * outside)
    };
    // A pixel that the cylinder only touches: the discriminant of its equation in z is zero.
    let [before, here, after] = [-1, 0, 1].map(|d| at(z + d).2);
    let (square, linear) = (before + after - 2 * here, after - before);
    let touches = linear * linear == 8 * square * here;
    let depths = || (z - slack..=z + slack).map(at);
    if touches || depths().any(|(outside, ..)| outside <= 0) {
        return None;
    }
    let misses = depths().all(|(_, along, _)| along > 0) || depths().all(|(.., meets)| meets < 0);
    let meets = depths().all(|(_, along, meets)| along < 0 && meets > 0);
    (misses || meets).then_some(meets)
}

/// The properties above are not about empty shadows: a sphere over the middle of the zone, lit from the side, shades a
/// band behind it.
#[test]
fn a_sphere_shades_a_band() {
    let volume = sphere_shadow([8, 8, 0], 4, [3, 0, -4]);
    let mut columns = Vec::new();
    each_point(&volume, &[6 * SCALE], |x, y, _, inside| {
        // The lines y = 4 and y = 12 touch the shadow.
        let exact = sphere_shades([8, 8, 0], 4, [3, 0, -4], [x, y, 6 * SCALE], 0);
        assert_eq!(exact.is_none(), y == 4 || y == 12, "({x}, {y})");
        assert_eq!(inside, exact.unwrap_or(inside), "({x}, {y})");
        if inside && y == 8 {
            columns.push(x);
        }
    });
    // The axis of the shadow is at x = 8 - 6 * 3 / 4, its half width 4 / (4/5).
    assert_eq!(columns, (0..=8).collect::<Vec<i64>>());
}

/// A triangle at 20 from the light shades one that is 1.2 times as large at 24: the places with x, y of at least 1.2
/// and a sum of at most 14.4, of which there are 11 + 10 + .. + 1.
#[test]
fn a_facet_shades_a_triangle() {
    let (corners, light) = ([[2, 2, 0], [12, 2, 0], [2, 12, 0]], [6, 6, -20]);
    let volume = words(None, facet_shadow(corners, light), 1);
    let mut shaded = 0;
    each_point(&volume, &[4 * SCALE], |x, y, z, inside| {
        let exact = facet_shades(corners, light, [x, y, z], 40);
        assert_eq!(exact, Some(inside), "({x}, {y})");
        assert_eq!(inside, x >= 2 && y >= 2 && x + y <= 14, "({x}, {y})");
        shaded += u32::from(inside);
    });
    assert_eq!(shaded, 66);
}

/// The words of a scene's volumes fit their registers once they are as those hold them, and give every pixel its value;
/// moved to the screen's corner, some of the 32-bit format are longer than that.
#[test]
fn words_of_volumes_are_shown_as_registers_hold_them() {
    let mut file = scene_file("orthographic");
    for light in &mut file.lights {
        light.shadows |= !matches!(light.beam, Beam::Spot { .. });
    }
    let format = Format::new(32).expect("a format");
    let framed = file.frame(file.image.width, file.image.height);
    let prepared = prepare(&framed.expect("a valid size"), format).expect("fits");
    let (linear, quadratic) = (format.pe1_width(), format.pe2_width());
    let mut longer = 0;
    for volume in &prepared.volumes {
        let words = volume.words.wrapped(&format);
        longer += usize::from(serde_json::to_value(&volume.words).is_err());
        assert_eq!(words.wrapped(&format), words);
        serde_json::to_value(&words).expect("no word is longer than JSON takes");
        let b = words.screen_box;
        let places = [(b.x0, b.y0), (b.x1, b.y0), (b.x0, b.y1), (b.x1, b.y1)];
        for (x, y) in places {
            if let (Some(held), Some(q)) = (&words.quadric, &volume.words.quadric) {
                assert_eq!(
                    held.f1.wrapped_at(x, y, linear),
                    q.f1.wrapped_at(x, y, linear)
                );
                assert_eq!(
                    held.f2.wrapped_at(x, y, quadratic),
                    q.f2.wrapped_at(x, y, quadratic)
                );
            }
            for (held, plane) in words.planes.iter().zip(&volume.words.planes) {
                let at = |l: &Linear| l.wrapped_at(x, y, format.plane);
                assert_eq!(at(&held.depth), at(&plane.depth));
            }
        }
    }
    println!(
        "{longer} of {} volumes have longer words",
        prepared.volumes.len()
    );
    assert!(longer > 0);
}
