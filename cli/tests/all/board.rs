//! `imogene board`: sources, pins and bitstream. Needs the package 'verilator', and under `IMOGENE_FULL=1` the tools of
//! `scripts/setup --synth --boards`; fails without them.

use crate::common::{imogene, json_in, refusal_in, scene};
use serde_json::Value;
use std::path::Path;

fn is_full() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

fn board(name: &str, file: &str, options: &[&str], folder: &Path) -> Value {
    let scene = scene(file).display().to_string();
    let arguments = [&["board", name, &scene, "--out", "out"], options].concat();
    json_in(&arguments, folder)
}

fn pictures_are_equal(folder: &Path, names: &[&str]) {
    let read = |name: &str| std::fs::read(folder.join("out").join(name)).expect("a picture");
    for name in names {
        assert!(read(name) == read("golden.png"), "{name}");
    }
}

/// Whole: the words in a memory, the machine, DVI words, pairs of bits, pins; found again by a receiver.
#[test]
fn the_pins_of_a_simulated_board_show_the_golden_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let options = ["--flat", "--mode", "160x120", "--samples"];
    let found = board("simulation", "ellipsoid.toml", &options, folder.path());
    let pins = &found["pins"];
    assert_eq!(
        (&pins["pixels"], &pins["differing"]),
        (&(2 * 19_200).into(), &0.into())
    );
    assert!(pins["words"].as_u64() > Some(2 * 19_200), "{pins}");
    assert!(pins["disparity"].as_i64() <= Some(8), "{pins}");
    assert_eq!(found["machine"]["lights"], 0);
    pictures_are_equal(folder.path(), &["pins.png"]);
    // One byte for every bit, and the picture that it is compared with by others.
    let samples = std::fs::metadata(folder.path().join("out/pins.bin")).expect("samples");
    assert_eq!(
        samples.len(),
        10 * pins["clocks"].as_u64().expect("a number")
    );
    let golden = std::fs::metadata(folder.path().join("out/golden.rgb")).expect("a picture");
    assert_eq!(golden.len(), 3 * 19_200);
}

/// Colours from tables that stand in memory from the beginning, one for each set of lights: no word of them is sent.
#[test]
fn the_pins_of_a_board_show_colours_from_tables() {
    let folder = tempfile::tempdir().expect("a folder");
    let options = ["--lit-sphere=16", "--mode", "160x120"];
    let scene = "shadows/ball-before-ball.toml";
    let found = board("simulation", scene, &options, folder.path());
    assert_eq!(found["pins"]["differing"], 0);
    let machine = &found["machine"];
    assert_eq!(machine["lights"], 1);
    assert_eq!(
        machine["lit_sphere"],
        serde_json::json!({ "side": 16, "materials": 2 })
    );
    let words = found["words"].as_u64().expect("a number");
    assert!(words < 200, "{words}");
    pictures_are_equal(folder.path(), &["pins.png"]);
    let page = std::fs::read_to_string(folder.path().join("out/board.md")).expect("a page");
    for part in [
        "(pins.png)",
        &format!("{words} words"),
        "| the sources | 2 | 38400 | 0 |",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    assert!(!page.contains("fusesoc"), "{page}");
}

/// Images in memory, each for as many frames of the screen as the scene says: from the first again behind the last.
#[test]
fn the_pins_of_a_board_show_an_animation() {
    let folder = tempfile::tempdir().expect("a folder");
    let options = ["--flat", "--mode", "160x120", "--animation", "2..3"];
    let found = board(
        "simulation",
        "animation/moon.toml",
        &[&options[..], &["--frames", "14"]].concat(),
        folder.path(),
    );
    assert_eq!(found["images"], 2);
    // 0.08 s at 60 frames a second.
    assert_eq!(found["frames_per_image"], 5);
    let pins = &found["pins"];
    // One black frame comes first.
    assert_eq!(pins["frames"], 15);
    assert_eq!(
        (&pins["pixels"], &pins["differing"]),
        (&(15 * 19_200).into(), &0.into())
    );
    let golden = std::fs::read(folder.path().join("out/golden.png")).expect("a picture");
    let decoder = png::Decoder::new(std::io::Cursor::new(golden));
    let mut reader = decoder.read_info().expect("a picture");
    let control = reader.info().animation_control.expect("an animation");
    assert_eq!(control.num_frames, 2);
    let mut frame = || {
        let mut picture = vec![0; reader.output_buffer_size().expect("a size")];
        reader.next_frame(&mut picture).expect("a frame");
        picture
    };
    // The moon moves.
    assert_ne!(frame(), frame());
}

#[test]
fn sources_need_no_tool() {
    let folder = tempfile::tempdir().expect("a folder");
    let options = ["--flat", "--sources-only"];
    let scene = scene("ellipsoid.toml").display().to_string();
    let mut command = imogene();
    command.args(["board", "ulx3s-12", &scene, "--out", "out"]);
    command
        .args(options)
        .env("PATH", "")
        .current_dir(folder.path());
    command.assert().success();
    let read =
        |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).expect("a file");
    let core = read("ulx3s-12.core");
    for part in [
        "name: imogene:board:ulx3s-12:",
        "flow: trellis",
        "board.lpf: {file_type: LPF}",
        "\"--12k\"",
    ] {
        assert!(core.contains(part), "{part}: {core}");
    }
    assert!(read("board.md").contains("run imogene:board:ulx3s-12\n"));
    let pins = read("board.lpf");
    for line in [
        "LOCATE COMP \"clock\" SITE \"G2\";",
        "LOCATE COMP \"channel_3\" SITE \"A17\";",
        "IOBUF PORT \"channel_0\" IO_TYPE=LVCMOS33D DRIVE=4;",
        "FREQUENCY PORT \"clock\" 25 MHZ;",
    ] {
        assert!(pins.contains(line), "{line}: {pins}");
    }
    let verilog = read("board.v");
    for divider in [
        ".CLKI_DIV(7), .CLKFB_DIV(47)",
        ".CLKOP_DIV(4)",
        ".CLKOS_DIV(20)",
        ".CLKOS2_DIV(3)",
    ] {
        assert!(verilog.contains(divider), "{divider}");
    }
}

/// The top level with the stated models of the cells, in Verilator.
#[test]
fn what_a_board_is_made_of_is_lint_clean() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = scene("ellipsoid.toml").display().to_string();
    let models = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../synth/board/src/top/models.v"
    );
    for board in ["ulx3s-12", "icebreaker", "hx8k-evb"] {
        let mut command = imogene();
        command.args(["board", board, &scene, "--sources-only", "--out", board]);
        // One machine for all of them.
        let machine = folder.path().join("ulx3s-12/machine.toml");
        match machine.exists() {
            true => command.arg("--machine").arg(machine),
            false => command.arg("--flat"),
        };
        command.current_dir(folder.path()).assert().success();
        let lint = std::process::Command::new("verilator")
            .args([
                "--lint-only",
                "-Wall",
                "-Wno-DECLFILENAME",
                "--top-module",
                "board_top",
                "board.v",
            ])
            .args(["-v", models])
            // Cells of the part have pins and parameters that this design has no use for.
            .args(["-Wno-PINMISSING", "-Wno-UNUSEDPARAM"])
            .current_dir(folder.path().join(board))
            .output()
            .expect("verilator, which scripts/setup installs");
        let said = String::from_utf8_lossy(&lint.stderr);
        assert!(lint.status.success(), "{board}: {said}");
    }
}

#[test]
fn what_is_refused_says_what_would_do() {
    let folder = tempfile::tempdir().expect("a folder");
    let cone = scene("cone.toml").display().to_string();
    let refused = |more: &[&str]| {
        let arguments = [&["board"], more, &["--out", "out"]].concat();
        let said = refusal_in(&arguments, folder.path());
        assert!(!folder.path().join("out").exists());
        said
    };
    let said = refused(&["ulx3s-99", &cone]);
    assert!(
        said.contains("ulx3s-99") && said.contains("ulx3s-85"),
        "{said}"
    );
    let said = refused(&["hx8k-evb", &cone, "--mode", "1280x720"]);
    assert!(
        said.contains("1280x720") && said.contains("it has 640x480"),
        "{said}"
    );
    for (board, option, part) in [
        ("tinytapeout", "--animation=1..2", "a tile moves by itself"),
        ("ulx3s-12", "--layout", "for a tile"),
        ("hx8k-evb", "--samples", "DVI channels"),
    ] {
        let said = refused(&[board, &cone, option]);
        assert!(said.contains(board) && said.contains(part), "{said}");
    }
    let said = refused(&["simulation", &cone, "--animation", "1..2"]);
    assert!(
        said.contains("cone.toml") && said.contains("image"),
        "{said}"
    );
    let zone = concat!(env!("CARGO_MANIFEST_DIR"), "/../machines/zone-160x120.toml");
    let said = refused(&["simulation", &cone, "--machine", zone]);
    assert!(said.contains("a board takes a beam machine"), "{said}");
}

/// What is in the part, not what was meant: a whole frame out of the bitstream of an iCE40, and out of the routed cells
/// of an ECP5.
#[test]
fn what_is_in_the_part_shows_the_golden_picture() {
    if !is_full() {
        return;
    }
    in_the_part("hx8k-evb", "bitstream");
    in_the_part("ulx3s-12", "netlist");
}

fn in_the_part(name: &str, witness: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let found = board(name, "ellipsoid.toml", &["--flat"], folder.path());
    for pins in [&found["pins"], &found[witness]] {
        assert_eq!(
            (&pins["pixels"], &pins["differing"]),
            (&(2 * 307_200).into(), &0.into())
        );
    }
    let clock = &found["routed"]["clocks"][0];
    assert!(
        clock["achieved_mhz"].as_f64() > clock["wanted_mhz"].as_f64(),
        "{clock}"
    );
    pictures_are_equal(folder.path(), &["pins.png", &format!("{witness}.png")]);
}

/// The shading processor takes more than the part has: that is said, and nothing is written.
#[test]
fn a_machine_that_does_not_fit_is_refused_with_what_runs_out() {
    if !is_full() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let cone = scene("cone.toml").display().to_string();
    let arguments = [
        "board",
        "hx8k-evb",
        &cone,
        "--no-simulation",
        "--out",
        "out",
    ];
    let said = refusal_in(&arguments, folder.path());
    assert!(
        said.contains("does not fit hx8k ct256: it takes") && said.contains("of 7680"),
        "{said}"
    );
    assert!(said.contains("--flat"), "{said}");
    assert!(!folder.path().join("out").exists());
}

#[test]
fn a_tile_shows_its_golden_frames_and_has_the_files_of_its_project() {
    let folder = tempfile::tempdir().expect("a folder");
    let found = board(
        "tinytapeout",
        "ellipsoid.toml",
        &["--no-bitstream"],
        folder.path(),
    );
    let pins = &found["pins"];
    assert_eq!(pins["frames"], 3);
    assert_eq!(
        (&pins["pixels"], &pins["differing"]),
        (&(3 * 307_200).into(), &0.into())
    );
    let read = |name: &str| {
        let path = folder.path().join("out").join(name);
        std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{name}: {error}"))
    };
    let info = read("info.yaml");
    for line in [
        "tiles: \"1x2\"",
        "clock_hz: 25175000",
        "uo[7]: \"hsync\"",
        "uo[0]: \"red_1\"",
        "ui[0]: \"\"",
    ] {
        assert!(info.contains(line), "{line}: {info}");
    }
    let top = "tt_um_imogene_ellipsoid";
    for name in ["info.yaml", "src/project.v", "test/tb.v"] {
        assert!(read(name).contains(top), "{name}");
    }
    // A chip has no values at power-up.
    assert!(!read("src/project.v").contains("initial"));
    serde_json::from_str::<Value>(&read("src/config.json")).expect("JSON");
    assert!(read("test/test.py").contains("COLOURS = [[4, 0], [5, 1], [6, 2]]"));
    for number in 0..3 {
        let reference = folder
            .path()
            .join(format!("out/test/reference/frame{number}.png"));
        assert!(reference.is_file(), "frame {number}");
    }
}

#[test]
fn what_a_tile_cannot_draw_is_refused() {
    let scene = scene("cut-sphere.toml").display().to_string();
    let arguments = [
        "board",
        "tinytapeout",
        &scene,
        "--sources-only",
        "--out",
        "out",
    ];
    let said = refusal_in(&arguments, Path::new("."));
    assert!(
        said.contains("at most 3 planes; the scene has 2 objects"),
        "{said}"
    );
}

/// In the cells of 180 nm with their delays, from unknown states on; the area is that of the shuttle's cells.
#[test]
fn the_cells_of_a_tile_show_the_golden_frames() {
    if !is_full() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let found = board(
        "tinytapeout",
        "ellipsoid.toml",
        &["--layout"],
        folder.path(),
    );
    assert!(found["percent_of_tiles"].as_f64() < Some(80.0), "{found}");
    for kind in ["gate_pins", "layout_pins"] {
        let pins = &found[kind];
        let shown = (&pins["frames"], &pins["differing"]);
        assert_eq!(shown, (&3.into(), &0.into()), "{kind}");
    }
    assert_eq!(
        (
            &found["layout"]["unrouted"],
            &found["layout"]["differences"]
        ),
        (&0.into(), &0.into())
    );
}
