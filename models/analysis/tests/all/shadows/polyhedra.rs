//! Random polyhedra: their shadows are volumes of planes alone.

use super::compare::{Tally, compare};
use super::{F, before_a_wall, source, sources};
use crate::pictures::Pictures;
use imogene_prepare::prepare;
use imogene_prepare::volume::Beginning;
use imogene_scene::{FramedObject, FramedQuadric, Plane, Quadric, Surface};
use imogene_testkit::*;
use num_rational::BigRational;
use num_traits::Signed;

fn polyhedron(name: &str, planes: &[[i64; 4]]) -> FramedObject {
    let solid = object(name, Surface::Solid, Quadric::everywhere(), planes);
    FramedObject::Polyhedron(Box::new(solid))
}

/// A box whose six sides are out of square, and with ten planes a corner less at every second of its corners.
fn random_polyhedron(random: &mut Random, name: &str, planes: usize) -> FramedObject {
    let mut whole = |most: f64| (random.signed() * most).round() as i64;
    let centre: [i64; 3] = std::array::from_fn(|_| whole(16.0));
    let mut directions = vec![];
    for axis in 0..3 {
        for side in [20, -20] {
            let mut n: [i64; 3] = std::array::from_fn(|_| whole(6.0));
            n[axis] += side;
            directions.push((n, 20 * (15 + whole(7.0))));
        }
    }
    for signs in [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]] {
        let n = signs.map(|sign| 12 * sign + whole(5.0));
        directions.push((n, 20 * (17 + whole(7.0))));
    }
    let through = |(n, distance): &([i64; 3], i64)| {
        let at: i64 = (0..3).map(|k| n[k] * centre[k]).sum();
        [n[0], n[1], n[2], -at - distance]
    };
    let list: Vec<[i64; 4]> = directions.iter().take(planes).map(through).collect();
    polyhedron(name, &list)
}

fn side(plane: &Plane, [x, y, z, w]: &[BigRational; 4]) -> BigRational {
    let [a, b, c, d] = plane.coefficients();
    a * x + b * y + c * z + d * w
}

/// No volume has a quadric; each begins at a face that sees its source, and has the planes of its object.
fn assert_planes_alone(pictures: &Pictures) {
    let (framed, prepared) = (&pictures.scene, &pictures.prepared);
    for volume in &prepared.volumes {
        let (object, Beginning::Cut(cut)) = volume.caster.expect("no spot") else {
            panic!("{}: begins at no plane", volume.name);
        };
        let polyhedron = framed.objects[object].caster().expect("casts a shadow");
        let source = &framed.sources[usize::from(volume.words.source)];
        assert!(side(&polyhedron.planes[cut], &source.point).is_positive());
        assert_eq!(volume.words.quadric, None, "{}", volume.name);
        assert_eq!(volume.words.planes.len(), polyhedron.planes.len());
    }
}

/// Polyhedra of six and ten planes before a wall, a point source and a directional one, in both projections.
#[test]
fn random_polyhedra_have_the_shadows_of_the_exact_rays() {
    let mut random = Random(11);
    let mut tally = Tally::default();
    let mut volumes = 0;
    let rounds = if is_full() { 12 } else { 6 };
    for round in 0..rounds {
        let casters = [("six", 6), ("ten", 10)];
        let casters = casters.map(|(name, planes)| random_polyhedron(&mut random, name, planes));
        let mut framed = before_a_wall(round, casters);
        framed.sources = sources(&mut random);
        let pictures = Pictures::of(framed, F).expect("fits the base format");
        volumes += pictures.prepared.volumes.len();
        assert_planes_alone(&pictures);
        compare(&pictures, &mut tally);
    }
    eprintln!("{volumes} volumes, {tally:?}");
    assert!(volumes > 10 * rounds);
    let lit = 8000 * rounds;
    assert!(tally.lit > lit && 4 * tally.dark > lit, "{tally:?}");
    assert!(tally.open * 500 < tally.flags, "{tally:?}");
    assert_eq!(tally.differing, tally.at_an_edge, "{tally:?}");
    assert!(tally.differing * 10_000 < tally.flags, "{tally:?}");
}

const CUBE: [[i64; 4]; 6] = [
    [1, 0, 0, -20],
    [-1, 0, 0, -20],
    [0, 1, 0, -20],
    [0, -1, 0, -20],
    [0, 0, 1, -20],
    [0, 0, -1, -20],
];

fn refusal(planes: &[[i64; 4]], point: [i64; 4]) -> Option<String> {
    let other = polyhedron("other", &CUBE.map(|[a, b, c, d]| [a, b, c, d - 60 * a]));
    let mut framed = before_a_wall(1, [other, polyhedron("crate", planes)]);
    framed.sources = vec![source([0, 60, -100, 1]), source(point)];
    prepare(&framed, F).err().map(|error| error.to_string())
}

/// Inside, on a face, an edge or a corner, and where an open one is endless towards a directional source; a hair
/// outside is accepted.
#[test]
fn a_source_inside_a_polyhedron_is_refused_by_name() {
    let open = &CUBE[..5];
    let refused: [(&[[i64; 4]], [i64; 4]); 6] = [
        (&CUBE, [3, -4, 5, 1]),
        (&CUBE, [0, 0, -20, 1]),
        (&CUBE, [20, 20, 0, 1]),
        (&CUBE, [-20, 20, -20, 1]),
        (open, [0, 0, -1, 0]),
        (open, [0, 0, -90, 1]),
    ];
    for (planes, point) in refused {
        let message = refusal(planes, point).expect("refused");
        for part in ["'crate'", "lights[1]"] {
            assert!(message.contains(part), "`{part}` is missing in: {message}");
        }
    }
    assert_eq!(refusal(&CUBE, [0, 0, -20_001, 1000]), None);
    assert_eq!(refusal(&CUBE, [0, 0, -1, 0]), None);
}

/// A polyhedron told to cast no shadow has no volume.
#[test]
fn a_polyhedron_can_be_without_shadow() {
    let quiet = |name| {
        let planes = CUBE.map(plane).to_vec();
        FramedObject::Polyhedron(Box::new(FramedQuadric {
            casts_shadow: false,
            planes,
            ..object(name, Surface::Solid, Quadric::everywhere(), &[])
        }))
    };
    let mut framed = before_a_wall(0, [quiet("first"), polyhedron("second", &CUBE)]);
    framed.sources = vec![source([0, 0, -100, 1])];
    let prepared = prepare(&framed, F).expect("fits");
    let casters = prepared.volumes.iter().filter_map(|v| Some(v.caster?.0));
    let casters: Vec<usize> = casters.collect();
    // The front face alone sees the source.
    assert_eq!(casters, [2]);
    assert_eq!(prepared.volumes[0].caster, Some((2, Beginning::Cut(5))));
}
