//! `imogene fit` and machines of any widths on the command line.

use assert_cmd::Command;
use serde_json::Value;
use std::path::{Path, PathBuf};

fn imogene(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("imogene").unwrap();
    command
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .args(arguments);
    command
}

fn output(command: &mut Command) -> (i32, String, String) {
    let output = command.output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (
        output.status.code().unwrap(),
        text(&output.stdout),
        text(&output.stderr),
    )
}

/// Search, Verilog and pins on a real scene; in the full run with the costs of both machines, whose shading processor
/// takes a minute of synthesis.
#[test]
fn a_scene_is_fitted_emitted_and_compared() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("fit");
    let with_costs = std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1");
    let (code, stdout, stderr) = output(
        imogene(&[
            "--json",
            "fit",
            "scenes/cut-sphere.toml",
            "--size",
            "48x36",
            "--max-depth-error",
            "0.5px",
            "--max-silhouette-errors",
            "0",
            "--out",
            out.to_str().unwrap(),
        ])
        .args((!with_costs).then_some("--no-cost")),
    );
    assert_eq!(code, 0, "{stderr}");
    let report: Value = serde_json::from_str(&stdout).unwrap();
    for limit in report["limits"].as_array().unwrap() {
        let (measured, allowed) = (limit["measured"].as_f64(), limit["allowed"].as_f64());
        assert!(measured <= allowed, "{limit}");
    }
    assert_eq!(report["cosim"][0]["mismatches"], 0);
    // Every pin on every clock: a black frame, and that of the scene.
    assert_eq!(report["cosim"][0]["pixels"], 2 * 48 * 36);
    if with_costs {
        assert!(report["cost"]["lut"].as_u64() < report["base_cost"]["lut"].as_u64());
        assert!(report["saving_percent"]["lut"].as_f64().unwrap() > 0.0);
    }
    for file in [
        "machine.toml",
        "beam_display.v",
        "contract.md",
        "fit.json",
        "golden.png",
        "errors.png",
    ] {
        assert!(out.join(file).is_file(), "{file}");
    }
    // The command that it names shows the same on the pins of the same Verilog.
    let again = folder.path().join("again");
    let command = report["command"].as_str().unwrap();
    let arguments: Vec<&str> = command
        .split(' ')
        .skip(1)
        .map(|word| {
            if word == "DIR" {
                again.to_str().unwrap()
            } else {
                word
            }
        })
        .collect();
    let (code, _, stderr) = output(&mut imogene(&arguments));
    assert_eq!(code, 0, "{stderr}");
    let text = |folder: &Path| std::fs::read_to_string(folder.join("beam_display.v")).unwrap();
    assert_eq!(text(&out), text(&again));
    let bytes = |path| std::fs::read(path).unwrap();
    assert_eq!(bytes(out.join("golden.png")), bytes(again.join("pins.png")));
    let contract = std::fs::read_to_string(out.join("contract.md")).unwrap();
    assert!(contract.contains("how it is known") && contract.contains(command));
}

/// Shadows, meshes and more objects than a beam machine has processors, without an outside tool.
#[test]
fn scenes_of_every_kind_are_fitted_to_the_pins() {
    let folder = tempfile::tempdir().unwrap();
    let cases: [(&str, &[&str], &str); 9] = [
        ("processors/polyhedron", &[], "beam"),
        ("processors/mesh", &["--machine", "beam"], "beam"),
        ("processors/paraboloids", &[], "beam"),
        ("processors/curved-facet", &[], "beam"),
        ("processors/first-generation", &[], "beam"),
        ("shadows/robot", &[], "zone"),
        ("processors/mesh", &[], "zone"),
        ("cone", &["--machine", "zone", "--min-fps", "60"], "zone"),
        ("extremes/sixteen-lights", &[], "beam"),
    ];
    for (scene, more, kind) in cases {
        let out = folder.path().join(scene.replace('/', "-"));
        let path = format!("scenes/{scene}.toml");
        let mut arguments = vec!["--json", "fit", &path, "--size", "32x24", "--no-cost"];
        arguments.extend(["--max-depth-error", "2px", "--out", out.to_str().unwrap()]);
        arguments.extend(more);
        let (code, stdout, stderr) = output(&mut imogene(&arguments));
        assert_eq!(code, 0, "{scene}: {stderr}");
        let report: Value = serde_json::from_str(&stdout).unwrap();
        assert_eq!(report["machine"]["machine"], kind, "{scene}");
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{scene}");
        assert_eq!(report["cost"], Value::Null, "{scene}");
        assert!(out.join("machine.toml").is_file(), "{scene}");
    }
}

/// Scenes with an object that the viewer lies on, which no machine draws yet.
const NO_MACHINE: [&str; 3] = [
    "extremes/eye-barely-inside.toml",
    "extremes/eye-on-quadric.toml",
    "extremes/paraboloid-along-its-axis.toml",
];

fn scenes_in(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => scenes_in(&path, found),
            false => found.push(path),
        }
    }
}

/// In the full run every scene that there is goes to the pins of a machine that is made for it; else one in twenty.
#[test]
fn scenes_go_to_the_pins_of_machines_that_are_made_for_them() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let mut scenes = vec![];
    scenes_in(&root, &mut scenes);
    scenes.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    scenes.sort();
    assert!(scenes.len() > 80);
    let is_full = std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1");
    let step = if is_full { 1 } else { 20 };
    let folder = tempfile::tempdir().unwrap();
    for (index, path) in scenes.iter().enumerate().step_by(step) {
        let out = folder.path().join(index.to_string());
        let (code, stdout, stderr) = output(
            imogene(&["--json", "--allow-missing", "fit"])
                .arg(path)
                .args(["--size", "32x24", "--max-depth-error", "2px", "--no-cost"])
                .arg("--out")
                .arg(&out),
        );
        let name = path.strip_prefix(&root).unwrap().display().to_string();
        if NO_MACHINE.contains(&name.as_str()) {
            assert_eq!(code, 2, "{name}: {stderr}");
            continue;
        }
        assert_eq!(code, 0, "{name}: {stderr}");
        let report: Value = serde_json::from_str(&stdout).unwrap();
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{name}");
        assert!(report["cosim"][0]["pixels"].as_u64() >= Some(2 * 32 * 24));
    }
}

#[test]
fn a_pace_out_of_reach_is_refused_with_the_fastest_machine() {
    let out = tempfile::tempdir().unwrap();
    let out = out.path().join("fit");
    let (code, _, stderr) = output(&mut imogene(&[
        "fit",
        "scenes/cone.toml",
        "--size",
        "32x24",
        "--max-depth-error",
        "1px",
        "--no-cost",
        "--min-fps",
        "1e6",
        "--out",
        out.to_str().unwrap(),
    ]));
    assert_eq!(code, 1, "{stderr}");
    assert!(
        stderr.contains("1000000 frames per second at 50 MHz"),
        "{stderr}"
    );
    assert!(!out.exists());
}

#[test]
fn a_budget_out_of_reach_fails_the_check_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("fit");
    let (code, _, stderr) = output(&mut imogene(&[
        "fit",
        "scenes/cut-sphere.toml",
        "--size",
        "32x24",
        "--max-normal-error",
        "0",
        "--out",
        out.to_str().unwrap(),
    ]));
    assert_eq!(code, 1, "{stderr}");
    assert!(
        stderr.contains("out of reach") && stderr.contains("normal"),
        "{stderr}"
    );
    assert!(stderr.contains("--widths depth="), "{stderr}");
    assert!(!out.exists());
}

#[test]
fn bad_input_is_refused_with_what_would_be_accepted() {
    let scene = "scenes/cut-sphere.toml";
    let cases: [(&[&str], &str); 8] = [
        (&["fit", scene, "--out", "x"], "--max-depth-error"),
        (
            &["fit", scene, "--out", "x", "--max-depth-error", "1m"],
            "0.5px",
        ),
        (
            &["fit", scene, "--out", "x", "--max-face-errors", "1.5"],
            "0.1%",
        ),
        (
            &[
                "fit",
                scene,
                "scenes/teapot.toml",
                "--out",
                "x",
                "--max-depth-error",
                "1",
            ],
            "the same objects",
        ),
        (
            &[
                "fit",
                "scenes/extremes/eye-on-quadric.toml",
                "--out",
                "x",
                "--max-depth-error",
                "1",
            ],
            "processors of square roots alone",
        ),
        (
            &[
                "emit", "pe1", "--widths", "depth=20", "--slots", "1", "--out", "x",
            ],
            "takes the unit beam",
        ),
        (
            &[
                "emit", "beam", "--widths", "depth=20", "--slots", "13", "--out", "x",
            ],
            "3,0,2v",
        ),
        (
            &["emit", "beam", "--widths", "depth=20", "--out", "x"],
            "--slots",
        ),
    ];
    for (arguments, part) in cases {
        let (code, stdout, stderr) = output(&mut imogene(arguments));
        assert_eq!(code, 2, "{arguments:?}: {stderr}");
        assert!(
            stderr.contains(part) && stdout.is_empty(),
            "{arguments:?}: {stderr}"
        );
        assert!(!Path::new(env!("CARGO_MANIFEST_DIR")).join("../x").exists());
    }
}

/// The products of a solid, and the layers of transparent objects, on the pins; then the same from the machine file.
#[test]
fn solids_and_glass_go_to_the_pins() {
    let folder = tempfile::tempdir().unwrap();
    for (scene, key, of_zones) in [
        (
            "scenes/solids/bracket.toml",
            "products = \"1-4,1-4\"",
            "products = \"1-4\"",
        ),
        (
            "scenes/solids/printed-example.toml",
            "products = \"2-1,2-1,2-1,2-1\"",
            "products = \"2-1\"",
        ),
        (
            "scenes/glass/still-life.toml",
            "layers = 3",
            "in a beam machine alone",
        ),
    ] {
        let out = folder.path().join(key);
        let size = ["--size", "64x48"];
        let (code, stdout, stderr) = output(
            imogene(&[
                "--json",
                "fit",
                scene,
                "--max-depth-error",
                "1px",
                "--no-cost",
                "--out",
            ])
            .arg(&out)
            .args(size),
        );
        assert_eq!(code, 0, "{scene}: {stderr}");
        let report: Value = serde_json::from_str(&stdout).unwrap();
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{scene}");
        let machine = out.join("machine.toml");
        let text = std::fs::read_to_string(&machine).unwrap();
        assert!(text.contains(key), "{scene}: {text}");
        let (code, _, stderr) = output(
            imogene(&["machine", scene, "--machine"])
                .arg(&machine)
                .arg("--out")
                .arg(folder.path().join("again").join(key)),
        );
        assert_eq!(code, 0, "{scene}: {stderr}");
        // A zone machine draws one product after another, and has no blends.
        let (code, _, stderr) = output(&mut imogene(&[
            "machine",
            scene,
            "--machine",
            "machines/zone-320x240.toml",
            "--out",
            folder.path().join("zone").to_str().unwrap(),
        ]));
        assert_eq!(code, 2, "{scene}");
        assert!(stderr.contains(of_zones), "{scene}: {stderr}");
    }
}
