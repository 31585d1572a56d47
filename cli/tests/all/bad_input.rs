//! Bad input: one clear message on standard error, exit code 2, no panic, nothing half-written.

use crate::common::{imogene, scene};
use std::path::Path;

/// A scene with one sphere; `object` replaces its shape lines, `camera` its camera.
fn scene_text(camera: &str, object: &str) -> String {
    format!(
        "format = 1\ntitle = \"t\"\n\n[camera]\n{camera}\n\n[[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n\n[[objects]]\nname = \"thing\"\nmaterial = \"m\"\n{object}\n"
    )
}

const CAMERA: &str = "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nviewer_distance = 10\nview_height = 4";
const SPHERE: &str = "kind = \"sphere\"\nradius = 1";

/// Every file below a folder.
fn files_below(folder: &Path) -> Vec<std::path::PathBuf> {
    std::fs::read_dir(folder)
        .unwrap()
        .flat_map(|entry| {
            let path = entry.unwrap().path();
            if path.is_dir() {
                files_below(&path)
            } else {
                vec![path]
            }
        })
        .collect()
}

/// Renders a scene text and returns the message of its refusal.
fn refusal(text: &[u8]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("scene.toml");
    std::fs::write(&input, text).unwrap();
    let output = imogene()
        .args(["render", "--size", "64x48", "-o"])
        .arg(folder.path().join("picture.png"))
        .arg(&input)
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.starts_with("error: "), "{message}");
    assert!(!message.contains("panicked"), "{message}");
    assert_eq!(files_below(folder.path()), [input], "something was written");
    message
}

fn assert_mentions(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
}

#[test]
fn the_template_itself_is_accepted() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("scene.toml");
    std::fs::write(&input, scene_text(CAMERA, SPHERE)).unwrap();
    imogene()
        .args(["render", "--size", "64x48", "-o"])
        .arg(folder.path().join("picture.png"))
        .arg(&input)
        .assert()
        .success();
}

#[test]
fn truncated_file() {
    let whole = std::fs::read(scene("teapot.toml")).unwrap();
    let message = refusal(&whole[..whole.len() / 2]);
    assert_mentions(&message, &["scene.toml:"]);
}

#[test]
fn every_truncation_of_a_scene_is_refused_or_a_scene() {
    // A shorter text may be a complete scene with fewer objects; it must never be a panic or another exit code.
    let whole = std::fs::read(scene("cut-sphere.toml")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for length in (0..whole.len()).step_by(whole.len() / 40) {
        let input = folder.path().join("scene.toml");
        std::fs::write(&input, &whole[..length]).unwrap();
        let output = imogene()
            .args(["prepare", "--size", "16x12"])
            .arg(&input)
            .output()
            .unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(
            matches!(output.status.code(), Some(0 | 2)),
            "{length}: {message}"
        );
        assert!(!message.contains("panicked"), "{message}");
    }
}

#[test]
fn unknown_key() {
    let text = scene_text(CAMERA, "kind = \"sphere\"\nradius = 1\ncolor = 3");
    assert_mentions(&refusal(text.as_bytes()), &["scene.toml:", "color"]);
}

#[test]
fn not_a_number() {
    let text = scene_text(CAMERA, "kind = \"sphere\"\nradius = nan");
    assert_mentions(&refusal(text.as_bytes()), &["thing", "radius"]);
}

#[test]
fn zero_radius() {
    let text = scene_text(CAMERA, "kind = \"sphere\"\nradius = 0");
    assert_mentions(&refusal(text.as_bytes()), &["thing", "radius"]);
}

#[test]
fn zero_normal() {
    let object = format!("{SPHERE}\ncuts = [{{ point = [0, 0, 0], normal = [0, 0, 0] }}]");
    assert_mentions(
        &refusal(scene_text(CAMERA, &object).as_bytes()),
        &["thing", "normal"],
    );
}

#[test]
fn singular_transform() {
    let object = format!("{SPHERE}\nplace = [{{ scale = [1, 0, 1] }}]");
    assert_mentions(
        &refusal(scene_text(CAMERA, &object).as_bytes()),
        &["thing", "scale"],
    );
}

#[test]
fn a_far_end_before_the_near_end() {
    let camera = CAMERA
        .replace("perspective", "orthographic")
        .replace("viewer_distance = 10", "near = 3\nfar = -3");
    assert_mentions(
        &refusal(scene_text(&camera, SPHERE).as_bytes()),
        &["far", "not behind `near`", "greater number"],
    );
}

#[test]
fn a_window_too_small_to_see_anything() {
    let camera = CAMERA.replace("view_height = 4", "view_height = 1e-306");
    assert_mentions(
        &refusal(scene_text(&camera, SPHERE).as_bytes()),
        &["view_height", "too small", "1e-30"],
    );
}

#[test]
fn quadric_too_large_for_the_format() {
    // The eye is a thousandth off a ball of which a slice is drawn by a processor that has roots alone.
    let object = "kind = \"sphere\"\nradius = 9.999\nprocessor = \"first_generation\"\n\
        cuts = [{ point = [0, 0, 1], normal = [0, 0, 1] }, { point = [0, 0, -1], normal = [0, 0, -1] }]";
    assert_mentions(
        &refusal(scene_text(CAMERA, object).as_bytes()),
        &["thing", "too large", "bits", "`near = "],
    );
}

#[test]
fn missing_file_folder_and_binary_noise() {
    let output = imogene()
        .args(["check", "no/such/scene.toml"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert_mentions(
        &String::from_utf8(output.stderr).unwrap(),
        &["no/such/scene.toml"],
    );
    assert_mentions(&refusal(&[0xff, 0xfe, 0x00, 0x80, 0x31]), &["scene.toml"]);
    refusal(b"");
}

#[test]
fn unwritable_output_folder() {
    // A file stands where the folder should be: refused for every user, also the superuser.
    let folder = tempfile::tempdir().unwrap();
    let obstacle = folder.path().join("obstacle");
    std::fs::write(&obstacle, "x").unwrap();
    let out = obstacle.join("out");
    let text = out.to_str().unwrap();
    let teapot = scene("teapot.toml");
    let runs: [Vec<&str>; 3] = [
        vec!["demo", "--out", text],
        vec!["emit", "pe1", "--out", text],
        vec![
            "render",
            teapot.to_str().unwrap(),
            "--size",
            "32x24",
            "-o",
            text,
        ],
    ];
    for arguments in runs {
        let output = imogene().args(&arguments).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert_mentions(&message, &["cannot write", "obstacle"]);
    }
    assert_eq!(files_below(folder.path()), [obstacle]);
}

#[test]
fn usage_and_parameters_out_of_range() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let runs: [(Vec<&str>, &[&str]); 22] = [
        (
            vec!["emit", "quadric_pe", "--root-form", "cubic1", "--out", out],
            &["--root-form", "'cubic1' is no form", "restoring"],
        ),
        (
            vec!["emit", "quadric_pe", "--root-form", "linear3", "--out", out],
            &["linear3", "0 to 2 corrections"],
        ),
        (
            vec!["emit", "pe1", "--root-form", "linear2", "--out", out],
            &["pe1", "root-form"],
        ),
        (
            vec![
                "cosim",
                "quadric_volume",
                "--format",
                "16",
                "--root-form",
                "leading17",
            ],
            &["leading root = 17", "1 to 16"],
        ),
        (
            vec!["cosim", "x.toml", "--root-form", "linear2"],
            &["--root-form", "--widths depth=24,root_form=linear2"],
        ),
        (
            vec![
                "render",
                "x.toml",
                "--widths",
                "depth=24,root_form=iterative",
            ],
            &["iterative", "one pixel per clock"],
        ),
        (
            vec![
                "render",
                "x.toml",
                "--widths",
                "depth=11,root_form=quadratic1",
            ],
            &["quadratic root of 11 bits", "12 to 32"],
        ),
        (vec!["emit", "pe3", "--out", out], &["pe3", "pe2"]),
        (
            vec!["emit", "pe1", "--prefix", "1st-", "--out", out],
            &["1st-", "begin with a letter"],
        ),
        (
            vec!["emit", "pe1", "--format", "33", "--out", out],
            &["33", "8 to 32"],
        ),
        (
            vec!["emit", "quadric_processor", "--planes", "13", "--out", out],
            &["13", "12"],
        ),
        (
            vec!["emit", "square_root", "--rows-per-stage", "0", "--out", out],
            &["0", "24"],
        ),
        (
            vec!["emit", "square_root_rows", "--digits", "25", "--out", out],
            &["digits", "25", "1 to 24"],
        ),
        (
            vec!["cosim", "pe1", "--corrections", "1"],
            &["pe1", "corrections"],
        ),
        (
            vec!["emit", "beam", "--objects", "257", "--out", out],
            &["257", "256"],
        ),
        (vec!["cosim", "pe1", "--format", "7"], &["7", "8 to 32"]),
        (vec!["cosim", "nothing"], &["nothing", "pe1"]),
        (
            vec!["cosim", "pe1", "--widths", "depth=20"],
            &["--widths", "scene"],
        ),
        (
            vec![
                "synth", "pe1", "--target", "ecp5-45k", "--widths", "depth=20", "--slots", "1",
            ],
            &["--widths", "beam", "pe1"],
        ),
        (
            vec![
                "synth", "beam", "--target", "ecp5-45k", "--widths", "depth=20", "--slots", "1",
                "--seeds", "9",
            ],
            &["--widths", "--seeds"],
        ),
        (
            vec!["synth", "--check", "--rows-per-stage", "3"],
            &["--check", "--rows-per-stage"],
        ),
        (
            vec!["render", "x.toml", "--size", "10by10", "-o", "p.png"],
            &["10by10", "320x240"],
        ),
    ];
    for (arguments, parts) in runs {
        let output = imogene().args(&arguments).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert_mentions(&message, parts);
        assert!(!message.contains("panicked"), "{message}");
    }
    assert_eq!(files_below(folder.path()), Vec::<std::path::PathBuf>::new());
}

/// Only the words of the quadric and the patch processor have bounds; waveforms and faults are those of the beam
/// machine.
#[test]
fn scenes_of_other_processors_are_refused_where_the_quadric_processor_is_meant() {
    let folder = tempfile::tempdir().unwrap();
    let trace = folder.path().join("trace.vcd");
    let mesh = scene("processors/mesh.toml");
    let [mesh, trace] = [&mesh, &trace].map(|path| path.to_str().unwrap());
    let runs: [(Vec<&str>, [&str; 3]); 4] = [
        (
            vec!["bounds", mesh],
            ["mesh.toml", "no object", "quadric or patch processor"],
        ),
        (
            vec!["cosim", mesh, "--vcd", trace],
            ["--vcd", "beam machine", "quadric processors"],
        ),
        (
            vec!["cosim", mesh, "--inject-fault", "0:1:2"],
            ["--inject-fault", "beam machine", "quadric processors"],
        ),
        (
            vec!["cosim", mesh, "--guards", "2:2"],
            ["--guards", "beam machine", "quadrics"],
        ),
    ];
    for (arguments, parts) in runs {
        let output = imogene().args(&arguments).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert_mentions(&message, &parts);
    }
    assert_eq!(files_below(folder.path()), Vec::<std::path::PathBuf>::new());
}

/// The message with which a command refuses guard bits.
fn guards_refusal(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let output = imogene()
        .args(["render", "--size", "32x24", "-o"])
        .arg(folder.path().join("picture.png"))
        .arg(scene("cone.toml"))
        .args(arguments)
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        files_below(folder.path()).is_empty(),
        "something was written"
    );
    message
}

#[test]
fn guard_bits_that_cannot_be_had_are_refused() {
    let refused = |arguments: &[&str], parts: &[&str]| {
        assert_mentions(&guards_refusal(arguments), parts);
    };
    refused(&["--guards", "3"], &["expected G1:G2"]);
    refused(&["--guards", "17:0"], &["at most 16"]);
    refused(&["--guards", "0:4", "--format", "32"], &["64", "at most 0"]);
    refused(&["--format", "7"], &["7 bits", "8 to 32"]);
    refused(
        &["--format", "40", "--model", "rtl"],
        &["40 bits", "8 to 32"],
    );
}

#[test]
fn bounds_refuse_what_they_cannot_try() {
    let refused = |arguments: &[&str], parts: &[&str]| {
        let output = imogene().arg("bounds").args(arguments).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_mentions(&message, parts);
    };
    let cone = scene("cone.toml");
    let cone = cone.to_str().unwrap();
    refused(&["--sizes", "64x48"], &["required"]);
    refused(&[cone, "--cases", "5"], &["cannot be used with"]);
    refused(&[cone, "--formats", "40"], &["40", "8 to 32"]);
    refused(&["nowhere.toml"], &["nowhere.toml"]);
}

/// A scene of a ball and a box, and a solid of them.
fn solid_text(of: &str, ball: &str) -> String {
    let ball = format!("kind = \"sphere\"\nradius = 1\n{ball}");
    let text = scene_text(CAMERA, &ball);
    format!(
        "{text}\n[[objects]]\nname = \"other\"\nmaterial = \"m\"\nkind = \"sphere\"\nradius = 0.5\n\n\
         [[solids]]\nname = \"part\"\nof = {of}\n"
    )
}

#[test]
fn a_solid_that_cannot_be_had_names_the_object_and_what_would_do() {
    let both = "{ difference = [\"thing\", \"other\"] }";
    let refused = |of: &str, ball: &str| refusal(solid_text(of, ball).as_bytes());
    for (of, ball, parts) in [
        (
            "{ difference = [\"thing\", \"hole\"] }",
            "",
            ["solid `part`, object `hole`", "`thing`, `other`"],
        ),
        (
            "{ difference = [\"thing\"] }",
            "",
            ["solid `part`", "two operands"],
        ),
        (
            "{ less = [\"thing\", \"other\"] }",
            "",
            ["unknown variant `less`", "`difference`"],
        ),
        (
            "{ union = [\"thing\", 3] }",
            "",
            ["invalid type", "the name of an object"],
        ),
        (
            both,
            "mode = \"patch\"",
            ["surface without inside", "mode = \"solid\""],
        ),
    ] {
        assert_mentions(&refused(of, ball), &parts);
    }
    let parallel = solid_text(both, "processor = \"paraboloid\"")
        .replace("perspective", "orthographic")
        .replace("viewer_distance = 10\n", "");
    assert_mentions(
        &refusal(parallel.as_bytes()),
        &["hands on no back", "quadric processor"],
    );
    let shadows = solid_text(both, "")
        + "\n[[lights]]\nkind = \"directional\"\nfrom = [0, 5, 5]\nshadows = true\n";
    assert_mentions(
        &refusal(shadows.as_bytes()),
        &["solid 'part'", "casts_shadow = false"],
    );
    let double = solid_text(both, "").replace("kind = \"sphere\"\nradius = 1\n", "kind = \"cone\"\nradii = [1, 1, 1]\nplace = [{ rotate = { axis = \"x\", degrees = 90 } }]\n");
    assert_mentions(
        &refusal(double.as_bytes()),
        &[
            "object 'thing' is met twice",
            "cut one of its two parts off",
        ],
    );
}
