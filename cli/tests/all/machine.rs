//! `imogene machine`: from a scene and a description to the picture from the pins.

use crate::common::imogene;
use imogene_studies::picture::write_png;
use serde_json::Value;
use std::path::Path;

/// A beam machine with a screen of 40 x 30 pixels, and a zone machine for it.
const SMALL: [(&str, &str); 2] = [
    (
        "machine = \"beam\"\nobjects = 10\n",
        "loader_words = 1024\ndepth_word = 18\nwidths = { g1 = 2, g2 = 3, normal = 14 }\n",
    ),
    (
        "machine = \"zone\"\nobjects = 3\n",
        "zone = { width = 16, height = 16 }\nsupersampling = 2\noverlay = true\n",
    ),
];
const COMMON: &str = "planes = 3\nrows_per_stage = 6\nlights = 2\nmode = { columns = [40, 4, 4, 4], lines = [30, 2, 2, 40] }\n";

#[test]
fn the_pins_show_the_golden_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let mask = folder.path().join("mask.png");
    let stripes: Vec<u8> = (0..3 * 40 * 30)
        .map(|byte| u8::from(byte / 3 % 11 == 4))
        .collect();
    write_png(&mask, 40, 30, &stripes).expect("a picture");
    for (index, (head, tail)) in SMALL.iter().enumerate() {
        let description = folder.path().join(format!("{index}.toml"));
        std::fs::write(&description, format!("{head}{COMMON}{tail}")).expect("a file");
        let out = folder.path().join(format!("out{index}"));
        let mut command = imogene();
        command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        command.args([
            "machine",
            "scenes/teapot.toml",
            "--machine",
            description.to_str().expect("a plain path"),
            "--engine",
            "built-in",
            "--out",
            out.to_str().expect("a plain path"),
            "--json",
        ]);
        if tail.contains("overlay") {
            command.arg("--overlay").arg(&mask);
        }
        let output = command.output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{said}");
        let value: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
        assert_eq!(value["equal"], true);
        assert_eq!(value["pixels_per_frame"], 1200);
        assert_eq!(value["report"]["mismatches"], 0);
        let pins = std::fs::read(out.join("pins.png")).expect("a picture");
        assert!(pins == std::fs::read(out.join("golden.png")).expect("a picture"));
        for file in value["files"].as_array().expect("files") {
            assert!(
                Path::new(file.as_str().expect("a path")).is_file(),
                "{file}"
            );
        }
    }
}

/// A machine for one ellipsoid.
const TINY: &str = "machine = \"beam\"\nobjects = 1\nplanes = 2\nlights = 2\nrows_per_stage = 24\n\
                    mode = { columns = [8, 4, 4, 4], lines = [6, 2, 2, 20] }\n";

#[test]
fn waveforms_go_from_the_bus_to_the_pins() {
    let folder = tempfile::tempdir().expect("a folder");
    let [description, vcd] = ["tiny.toml", "pins.vcd"].map(|name| folder.path().join(name));
    std::fs::write(&description, TINY).expect("a file");
    let run = |more: &[&str]| {
        let mut command = imogene();
        command
            .arg("machine")
            .arg(crate::common::scene("ellipsoid.toml"));
        command.arg("--machine").arg(&description);
        command.arg("--out").arg(folder.path().join("out"));
        command.arg("--vcd").arg(&vcd).args(more);
        let output = command.output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.code(), said)
    };
    let window = ["--vcd-from", "frame:2,line:3", "--vcd-clocks", "20"];
    let nets = ["--vcd-nets", "core.objects.decider,loader.comes"];
    let (code, said) = run(&[&window[..], &nets].concat());
    assert_eq!(code, Some(0), "{said}");
    let text = std::fs::read_to_string(&vcd).expect("a file");
    for part in ["beam_display", "s_tvalid", "hsync", "loader", "comes"] {
        assert!(text.contains(part), "{part}");
    }
    let rises = text.lines().filter(|line| *line == "1!").count();
    assert_eq!(rises, 20);
    assert!(vcd.with_extension("gtkw").is_file());
    std::fs::remove_file(&vcd).expect("it is there");

    // What never comes is said; what cannot come is refused.
    let (code, said) = run(&["--vcd-from", "frame:99"]);
    assert!(
        code == Some(0) && said.contains("ended before frame:99"),
        "{said}"
    );
    assert_eq!(run(&["--vcd-at-mismatch"]).0, Some(0));
    assert!(!vcd.exists(), "nothing differs");
    for (more, wanted) in [
        (["--vcd-from", "line:6"], "accepted: 0,0 to 7,5"),
        (["--vcd-from", "6"], "frame:2,line:120"),
        (["--vcd-nets", "core.shade"], "core has objects, shading,"),
    ] {
        let (code, said) = run(&more);
        assert!(code == Some(2) && said.contains(wanted), "{more:?}: {said}");
    }
}

#[test]
fn many_frames_of_a_scene_are_waited_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let description = folder.path().join("tiny.toml");
    std::fs::write(&description, TINY).expect("a file");
    let mut command = imogene();
    command.args([
        "machine", "--engine", "built-in", "--frames", "24", "--json",
    ]);
    command.arg(crate::common::scene("ellipsoid.toml"));
    command.arg("--machine").arg(&description);
    command.arg("--out").arg(folder.path().join("out"));
    let output = command.output().expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let value: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let shown = value["shown"].as_array().expect("frames");
    assert_eq!(shown.iter().filter(|frame| **frame == 0).count(), 24);
}

/// What the program says of scenes on a machine of which it writes the Verilog alone, and how it ends.
fn emitted(scenes: &[&Path], description: &Path, out: &Path) -> (Option<i32>, String) {
    let mut command = imogene();
    command.arg("machine").args(scenes);
    command.arg("--machine").arg(description);
    command.arg("--emit-only").arg("--out").arg(out);
    let output = command.output().expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code(), said)
}

/// A description with the lines of an advice in place of its own.
fn advised(description: &str, advice: &str) -> String {
    let mut table: toml::Table = description.parse().expect("a description");
    for line in advice.lines() {
        match line.strip_prefix("# and no ") {
            Some(key) => drop(table.remove(key)),
            None => table.extend(line.parse::<toml::Table>().expect("a line of TOML")),
        }
    }
    table.to_string()
}

#[test]
fn the_lines_that_a_refusal_advises_are_accepted() {
    let folder = tempfile::tempdir().expect("a folder");
    let (path, out) = (
        folder.path().join("machine.toml"),
        folder.path().join("out"),
    );
    let tiny = "planes = 0\nmode = { columns = [40, 4, 4, 4], lines = [30, 2, 2, 2] }\n";
    let beam = format!("machine = \"beam\"\nobjects = 1\n{tiny}");
    let zone = format!(
        "machine = \"zone\"\nobjects = 1\nvolume_planes = 0\nzone = {{ width = 16, height = 16 }}\n{tiny}"
    );
    let beam_640 =
        "machine = \"beam\"\nobjects = 2\nplanes = 3\nloader_words = 50\nmode = \"640x480\"\n";
    let stream = format!("{beam}output = \"stream\"\n");
    let [teapot, robot, cylinders, molecule] = [
        "teapot.toml",
        "shadows/robot.toml",
        "crossing-cylinders.toml",
        "zones/molecule-480.toml",
    ]
    .map(crate::common::scene);
    let [teapot, robot, cylinders, molecule] = [&*teapot, &*robot, &*cylinders, &*molecule];
    let [bracket, printed] = ["bracket", "printed-example"]
        .map(|name| crate::common::scene(&format!("solids/{name}.toml")));
    let [bracket, printed] = [&*bracket, &*printed];
    let few = ["objects = 10 ", "planes = ", "lights = 2 # was 1"];
    let slotted = beam.replace("objects = 1\nplanes = 0", "slots = \"3,0\"");
    let suns = format!("{beam}suns = 1\n");
    let solid = zone.replace("objects = 1\n", "objects = 4\nproducts = \"2-1\"\n");
    let sphere = format!("{beam}lights = 0\nlit_sphere = {{ side = 128, materials = 1 }}\n");
    let parallel = crate::common::scene("orthographic.toml");
    let cases: [(&[&Path], &str, &[&str]); 12] = [
        (&[&*parallel], &sphere, &["objects = ", "lit_sphere = { "]),
        (
            &[bracket],
            &zone,
            &[
                "products = \"1-4\"",
                "objects = 6 # was 1",
                "planes = 6 # was 0",
            ],
        ),
        (
            &[printed, bracket],
            &solid,
            &["products = \"2-4\" # was \"2-1\"", "objects = 7 # was 4"],
        ),
        (&[teapot], &suns, &few),
        (&[teapot], &beam, &[few.as_slice(), &["mode = "]].concat()),
        (&[cylinders, teapot], &stream, &few),
        (
            &[teapot],
            &slotted,
            &["slots = \"3,2,", "objects = 10 # was 2", "lights = 2"],
        ),
        (
            &[teapot],
            beam_640,
            &["objects = 10 ", "lights = 2 # was 1", "loader_words = "],
        ),
        (
            &[robot, teapot],
            &beam,
            &["objects = 39 ", "volumes = 157 ", "mode = "],
        ),
        (
            &[robot],
            &zone,
            &[
                "volumes = 1 ",
                "volume_planes = ",
                "planes = ",
                "lights = 2 ",
            ],
        ),
        (
            &[molecule],
            &beam,
            &["machine = \"zone\"", "zone = ", "lights = 2 "],
        ),
        (
            &[molecule],
            beam_640,
            &["machine = \"zone\"", "# and no loader_words"],
        ),
    ];
    for (scenes, description, wanted) in cases {
        std::fs::write(&path, description).expect("a file");
        let (code, said) = emitted(scenes, &path, &out);
        assert_eq!(code, Some(2), "{said}");
        assert!(!out.exists(), "nothing is written");
        let (first, advice) = said.split_once('\n').expect("lines of an advice");
        assert!(
            first.contains("machine.toml: the machine has too little"),
            "{said}"
        );
        for line in wanted {
            assert!(
                advice.lines().any(|found| found.starts_with(line)),
                "{line}: {said}"
            );
        }
        std::fs::write(&path, advised(description, advice)).expect("a file");
        let (code, said) = emitted(scenes, &path, &out);
        assert_eq!(code, Some(0), "{said}");
        std::fs::remove_dir_all(&out).expect("a folder");
    }
}

#[test]
fn more_planes_than_any_machine_has_are_not_advised() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = std::fs::read_to_string(crate::common::scene("cut-sphere.toml")).expect("a scene");
    // An object has at most 12 cuts, but its shadow needs a plane more.
    let cut = |i: u32| {
        let (y, x) = (f64::from(i) / 12.0 * std::f64::consts::TAU + 0.05).sin_cos();
        format!(
            "{{ point = [{}, {}, 0], normal = [{x}, {y}, 0.1] }}",
            0.8 * x,
            0.8 * y
        )
    };
    let cuts = (0..12).map(cut).collect::<Vec<_>>().join(", ");
    let shadows = "kind = \"directional\"\nshadows = true";
    let cut = format!(
        "{}\n[[objects]]\nname = \"many sides\"\nkind = \"sphere\"\nradius = 1\nmaterial = \"lemon\"\ncuts = [{cuts}]\n",
        text.replacen("kind = \"directional\"", shadows, 1)
    );
    let machine = Path::new(env!("CARGO_MANIFEST_DIR")).join("../machines/zone-160x120.toml");
    let (name, says) = (
        "planes.toml",
        ["the shadow of object 'many sides'", "has 13 planes"],
    );
    let path = folder.path().join(name);
    std::fs::write(&path, cut).expect("a file");
    let (code, said) = emitted(&[&path], &machine, &folder.path().join("out"));
    assert_eq!(code, Some(2), "{said}");
    assert!(says.iter().all(|part| said.contains(part)), "{said}");
    assert!(said.contains(name) && !said.contains(" = "), "{said}");
    let mut command = imogene();
    let rendered = command
        .arg("render")
        .arg(&path)
        .args(["--size", "40x30", "-o"]);
    let rendered = rendered.arg(folder.path().join("picture.png")).output();
    let rendered = rendered.expect("the program runs");
    assert_eq!(
        rendered.status.code(),
        Some(0),
        "{name}: what is possible instead"
    );
}

#[test]
fn an_animation_is_shown_frame_by_frame() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = |range: &str| {
        let mut command = imogene();
        command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        command.args(["machine", "scenes/animation/arm.toml", "--json"]);
        command.args(["--machine", "machines/zone-320x240.toml", "--emit-only"]);
        command.args(["--animation", range, "--out"]);
        command
            .arg(folder.path())
            .output()
            .expect("the program runs")
    };
    let output = run("9..11");
    assert_eq!(output.status.code(), Some(0));
    let value: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let shown = [9, 10, 11].map(|n| format!("scenes/animation/arm.toml --frame {n}"));
    assert_eq!(value["scenes"], serde_json::json!(shown));
    // The arm moves, so that every frame has clocks of its own. It swings back too: frames further apart may agree.
    let clocks = value["zone_clocks"].as_array().expect("a list");
    assert!(clocks.len() == 3 && clocks[0] != clocks[1] && clocks[1] != clocks[2]);
    let refused = run("20..99");
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("numbers from 1 to 27"));
}

#[test]
fn what_a_machine_cannot_show_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let refused_with = |scene: &str, machine: &str, more: &[&str], says: &str| {
        let mut command = imogene();
        command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        command.args([
            "machine",
            scene,
            "--machine",
            machine,
            "--out",
            out.to_str().expect("a plain path"),
        ]);
        let output = command.args(more).output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(says), "{said}");
        assert!(!out.exists(), "{says}");
    };
    let refused = |scene: &str, machine: &str, says: &str| {
        refused_with(scene, machine, &[], says);
    };
    refused("scenes/teapot.toml", "no/machine.toml", "give the path");
    let tables = "machines/beam-lit-sphere.toml";
    for (scene, says) in [
        ("shadows/robot.toml", "lights = 2 # was 0"),
        ("glass/still-life.toml", "layers = "),
    ] {
        refused(&format!("scenes/{scene}"), tables, says);
    }
    let others = ["scenes/crossing-cylinders.toml"];
    let says = "crossing-cylinders.toml: lights or materials are other ones";
    refused_with("scenes/teapot.toml", tables, &others, says);
    let beam = "machines/beam-160x120.toml";
    refused("scenes/shadows/robot.toml", beam, "objects = 39 # was 10");
    let zone_machine = "machine = \"zone\" # was \"beam\"";
    refused("scenes/shadows/sphere-surface.toml", beam, zone_machine);
    let zone = "machines/zone-160x120.toml";
    let mesh = "scenes/processors/mesh.toml";
    refused(
        mesh,
        zone,
        "widths = { g1 = 10 } in the machine description",
    );
    let words = folder.path().join("words.toml");
    for (line, says) in [
        (
            "depth_word = 7",
            "depth word of 7 bits: accepted are 8 to 32",
        ),
        (
            "depth_word = 40",
            "depth word of 40 bits: accepted are 8 to 32",
        ),
        ("widths = { g1 = 17 }", "guard bits 17:0: at most 16 each"),
        ("depth_word = 31\nwidths = { g2 = 3 }", "accepts at most 2"),
        (
            "widths = { plane = 20 }",
            "plane word of 20 bits: accepted are 24 to 36",
        ),
        ("root_form = \"linear\"", "0 to 2 corrections"),
        ("root_form = \"iterative\"", "one pixel per clock"),
        ("root_form = \"rows8\"", "`dropped` of the widths"),
        (
            "widths = { root = 16 }\nroot_form = \"leading17\"",
            "leading root of 17 bits: accepted are 1 to 16",
        ),
        (
            "widths = { root = 16, dropped = 5 }\nroot_form = \"quadratic1\"",
            "quadratic root of 11 bits: accepted are 12 to 32",
        ),
    ] {
        let text = format!("machine = \"beam\"\nobjects = 10\n{COMMON}{line}\n");
        std::fs::write(&words, text).expect("a file");
        let words = words.to_str().expect("a plain path");
        refused("scenes/teapot.toml", words, says);
    }
    let mask = ["--overlay", "docs/images/trace.png"];
    refused_with("scenes/teapot.toml", zone, &mask, "overlay = true");
    let description = folder.path().join("overlaid.toml");
    let text = format!("machine = \"beam\"\nobjects = 10\n{COMMON}overlay = true\n");
    std::fs::write(&description, text).expect("a file");
    let overlaid = description.to_str().expect("a plain path");
    refused_with(
        "scenes/teapot.toml",
        overlaid,
        &mask,
        "the screen has 40 x 30",
    );
    let mask = ["--overlay", "README.md"];
    refused_with("scenes/teapot.toml", overlaid, &mask, "a PNG picture");
}
