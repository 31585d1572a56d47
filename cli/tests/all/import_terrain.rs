//! `imogene terrain` and `imogene import` of heights: files, reports, messages.

use crate::common::{Place, columns};

#[test]
fn heights_become_a_scene_and_a_picture() {
    let place = Place::new();
    let made = "terrain --levels 3 --seed 5 -o a.heights";
    assert_eq!(place.json(made)["side"], 9);
    let text = place.bytes("a.heights");
    place.json(made);
    assert_eq!(place.bytes("a.heights"), text);
    for cells in ["bilinear", "ruled", "auto"] {
        let report = place.json(&format!("import a.heights --cells {cells} -o a.toml"));
        assert_eq!(report["kind"], "heights");
        assert_eq!(report["report"]["cells"], 64);
        assert!(report["objects"].as_u64().unwrap() >= 64);
        let drawn = place.json("render a.toml --model golden --size 80x60 -o a.png");
        let covered = drawn["covered_pixels"].as_u64().unwrap();
        assert!(covered > 400, "{cells}");
    }
    // The eye lies on every ruled cell.
    place.json("import a.heights --cells ruled -o a.toml");
    for model in ["rtl", "golden"] {
        place.json(&format!(
            "render a.toml --model {model} --size 80x60 -o {model}.png"
        ));
    }
    assert_eq!(place.bytes("rtl.png"), place.bytes("golden.png"));
}

#[test]
fn bad_files_and_options_are_refused() {
    let place = Place::new();
    place.write("bad.asc", "ncols 2\nnrows 2\ncellsize 5\n1 2 3 high\n");
    place.write("good.heights", "1 2\n3 5\n");
    let cases = "
        import bad.asc                        | bad.asc:4:7: `high`
        import good.heights --height-factor 0 | height factor of 0
        import good.heights --region 0,0,3,3  | within the grid of 2 x 2
        import good.heights --eye-at 1,2      | three numbers
        terrain --levels 11                   | 1 to 10
        terrain --roughness 2                 | 0 (rough) to 1 (smooth)
    ";
    for [line, says] in columns(cases) {
        place.run(&format!("{line} -o x.toml")).refused(&[says]);
        assert!(!place.has("x.toml"));
    }
}
