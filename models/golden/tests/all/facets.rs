//! Flat and curved facets: neighbours share every pixel of their common side exactly once; depth and normals against
//! exact values.

use crate::common::*;
use imogene_algebra::rational::{fraction, integer, power_of_two, round_half_up};
use imogene_algebra::whole::primitive;
use imogene_golden::object::curved_facet::CurvedFacetWords;
use imogene_golden::object::facet::{Corner, FACE_FACET, FacetError, FacetWords, SUBPIXEL};
use imogene_golden::object::paraboloid::{depth_guard, normal_guard, plane_guard};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

const F: Format = Format::BASE;
const SIDE: i64 = 26;
const ONE: i64 = 1 << SUBPIXEL;
const SCREEN: ScreenBox = ScreenBox::of([0, SIDE - 1], [0, SIDE - 1]);

fn corner(x: i64, y: i64, z: i64) -> Corner {
    Corner {
        x,
        y,
        z: integer(z),
        normal: [x as i16, -7 * y as i16, -20_000],
    }
}

/// In units of `2^-guard`, rounded, half a unit of the result added.
fn second_degree(exact: &Exact, guard: u32) -> Quadratic {
    let word = |v: &BigRational| round_half_up(&(v * power_of_two(guard))).to_i128().unwrap();
    let [a, b, c, d, e, f] = exact.each_ref().map(word);
    Quadratic::new([a, b, c, d, e, f + (1 << guard >> 1)])
}

/// The word of a side: its sign is that of the exact expression, not negative on the facet.
fn side(exact: &Exact) -> Quadratic {
    second_degree(&primitive(exact.clone()), 0)
}

/// The same side for the neighbour: `-q - 1` is not negative exactly where q is negative, so no pixel is in both or in
/// neither.
fn other_side(q: &Quadratic) -> Quadratic {
    Quadratic::new([-q.a, -q.b, -q.c, -q.d, -q.e, -q.f - 1])
}

fn flat(words: &FacetWords, mut visit: impl FnMut(i64, i64, ObjectPixel)) {
    for (x, y) in square(SIDE) {
        visit(x, y, words.at(x, y, &F));
    }
}

fn present(pixel: &ObjectPixel) -> bool {
    pixel.zf != F.z_max()
}

/// Corners of a net of 6 x 6 meshes over the zone and beyond: inner ones moved by less than a quarter of a mesh, every
/// second time onto a pixel: then no triangle of a mesh turns over, whichever diagonal divides it.
fn net(moves: &[(i64, i64, bool)]) -> Vec<Vec<Corner>> {
    let mesh = 5 * ONE;
    let is_inner = |i: i64| (1..6).contains(&i);
    let at = |row: i64, column: i64| {
        let (dx, dy, on_pixel) = moves[(row * 7 + column) as usize];
        let moves = is_inner(row) && is_inner(column);
        let place = |i: i64, d: i64| {
            let v = (i - 1) * mesh + mesh / 2 + if moves { d } else { 0 };
            let nearest = (v + ONE / 2).div_euclid(ONE) * ONE;
            if on_pixel { nearest } else { v }
        };
        let z = 100 * row - 31 * column * column;
        corner(place(column, dx), place(row, dy), z)
    };
    let line = |row| (0..7).map(|column| at(row, column)).collect();
    (0..7).map(line).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Every pixel of the zone is in exactly one triangle of a net, whichever way its corners are turned and listed.
    #[test]
    fn triangles_of_a_net_cover_every_pixel_once(
        // Half a pixel more to get onto a pixel, and a quarter of a mesh is 20.
        moves in prop::collection::vec((-11i64..=11, -11i64..=11, any::<bool>()), 49),
        diagonals in prop::collection::vec((any::<bool>(), 0usize..3, any::<bool>()), 36)
    ) {
        let net = net(&moves);
        let mut count = vec![0; (SIDE * SIDE) as usize];
        for row in 0..6 {
            for column in 0..6 {
                let [a, b, c, d] = [(0, 0), (0, 1), (1, 1), (1, 0)]
                    .map(|(r, s)| net[row + r][column + s].clone());
                let (falling, rotation, turned) = diagonals[row * 6 + column];
                let pair = if falling {
                    [[a.clone(), b, c.clone()], [a, c, d]]
                } else {
                    [[a, b.clone(), d.clone()], [b, c, d]]
                };
                for mut triangle in pair {
                    triangle.rotate_left(rotation);
                    if turned {
                        triangle.reverse();
                    }
                    let words = FacetWords::new(&triangle, SCREEN, &F).unwrap();
                    flat(&words, |x, y, pixel| count[(y * SIDE + x) as usize] += i32::from(present(&pixel)));
                }
            }
        }
        prop_assert_eq!(count, vec![1; (SIDE * SIDE) as usize]);
    }

    /// The mask is the exact set of pixel centres of the closed triangle, less some of its border; depth and normals
    /// are the exact interpolation but for the rounding of the words.
    #[test]
    fn a_triangle_is_the_exact_one(
        places in [(-99i64..500, -99i64..500, -900_000i64..900_000), (-99i64..500, -99i64..500, -900_000i64..900_000), (-99i64..500, -99i64..500, -900_000i64..900_000)],
        normals in [[-32_000i16..=32_000, -32_000..=32_000, -32_000..=32_000], [-32_000i16..=32_000, -32_000..=32_000, -32_000..=32_000], [-32_000i16..=32_000, -32_000..=32_000, -32_000..=32_000]]
    ) {
        let corners: [Corner; 3] = std::array::from_fn(|i| Corner {
            x: places[i].0,
            y: places[i].1,
            z: integer(places[i].2),
            normal: normals[i],
        });
        let area = cross(&corners[0], (corners[1].x, corners[1].y), (corners[2].x, corners[2].y));
        prop_assume!(area != 0);
        let words = FacetWords::new(&corners, SCREEN, &F).unwrap();
        let mut wrong = None;
        flat(&words, |x, y, pixel| {
            // Twice the areas of the parts: barycentric coordinates over `area`.
            let at = (x * ONE, y * ONE);
            let part = |i: usize| {
                let (p, q) = (&corners[(i + 1) % 3], &corners[(i + 2) % 3]);
                cross(p, (q.x, q.y), at) * area.signum()
            };
            let parts = [part(0), part(1), part(2)];
            let open = parts.iter().all(|&v| v > 0);
            let closed = parts.iter().all(|&v| v >= 0);
            let mut right = present(&pixel) == open || (closed && !open);
            if present(&pixel) {
                let mean = |w: [BigRational; 3]| -> BigRational {
                    let sum: BigRational = parts.iter().zip(w).map(|(&p, w)| integer(p) * w).sum();
                    sum / integer(area.abs())
                };
                let rounding = |guard: u32| linear_bound(x, y, guard);
                let z = mean(std::array::from_fn(|i| corners[i].z.clone()));
                right &= (integer(pixel.zf) - z).abs() <= rounding(plane_guard(&F));
                right &= pixel.number == FACE_FACET && pixel.zb == pixel.zf;
                for (k, &component) in pixel.normal.iter().enumerate() {
                    let n = mean(std::array::from_fn(|i| integer(normals[i][k].into())));
                    right &= (integer(component.into()) - n).abs() <= rounding(8);
                }
            }
            if !right {
                wrong = Some((x, y, pixel));
            }
        });
        prop_assert_eq!(wrong, None);
    }

    /// The cells that three conics cut the screen into have every pixel once, those on the conics too.
    #[test]
    fn cells_of_conics_cover_every_pixel_once(
        conics in [[-3i64..=3, -3..=3, -2..=2, -40..=40, -40..=40, -300..=300], [-3i64..=3, -3..=3, -2..=2, -40..=40, -40..=40, -300..=300], [-3i64..=3, -3..=3, -2..=2, -40..=40, -40..=40, -300..=300]],
        denominator in 1i64..9
    ) {
        let exact: [Exact; 3] = conics.map(|c| c.map(|v| fraction(v, denominator)));
        let sides = exact.each_ref().map(side);
        let depth = [fraction(3, 7), fraction(-2, 9), integer(1), integer(-90), integer(50), integer(1000)];
        let normal = [fraction(1, 5), integer(0), integer(0), integer(30), integer(-7), integer(-9000)];
        let mut count = vec![0; (SIDE * SIDE) as usize];
        let mut wrong = None;
        for cell in 0..8 {
            let within = |i: usize| cell >> i & 1 == 0;
            let chosen = (0..3).map(|i| if within(i) { sides[i] } else { other_side(&sides[i]) });
            let words = CurvedFacetWords {
                screen_box: SCREEN,
                sides: chosen.collect(),
                depth: second_degree(&depth, depth_guard(&F)),
                normal: [second_degree(&normal, normal_guard(&F)); 3],
            };
            for (x, y) in square(SIDE) {
                let pixel = words.at(x, y, &F);
                let inside = (0..3).all(|i| within(i) != value_at(&exact[i], x, y).is_negative());
                let mut right = present(&pixel) == inside;
                if inside {
                    count[(y * SIDE + x) as usize] += 1;
                    let bound = rounding_bound(x, y, depth_guard(&F));
                    right &= (integer(pixel.zf) - value_at(&depth, x, y)).abs() <= bound;
                    right &= (integer(pixel.normal[1].into()) - value_at(&normal, x, y)).abs() <= bound;
                }
                if !right {
                    wrong = Some((cell, x, y, pixel));
                }
            }
        }
        prop_assert_eq!(wrong, None);
        prop_assert_eq!(count, vec![1; (SIDE * SIDE) as usize]);
    }
}

fn cross(p: &Corner, q: (i64, i64), r: (i64, i64)) -> i64 {
    (q.0 - p.x) * (r.1 - p.y) - (r.0 - p.x) * (q.1 - p.y)
}

/// A fan of eight around a pixel, all sides through pixel centres: the worst case for ties.
#[test]
fn a_fan_around_a_pixel_has_it_once() {
    let columns = [4, 12, 20, 20, 20, 12, 4, 4];
    let lines = [4, 4, 4, 12, 20, 20, 20, 12];
    let at = |x: i64, y: i64| corner(x * ONE, y * ONE, 0);
    let around = |i: usize| at(columns[i % 8], lines[i % 8]);
    let mut count = vec![0; (SIDE * SIDE) as usize];
    for i in 0..8 {
        let triangle = [at(12, 12), around(i), around(i + 1)];
        let words = FacetWords::new(&triangle, SCREEN, &F).unwrap();
        flat(&words, |x, y, pixel| {
            count[(y * SIDE + x) as usize] += i32::from(present(&pixel));
        });
    }
    for ((x, y), count) in square(SIDE).zip(count) {
        // Of the square's border, the near columns and lines belong to it.
        let expected = (4..20).contains(&x) && (4..20).contains(&y);
        assert_eq!(count, i32::from(expected), "({x}, {y})");
    }
}

#[test]
fn a_square_is_its_two_triangles() {
    let corners =
        [(3, 2), (20, 4), (23, 19), (6, 17)].map(|(x, y)| corner(x * ONE, y * ONE, 40 * x - 7 * y));
    let draw = |list: &[Corner]| {
        let mut picture = Vec::new();
        let words = FacetWords::new(list, SCREEN, &F).unwrap();
        flat(&words, |_, _, pixel| picture.push(pixel));
        picture
    };
    let [a, b, c, d] = corners.clone();
    let whole = draw(&corners);
    let halves = [draw(&[a.clone(), b, c.clone()]), draw(&[a, c, d])];
    for (i, pixel) in whole.iter().enumerate() {
        let parts: Vec<_> = halves.iter().map(|h| h[i]).filter(present).collect();
        assert_eq!(parts.len(), usize::from(present(pixel)), "pixel {i}");
        let are_equal = parts.iter().all(|p| p == pixel);
        assert!(are_equal, "pixel {i}: {pixel:?} and {parts:?}");
    }
}

#[test]
fn corners_that_are_no_facet_are_refused() {
    let at = |x, y, z| corner(x * ONE, y * ONE, z);
    let new = |corners: &[Corner]| FacetWords::new(corners, SCREEN, &F).unwrap_err();
    assert_eq!(new(&[at(0, 0, 0), at(1, 1, 0)]), FacetError::Corners(2));
    let row = [at(0, 0, 0), at(1, 1, 0), at(2, 2, 0)];
    assert_eq!(new(&row), FacetError::NotConvex);
    let bow = [at(0, 0, 0), at(5, 5, 0), at(5, 0, 0), at(0, 5, 0)];
    assert_eq!(new(&bow), FacetError::NotConvex);
    let bent = [at(0, 0, 0), at(5, 0, 0), at(5, 5, 1), at(0, 5, 0)];
    assert_eq!(new(&bent), FacetError::NotLinear("plane"));
    let mut long = [at(0, 0, 0), at(5, 0, 0), at(5, 5, 0)];
    long[1].normal[2] = i16::MIN;
    assert_eq!(new(&long), FacetError::Component(i16::MIN));
    let why = new(&bent).to_string();
    assert!(why.contains("two facets of three corners"));
}
