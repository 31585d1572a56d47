//! The parts of the comparison of facets, paraboloids and quadrics.

mod tessellate;

use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::object::facet_contour::FacetContour;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::words::Object;
use imogene_prepare::{Framing, prepare};
use imogene_scene::{FramedScene, SceneFile};
use imogene_studies::primitives::speed::facets;
use imogene_studies::primitives::tessellate::{drop_turned_away, to_mesh};
use imogene_studies::primitives::{Subject, Variant, fair_sides};
use imogene_testkit::scene_file;

const F: Format = Format::BASE;

fn scene() -> SceneFile {
    scene_file("comparison/three-solids")
}

/// Of a closed mesh the nearest facet is never one that is turned away.
#[test]
fn facets_turned_away_are_not_missed() {
    for sides in [5, 8, 20] {
        let mut file = scene();
        file.objects.iter_mut().for_each(|o| to_mesh(o, sides));
        let mut framed = file.frame(160, 120).unwrap();
        let draw = |framed: &FramedScene| {
            let slots = prepare(framed, F).unwrap().slots();
            (beam::render(&slots, &F, 160, 120, || ()), slots.len())
        };
        let (whole, all) = draw(&framed);
        let before = drop_turned_away(&mut framed);
        let (seen, left) = draw(&framed);
        assert!(before > 0 && left * 10 < all * 7, "{left} of {all}");
        let pairs = || whole.id.iter().zip(&seen.id);
        let differ = pairs().filter(|(a, b)| a != b).count();
        assert_eq!(differ, 0, "{sides} sides");
    }
}

#[test]
fn contour_following_draws_every_facet_of_the_comparison() {
    let subject = Subject::new(&scene(), (96, 72), F).unwrap();
    for variant in [Variant::Facets(8), Variant::Facets(20), Variant::FairFacets] {
        let drawn = subject.draw(variant).unwrap();
        let mut pixels = 0;
        for words in facets(&drawn.slots) {
            let mut followed = vec![];
            FacetContour::new(words, &F).for_each_pixel(|x, y, p| followed.push((x, y, p)));
            let each = ScreenBox::of_screen(96, 72).each();
            let scanned = each.map(|(x, y)| (x, y, words.at(x, y, &F)));
            let scanned: Vec<_> = scanned.filter(|(.., p)| p.zf != F.z_max()).collect();
            pixels += scanned.len();
            assert_eq!(followed, scanned);
        }
        assert!(pixels > 2500, "{pixels}");
    }
}

/// The table of the specification for half a pixel.
#[test]
fn fair_polygons() {
    let radii = [10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];
    assert_eq!(radii.map(fair_sides), [10, 15, 23, 32, 45, 71, 100]);
    assert_eq!([0.1, 0.5, 0.6].map(fair_sides), [3, 3, 3]);
}
