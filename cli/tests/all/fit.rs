//! `imogene fit` and machines of any widths on the command line.

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

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

/// Search, synthesis, Verilog and Verilator on a real scene.
#[test]
fn a_scene_is_fitted_emitted_and_compared() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("fit");
    let (code, stdout, stderr) = output(&mut imogene(&[
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
    ]));
    assert_eq!(code, 0, "{stderr}");
    let report: Value = serde_json::from_str(&stdout).unwrap();
    for limit in report["limits"].as_array().unwrap() {
        let (measured, allowed) = (limit["measured"].as_f64(), limit["allowed"].as_f64());
        assert!(measured <= allowed, "{limit}");
    }
    assert_eq!(report["cosim"][0]["mismatches"], 0);
    assert_eq!(report["cosim"][0]["pixels"], 48 * 36);
    assert!(report["cost"]["lut"].as_u64() < report["base_cost"]["lut"].as_u64());
    assert!(report["saving_percent"]["lut"].as_f64().unwrap() > 0.0);
    for file in [
        "beam.v",
        "contract.md",
        "fit.json",
        "golden.png",
        "errors.png",
    ] {
        assert!(out.join(file).is_file(), "{file}");
    }
    // The command that it names writes the same Verilog.
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
    let text = |folder: &Path| std::fs::read_to_string(folder.join("beam.v")).unwrap();
    assert_eq!(text(&out), text(&again));
    let contract = std::fs::read_to_string(out.join("contract.md")).unwrap();
    assert!(contract.contains("how it is known") && contract.contains(command));
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
                "scenes/processors/mesh.toml",
                "--out",
                "x",
                "--max-depth-error",
                "1",
            ],
            "leave `processor` out",
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
