//! The commands on real input: files, JSON keys that scripts rely on, exit codes.

use crate::common::{imogene, scene};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    let output = imogene().args(arguments).arg("--json").output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{arguments:?}: {message}");
    serde_json::from_slice(&output.stdout).expect("standard output is one JSON document")
}

fn assert_keys(value: &Value, keys: &[&str]) {
    for key in keys {
        assert!(value.get(key).is_some(), "no key '{key}' in {value}");
    }
}

const COSIM_KEYS: [&str; 8] = [
    "engine",
    "cycles",
    "pixels",
    "mismatches",
    "seconds",
    "cycles_per_second",
    "seed",
    "files",
];

#[test]
fn demo_draws_the_teapot_with_no_difference() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("demo");
    let summary = json(&["demo", "--out", out.to_str().unwrap()]);
    assert_keys(&summary, &COSIM_KEYS);
    assert_eq!(summary["mismatches"], 0);
    assert_eq!(summary["pixels"], 320 * 240);
    for name in [
        "image.png",
        "golden.png",
        "trace.vcd",
        "trace.gtkw",
        "beam.v",
        "summary.json",
    ] {
        assert!(out.join(name).is_file(), "no {name}");
    }
    let picture = std::fs::read(out.join("image.png")).unwrap();
    assert_eq!(picture, std::fs::read(out.join("golden.png")).unwrap());
    let vcd = std::fs::read_to_string(out.join("trace.vcd")).unwrap();
    assert!(vcd.contains("processor_0") && vcd.contains("golden") && vcd.contains("hardware"));
    let written: Value =
        serde_json::from_slice(&std::fs::read(out.join("summary.json")).unwrap()).unwrap();
    assert_eq!(written["mismatches"], 0);
}

#[test]
fn three_models_draw_the_same_molecule() {
    let folder = tempfile::tempdir().unwrap();
    let molecule = scene("molecule.toml");
    let mut pictures = Vec::new();
    for model in ["golden", "rtl", "exact"] {
        let path = |name: &str| folder.path().join(format!("{model}-{name}"));
        let (png, depth, ids, normals) =
            (path("p.png"), path("d.npy"), path("i.npy"), path("n.npy"));
        let report = json(&[
            "render",
            molecule.to_str().unwrap(),
            "--model",
            model,
            "--size",
            "40x30",
            "-o",
            png.to_str().unwrap(),
            "--depth",
            depth.to_str().unwrap(),
            "--ids",
            ids.to_str().unwrap(),
            "--normals",
            normals.to_str().unwrap(),
        ]);
        assert_keys(
            &report,
            &["model", "width", "height", "seconds", "pixels_per_second"],
        );
        assert_eq!(report["width"], 40);
        let header = std::fs::read(&depth).unwrap();
        let text = String::from_utf8_lossy(&header[..80]).into_owned();
        assert!(text.contains("'<i8'") && text.contains("(30, 40"), "{text}");
        assert!(normals.is_file());
        pictures.push((std::fs::read(&png).unwrap(), std::fs::read(&ids).unwrap()));
    }
    assert_eq!(
        pictures[0], pictures[1],
        "golden and hardware pictures differ"
    );
    assert_eq!(
        pictures[0].1, pictures[2].1,
        "golden and exact object indices differ"
    );
}

#[test]
fn emit_reports_top_files_latency_and_ports() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let report = json(&[
        "emit",
        "quadric_processor",
        "--planes",
        "2",
        "--rows-per-stage",
        "4",
        "--out",
        out,
    ]);
    assert_keys(&report, &["top", "files", "latency", "ports"]);
    assert_eq!(report["latency"], 6 + 2 + 7);
    let file = report["files"][0].as_str().unwrap();
    let first = std::fs::read(file).unwrap();
    json(&[
        "emit",
        "quadric_processor",
        "--planes",
        "2",
        "--rows-per-stage",
        "4",
        "--out",
        out,
    ]);
    assert_eq!(
        first,
        std::fs::read(file).unwrap(),
        "emission is not deterministic"
    );
    let text = String::from_utf8(first).unwrap();
    assert!(
        text.contains("imogene emit quadric_processor --format 24 --planes 2 --rows-per-stage 4")
    );
}

#[test]
fn emit_split_writes_each_module_once_and_lists_them() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let report = json(&["emit", "quadric_pe", "--split", "--out", out]);
    let list = std::fs::read_to_string(folder.path().join("quadric_pe.f")).unwrap();
    assert_eq!(list.lines().last(), Some("quadric_pe.v"));
    assert_eq!(
        list.lines().count() as u64,
        report["modules"].as_u64().unwrap()
    );
    for file in list.lines() {
        let text = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let module = file.strip_suffix(".v").unwrap();
        assert_eq!(text.matches("\nmodule ").count(), 1, "{file}");
        assert!(text.contains(&format!("\nmodule {module} (")), "{file}");
    }
}

#[test]
fn emit_puts_a_prefix_before_modules_and_files() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    for (prefix, word) in [("narrow_", "16"), ("wide_", "24")] {
        let report = json(&[
            "emit",
            "square_root",
            "--format",
            word,
            "--split",
            "--prefix",
            prefix,
            "--out",
            out,
        ]);
        assert_eq!(report["top"], format!("{prefix}square_root"));
        let list = folder.path().join(format!("{prefix}square_root.f"));
        let list = std::fs::read_to_string(list).unwrap();
        assert_eq!(list.lines().count(), 3);
        for file in list.lines() {
            let text = std::fs::read_to_string(folder.path().join(file)).unwrap();
            let module = file.strip_suffix(".v").unwrap();
            assert!(module.starts_with(prefix), "{file}");
            assert!(text.contains(&format!("\nmodule {module} (")), "{file}");
        }
    }
}

#[test]
fn units_prepare_and_check_answer_in_json() {
    let units = json(&["units"]);
    let names: Vec<&str> = units
        .as_array()
        .unwrap()
        .iter()
        .map(|unit| unit["name"].as_str().unwrap())
        .collect();
    for name in ["pe1", "square_root", "quadric_processor", "decider", "beam"] {
        assert!(names.contains(&name), "no {name} in {names:?}");
    }
    let teapot = scene("teapot.toml");
    let prepared = json(&["prepare", teapot.to_str().unwrap(), "--size", "160x120"]);
    assert_eq!(prepared["objects"].as_array().unwrap().len(), 10);
    let checked = json(&["check", teapot.to_str().unwrap(), "--size", "160x120"]);
    assert_keys(&checked, &["objects", "bounds", "widths", "ok"]);
    assert_keys(
        &checked["bounds"],
        &["depth_lsb", "silhouette_px", "normal_deg"],
    );
    assert_keys(
        &checked["objects"][0],
        &[
            "name",
            "kind",
            "class",
            "problems",
            "shows",
            "visible_pixels",
            "front_view",
            "prism",
            "degenerate",
            "highlights",
            "perpendicular_planes",
            "planes_without_effect",
        ],
    );
    let accumulators = &checked["objects"][0]["accumulators"];
    assert_keys(
        accumulators,
        &["f1", "f2", "f1_minus_r", "root", "normal_sum"],
    );
    assert_keys(
        &accumulators["increments"]["f2"],
        &["a2", "b2", "c", "j", "p", "i", "line_value"],
    );
    assert_keys(&checked["summary"]["guards"], &["g1", "g2", "accepted"]);
    let machine = &checked["summary"]["machine"];
    assert_keys(machine, &["widths", "slots", "root_limit", "plane_limit"]);
    // What is printed is what the commands take, and the scene fits it.
    let widths = machine["widths"].as_str().unwrap();
    let path = teapot.to_str().unwrap();
    let narrow = json(&["check", path, "--size", "160x120", "--widths", widths]);
    assert_eq!(&narrow["summary"]["machine"], machine);
}

/// Moved to the screen's corner, a 64-bit word can be longer; it is shown as its register holds it.
#[test]
fn the_longest_words_are_printed() {
    let path = scene("orthographic.toml");
    let prepared = json(&["prepare", path.to_str().unwrap(), "--format", "32"]);
    assert!(prepared["objects"].as_array().unwrap().len() > 3);
    // The same of its shadows.
    let text = std::fs::read_to_string(&path).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shadows.toml");
    let shaded = text.replace("[[lights]]\n", "[[lights]]\nshadows = true\n");
    std::fs::write(&path, shaded).unwrap();
    let prepared = json(&["prepare", path.to_str().unwrap(), "--format", "32"]);
    assert!(prepared["volumes"].as_array().unwrap().len() > 10);
}

/// Objects of the other processors: their words, widths and problems under stable keys, in every format.
#[test]
fn scenes_of_other_processors_are_drawn_prepared_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let expected = [
        ("polyhedron", "polyhedron", "polyhedron"),
        ("mesh", "mesh", "facet"),
        ("paraboloids", "sphere", "sphere"),
        ("first-generation", "ellipsoid", "first_generation"),
        ("patch-processor", "elliptic_paraboloid", "patch"),
        ("tetrahedra", "ellipsoid", "patch"),
        ("curved-facet", "sphere", "curved_facet"),
    ];
    for (name, kind, processor) in expected {
        let path = scene(&format!("processors/{name}.toml"));
        let path = path.to_str().unwrap();
        for format in ["16", "24", "32"] {
            let options = [path, "--size", "120x90", "--format", format];
            let prepared = json(&[&["prepare"], &options[..]].concat());
            assert_eq!(prepared["objects"][0]["processor"], processor, "{name}");
            let checked = json(&[&["check"], &options[..]].concat());
            let object = &checked["objects"][0];
            assert_eq!(
                (&object["kind"], &object["processor"]),
                (&kind.into(), &processor.into())
            );
            assert_keys(
                object,
                &["name", "screen_box", "pixels", "needed", "problems"],
            );
            assert!(object["pixels"].as_u64().unwrap() > 100, "{name}");
            for model in ["golden", "exact"] {
                let picture = folder.path().join(format!("{name}-{model}.png"));
                let picture = picture.to_str().unwrap();
                let drawn =
                    json(&[&["render", "--model", model, "-o", picture], &options[..]].concat());
                assert!(drawn["covered_pixels"].as_u64().unwrap() > 500, "{name}");
                assert!(std::fs::metadata(picture).unwrap().len() > 500);
            }
        }
    }
}

#[test]
fn cosim_replays_its_seed_and_writes_waveforms() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("pe2.vcd");
    let arguments = [
        "cosim",
        "pe2",
        "--seed",
        "42",
        "--clocks",
        "3000",
        "--vcd",
        vcd.to_str().unwrap(),
    ];
    let report = json(&arguments);
    assert_keys(&report, &COSIM_KEYS);
    assert_eq!(
        (&report["seed"], &report["mismatches"]),
        (&Value::from(42), &Value::from(0))
    );
    let first = std::fs::read(&vcd).unwrap();
    json(&arguments);
    assert_eq!(
        first,
        std::fs::read(&vcd).unwrap(),
        "the same seed gave another stimulus"
    );
    assert!(vcd.with_extension("gtkw").is_file());
}

#[test]
fn cosim_of_a_scene_takes_any_widths() {
    let cone = scene("cone.toml");
    let cosim = |more: &[&str]| {
        let scene = ["cosim", cone.to_str().unwrap(), "--size", "48x36"];
        json(&[&scene, more].concat())
    };
    // Bit 27 of the first word of f1 is there with guard bits alone.
    let fault = |more: &[&str]| {
        let mut run = imogene();
        run.arg("cosim").arg(&cone).args(["--size", "48x36"]);
        let run = run.args(["--inject-fault", "0:0:27"]).args(more);
        run.output().unwrap().status.code()
    };
    assert_eq!(
        (fault(&[]), fault(&["--guards", "2:3"])),
        (Some(2), Some(1))
    );
    let own = [
        "--widths",
        "depth=19,root=17,plane=29,normal=14,g1=3,g2=4,dropped=1",
    ];
    // The root has 16 rows in the place of 24.
    let clocks = |report: &Value| report["cycles"].as_u64().unwrap();
    assert!(clocks(&cosim(&own)) < clocks(&cosim(&[])));
    for words in [own, ["--guards", "2:3"]] {
        let report = cosim(&words);
        assert_eq!(report["mismatches"], 0);
        let again = report["reproduce"].as_str().unwrap();
        assert!(again.contains(&words.join(" ")), "{again}");
    }
}

#[test]
fn an_injected_fault_fails_with_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("fault.vcd");
    let output = imogene()
        .arg("cosim")
        .arg(scene("cone.toml"))
        .args(["--size", "48x36", "--inject-fault", "0:2:20", "--vcd"])
        .arg(&vcd)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).unwrap();
    for part in [
        "cycle",
        "pixel",
        "hardware",
        "golden",
        "fault.vcd",
        "reproduce",
    ] {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
    assert!(vcd.is_file());
}

#[test]
fn the_built_in_engine_has_its_old_name_too() {
    for name in ["built-in", "rust-hdl"] {
        let report = json(&["cosim", "pe1", "--clocks", "100", "--engine", name]);
        assert_eq!(report["engine"], "built-in");
        let reproduce = report["reproduce"].as_str().unwrap();
        assert!(reproduce.contains("--engine built-in"), "{reproduce}");
    }
}

#[test]
fn cosim_of_a_unit_in_icarus() {
    let report = json(&[
        "cosim",
        "cut_plane",
        "--engine",
        "icarus",
        "--clocks",
        "2000",
    ]);
    assert_eq!(
        (&report["engine"], &report["mismatches"]),
        (&Value::from("icarus"), &Value::from(0))
    );
}

#[test]
fn a_scene_in_icarus_has_waveforms_of_its_outputs() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("cone.vcd");
    let cone = scene("cone.toml");
    let report = json(&[
        "cosim",
        cone.to_str().unwrap(),
        "--size",
        "32x24",
        "--engine",
        "icarus",
        "--vcd",
        vcd.to_str().unwrap(),
    ]);
    assert_eq!(
        (&report["engine"], &report["pixels"]),
        (&Value::from("icarus"), &Value::from(32 * 24))
    );
    assert_eq!(report["mismatches"], 0);
    let text = std::fs::read_to_string(&vcd).unwrap();
    assert!(text.contains("$scope module beam") && !text.contains("processor_0"));
}

#[test]
fn the_engines_are_timed_side_by_side() {
    let speeds = json(&["speed", "pe1", "--seconds", "1"]);
    let rows = speeds.as_array().expect("a list");
    assert_eq!(rows.len(), 9);
    for row in rows {
        assert_keys(
            row,
            &[
                "engine",
                "work",
                "clocks_per_second",
                "ratio",
                "frame_seconds",
            ],
        );
    }
    assert_eq!(rows[0]["engine"], "built-in");
    assert_eq!(rows[0]["ratio"], 1.0);
}

#[test]
fn guard_bits_sharpen_the_bounds_of_a_check() {
    let cone = scene("cone.toml");
    let depth = |guards: &str| {
        let report = json(&[
            "check",
            cone.to_str().unwrap(),
            "--size",
            "96x72",
            "--guards",
            guards,
        ]);
        report["objects"][0]["bounds"]["f2"].as_f64().unwrap()
    };
    assert!(depth("2:4") < depth("0:0") / 4.0);
}

#[test]
fn bounds_hold_on_random_cases() {
    let trial = json(&["bounds", "--cases", "300", "--seed", "5"]);
    assert_eq!(
        (&trial["violations"], &trial["cases"]),
        (&0.into(), &300.into())
    );
    let formats = trial["formats"].as_array().unwrap();
    assert!(formats.len() >= 8);
    for format in formats {
        assert_keys(
            format,
            &[
                "depth",
                "guard_linear",
                "guard_quadratic",
                "pixels",
                "decided_exactly",
            ],
        );
        assert_eq!(format["cases"], 300);
        for term in format["terms"].as_array().unwrap() {
            assert_keys(
                term,
                &[
                    "term",
                    "comparisons",
                    "tightness",
                    "mean",
                    "observed",
                    "bound",
                ],
            );
        }
    }
    assert_eq!(
        trial,
        json(&["bounds", "--cases", "300", "--seed", "5"]),
        "not reproducible"
    );
}

#[test]
fn headroom_of_scenes_is_a_table() {
    let (cone, ellipsoid) = (scene("cone.toml"), scene("ellipsoid.toml"));
    let rows = json(&[
        "bounds",
        cone.to_str().unwrap(),
        ellipsoid.to_str().unwrap(),
        "--sizes",
        "64x48,32x24",
        "--formats",
        "16,24",
    ]);
    let summary = rows["summary"].as_array().unwrap();
    assert_eq!(summary.len(), 4);
    assert_keys(
        &summary[0],
        &[
            "width",
            "depth_word",
            "silhouette_errors",
            "derived",
            "confirmed",
        ],
    );
    let rows = rows["scenes"].as_array().unwrap();
    assert_eq!(rows.len(), 8);
    for row in rows {
        assert_keys(
            row,
            &[
                "scene",
                "width",
                "depth_word",
                "silhouette_errors",
                "derived",
                "confirmed",
                "depth_max_lsb",
                "depth_rms_lsb",
            ],
        );
    }
    // Longer words need fewer guard bits: 16 bits more of f2.
    let derived = |row: usize| rows[row]["derived"].as_i64().unwrap();
    assert!((derived(0) - derived(1) - 16).abs() <= 1);
}

#[test]
fn cosim_of_a_unit_in_verilator_writes_waveforms() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = folder.path().join("cut_plane.vcd");
    let report = json(&[
        "cosim",
        "cut_plane",
        "--engine",
        "verilator",
        "--clocks",
        "2000",
        "--vcd",
        vcd.to_str().unwrap(),
    ]);
    assert_eq!(
        (&report["engine"], &report["mismatches"]),
        (&Value::from("verilator"), &Value::from(0))
    );
    let reproduce = report["reproduce"].as_str().unwrap();
    assert!(reproduce.contains("--engine verilator"), "{reproduce}");
    assert!(vcd.is_file());
}

#[test]
fn a_missing_verilator_is_one_message() {
    let output = imogene()
        .args(["cosim", "cut_plane", "--engine", "verilator"])
        .env("PATH", "")
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    for part in ["error: 'verilator' was not found", "package 'verilator'"] {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
}

#[test]
fn mutate_scores_a_unit_and_writes_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("mutation.md");
    let reports = json(&[
        "mutate",
        "two_volume_merge",
        "--mutants",
        "50",
        "--out",
        page.to_str().unwrap(),
    ]);
    let report = &reports[0];
    assert_eq!(report["unit"], Value::from("two_volume_merge"));
    assert_eq!(report["mutants"], Value::from(50));
    assert_eq!(report["score"], Value::from(100.0));
    let text = std::fs::read_to_string(page).unwrap();
    assert!(text.contains("| two_volume_merge |"), "{text}");
}

#[test]
fn a_missing_yosys_is_one_message() {
    let output = imogene()
        .args(["mutate", "cut_plane"])
        .env("PATH", "")
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    for part in ["error: 'yosys' was not found", "package 'yosys'"] {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
}

#[test]
fn cosim_of_a_scene_in_verilator_agrees_and_finds_a_fault() {
    let cone = scene("cone.toml");
    let arguments = ["--engine", "verilator", "--size", "64x48"];
    let mut good = vec!["cosim", cone.to_str().unwrap()];
    good.extend(arguments);
    let report = json(&good);
    assert_eq!(report["engine"], Value::from("verilator"));
    assert_eq!(report["mismatches"], Value::from(0));
    assert_eq!(report["pixels"], Value::from(64 * 48));

    let output = imogene()
        .args(&good)
        .args(["--inject-fault", "0:2:20"])
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("--engine verilator"), "{message}");
}

#[test]
fn contract_prints_json_or_markdown_and_writes_a_file() {
    let value = json(&["contract", "pe1", "--format", "16"]);
    assert_keys(
        &value,
        &[
            "unit",
            "computes",
            "source",
            "parameters",
            "ports",
            "latency",
            "throughput",
            "reset",
            "ties",
            "error",
            "command",
        ],
    );
    let port = &value["ports"].as_array().expect("ports")[4];
    assert_eq!((&port["name"], &port["width"]), (&"a".into(), &18.into()));
    assert_eq!(port["formula"], "W + 2");
    let folder = tempfile::tempdir().expect("a scratch folder");
    let file = folder.path().join("pe1.md");
    let name = file.to_str().expect("a plain path");
    imogene()
        .args(["contract", "pe1", "--out", name])
        .assert()
        .success();
    let page = std::fs::read_to_string(&file).expect("the page");
    assert!(page.contains("| `a` | input | 26 | `W + 2` |"), "{page}");
    imogene().args(["contract", "pe3"]).assert().code(2);
}

#[test]
fn package_writes_every_core_that_it_names() {
    let folder = tempfile::tempdir().expect("a scratch folder");
    let out = folder.path().to_str().expect("a plain path");
    let value = json(&["package", "--clocks", "20", "--out", out]);
    assert_keys(&value, &["cores", "bytes", "files"]);
    assert_eq!(value["cores"], 46);
    for file in value["files"].as_array().expect("files") {
        let path = std::path::Path::new(file.as_str().expect("a path"));
        assert!(path.is_file(), "{}", path.display());
    }
    for file in ["beam.core", "contract.json", "bench/bench.v", "rtl/beam.v"] {
        assert!(folder.path().join("beam").join(file).is_file(), "{file}");
    }
}
