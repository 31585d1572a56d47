use imogene_studies::evaluate::duplication::{Edges, touched};
use imogene_studies::evaluate::{Evaluation, Hardware, Parts, evaluate};
use minijinja::Environment;
use serde::Deserialize;

/// Of the table, what the source counts in processors.
#[derive(Deserialize)]
struct Table {
    groups: Vec<Subject>,
}

#[derive(Deserialize)]
struct Subject {
    #[serde(default)]
    processors: Vec<Processor>,
}

#[derive(Deserialize)]
struct Processor {
    unit: String,
    #[serde(default)]
    parameters: String,
    counts: [usize; 4],
}

/// With the processors that the source counts.
fn evaluation() -> Evaluation {
    let table = include_str!("../../../src/evaluate/evaluation.toml");
    let table: Table = toml::from_str(table).unwrap();
    let all = table.groups.into_iter().flat_map(|group| group.processors);
    let parts = all.map(|processor| Parts {
        unit: processor.unit,
        parameters: processor.parameters,
        counts: processor.counts,
    });
    let hardware = Hardware {
        processors: parts.collect(),
        zone_timing: Default::default(),
    };
    evaluate(&hardware).unwrap()
}

/// Group and row, what the source's own sum gives, and how far the print may be rounded.
const PRINTED: &str = "
    facet: colours, contour following = 73 + 207 + 54
    facet: colours, expressions = 43 + 207 + 72
    facet: normals, contour following = 73 + 54
    facet: normals, expressions = 43 + 72
    facet: normals, contour following, all = 262 + 73 + 54 + 45
    facet: normals, expressions, all = 262 + 43 + 72 + 72
    frame: facet, all = 112 + 117 + 33
    frame: matrices of a quadric: product, determinant, cofactors = 112 + 95 + 272
    frame: inverse, all = 272 + 95 + 24
    quadric: quadric processor, all = 52 + 74 + 54 + 93
    quadric: patch processor, all = 51 + 74 + 120
    quadric: quadric, three planes = 182 + 84 + 273
    quadric: quadric, three planes, with matrices = 539 + 479
    quadric: patch, four planes, with matrices = 567 + 479
    polyhedron: polyhedron, all = 168 + 72 + 144 + 36 + 36
    zones: refinement, patch, 5 x 5 zones = 90 + 20 * 36
    zones: refinement, patch, 2 x 2 zones = 90 + 20 * 9
    zones: refinement, quadric, 5 x 5 zones = 420 + 30 * 36
    zones: refinement, quadric, 2 x 2 zones = 420 + 30 * 9
    zones: facet of 20 x 20 in zones of 32, mean = 174 +- 1
    zones: patch of 20 x 20 in zones of 32, mean = 330 +- 1
    zones: quadric of 20 x 20 in zones of 32, mean = 1006 +- 1
    software: facet of 20 x 20 = 20 * 20 * 10 + 20 * 7
    software: quadric of 128 x 128 = 128 * 128 * (0.75 * 95 + 0.25 * 9) + 128 * 10
    software: quadric of 80 x 80 = 80 * 80 * (0.75 * 95 + 0.25 * 9) + 80 * 10
    software: patch of 80 x 80 = 80 * 80 * (0.75 * 63 + 0.25 * 10) + 80 * 11
    software: patch of 64 x 64 = 64 * 64 * (0.75 * 63 + 0.25 * 10) + 64 * 11
    pipeline: processors that one link keeps busy, zones of 128 = 496
    pipeline: the same, zones of 64 = 124
    pipeline: zones of 128 of one processor = 2014 +- 0.5
    pipeline: zones of 64 of one processor = 8057 +- 0.5
    pipeline: patches times zones, zones of 128 = 1000000 +- 1
    pipeline: patches of 80 x 80, zones of 128 = 370000 +- 11100";

/// Sums of the printed tables, with the corrections: a slip in a printed number does not get through.
#[test]
fn printed_values_add_up() {
    let evaluation = evaluation();
    let arithmetic = Environment::new();
    let mut checked = 0;
    for line in PRINTED.trim().lines().map(str::trim) {
        let (group, rest) = line.split_once(": ").expect("a group");
        let (name, sum) = rest.split_once(" = ").expect("a sum");
        let (sum, rounded) = sum.split_once(" +- ").unwrap_or((sum, "0"));
        let row = evaluation.row(group, name);
        let row = row.unwrap_or_else(|| panic!("no {name}"));
        let sum = arithmetic.compile_expression(sum).expect("a sum");
        let sum = f64::try_from(sum.eval(()).expect("no names")).expect("a number");
        let off = row.reference().expect("a number") - sum;
        assert!(off.abs() <= rounded.parse().unwrap(), "{line}: {off}");
        checked += 1;
    }
    assert_eq!(checked, 33);
}

/// With eight corners of four zones in place of nine the source's parts give the printed means, to their last
/// digit.
#[test]
fn printed_means_take_eight_corners() {
    let share = touched(20, 32, Edges::Anywhere);
    let corners = 4.0 * share.one + 6.0 * share.two + 8.0 * share.four;
    for ([presort, set_up, corner, shift], printed) in [
        ([48.0, 0.0, 15.0, 14.0], 169.0),
        ([60.0, 90.0, 20.0, 26.0], 323.0),
        ([340.0, 420.0, 30.0, 24.0], 995.0f64),
    ] {
        let mean = presort + set_up + corner * corners + shift * (share.mean - 1.0);
        assert!((mean - printed).abs() <= 1.0, "{mean} {printed}");
    }
}

/// Our totals are the sums of our parts.
#[test]
fn our_sums_add_up() {
    let evaluation = evaluation();
    let ours = |group: &str, name: &str| evaluation.row(group, name).expect("a row").ours;
    let first = |group: &str, count: usize| -> f64 {
        let found = evaluation.groups.iter().find(|g| g.name == group);
        let rows = found.expect("a group").rows[..count].iter();
        rows.map(|row| row.ours).sum()
    };
    let of = |name: &str| ours("quadric", name);
    let (solid, patch) = (of("quadric processor, all"), of("patch processor, all"));
    assert_eq!(solid, first("quadric", 4));
    assert_eq!(patch, first("quadric", 2) + of("patch: four planes"));
    assert_eq!(of("quadric, three planes"), 182.0 + 84.0 + solid);
    assert_eq!(of("patch, four planes"), 182.0 + 140.0 + patch);
    let polyhedron = ours("polyhedron", "polyhedron, all");
    assert_eq!(polyhedron, first("polyhedron", 5));
    // Four PE2 and two PE1 (Chaillou, IV.2.4).
    let rows = evaluation.groups.iter().flat_map(|group| &group.rows);
    let mut sphere = rows.filter(|row| row.section == "Chaillou, IV.2.4" && row.unit == "a pixel");
    assert_eq!(sphere.next().map(|row| row.ours), Some(10.0));
}
