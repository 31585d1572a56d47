//! Facets by contour following in software equal the facet processor pixel for pixel.

use imogene_algebra::rational::{fraction, integer};
use imogene_golden::format::Format;
use imogene_golden::object::facet::{Corner, FacetError, FacetWords, MAX_COMPONENT, SUBPIXEL};
use imogene_golden::object::facet_contour::FacetContour;
use imogene_golden::object::quadric::{ObjectPixel, ScreenBox};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::words::Object;
use imogene_golden::unit::normal::LINEAR_WIDTH;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_testkit::scene_file;
use proptest::prelude::*;

const WIDTH: i64 = 40;
const HEIGHT: i64 = 30;

type Pixels = Vec<(i64, i64, ObjectPixel)>;

/// The processor over the whole screen.
fn by_processor(words: &FacetWords, format: &Format, width: i64, height: i64) -> Pixels {
    let mut found = vec![];
    for y in 0..height {
        for x in 0..width {
            let pixel = words.at(x, y, format);
            if pixel.zf != format.z_max() {
                found.push((x, y, pixel));
            }
        }
    }
    found
}

fn by_contour(words: &FacetWords, format: &Format) -> Pixels {
    let contour = FacetContour::new(words, format);
    let mut found = vec![];
    contour.for_each_pixel(|x, y, pixel| found.push((x, y, pixel)));
    found
}

/// A place in sixteenths of a pixel on and around the screen; every second one on a pixel, where ownership decides.
fn place() -> impl Strategy<Value = (i64, i64)> {
    let any = (-200i64..840, -200i64..680);
    let whole = (-10i64..50, -10i64..40).prop_map(|(x, y)| (x << SUBPIXEL, y << SUBPIXEL));
    // Small ones as well, whose sides pass between pixels.
    let near = (300i64..340, 200i64..240);
    prop_oneof![any, whole, near]
}

fn normal() -> impl Strategy<Value = [i16; 3]> {
    [
        -MAX_COMPONENT..=MAX_COMPONENT,
        -MAX_COMPONENT..=MAX_COMPONENT,
        -MAX_COMPONENT..=MAX_COMPONENT,
    ]
}

/// The box of the preparation, the whole screen, or any part of it.
fn boxes(corners: &[Corner]) -> [ScreenBox; 2] {
    let bound = |of: fn(&Corner) -> i64, size: i64| {
        let all = corners.iter().map(of);
        let (least, most) = (all.clone().min().unwrap(), all.max().unwrap());
        let first = (least + 15) >> SUBPIXEL;
        (first.max(0), (most >> SUBPIXEL).min(size - 1))
    };
    let ((x0, x1), (y0, y1)) = (bound(|c| c.x, WIDTH), bound(|c| c.y, HEIGHT));
    let whole = ScreenBox {
        x0: 0,
        x1: WIDTH - 1,
        y0: 0,
        y1: HEIGHT - 1,
    };
    [ScreenBox { x0, x1, y0, y1 }, whole]
}

/// As the registers hold them.
fn wrapped(words: FacetWords, format: &Format) -> FacetWords {
    FacetWords {
        edges: words
            .edges
            .iter()
            .map(|e| e.wrapped(format.plane))
            .collect(),
        depth: words.depth.wrapped(format.plane),
        normal: words.normal.map(|n| n.wrapped(LINEAR_WIDTH)),
        ..words
    }
}

/// Compares both on every box; the number of pixels.
fn compare(corners: &[Corner], format: &Format, part: ScreenBox) -> Result<usize, TestCaseError> {
    let mut pixels = 0;
    let [tight, whole] = boxes(corners);
    for window in [tight, whole, part] {
        let words = FacetWords::new(corners, window, format).unwrap();
        for words in [wrapped(words.clone(), format), words] {
            let processor = by_processor(&words, format, WIDTH, HEIGHT);
            let contour = by_contour(&words, format);
            pixels += processor.len();
            prop_assert_eq!(processor, contour, "{:?} in {:?}", corners, window);
        }
    }
    Ok(pixels)
}

fn part() -> impl Strategy<Value = ScreenBox> {
    (0..WIDTH, 0..WIDTH, 0..HEIGHT, 0..HEIGHT).prop_map(|(x, u, y, v)| ScreenBox {
        x0: x.min(u),
        x1: x.max(u),
        y0: y.min(v),
        y1: y.max(v),
    })
}

fn format() -> impl Strategy<Value = Format> {
    prop::sample::select(&Format::CATALOGUE[..]).prop_map(|depth| Format::new(depth).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn triangles(
        places in [place(), place(), place()],
        normals in [normal(), normal(), normal()],
        // Beyond both ends of the depth word as well.
        depths in [-5i64..=5, -5i64..=5, -5i64..=5],
        format in format(),
        part in part(),
    ) {
        let corners: [Corner; 3] = std::array::from_fn(|i| Corner {
            x: places[i].0,
            y: places[i].1,
            z: fraction(depths[i], 4) * integer(format.z_max()) + integer(7 * i as i64),
            normal: normals[i],
        });
        match FacetWords::new(&corners, part, &format) {
            Err(FacetError::NotConvex) => return Err(TestCaseError::reject("no area")),
            other => drop(other.unwrap()),
        }
        compare(&corners, &format, part)?;
    }

    /// Convex quadrangles: an affine picture of a kite, with three sides on one contour as often as two.
    #[test]
    fn quadrangles(
        origin in place(),
        (ux, uy, vx, vy) in (-90i64..90, -90i64..90, -90i64..90, -90i64..90),
        (p, q) in (1i64..6, 1i64..6),
        depths in [-3i64..=3, -3i64..=3, -3i64..=3],
        format in format(),
        part in part(),
    ) {
        // (0, 0), u, p u + q v, v is convex if p + q > 1.
        let along = |s: i64, t: i64| (origin.0 + s * ux + t * vx, origin.1 + s * uy + t * vy);
        let value = |s: i64, t: i64| fraction(depths[0] + s * depths[1] + t * depths[2], 40) * integer(format.z_max());
        let component = |s: i64, t: i64| (1000 * s - 900 * t) as i16;
        let corners = [(0, 0), (1, 0), (p, q), (0, 1)].map(|(s, t)| Corner {
            x: along(s, t).0,
            y: along(s, t).1,
            z: value(s, t),
            normal: [component(s, t), component(t, s), -20_000],
        });
        if ux * vy == uy * vx {
            return Err(TestCaseError::reject("no area"));
        }
        compare(&corners, &format, part)?;
    }
}

/// Every facet of a scene, as it is prepared; the operations are those of its spans.
#[test]
fn facets_of_a_scene() {
    let framed = scene_file("processors/mesh").frame(320, 240).unwrap();
    let prepared = prepare(&framed, Format::BASE).unwrap();
    let (mut facets, mut pixels) = (0, 0);
    for slot in prepared.slots() {
        let ProcessorWords::Facet(words) = slot.words else {
            panic!("not a facet");
        };
        let processor = by_processor(&words, &Format::BASE, 320, 240);
        assert_eq!(processor, by_contour(&words, &Format::BASE));
        let operations = FacetContour::new(&words, &Format::BASE).operations();
        assert_eq!(operations.pixels, processor.len() as u64);
        assert_eq!(operations.pixel_additions, 5 * operations.pixels);
        let window = words.screen_box;
        assert_eq!(operations.lines, (window.y1 - window.y0 + 1) as u64);
        facets += 1;
        pixels += processor.len();
    }
    assert!(facets > 60 && pixels > 10_000, "{facets} {pixels}");
}
