//! Meshes: each facet that the source does not see edge-on has a shadow of planes alone.

use super::compare::{Tally, compare};
use super::{F, before_a_wall, source, sources};
use crate::pictures::Pictures;
use imogene_algebra::rational::integer;
use imogene_analysis::exact::shadow;
use imogene_prepare::volume::Beginning;
use imogene_scene::{FramedFacet, FramedMesh, FramedObject, Quadric, Surface};
use imogene_testkit::*;

fn mesh(name: &str, vertices: &[[i64; 3]], faces: &[&[usize]]) -> FramedMesh {
    let facet = |(face, corners): (usize, &&[usize])| FramedFacet {
        face,
        corners: corners.to_vec(),
        normal: [0, 0, -(1 << 14)],
    };
    FramedMesh {
        name: name.into(),
        material: 0,
        vertices: vertices.iter().map(|v| v.map(integer)).collect(),
        normals: None,
        facets: faces.iter().enumerate().map(facet).collect(),
        casts_shadow: true,
    }
}

/// Three triangles and a parallelogram about a point, in any directions: an open mesh that may cross itself.
fn random_mesh(random: &mut Random, name: &str) -> FramedObject {
    let mut whole = |most: f64| (random.signed() * most).round() as i64;
    let centre: [i64; 3] = std::array::from_fn(|_| whole(16.0));
    let mut vertices: Vec<[i64; 3]> = (0..6).map(|_| centre.map(|at| at + whole(30.0))).collect();
    let [a, b, c] = [0, 1, 2].map(|corner| vertices[corner]);
    vertices.push(std::array::from_fn(|k| a[k] + c[k] - b[k]));
    let faces: [&[usize]; 4] = [&[0, 1, 2, 6], &[2, 3, 4], &[4, 5, 0], &[5, 3, 1]];
    FramedObject::Mesh(Box::new(mesh(name, &vertices, &faces)))
}

/// Meshes before a wall, a point source and a directional one, in both projections.
#[test]
fn random_meshes_have_the_shadows_of_the_exact_rays() {
    let mut random = Random(17);
    let mut tally = Tally::default();
    let rounds = if is_full() { 24 } else { 8 };
    for round in 0..rounds {
        let casters = ["first", "second"].map(|name| random_mesh(&mut random, name));
        let mut framed = before_a_wall(round, casters);
        framed.sources = sources(&mut random);
        let pictures = Pictures::of(framed, F).expect("fits the base format");
        for volume in &pictures.prepared.volumes {
            let (_, beginning) = volume.caster.expect("no spot");
            assert!(matches!(beginning, Beginning::Facet(_)), "{}", volume.name);
            assert_eq!(volume.words.quadric, None, "{}", volume.name);
        }
        compare(&pictures, &mut tally);
    }
    eprintln!("{tally:?}");
    let lit = 5000 * rounds;
    assert!(tally.lit > lit && 4 * tally.dark > lit, "{tally:?}");
    assert!(tally.open * 25 < tally.flags, "{tally:?}");
    assert!(tally.differing * 1000 < tally.flags, "{tally:?}");
    // Corners are drawn where the nearest sixteenth of a pixel is: beside the edge of two facets one can darken the
    // other.
    let beside = tally.differing - tally.at_an_edge;
    assert!(beside * 5000 < tally.flags, "{tally:?}");
}

/// Corners of a cube of 40 and its faces.
const CORNERS: [[i64; 3]; 8] = [
    [-20, -20, -20],
    [20, -20, -20],
    [20, 20, -20],
    [-20, 20, -20],
    [-20, -20, 20],
    [20, -20, 20],
    [20, 20, 20],
    [-20, 20, 20],
];
const FACES: [&[usize]; 7] = [
    &[0, 1, 2, 3],
    &[4, 5, 6, 7],
    &[0, 1, 5, 4],
    &[2, 3, 7, 6],
    &[1, 2, 6, 5],
    &[0, 3, 7],
    &[0, 4, 7],
];

/// A cube as a mesh, one of its faces in two triangles, darkens what the cube of planes darkens.
#[test]
fn a_mesh_has_the_shadow_of_the_polyhedron_it_encloses() {
    let planes: Vec<[i64; 4]> = (0..3)
        .flat_map(|axis| {
            [1, -1].map(|sign| {
                let mut plane = [0, 0, 0, -20];
                plane[axis] = sign;
                plane
            })
        })
        .collect();
    let solid = object("cube", Surface::Solid, Quadric::everywhere(), &planes);
    let lights = [source([70, 50, -90, 1]), source([-3, 4, -6, 0])];
    for round in [0, 1] {
        let flags = |cube: FramedObject| {
            let away = object("away", Surface::Solid, sphere([400, 0, 100], 10), &[]);
            let mut framed = before_a_wall(round, [cube, away.into()]);
            framed.sources = lights.to_vec();
            let pictures = Pictures::of(framed, F).expect("fits the base format");
            let exact = shadow::lighting(&pictures.scene, || ());
            let golden = pictures.prepared.light(&pictures.golden, || ());
            let wall = pictures
                .exact
                .iter()
                .map(|at| at.is_some_and(|at| at.id == 0));
            let wall: Vec<bool> = wall.collect();
            let of_wall = |flags: &[u16]| -> Vec<u16> {
                let all = flags.iter().zip(&wall);
                all.filter(|(_, wall)| **wall)
                    .map(|(flags, _)| *flags)
                    .collect()
            };
            (of_wall(&exact.flags), of_wall(&golden.flags))
        };
        let (exact, golden) = flags(FramedObject::Polyhedron(Box::new(solid.clone())));
        let of_mesh = flags(FramedObject::Mesh(Box::new(mesh("cube", &CORNERS, &FACES))));
        assert_eq!(of_mesh.0, exact);
        let differing = of_mesh
            .1
            .iter()
            .zip(&golden)
            .filter(|(a, b)| a != b)
            .count();
        assert!(
            200 * differing < exact.len(),
            "{differing} of {}",
            exact.len()
        );
        assert!(exact.iter().any(|flags| flags & 3 != 3));
    }
}

/// A mesh told to cast no shadow has no volume.
#[test]
fn a_mesh_can_be_without_shadow() {
    let quiet = FramedMesh {
        casts_shadow: false,
        ..mesh("quiet", &CORNERS, &FACES)
    };
    let away = object("away", Surface::Solid, sphere([400, 0, 100], 10), &[]);
    let mut framed = before_a_wall(0, [FramedObject::Mesh(Box::new(quiet)), away.into()]);
    framed.sources = vec![source([70, 50, -90, 1])];
    let pictures = Pictures::of(framed, F).expect("fits the base format");
    let mut casters = pictures.prepared.volumes.iter().map(|volume| volume.caster);
    assert!(casters.all(|caster| caster.is_some_and(|(object, _)| object != 1)));
    let dark = shadow::lighting(&pictures.scene, || ());
    let wall = pictures.exact.iter().zip(&dark.flags);
    let mut wall = wall.filter(|(at, _)| at.is_some_and(|at| at.id == 0));
    assert!(wall.all(|(_, flags)| flags & 1 == 1));
}
