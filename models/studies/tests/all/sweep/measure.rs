use imogene_golden::format::Format;
use imogene_prepare::{Framing, PreparedObject, PreparedQuadric, PreparedScene, prepare};
use imogene_scene::{FramedScene, Shape};
use imogene_studies::sweep::grid::{BESIDE, cut, moved, orthographic, scene};
use imogene_studies::sweep::measure::measure;

fn cut_ball() -> (FramedScene, PreparedScene) {
    let cuts = vec![cut([6.0, 0.0, 12.0], [0.5, 0.25, 1.0])];
    let ball = moved("ball", Shape::Sphere { radius: 24.0 }, cuts, BESIDE);
    let framed = scene("ball", orthographic(64.0), vec![ball]).frame(96, 72);
    let framed = framed.expect("valid");
    let prepared = prepare(&framed, Format::BASE).expect("fits");
    (framed, prepared)
}

fn spoiled(spoil: impl Fn(&mut PreparedQuadric)) -> Vec<String> {
    let (framed, mut prepared) = cut_ball();
    let PreparedObject::Quadric(ball) = &mut prepared.objects[0] else {
        panic!("a quadric");
    };
    spoil(ball);
    measure(&framed, &prepared).violations
}

#[test]
fn a_picture_within_its_bounds_breaks_no_rule() {
    let (framed, prepared) = cut_ball();
    let figures = measure(&framed, &prepared);
    assert_eq!(figures.violations, Vec::<String>::new());
    assert!(figures.observed.compared > 1700 && figures.observed.normals > 1700);
    assert!(figures.observed.silhouette_px.is_some_and(|off| off > 0.0));
    assert!(figures.ratios.depth > 0.5 && figures.ratios.depth <= 1.0);
}

/// Each rule finds what breaks it: the words are changed, and the bounds are not.
#[test]
fn every_rule_is_found_broken() {
    let has = |found: &[String], text| found.iter().any(|v| v.contains(text));
    let depth = spoiled(|ball| ball.words.f1.c += 20);
    assert!(has(&depth, "depth off by"), "{depth:?}");
    let plane = spoiled(|ball| ball.words.planes[0].depth.c += 5_000);
    assert!(has(&plane, "depth off by") && has(&plane, "not announced as undecided"));
    let normal = spoiled(|ball| ball.words.normal.g[0].c += 40_000);
    assert!(has(&normal, "normal off by"), "{normal:?}");
    let silhouette = spoiled(|ball| ball.words.f2.f += 1 << 36);
    assert!(has(&silhouette, "silhouette of 'ball' is displaced"));
}
