//! `imogene terrain` and `imogene import` of heights: files, reports, messages.

use crate::common::{json_in, refusal_in};

#[test]
fn heights_become_a_scene_and_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let made = ["terrain", "--levels", "3", "--seed", "5", "-o", "a.heights"];
    assert_eq!(json_in(&made, folder)["side"], 9);
    let text = std::fs::read(folder.join("a.heights")).unwrap();
    json_in(&made, folder);
    assert_eq!(std::fs::read(folder.join("a.heights")).unwrap(), text);
    for cells in ["bilinear", "ruled", "auto"] {
        let import = ["import", "a.heights", "--cells", cells, "-o", "a.toml"];
        let report = json_in(&import, folder);
        assert_eq!(
            (&report["kind"], &report["report"]["cells"]),
            (&"heights".into(), &64.into())
        );
        assert!(report["objects"].as_u64().unwrap() >= 64);
        let draw = [
            "render", "a.toml", "--model", "golden", "--size", "80x60", "-o", "a.png",
        ];
        assert!(
            json_in(&draw, folder)["covered_pixels"].as_u64().unwrap() > 400,
            "{cells}"
        );
    }
    // No hardware for what the eye lies on.
    json_in(
        &["import", "a.heights", "--cells", "ruled", "-o", "a.toml"],
        folder,
    );
    let draw = [
        "render", "a.toml", "--model", "rtl", "--size", "16x12", "-o", "b.png",
    ];
    let message = refusal_in(&draw, folder);
    assert!(
        message.contains("cell-") && message.contains("quotient processor"),
        "{message}"
    );
    assert!(!folder.join("b.png").exists());
}

#[test]
fn bad_files_and_options_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(
        folder.join("bad.asc"),
        "ncols 2\nnrows 2\ncellsize 5\n1 2 3 high\n",
    )
    .unwrap();
    std::fs::write(folder.join("good.heights"), "1 2\n3 5\n").unwrap();
    let message = refusal_in(&["import", "bad.asc", "-o", "x.toml"], folder);
    assert!(message.contains("bad.asc:4:7: `high`"), "{message}");
    let cases: [(&[&str], &str); 5] = [
        (
            &[
                "import",
                "good.heights",
                "--height-factor",
                "0",
                "-o",
                "x.toml",
            ],
            "height factor of 0",
        ),
        (
            &[
                "import",
                "good.heights",
                "--region",
                "0,0,3,3",
                "-o",
                "x.toml",
            ],
            "within the grid of 2 x 2",
        ),
        (
            &["import", "good.heights", "--eye-at", "1,2", "-o", "x.toml"],
            "three numbers",
        ),
        (&["terrain", "--levels", "11", "-o", "x.toml"], "1 to 10"),
        (
            &["terrain", "--roughness", "2", "-o", "x.toml"],
            "0 (rough) to 1 (smooth)",
        ),
    ];
    for (arguments, says) in cases {
        let message = refusal_in(arguments, folder);
        assert!(message.contains(says), "{message}");
        assert!(!folder.join("x.toml").exists());
    }
}
