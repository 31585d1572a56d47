//! Conversion in software (source: chapter 5).

use super::count::Counter;
use super::row::{Group, Row};
use super::work::pixel::{self, Object, Scan};
use super::work::quadric::Kind;

/// Half of a box of 20 x 20 pixels, with the diagonal: sides, depth, normal.
pub const FACET: [[f64; 3]; 7] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [-1.0, -1.0, 19.0],
    [3.0, -2.0, 500.0],
    [4.0, 0.0, -40.0],
    [0.0, 4.0, -40.0],
    [0.0, 0.0, -100.0],
];

/// A ball that fills a box of so many pixels, cut by up to four planes: one from the front, one from the back, two along the line of sight.
pub fn ball(side: u64, planes: usize) -> Object {
    let middle = (side as f64 - 1.0) / 2.0;
    let radius = side as f64 / 2.0;
    let all = [
        (Kind::Front, [0.5, 0.25, -0.8 * radius - 0.75 * middle]),
        (Kind::Back, [-0.25, 0.5, 0.85 * radius - 0.25 * middle]),
        (Kind::Perpendicular, [1.0, 0.0, -2.0]),
        (Kind::Perpendicular, [0.0, -1.0, side as f64 - 3.0]),
    ];
    Object {
        f1: [0.0, 0.0, 0.0],
        f2: [
            -1.0,
            -1.0,
            0.0,
            2.0 * middle,
            2.0 * middle,
            radius * radius - 2.0 * middle * middle,
        ],
        planes: all[..planes].to_vec(),
        normal: (
            [[1.0, 0.0, -middle], [0.0, 1.0, -middle], [0.0, 0.0, 0.0]],
            [0.0, 0.0, 1.0],
        ),
    }
}

/// The scans that rows are made of.
struct Scans {
    facet: Scan,
    solids: [Scan; 2],
    patches: [Scan; 2],
}

impl Scans {
    fn run() -> Scans {
        let counter = Counter::default();
        Scans {
            facet: pixel::facet(&counter, 20, FACET),
            solids: [128, 80].map(|side| pixel::solid(&counter, side, &ball(side, 3))),
            patches: [80, 64].map(|side| pixel::patch(&counter, side, &ball(side, 4))),
        }
    }
}

/// The source's count of a box: operations inside and outside, three quarters of it covered, and lines.
fn source(side: f64, inside: f64, outside: f64, line: f64) -> f64 {
    side * side * (0.75 * inside + 0.25 * outside) + side * line
}

/// The rows.
pub fn group() -> Group {
    let Scans {
        facet,
        solids,
        patches,
    } = Scans::run();
    let row = |name: &str, printed: f64, ours: f64| {
        Row::new(name, "chapter 5", printed, ours, "operations")
    };
    let covered = |scan: &Scan| 100.0 * scan.inside as f64 / scan.pixels() as f64;
    let boxed = |name: &str, printed: f64, scan: &Scan| {
        let covers = format!(
            "the object covers {:.1} % of the box, 75 % in the source",
            covered(scan)
        );
        row(name, printed, scan.total() as f64).why(covers)
    };
    let half = 200.0;
    let per_covered = |side: f64, total: f64| total / (0.75 * side * side);
    let source_facet = 4140.0 / half;
    let ratio = |name: &str, printed: &'static str, corrected: f64, ours: f64| {
        Row::new(name, "chapter 5", printed, ours, "times").corrected(corrected)
    };
    let [quadric, patch] = [&solids[1], &patches[0]];
    Group {
        name: "software",
        title: "Conversion in software",
        about: "A scalar program visits every pixel of the object's box and steps all its expressions on by forward differences. Ours is run on a triangle of half its box, on a ball cut by three planes and on a patch of four, all in real numbers, and \
                every operation at every pixel is counted, tests that are not reached left out."
            .into(),
        rows: vec![
            row("facet, pixel inside", 10.0, facet.per_inside()).why("seven steps and three tests, and one of the z-buffer, which the source leaves out"),
            row("facet, pixel outside", 10.0, facet.per_outside()).why("seven steps, and the tests up to the side that is missed"),
            row("facet, line", 7.0, facet.per_line()).why("seven steps"),
            row("facet of 20 x 20", 4140.0, facet.total() as f64).why("half of the box is inside"),
            row("quadric, pixel inside", 95.0, quadric.per_inside())
                .why("nine steps, a root, two sums, two tests for a plane and less where it does not cut; the source counts assignments, and two intervals at every pixel, of which a solid seen from the side has one"),
            row("quadric, pixel outside", 9.0, quadric.per_outside()).why("nine steps and the sign of f2, which the source leaves out; pixels that a plane removes are outside too"),
            row("quadric, line", 10.0, quadric.per_line()).why("three of the second degree, seven others"),
            boxed("quadric of 128 x 128", 1_205_504.0, &solids[0]),
            boxed("quadric of 80 x 80", 471_200.0, quadric),
            row("patch, pixel inside", 63.0, patch.per_inside()).why("ten steps; the near face is asked first, and the far one only where that is cut"),
            row("patch, pixel outside", 10.0, patch.per_outside()).why("ten steps and the sign of f2; faces that planes remove are outside too, after a root"),
            row("patch, line", 11.0, patch.per_line()).why("three of the second degree, eight others"),
            boxed("patch of 80 x 80", 319_280.0, patch),
            boxed("patch of 64 x 64", 204_480.0, &patches[1]),
            ratio("quadric of 80 x 80 over facet of 20 x 20", "more than 100", 471_200.0 / 4140.0, quadric.total() as f64 / facet.total() as f64)
                .why("the source's number of facets at which a quadric in software breaks even; it compares different areas"),
            ratio("quadric over facet, each covered pixel", "nothing", per_covered(80.0, source(80.0, 95.0, 9.0, 10.0)) / source_facet, quadric.per_covered() / facet.per_covered())
                .why("at equal area a quadric costs so many times a facet, however many facets it replaces"),
            ratio("patch over facet, each covered pixel", "nothing", per_covered(80.0, source(80.0, 63.0, 10.0, 11.0)) / source_facet, patch.per_covered() / facet.per_covered())
                .why("the same"),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn printed_totals_follow_from_printed_parts() {
        assert_eq!(20.0 * 20.0 * 10.0 + 20.0 * 7.0, 4140.0);
        assert_eq!(source(128.0, 95.0, 9.0, 10.0), 1_205_504.0);
        assert_eq!(source(80.0, 95.0, 9.0, 10.0), 471_200.0);
        assert_eq!(source(80.0, 63.0, 10.0, 11.0), 319_280.0);
        assert_eq!(source(64.0, 63.0, 10.0, 11.0), 204_480.0);
    }
}
