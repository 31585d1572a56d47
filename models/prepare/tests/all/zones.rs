//! Zones are coefficient changes: every pixel keeps its value on any split of the screen.

use imogene_golden::format::Format;
use imogene_golden::object::line::for_each_present;
use imogene_golden::object::quadric::{ObjectPixel, QuadricWords};
use imogene_golden::object::words::{Object, Words};
use imogene_scene::Surface;
use imogene_testkit::*;
use proptest::prelude::*;
use std::sync::LazyLock;

const F: Format = Format::BASE;

static OBJECTS: LazyLock<Vec<QuadricWords>> = LazyLock::new(|| {
    let cuts = [[0, 0, -1, 250], [0, 1, 0, -80], [3, -1, 1, -420]];
    let ball = |name, surface| object(name, surface, sphere([20, -10, 300], 100), &cuts);
    let waist = centred([1, 1, -1], [-60, 30, 0], 3600);
    let objects = vec![
        ball("solid", Surface::Solid),
        ball("patch", Surface::Patch),
        object(
            "front",
            Surface::Solid,
            waist,
            &[[0, 0, -1, -100], [0, 0, 1, -100]],
        ),
    ];
    prepare(&scene(objects))
        .quadrics()
        .map(|(_, o)| o.words.clone())
        .collect()
});

fn picture(words: &QuadricWords, width: i64, height: i64) -> Vec<Option<ObjectPixel>> {
    let mut pixels = vec![None; (width * height) as usize];
    for y in 0..height {
        for_each_present(words, &F, y, |x, pixel| {
            pixels[(y * width + x) as usize] = Some(pixel);
        });
    }
    pixels
}

fn cut_out(
    whole: &[Option<ObjectPixel>],
    x0: i64,
    y0: i64,
    width: i64,
    height: i64,
) -> Vec<Option<ObjectPixel>> {
    let line = |y: i64| {
        let first = (y * i64::from(WIDTH) + x0) as usize;
        whole[first..first + width as usize].to_vec()
    };
    (y0..y0 + height).flat_map(line).collect()
}

/// The processor at every pixel of the zone.
fn processed(words: &QuadricWords, width: i64, height: i64) -> Vec<Option<ObjectPixel>> {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let present = |(x, y)| Some(words.at(x, y, &F)).filter(|p| p.zf != F.z_max());
    pixels.map(present).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_split_gives_the_same_pixels(which in 0usize..3, split_x in 1i64..719, split_y in 1i64..539) {
        let words = &OBJECTS[which];
        let (width, height) = (i64::from(WIDTH), i64::from(HEIGHT));
        let whole = picture(words, width, height);
        for (x0, w) in [(0, split_x), (split_x, width - split_x)] {
            for (y0, h) in [(0, split_y), (split_y, height - split_y)] {
                let zone = picture(&words.for_zone(x0, y0, w, h), w, h);
                prop_assert!(zone == cut_out(&whole, x0, y0, w, h), "zone {w} x {h} at ({x0}, {y0})");
            }
        }
    }

    #[test]
    fn a_processor_started_in_any_zone_gives_the_same_pixels(
        which in 0usize..3, x0 in 200i64..480, y0 in 150i64..380, w in 1i64..40, h in 1i64..20
    ) {
        let words = &OBJECTS[which];
        let whole = picture(words, i64::from(WIDTH), i64::from(HEIGHT));
        let zone = words.for_zone(x0, y0, w, h);
        prop_assert_eq!(processed(&zone, w, h), cut_out(&whole, x0, y0, w, h));
        // A zone of a zone is a zone.
        let nested = words.for_zone(x0 - 50, y0 - 30, 200, 200).for_zone(50, 30, w, h);
        prop_assert_eq!(processed(&nested, w, h), cut_out(&whole, x0, y0, w, h));
    }
}
