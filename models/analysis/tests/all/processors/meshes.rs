//! Meshes: within the rounding of their corners, without cracks, split where they must be.

use super::*;
use imogene_testkit::Random;

/// A facet's corner is moved by up to a 32nd of a pixel each way, which its slope turns into depth.
#[test]
fn meshes_are_within_the_rounding_of_their_corners() {
    let format = Format::BASE;
    let pictures = pictures("mesh", format);
    let differences = differences(&pictures);
    println!("{differences} pixels differ");
    assert!(differences < 60, "{differences}");
    // Slope of the facet that is seen at each pixel, in depth words per pixel.
    let width = pictures.golden.width;
    let mut nearest = vec![(format.z_max(), 0.0f64); pictures.exact.len()];
    for slot in pictures.prepared.slots() {
        let ProcessorWords::Facet(words) = &slot.words else {
            panic!("a mesh is drawn by facet processors");
        };
        let unit = f64::from(1 << 10);
        let slope = (words.depth.a.abs() + words.depth.b.abs()) as f64 / unit;
        for y in 0..pictures.golden.height {
            slot.words.for_each_present(&format, y as i64, |x, pixel| {
                let known = &mut nearest[y * width + x as usize];
                if pixel.zf < known.0 {
                    *known = (pixel.zf, slope);
                }
            });
        }
    }
    let mut compared = 0;
    for (i, off) in pictures.depth_errors() {
        assert_eq!(nearest[i].0, pictures.golden.depth[i]);
        // Near an edge the other picture may show the facet beside this one, so its slope counts too.
        let slopes = pictures.around(i, 1).map(|i| nearest[i].1);
        let slope = slopes.fold(0.0, f64::max);
        let bound = 2.0 * slope / 16.0 + 2.0;
        assert!(off.abs() <= bound, "{off} beyond {bound}");
        compared += 1;
    }
    assert!(compared > 15_000);
    // Phong normals: linear on the screen instead of in space. Flat ones are those of their faces, up to a change of
    // face at an edge.
    let normals = pictures.normal_errors();
    let phong = normals.iter().filter(|&&(id, _)| id > 0);
    let worst = phong.map(|&(_, off)| off).fold(0.0, f64::max);
    println!("interpolated normals within {worst} degrees");
    assert!(worst < 3.0, "{worst}");
    let flat: Vec<f64> = normals.iter().filter(|n| n.0 == 0).map(|n| n.1).collect();
    let other = flat.iter().filter(|&&off| off > 0.01).count();
    assert!(flat.len() > 3000 && other < 30, "{other} of {}", flat.len());
}

/// Every pixel that the exact mesh covers by more than the rounding of corners is covered: corners round to one place.
#[test]
fn meshes_have_no_cracks() {
    for seed in 0..6u32 {
        let mut file = file("mesh");
        file.objects
            .retain(|o| o.name == "ball" || o.name == "sheet");
        let mut random = Random(u64::from(seed) + 77);
        if let Some(imogene_scene::Step::Translate(offset)) = file.objects[0].place.last_mut() {
            *offset = [random.signed(), random.signed(), random.signed()];
        }
        let pictures = Pictures::of_file(&file, (200, 150), Format::BASE);
        let all = |&i: &usize| pictures.around(i, 1).all(|i| pictures.exact[i].is_some());
        let inside: Vec<usize> = (0..pictures.exact.len()).filter(all).collect();
        for &i in &inside {
            let place = pictures.place(i);
            assert!(pictures.golden.id[i] >= 0, "seed {seed}: {place:?}");
        }
        assert!(inside.len() > 1000);
    }
}

/// A mesh of four vertices and one face, seen straight on, a hundred pixels to the unit.
fn one_face(vertices: [[f64; 3]; 4], face: [usize; 4]) -> Pictures {
    let mut file = file("mesh");
    file.objects.truncate(1);
    file.objects[0].place.clear();
    file.objects[0].shape = Shape::Mesh(imogene_scene::Mesh {
        vertices: vertices.to_vec(),
        faces: vec![face.to_vec()],
        normals: vec![],
    });
    file.camera = parallel_view([0.0, 0.1, 9.0]);
    Pictures::of_file(&file, (533, 400), Format::BASE)
}

/// A face is one processor if its corners are in a plane on the screen, two if not, split where both halves are inside;
/// none if it is seen edge-on.
#[test]
fn faces_are_split_where_they_must_be() {
    let square = [
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
    ];
    let lifted = |corner: usize, to: [f64; 3]| {
        let mut vertices = square;
        vertices[corner] = to;
        vertices
    };
    let whole = [0, 1, 2, 3];
    // Vertices, processors, and pixels up to those on the sides.
    let cases = [
        (square, 1, 40_000),
        (lifted(2, [1.0, 1.0, 0.4]), 2, 40_000),
        // Concave at corner 2, then at corner 1: a quarter is missing.
        (lifted(2, [0.0, 0.0, 0.0]), 2, 20_000),
        (lifted(2, [-0.5, -0.5, 0.3]), 2, 10_000),
        (lifted(1, [-0.5, 0.5, 0.3]), 2, 10_000),
    ];
    for (vertices, processors, pixels) in cases {
        let pictures = one_face(vertices, whole);
        assert_eq!(pictures.prepared.slots().len(), processors, "{vertices:?}");
        let golden = pictures.golden.covered() as i64;
        let exact = pictures.exact.iter().flatten().count() as i64;
        assert!((golden - pixels).abs() < 300, "{vertices:?}: {golden}");
        // The exact picture has the pixels on all of its sides.
        assert!((exact - golden).abs() < 500, "{golden} {exact}");
    }
    let upright = square.map(|[x, y, _]| [x, 0.1, y]);
    let pictures = one_face(upright, whole);
    assert_eq!(pictures.prepared.slots().len(), 0);
    assert_eq!(pictures.golden.covered(), 0);
    let notes = pictures.prepared.objects[0].notes();
    for part in ["edge-on", "faces 0"] {
        assert!(notes[0].contains(part), "{notes:?}");
    }
}

/// Slots are in the order of the objects, and a pixel carries the index of its object.
#[test]
fn slots_follow_the_objects() {
    let pictures = pictures("mesh", Format::BASE);
    let slots = pictures.prepared.slots();
    assert!(slots.is_sorted_by_key(|slot| slot.object));
    for object in 0..3 {
        assert!(slots.iter().filter(|s| s.object == object).count() > 5);
        assert!(pictures.golden.id.contains(&(object as i32)));
    }
}
