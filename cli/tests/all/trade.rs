//! `imogene trade`: files, keys, commands that reproduce, refusals.

use crate::common::{Place, Run, assert_keys, scene};
use serde_json::Value;

/// A trade of a scene into a folder of the place.
fn trade(place: &Place, name: &str, more: &str) -> Run {
    sized_trade(place, name, "48x36", more)
}

fn sized_trade(place: &Place, name: &str, size: &str, more: &str) -> Run {
    let options = format!("--size {size} --points quick --no-cost");
    place.run(&format!("--json trade scenes/{name} {options} {more}"))
}

#[test]
fn every_file_is_written_whatever_the_parts() {
    let place = Place::new();
    let into = |out: &str| trade(&place, "cut-sphere.toml", &format!("--out {out}")).ended(0);
    let summary = into("out").json();
    assert_eq!(summary["files"].as_array().unwrap().len(), 7);
    place.assert_files(&summary);
    let report: Value = serde_json::from_str(&place.text("out/trade.json")).unwrap();
    let points = report["points"].as_array().unwrap();
    assert_eq!(points.len() as u64, summary["points"]);
    for point in points {
        assert_keys(point, "format unit errors cost command");
    }
    // Again, from what is kept; and in two parts.
    let read = |out: &str| {
        let text = place.text(&format!("{out}/trade.json"));
        text.replace(&format!("{out}/"), "OUT/")
    };
    let first = read("out");
    into("out");
    assert!(read("out") == first);
    for part in ["2/2", "1/2"] {
        let shard = format!("--out parts --shard {part}");
        let done = trade(&place, "cut-sphere.toml", &shard).ended(0).json();
        assert!(done["points"].as_u64().unwrap() > 0);
        assert!(!place.has("parts/trade.json"));
    }
    into("parts");
    assert!(read("parts") == first);
}

/// The command of a point draws its picture, in hardware as in the golden model, and the hardware takes as many clocks
/// from frame to frame as the point says.
#[test]
fn every_point_is_a_machine_that_draws_its_picture_in_its_clocks() {
    let place = Place::new();
    sized_trade(&place, "cut-sphere.toml", "96x32", "--out out").ended(0);
    let report: Value = serde_json::from_str(&place.text("out/trade.json")).unwrap();
    let points = report["points"].as_array().unwrap();
    let of = |id: &str| points.iter().find(|point| point["id"] == id).unwrap();
    for id in [
        "w20-n16-g0.0-d3-r2",
        "w16-n16-g0.0-d0-z16k1-r2",
        "w16-n16-g0.0-d0-s2-z16k2-r1",
        "w16-n16-g0.0-d0-p2-r1",
        "w12-n16-g0.0-d0-iterative-r1",
        "w16-n16-g0.0-d0-t32-r1",
        "w16-n16-g0.0-d0-t32-c2-r1",
        "w16-n16-g0.0-d0-t32-z16k2-r1",
    ] {
        let point = of(id);
        let command = point["command"].as_str().unwrap();
        let name = scene("cut-sphere.toml");
        let cycles = [1, 2, 3].map(|times| {
            let names = vec![name.as_str(); times].join(" ");
            let command = command.replacen(&name, &names, 1);
            let shown = place.reproduced(&command.into(), id);
            assert_eq!(shown["report"]["mismatches"], 0, "{id}");
            shown["report"]["cycles"].as_u64().unwrap()
        });
        let clocks = point["clocks_per_frame"].as_u64().unwrap();
        assert_eq!(cycles[2] - cycles[1], clocks, "{id}");
        assert!(cycles[0] > clocks, "{id}");
        if !id.contains("-p2") {
            let kept = format!("out/{}", point["picture"].as_str().unwrap());
            let seen = format!("{id}/pins.png");
            assert!(place.bytes(&seen) == place.bytes(&kept), "{id}");
        }
    }
    let point = of("w24-n16-g0.0-d0-r1");
    place.reproduced(&point["emit"], "emitted");
    assert!(place.has("emitted/beam_stream.v"));
}

#[test]
fn zones_and_widths_of_one_picture() {
    let place = Place::new();
    let line = "render scenes/cone.toml --size 64x48 -o p.png";
    let render = |more: &str| place.run(&format!("{line} {more}"));
    let picture = |more: &str| {
        render(more).ended(0);
        place.bytes("p.png")
    };
    let by_widths = picture("--widths depth=16");
    assert!(picture("--format 16") == by_widths);
    assert!(picture("--widths depth=12 --zone 16") != by_widths);
    let golden = picture("--widths depth=20,root=18");
    assert!(picture("--widths depth=20,root=18 --model rtl") == golden);
    std::fs::remove_file(place.path("p.png")).unwrap();
    for (more, wanted) in [
        ("--widths depth=40", "accepted are 8 to 32"),
        ("--widths root=12", "depth=W"),
        ("--widths depth=16 --format 16", "cannot be used with"),
        ("--zone 16 --model exact", "--model golden"),
        ("--zone 1", "8..=4096"),
    ] {
        render(more).refused(&[wanted]);
        assert!(!place.has("p.png"));
    }
}

#[test]
fn bad_input_is_refused_and_writes_nothing() {
    let place = Place::new();
    for (name, more, wanted) in [
        ("processors/mesh.toml", "", "processor \"facet\""),
        ("cone.toml", "--target abacus", "abacus"),
        ("cone.toml", "--shard 3/2", "K from 1 to N"),
        ("cone.toml", "--shard 0/2", "K from 1 to N"),
        ("nowhere.toml", "", "nowhere.toml"),
    ] {
        let refused = trade(&place, name, &format!("--out out {more}")).refused(&[wanted]);
        assert_eq!(refused.json()["error"]["exit_code"], 2);
        assert!(!place.has("out"), "{name} {more}");
    }
}
