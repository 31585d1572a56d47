//! `imogene detail`, `render --split` and `machine --refine`: less work, the same picture.

use crate::common::imogene;
use serde_json::Value;
use std::path::Path;
use std::process::Output;

fn run(arguments: &[&str]) -> Output {
    let mut command = imogene();
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    command.args(arguments).output().expect("the program runs")
}

fn json(arguments: &[&str]) -> Value {
    let output = run(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    serde_json::from_slice(&output.stdout).expect("one JSON document")
}

fn refused(arguments: &[&str], wanted: &str) {
    let output = run(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains(wanted), "no '{wanted}' in: {said}");
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a plain path")
}

#[test]
fn a_divided_picture_is_the_whole_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    let scene = ["render", "scenes/teapot.toml", "--size", "83x61", "--json"];
    let draw = |name: &str, more: &[&str]| {
        let (png, ids) = (file(&format!("{name}.png")), file(&format!("{name}.npy")));
        let output = ["-o", text(&png), "--ids", text(&ids)];
        let value = json(&[&scene[..], &output, more].concat());
        (
            value,
            std::fs::read(png).expect("a picture"),
            std::fs::read(ids).expect("ids"),
        )
    };
    let whole = draw("whole", &[]);
    assert_eq!(whole.0["split"], Value::Null);
    for (split, workers, pieces) in [("zones:16x16", "3", 24), ("lines:3", "2", 3)] {
        let divided = draw(
            &workers.repeat(2),
            &["--split", split, "--workers", workers],
        );
        assert!(divided.1 == whole.1 && divided.2 == whole.2, "{split}");
        let report = &divided.0["split"];
        assert_eq!(report["split"], split);
        assert_eq!(report["pieces"], pieces);
        assert_eq!(
            report["workers"]
                .as_array()
                .expect("workers")
                .len()
                .to_string(),
            workers
        );
        let balance = report["balance"].as_f64().expect("a number");
        assert!(balance > 0.3 && balance <= 1.0);
    }
}

#[test]
fn bad_splits_are_refused_and_write_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let png = folder.path().join("p.png");
    let scene = [
        "render",
        "scenes/teapot.toml",
        "--size",
        "40x30",
        "-o",
        text(&png),
    ];
    let with = |more: &[&str], wanted: &str| refused(&[&scene[..], more].concat(), wanted);
    with(&["--split", "tiles:3"], "zones:WxH or lines:N");
    with(&["--split", "lines:0"], "zones:WxH or lines:N");
    with(&["--split", "lines:2", "--workers", "0"], "1..=1024");
    with(&["--workers", "2"], "--split");
    with(&["--split", "lines:2", "--zone", "16"], "--zone");
    with(
        &["--split", "lines:2", "--model", "exact"],
        "--model golden",
    );
    assert!(!png.exists());
}

#[test]
fn the_picture_of_what_is_left_is_the_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = "scenes/shadows/robot.toml";
    let whole = folder.path().join("whole.png");
    json(&[
        "render",
        scene,
        "--size",
        "80x60",
        "-o",
        text(&whole),
        "--json",
    ]);
    let out = folder.path().join("detail");
    let value = json(&[
        "detail",
        scene,
        "--size",
        "80x60",
        "--zone",
        "16",
        "--out",
        text(&out),
        "--json",
    ]);
    assert_eq!(value["changed"]["pixels"], 0);
    let picture = std::fs::read(out.join("picture.png")).expect("a picture");
    assert!(picture == std::fs::read(whole).expect("a picture"));
    for file in value["files"].as_array().expect("files") {
        assert!(
            Path::new(file.as_str().expect("a path")).is_file(),
            "{file}"
        );
    }
    assert_eq!(value["files"].as_array().map(Vec::len), Some(3));
    let volumes = |place: usize| {
        value["zone_streams"][place]["volumes"]
            .as_u64()
            .expect("a count")
    };
    assert!(volumes(2) <= volumes(1) && volumes(1) < volumes(0));
    let lossy = json(&[
        "detail", scene, "--size", "80x60", "--pixels", "30", "--json",
    ]);
    assert!(lossy["work"]["planes"][1].as_u64() <= value["work"]["planes"][1].as_u64());
    refused(&["detail", scene, "--zone", "3"], "8..=4095");
    refused(&["detail", "scenes/none.toml"], "scenes/none.toml");
}

#[test]
fn a_refined_stream_gives_the_same_picture_in_fewer_clocks() {
    let folder = tempfile::tempdir().expect("a folder");
    let description = folder.path().join("machine.toml");
    std::fs::write(&description, "machine = \"zone\"\nobjects = 3\nplanes = 4\nvolumes = 2\nvolume_planes = 10\nrows_per_stage = 6\nlights = 2\nmode = { columns = [40, 4, 4, 4], lines = [30, 2, 2, 40] }\nzone = { width = 16, height = 16 }\n").expect("a file");
    let show = |name: &str, refine: &str| {
        let out = folder.path().join(name);
        let value = json(&[
            "machine",
            "scenes/shadows/robot.toml",
            "--machine",
            text(&description),
            "--refine",
            refine,
            "--emit-only",
            "--out",
            text(&out),
            "--json",
        ]);
        let picture = std::fs::read(out.join("golden.png")).expect("a picture");
        (
            value["zone_clocks"][0]["total"].as_u64().expect("clocks"),
            picture,
        )
    };
    let [boxes, bounds, pixels] = ["box", "bounds", "pixels"].map(|refine| show(refine, refine));
    assert!(boxes.1 == bounds.1 && boxes.1 == pixels.1);
    assert!(bounds.0 < boxes.0 && pixels.0 <= bounds.0);
}
