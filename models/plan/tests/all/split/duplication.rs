use super::zones;
use imogene_golden::object::quadric::ScreenBox;
use imogene_plan::split::{Division, expected};

fn at(x0: i64, y0: i64, l: i64, h: i64) -> ScreenBox {
    ScreenBox::of([x0, x0 + l - 1], [y0, y0 + h - 1])
}

/// The source's numbers: 80 in 128 gives 2.641, 80 in 64 gives 5.06.
#[test]
fn the_formula_is_the_source_s() {
    for (l, zone, wanted) in [(80, 128, 2.640625), (80, 64, 5.0625), (20, 32, 2.640625)] {
        assert_eq!(expected(&at(0, 0, l, l), zones(zone, zone))[0], wanted);
    }
}

/// Every place of boxes of several sizes, counted.
#[test]
fn the_mean_over_all_places_is_the_formula_for_whole_pixels() {
    let (width, height) = (6, 4);
    let division = zones(width, height);
    let pieces = division.pieces(60, 60);
    for (l, h) in [(1, 1), (2, 5), (6, 4), (13, 9), (30, 1)] {
        let mut touched = 0;
        for x0 in 0..i64::from(width) {
            for y0 in 0..i64::from(height) {
                let window = at(x0, y0, l, h);
                let touching = pieces.iter().filter(|p| !p.part_of(&window).is_empty());
                touched += touching.count();
            }
        }
        let mean = touched as f64 / f64::from(width * height);
        let [source, whole] = expected(&at(0, 0, l, h), division);
        assert!((mean - whole).abs() < 1e-12, "{l} x {h}: {mean} {whole}");
        assert!(source > whole);
    }
    let lines = Division::Lines(4).pieces(60, 60);
    for h in [1, 3, 4, 9] {
        for y0 in 0..8 {
            let window = at(5, y0, 3, h);
            let touching = lines.iter().filter(|p| !p.part_of(&window).is_empty());
            assert_eq!(touching.count() as i64, h.min(4));
        }
    }
}
