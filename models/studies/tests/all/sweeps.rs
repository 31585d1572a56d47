//! The sweeps: the rules hold at every step, refusals come where the format gives out, and errors grow and shrink as
//! theory says.

use imogene_analysis::bounds::depth_bound;
use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_studies::sweep;
use imogene_studies::sweep::{
    Figures, GivesOut, Notice, Record, SweepResult, UnknownSweep, find, names, plot, section,
};
use std::path::Path;
use std::sync::LazyLock;

/// Every sweep in the base format, run once for all tests.
static RESULTS: LazyLock<Vec<SweepResult>> = LazyLock::new(|| {
    let run = |sweep: &sweep::Sweep| sweep.run(Format::BASE, |_| true, || ());
    sweep::ALL.iter().map(run).collect()
});

fn result(name: &str) -> &'static SweepResult {
    let found = RESULTS.iter().find(|r| r.name == name);
    found.expect("a sweep")
}

fn record(name: &str, series: usize, parameter: &str) -> &'static Record {
    let result = result(name);
    let mut records = result.records.iter();
    let found = records.find(|r| r.series == result.series[series] && r.parameter == parameter);
    found.expect("a step")
}

fn figures(name: &str, series: usize, parameter: &str) -> &'static Figures {
    let found = record(name, series, parameter).figures.as_ref();
    found.expect("a step that is drawn")
}

/// The figures of all steps of a series that are drawn.
fn drawn(name: &str, series: usize) -> Vec<&'static Figures> {
    let result = result(name);
    let records = result.records.iter();
    records
        .filter(|r| r.series == result.series[series])
        .filter_map(|r| r.figures.as_ref())
        .collect()
}

fn hold_the_rules(result: &SweepResult) {
    let name = result.name;
    assert_eq!(result.violations, Vec::<String>::new(), "{name}");
    for record in &result.records {
        let at = format!("{name}, {}, {}", record.series, record.parameter);
        assert_ne!(record.refused.is_some(), record.figures.is_some(), "{at}");
        let Some(f) = &record.figures else {
            continue;
        };
        let (o, r) = (&f.observed, &f.ratios);
        let ratios = [r.depth, r.silhouette, r.normal];
        assert!(ratios.iter().all(|&ratio| ratio <= 1.0), "{at}");
        assert!(o.depth_words <= f.bounds.depth_words + 1e-9, "{at}");
        assert!(o.silhouette_pixels + o.wrong_faces <= f.undecided, "{at}");
        // A picture that is wrong in a tenth of its pixels is turned down before.
        let wrong = o.silhouette_pixels * 10 > f.covered && f.covered > 100;
        let is_told = f.check_failed.is_some();
        assert!(!wrong || is_told, "{at}: wrong without notice");
    }
}

#[test]
fn no_bound_is_exceeded_and_every_wrong_pixel_was_announced() {
    for result in RESULTS.iter() {
        hold_the_rules(result);
    }
    let records = RESULTS.iter().flat_map(|r| &r.records);
    let compared = records.filter_map(|r| Some(r.figures.as_ref()?.observed.compared));
    let compared: usize = compared.sum();
    assert!(compared > 500_000, "{compared}");
}

#[test]
fn the_rules_hold_in_the_shortest_and_the_longest_word() {
    for depth in [16, 32] {
        let format = Format::new(depth).expect("in the catalogue");
        for sweep in sweep::ALL.iter().filter(|s| !s.has_own_formats()) {
            let few = |parameter: &str| ["10", "1", "0.01", "100", "0.0001"].contains(&parameter);
            hold_the_rules(&sweep.run(format, few, || ()));
        }
    }
}

/// Sweep, series, first and last value, and what the message says.
const REFUSED: &str = "
    cylinder-axis 0 0.007 0.000001 f2 reaches 2^47.6
    cylinder-axis 1 0.00007 0.000001 object 'rod': too large
    cylinder-axis 2 0.1 0 would need 49 bits, the word has 48
    eye-distance 0 3 0.000001 object 'ball': too large
    eye-distance 0 0 0 the viewer lies exactly on this quadric
    eye-distance 1 3 0.000001 object 'ball': too large
    eye-distance 1 0 0 the viewer lies exactly on this quadric
    eye-distance 2 3 0.000001 object 'ball': too large
    eye-distance 2 0 0 the viewer lies exactly on this quadric
    steep-plane 0 0.00001 0.000000001 cut 0: the plane passes so nearly through the viewer
    steep-plane 2 0.000001 0.000000001 the plane word has 36
    viewer-distance 0 20 28 f2 reaches 2^69.3
    viewer-distance 1 20 28 `near =
    word-length 1 31 32 4 guard bits of f2 make its processor 66 bits wide
    word-length 2 29 32 8 guard bits of f2 make its processor 66 bits wide
    word-length 3 25 32 16 guard bits of f2 make its processor 66 bits wide";

#[test]
fn refusals_come_where_the_format_gives_out() {
    let refused = RESULTS.iter().flat_map(|result| {
        let runs = result.gives_out.iter().map(move |g| (result, g));
        runs.filter(|(_, g)| g.by == Notice::Refused)
    });
    let found: Vec<_> = refused.collect();
    let expected: Vec<&str> = REFUSED.trim().lines().map(str::trim).collect();
    assert_eq!(found.len(), expected.len());
    for ((result, run), line) in found.into_iter().zip(expected) {
        let series = result.series.iter().position(|name| *name == run.series);
        let series = series.expect("a series");
        let values = format!("{} {series} {} {} ", result.name, run.first, run.last);
        let text = line.strip_prefix(&values);
        let text = text.unwrap_or_else(|| panic!("{values}: {line}"));
        assert!(run.message.contains(text), "{line}: {}", run.message);
    }
}

#[test]
fn a_silhouette_without_a_bound_fails_the_check_before_it_is_wrong() {
    let mut failing = vec![];
    for result in RESULTS.iter() {
        let runs = result
            .gives_out
            .iter()
            .filter(|g| g.by == Notice::CheckFails);
        failing.extend(runs.map(|g| (result.name, g.series, g.first.as_str())));
    }
    let expected = [
        ("viewer-distance", "whole ball", "10000000"),
        ("viewer-distance", "cut ball", "10000000"),
        ("thin", "leaf", "0.001"),
    ];
    assert_eq!(failing, expected);
}

/// Range scales with the word, so that a longer one does not move the refusals; what becomes too small moves by the
/// weight of its bits.
#[test]
fn longer_words_move_failing_checks_and_no_refusals() {
    let rows = [
        (16, "100000", "0.1"),
        (20, "1000000", "0.01"),
        (28, "100000000", "0.00001"),
        (32, "1000000000", "0.000001"),
    ];
    for (depth, distance, thickness) in rows {
        let format = Format::new(depth).expect("in the catalogue");
        let run = |name: &str, wanted: &[&str]| {
            let sweep = find(name).expect("a sweep");
            let result = sweep.run(format, |p| wanted.contains(&p), || ());
            let none = Vec::<String>::new();
            assert_eq!(result.violations, none, "{name}, {depth} bits");
            result.gives_out
        };
        let first = |runs: &[GivesOut], by: Notice| {
            let found = runs.iter().filter(|r| r.by == by);
            found.map(|r| r.first.clone()).collect::<Vec<_>>()
        };
        let axis = run("cylinder-axis", &["0.01", "0.007", "0.0001", "0.00007"]);
        assert_eq!(first(&axis, Notice::Refused), ["0.007", "0.00007", "0.01"]);
        let before: f64 = distance.parse().expect("a decimal");
        let before = (before / 10.0).to_string();
        let viewer = run("viewer-distance", &["28", "29", &before, distance]);
        assert_eq!(first(&viewer, Notice::Refused), ["28", "28"]);
        assert_eq!(first(&viewer, Notice::CheckFails), [distance, distance]);
        let thin = run("thin", &["1", thickness]);
        assert_eq!(first(&thin, Notice::CheckFails), [thickness]);
    }
}

#[test]
fn what_is_off_the_screen_or_between_the_pixels_is_said() {
    let beyond = record("side-offset", 1, "260").notice().expect("said");
    assert_eq!(beyond.0, Notice::NothingDrawn);
    assert!(beyond.1.contains("outside the screen"), "{}", beyond.1);
    let cap = record("tangent-plane", 1, "40").notice().expect("said");
    assert!(cap.1.contains("no pixel shows it"), "{}", cap.1);
}

/// The world can be moved anywhere: not a single figure changes. Floating point in scene coordinates loses the picture.
#[test]
fn an_offset_of_the_world_changes_nothing() {
    let text = |r: &Record| serde_json::to_string(&r.figures).expect("serialisable");
    let records = &result("world-offset").records;
    assert!(records.len() > 12);
    for record in records {
        assert_eq!(text(record), text(&records[0]), "{}", record.parameter);
    }
    let bound = figures("world-offset", 0, "0").bounds.depth_px;
    let naive = |parameter| record("world-offset", 0, parameter).naive;
    let floats = |parameter| naive(parameter).expect("compared");
    assert!(floats("0").single.depth_px < 0.01 && floats("0").single.silhouette_pixels == 0);
    assert!(floats("1000.1").single.depth_px > 500.0 * bound);
    assert!(floats("100000.1").single.silhouette_pixels > 1000);
    assert!(floats("0").double.depth_px < 1e-9);
    assert!(floats("100000000.1").double.depth_px > 500.0 * bound);
}

/// f2 grows with the square of the cotangent, its error does not: so many bits more, and so much less displacement.
#[test]
fn a_turning_cylinder_needs_two_bits_for_each_halving_of_the_angle() {
    let at = |tangent| figures("cylinder-axis", 1, tangent);
    let bits = |tangent| f64::from(at(tangent).needed.quadratic);
    let steps = [
        ("1", "0.1", 10f64),
        ("0.1", "0.01", 10.0),
        ("0.1", "0.0001", 1e3),
    ];
    for (from, to, ratio) in steps {
        let grown = bits(to) - bits(from);
        let off = (grown - 2.0 * ratio.log2()).abs();
        assert!(off < 1.5, "{from} to {to}: {grown}");
    }
    let moved = |tangent| at(tangent).bounds.silhouette_px;
    assert!(moved("0.1") < moved("1") / 10.0 && moved("0.001") < moved("0.1") / 1000.0);
}

/// Bits of a longer word halve the depth error and quarter the silhouette's, up to what rounding happens to give.
#[test]
fn longer_words_and_guard_bits_do_what_they_are_for() {
    let at = |series, depth: u32| figures("word-length", series, &depth.to_string());
    for depth in 12..=24 {
        let (short, long) = (at(0, depth).bounds, at(0, depth + 8).bounds);
        let depths = short.depth_px / long.depth_px;
        let silhouettes = short.silhouette_px / long.silhouette_px;
        assert!((64.0..1024.0).contains(&depths), "{depth}: {depths}");
        let range = 2048.0..4e6;
        assert!(range.contains(&silhouettes), "{depth}: {silhouettes}");
        // 16 guard bits of f2 are worth 2^16 in its error.
        let guarded = at(0, depth).bounds.silhouette_px / at(3, depth).bounds.silhouette_px;
        assert!(guarded > 500.0, "{depth}: {guarded}");
        assert!(at(3, depth).bounds.depth_words <= at(0, depth).bounds.depth_words + 1e-9);
    }
    // Normals have words of their own.
    let normal = |depth| at(0, depth).bounds.normal_deg;
    assert!(normal(12) > 10.0 && (normal(24) - normal(32)).abs() < 0.001);
}

/// A word is worth D / 2^23 pixels: the error in pixels grows with D, the silhouette's with its square.
#[test]
fn a_distant_viewer_costs_depth_and_silhouette() {
    let at = |distance| figures("viewer-distance", 0, distance).bounds;
    let distances = ["100", "1000", "10000", "100000", "1000000", "10000000"];
    for pair in distances.windows(2) {
        let ratio = at(pair[1]).silhouette_px / at(pair[0]).silhouette_px;
        assert!((10.0..1000.0).contains(&ratio), "{pair:?}: {ratio}");
    }
    for f in drawn("viewer-distance", 0) {
        assert!(f.bounds.depth_words < 30.0);
    }
}

/// Camera and distance to scale: the ball grows on the screen, and nothing gets worse.
#[test]
fn an_eye_that_takes_its_screen_along_comes_as_near_as_it_likes() {
    let found = drawn("eye-distance", 3);
    assert!(found.len() > 20);
    for f in found {
        assert!(f.needed.quadratic <= 45 && f.bounds.depth_words < 20.0);
        assert!(f.bounds.normal_deg < 0.014);
    }
}

/// The error of a sphere's depth is a function of f2: at the limb up to the root of the error of f2, from where f2 is
/// greater than that error on it falls, and inside no more is left than the error of f1 and the floor of the root.
#[test]
fn the_depth_error_of_a_sphere_is_largest_at_its_limb() {
    let sweep = find("sphere-radius").expect("a sweep");
    for (series, radius, file) in sweep.scenes(Format::BASE) {
        let scene = file.frame(96, 72).expect("valid");
        let prepared = prepare(&scene, Format::BASE).expect("fits");
        let (_, ball) = prepared.quadrics().next().expect("a ball");
        let (e1, e2) = (ball.bounds.f1, ball.bounds.f2);
        let limb = e1 + e2.sqrt() + 1.0;
        let mut last = limb;
        for power in 0..24u32 {
            // Squares, so that the floor of the root costs the same everywhere.
            let f2 = 1i64 << (2 * power);
            let bound = depth_bound(ball, 0, f2);
            assert!(bound <= limb + 1e-6, "{series}, {radius}, f2 = 4^{power}");
            if f2 as f64 >= e2 {
                assert!(bound <= last + 1e-6, "{series}, {radius}, f2 = 4^{power}");
                last = bound;
            }
        }
        let least = e1 + e2.sqrt();
        assert!(depth_bound(ball, 0, 0) >= least, "{series}, {radius}");
        assert!(last < e1 + 1.01, "{series}, {radius}");
    }
}

/// Thinner than the errors of its two planes, a slab is undecided everywhere; thicker, nowhere but at a few pixels of
/// its edge.
#[test]
fn a_slab_is_undecided_below_the_errors_of_its_planes() {
    let at = |thickness| figures("thin", 0, thickness);
    for thickness in ["10", "0.1", "0.001", "0.00001"] {
        assert!(at(thickness).undecided < 10, "{thickness}");
    }
    for thickness in ["0.000004", "0.0000001"] {
        let slab = at(thickness);
        assert!(slab.undecided >= slab.covered, "{thickness}");
    }
    let lune = |thickness| figures("thin", 1, thickness);
    assert!(lune("1").undecided < 10);
    assert!(lune("0.0000001").undecided * 10 > lune("0.0000001").covered * 9);
}

/// On the screen the flat face of a cap of height h is an ellipse of area 0.8 pi 2 R h.
#[test]
fn a_cap_that_shrinks_keeps_its_area() {
    for k in [14, 16, 18] {
        let height = 2048.0 * 0.5f64.powi(k);
        let area = 0.8 * std::f64::consts::PI * 2.0 * 2048.0 * height;
        let covered = figures("tangent-plane", 1, &k.to_string()).covered as f64;
        let off = (covered / area - 1.0).abs();
        assert!(off < 0.06, "k = {k}: {covered}, {area}");
    }
}

/// A plane whose edge lies between the pixel centres is never refused: one of its two forms always does.
#[test]
fn a_steep_plane_between_pixel_centres_is_drawn_at_every_inclination() {
    for series in [1, 3] {
        assert_eq!(drawn("steep-plane", series).len(), 11);
        let steepest = figures("steep-plane", series, "0.000000001");
        let perpendicular = figures("steep-plane", series, "0");
        assert_eq!(steepest.covered, perpendicular.covered);
        assert_eq!(steepest.observed, perpendicular.observed);
    }
}

#[test]
fn every_sweep_has_scenes_that_can_be_written_and_names_that_can_be_found() {
    for name in names() {
        let sweep = find(name).expect("listed");
        for (series, parameter, scene) in sweep.scenes(Format::BASE) {
            if let Ok(text) = scene.to_toml() {
                let again = imogene_scene::SceneFile::parse(&text, "again.toml");
                let again = again.expect("valid");
                assert_eq!(again, scene, "{name}, {series}, {parameter}");
            }
        }
    }
    let unknown = find("axis").err().expect("unknown");
    let name = "axis".to_owned();
    assert_eq!(unknown, UnknownSweep { name });
    assert!(unknown.to_string().contains("cylinder-axis, eye-distance"));
}

/// The page and its plots are what the program says today.
#[test]
fn the_page_and_the_plots_are_current() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let page = std::fs::read_to_string(docs.join("sweeps.md")).expect("the page");
    let advice =
        "run `imogene sweep --out docs/images/sweeps` and renew docs/sweeps.md as its end says";
    for result in RESULTS.iter() {
        let name = result.name;
        let text = section(result, Some("images/sweeps/")).unwrap();
        assert!(page.contains(&text), "{name} on docs/sweeps.md: {advice}");
        let kept = docs.join("images/sweeps").join(format!("{name}.svg"));
        let kept = std::fs::read_to_string(kept).expect("a plot");
        let now = plot(result).expect("a plot");
        assert!(kept == now, "{name}.svg: {advice}");
    }
}
