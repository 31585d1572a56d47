//! Every scene of the repository: golden picture against traced picture.

use imogene_analysis::bounds::check;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::machine::shader::shade_picture;
use imogene_oracle::compare::{Comparison, Mark, Pictures, compare};
use imogene_oracle::run::{Outcome, pictures, run, trace};
use imogene_prepare::Framing;
use imogene_prepare::shader::{material_numbers, shader_words};
use imogene_prepare::{PreparedScene, prepare};
use imogene_scene::{FramedScene, SceneFile, Step};

/// The scenes that their own check fails, since their words are too short for them: pixels of their outlines are
/// announced far from the edge.
const WITHOUT_BOUNDS: [&str; 1] = ["flat-as-a-leaf"];

/// The picture of the check is the scene's own size where that is small: the extremes are made for it.
fn size(scene: &SceneFile) -> (u32, u32) {
    let (w, h) = (scene.image.width, scene.image.height);
    if w * h <= 64 * 128 { (w, h) } else { (80, 60) }
}

#[test]
fn every_golden_picture_is_the_traced_one_outside_the_band() {
    let (mut refused, mut compared) = (vec![], 0);
    let (mut glass, mut solids, mut colours) = (0, 0, 0);
    for (name, scene) in crate::common::all() {
        let (w, h) = size(&scene);
        let outcome = run(&scene, w, h, Format::BASE, &|_| ()).expect("framed");
        let found = match outcome {
            Outcome::Refused(_) => {
                refused.push(name);
                continue;
            }
            Outcome::Compared(found) => found,
        };
        compared += 1;
        let c = &found.comparison;
        assert!(c.holds(), "{name}: {c:#?}");
        let is_without = WITHOUT_BOUNDS.contains(&name.as_str());
        assert_eq!(c.announced > 0, is_without, "{name}: {c:#?}");
        let marked = |mark| found.marks.iter().filter(|m| **m == mark).count();
        assert_eq!(marked(Mark::Inside), c.differences_inside);
        assert_eq!(marked(Mark::Outside), c.differences_outside);
        assert_eq!(marked(Mark::Tied), c.tied);
        assert_eq!(marked(Mark::Announced), c.announced);
        assert_eq!(marked(Mark::Colour), c.colours_beyond_bound);
        glass += c.transparent;
        solids += usize::from(!scene.solids.is_empty() && c.covered > 0);
        colours += c.colours_known;
        let has_depths = c.covered < 20 || c.depths > 0;
        assert!(has_depths, "{name}: no depth was compared");
        let is_special = is_without || c.band < 20 || c.tied > 0;
        let is_fine = c.differences_inside * 20 <= c.band || is_special;
        assert!(is_fine, "{name}: {c:#?}");
    }
    assert!(compared >= 60, "{compared}");
    assert!(refused.is_empty(), "{refused:?}");
    assert!(glass > 500 && solids >= 2, "{glass}, {solids}");
    assert!(colours > 100_000, "{colours}");
}

#[test]
fn a_scene_that_differs_is_one_whose_check_fails() {
    let is_without = |(name, _): &(String, _)| WITHOUT_BOUNDS.contains(&name.as_str());
    for (_, scene) in crate::common::all().filter(is_without) {
        let (framed, prepared) = words(&scene, (scene.image.width, scene.image.height));
        assert!(!check(&framed, &prepared).ok);
    }
}

/// A scene in the size of its picture, and its words.
type Words = (FramedScene, PreparedScene);

fn words(scene: &SceneFile, (width, height): (u32, u32)) -> Words {
    let framed = scene.frame(width, height).expect("framed");
    let prepared = prepare(&framed, Format::BASE).expect("prepared");
    (framed, prepared)
}

/// Its pictures, to hold others against the traced ones.
fn draw<'a>(scene: &SceneFile, (framed, prepared): &'a Words) -> Pictures<'a> {
    let traced = trace(scene, framed, &|_| ());
    pictures(traced, scene, framed, prepared).expect("bounds")
}

/// What is found of another golden picture, whose colours are not looked at.
fn against(pictures: &mut Pictures, frame: &Frame) -> Comparison {
    pictures.painted = None;
    pictures.pairs[0].golden = frame.clone();
    compare(pictures).0
}

/// A wrong picture is noticed: one object moved by two pixels, or one word of depth too many.
#[test]
fn wrong_pictures_are_noticed() {
    let scene = crate::common::read("teapot");
    let words = words(&scene, (80, 60));
    let mut drawn = draw(&scene, &words);
    let golden = drawn.pairs[0].golden.clone();
    let mut against = |frame| against(&mut drawn, frame);
    assert!(against(&golden).holds());
    let mut moved = golden.clone();
    moved.id.rotate_right(2);
    moved.number.rotate_right(2);
    assert!(against(&moved).differences_outside > 0);
    let mut deeper = golden.clone();
    let most = against(&golden).depth_bound as i64 + 1;
    deeper.depth.iter_mut().for_each(|d| *d += 2 * most);
    let found = against(&deeper);
    assert!(found.depths_beyond_bound > 0 && found.differences_outside == 0);
}

/// What is made wrong in a frame.
type Fault = fn(&mut Frame);

/// The golden picture of glass, with a fault in it.
fn with_fault((framed, prepared): &Words, golden: &Frame, fault: Fault) -> Vec<u8> {
    let mut frame = golden.clone();
    fault(&mut frame);
    let shading = shader_words(framed, &prepared.format).expect("words");
    let lighting = Lighting::full(&frame);
    shade_picture(&frame, &lighting, &material_numbers(framed), &shading)
}

/// Wrong blends are noticed by their colours, and a wrong surface of glass by its faces and depths.
#[test]
fn wrong_pictures_of_glass_are_found() {
    let mut scene = crate::common::read("glass/still-life");
    // One more sphere of glass, behind the ball.
    let mut hidden = scene.objects[4].clone();
    hidden.name = "hidden".into();
    hidden.place.push(Step::Translate([0.3, 0.2, -2.6]));
    scene.objects.push(hidden);
    let words = words(&scene, (160, 120));
    let mut drawn = draw(&scene, &words);
    let (right, _) = compare(&drawn);
    assert!(right.holds(), "{right:#?}");
    assert_eq!(drawn.pairs.len(), 5);
    assert!(right.transparent > 2000 && right.colours == 160 * 120);
    assert!(right.colours_known * 20 > 19 * right.colours);
    let golden = drawn.pairs[0].golden.clone();
    let faults: [(&str, Fault); 6] = [
        ("layers the wrong way round", |f| f.layers.reverse()),
        ("the parts of two colours exchanged", |f| {
            f.layers.iter_mut().for_each(|l| l.weight = 255 - l.weight);
        }),
        ("a part a twentieth off", |f| f.layers[0].weight += 13),
        ("a layer left out", |f| drop(f.layers.remove(1))),
        ("hidden surfaces seen", |f| {
            let depths = f.layers.iter_mut().flat_map(|l| &mut l.depth);
            let there = depths.filter(|z| **z < Format::BASE.z_max());
            there.for_each(|z| *z = Format::BASE.z_low());
        }),
        ("a normal of the surface behind", |f| {
            f.layers[2].normal = f.layers[0].normal.clone();
        }),
    ];
    for (what, fault) in faults {
        let colours = with_fault(&words, &golden, fault);
        drawn.painted.as_mut().expect("colours").golden = colours;
        let (found, marks) = compare(&drawn);
        let marked = marks.iter().filter(|mark| **mark == Mark::Colour).count();
        println!("{what}: {marked}");
        assert!(found.colours_beyond_bound > 20, "{what}: {found:#?}");
        assert_eq!(marked, found.colours_beyond_bound, "{what}");
        let others = (found.differences_outside, found.depths_beyond_bound);
        assert_eq!(others, (0, 0), "{what}");
    }
    drawn.painted = None;
    let most = 2 * right.depth_bound as i64 + 1;
    let depths = drawn.pairs[3].golden.depth.iter_mut();
    depths.for_each(|z| *z += most);
    assert!(compare(&drawn).0.depths_beyond_bound > 100);
    drawn.pairs[3].golden.id.rotate_right(2);
    assert!(compare(&drawn).0.differences_outside > 20);
}

/// Slivers between the pixels, seen where their corners are rounded to: the golden picture holds, and what is wrong
/// in it is still found.
#[test]
fn slivers_hold_and_wrong_pixels_of_a_mesh_are_found() {
    let slivers = "kind = \"mesh\"\nvertices = [[0.01, -0.267, -0.712], [0.321, -0.06, -0.745], [-0.985, -0.812, -1.177], \
        [-0.699, -0.146, -0.595], [-0.068, 0.344, 0.09], [-0.375, 0.186, -0.646], [-0.29, -1.59, 0.938], [0.241, -1.278, 0.754], \
        [1.158, -1.033, 0.922], [-0.692, -0.059, 0.163], [-0.417, 0.303, -0.923], [-0.624, 0.759, -1.049], [-0.023, 0.55, -0.855], \
        [-0.551, 0.686, -0.647], [-0.253, -0.157, -0.768]]\nfaces = [[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11], [12, 13, 14]]";
    let camera = "kind = \"perspective\"\neye = [-2.848, -3.182, 7.89]\ntarget = [-0.168, 0.045, -0.09]\nviewer_distance = 8.170\nview_height = 3.031\n";
    let scene = crate::common::scene(camera, &[slivers]);
    let (w, h) = (64, 48);
    let words = words(&scene, (w, h));
    let mut drawn = draw(&scene, &words);
    let golden = drawn.pairs[0].golden.clone();
    let found = against(&mut drawn, &golden);
    assert!(found.holds(), "{found:#?}");
    // A pixel that no facet and no seen pixel is near, and one beside the facet that is at another depth.
    let far_from_all = |&i: &usize| {
        let (x, y) = (i % w as usize, i / w as usize);
        let beside = imogene_oracle::compare::is_in_band(&drawn.pairs[0].traced, x, y);
        let facets = || drawn.tracer.facets_near(0, (x as u32, y as u32), 0.1);
        !beside && golden.id[i] < 0 && facets().is_empty()
    };
    let mut wrong = 0;
    let alone: Vec<usize> = (0..golden.id.len()).filter(far_from_all).collect();
    for i in alone.into_iter().step_by(97) {
        let mut frame = golden.clone();
        let like = golden.id.iter().position(|&id| id == 0);
        let like = like.expect("something is seen");
        (frame.id[i], frame.number[i]) = (0, golden.number[like]);
        frame.depth[i] = golden.depth[like];
        let found = against(&mut drawn, &frame);
        assert_eq!(found.differences_outside, 1, "pixel {i}");
        wrong += 1;
    }
    assert!(wrong > 10, "{wrong}");
    let sliver = 35 * w as usize + 24;
    assert_eq!(golden.id[sliver], 0);
    let mut deeper = golden.clone();
    deeper.depth[sliver] += 100_000;
    assert_eq!(against(&mut drawn, &deeper).differences_outside, 1);
}
