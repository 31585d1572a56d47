//! `imogene detail`, `render --split` and `machine --refine`: less work, the same picture.

use crate::common::{Place, json, run};
use serde_json::Value;

#[test]
fn a_divided_picture_is_the_whole_one() {
    let place = Place::new();
    let line = "render scenes/teapot.toml --size 83x61 -o p.png --ids i.npy";
    let draw = |more: &str| {
        let value = place.json(&format!("{line} {more}"));
        (value, place.bytes("p.png"), place.bytes("i.npy"))
    };
    let whole = draw("");
    assert_eq!(whole.0["split"], Value::Null);
    for (split, workers, pieces) in [("zones:16x16", 3, 24), ("lines:3", 2, 3)] {
        let divided = draw(&format!("--split {split} --workers {workers}"));
        assert!(divided.1 == whole.1 && divided.2 == whole.2, "{split}");
        let report = &divided.0["split"];
        assert_eq!(report["split"], split);
        assert_eq!(report["pieces"], pieces);
        assert_eq!(report["workers"].as_array().map(Vec::len), Some(workers));
        let balance = report["balance"].as_f64().expect("a number");
        assert!(balance > 0.3 && balance <= 1.0);
    }
}

#[test]
fn bad_splits_are_refused_and_write_nothing() {
    let place = Place::new();
    for (more, part) in [
        ("--split tiles:3", "zones:WxH or lines:N"),
        ("--split lines:0", "zones:WxH or lines:N"),
        ("--split lines:2 --workers 0", "1..=1024"),
        ("--workers 2", "--split"),
        ("--split lines:2 --zone 16", "--zone"),
        ("--split lines:2 --model exact", "--model golden"),
    ] {
        let line = "render scenes/teapot.toml --size 40x30 -o p.png";
        place.run(&format!("{line} {more}")).refused(&[part]);
    }
    assert!(!place.has("p.png"));
}

#[test]
fn the_picture_of_what_is_left_is_the_picture() {
    let place = Place::new();
    let scene = "scenes/shadows/robot.toml --size 80x60";
    place.json(&format!("render {scene} -o whole.png"));
    let value = place.json(&format!("detail {scene} --zone 16 --out detail"));
    assert_eq!(value["changed"]["pixels"], 0);
    assert!(place.bytes("detail/picture.png") == place.bytes("whole.png"));
    place.assert_files(&value);
    assert_eq!(value["files"].as_array().map(Vec::len), Some(3));
    let volumes = [0, 1, 2].map(|refinement| {
        let stream = &value["zone_streams"][refinement];
        stream["volumes"].as_u64().expect("a count")
    });
    assert!(volumes[2] <= volumes[1] && volumes[1] < volumes[0]);
    let lossy = json(&format!("detail {scene} --pixels 30"));
    assert!(lossy["work"]["planes"][1].as_u64() <= value["work"]["planes"][1].as_u64());
    run(&format!("detail {scene} --zone 3")).refused(&["8..=4095"]);
    run("detail scenes/none.toml").refused(&["scenes/none.toml"]);
}

const ZONE: &str = "
machine = \"zone\"
objects = 3
planes = 4
volumes = 2
volume_planes = 10
rows_per_stage = 6
lights = 2
mode = { columns = [40, 4, 4, 4], lines = [30, 2, 2, 40] }
zone = { width = 16, height = 16 }
";

#[test]
fn a_refined_stream_gives_the_same_picture_in_fewer_clocks() {
    let place = Place::new();
    place.write("machine.toml", ZONE);
    let line = "machine scenes/shadows/robot.toml --machine machine.toml --emit-only";
    let [boxes, bounds, pixels] = ["box", "bounds", "pixels"].map(|refine| {
        let value = place.json(&format!("{line} --refine {refine} --out {refine}"));
        let clocks = value["zone_clocks"][0]["total"].as_u64().expect("clocks");
        (clocks, place.bytes(&format!("{refine}/golden.png")))
    });
    assert!(boxes.1 == bounds.1 && boxes.1 == pixels.1);
    assert!(bounds.0 < boxes.0 && pixels.0 <= bounds.0);
}
