//! `imogene board`: sources, pins and bitstream. Needs the package 'verilator', and under `IMOGENE_FULL=1` the tools of
//! `scripts/setup --synth --boards`; fails without them.

use crate::common::{Place, Run, assert_has, columns, is_full, repository, rows, scene};
use serde_json::Value;

/// A board of a scene in the folder `out` of a place.
fn board(place: &Place, name: &str, file: &str, options: &str) -> Value {
    place.json(&format!("board {name} scenes/{file} --out out {options}"))
}

fn pictures_are_equal(place: &Place, names: &[&str]) {
    for name in names {
        let picture = place.bytes(&format!("out/{name}"));
        assert!(picture == place.bytes("out/golden.png"), "{name}");
    }
}

/// Pins showed so many frames of so many pixels, all as they must be.
fn assert_shown(pins: &Value, pixels: u64) {
    assert_eq!(pins["pixels"], pixels);
    assert_eq!(pins["differing"], 0);
}

/// Whole: the words in a memory, the machine, DVI words, pairs of bits, pins; found again by a receiver.
#[test]
fn the_pins_of_a_simulated_board_show_the_golden_picture() {
    let place = Place::new();
    let options = "--flat --mode 160x120 --samples";
    let found = board(&place, "simulation", "ellipsoid.toml", options);
    let pins = &found["pins"];
    assert_shown(pins, 2 * 19_200);
    assert!(pins["words"].as_u64() > Some(2 * 19_200), "{pins}");
    assert!(pins["disparity"].as_i64() <= Some(8), "{pins}");
    assert_eq!(found["machine"]["lights"], 0);
    pictures_are_equal(&place, &["pins.png"]);
    // One byte for every bit, and the picture that it is compared with by others.
    let clocks = pins["clocks"].as_u64().expect("a number") as usize;
    assert_eq!(place.bytes("out/pins.bin").len(), 10 * clocks);
    assert_eq!(place.bytes("out/golden.rgb").len(), 3 * 19_200);
}

/// Colours from tables that stand in memory from the beginning, one for each set of lights: no word of them is sent.
#[test]
fn the_pins_of_a_board_show_colours_from_tables() {
    let place = Place::new();
    let scene = "shadows/ball-before-ball.toml";
    let options = "--lit-sphere=16:nearest --mode 160x120 --sources-only";
    let found = board(&place, "simulation", scene, options);
    let tables = serde_json::json!({ "side": 16, "materials": 2, "nearest": true });
    assert_eq!(found["machine"]["lit_sphere"], tables);
    let place = Place::new();
    let options = "--lit-sphere=16 --mode 160x120";
    let found = board(&place, "simulation", scene, options);
    assert_eq!(found["pins"]["differing"], 0);
    let tables = serde_json::json!({ "side": 16, "materials": 2 });
    assert_eq!(found["machine"]["lit_sphere"], tables);
    assert_eq!(found["machine"]["lights"], 1);
    let words = found["words"].as_u64().expect("a number");
    assert!(words < 200, "{words}");
    pictures_are_equal(&place, &["pins.png"]);
    let page = place.text("out/board.md");
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
    let place = Place::new();
    let options = "--flat --mode 160x120 --animation 2..3 --frames 11";
    let found = board(&place, "simulation", "animation/moon.toml", options);
    assert_eq!(found["images"], 2);
    let first = "board simulation scenes/animation/moon.toml --flat --animation 2..2 --sources-only --out first";
    let first = place.json(first);
    let words = |found: &Value| found["words"].as_u64().expect("a count");
    // The planet stands still, and the moon has its colour in both images.
    assert!(
        words(&found) < 3 * words(&first) / 2,
        "{} of {}",
        words(&found),
        words(&first)
    );
    // 0.08 s at 60 frames a second.
    assert_eq!(found["frames_per_image"], 5);
    let pins = &found["pins"];
    // One black frame comes first.
    assert_eq!(pins["frames"], 12);
    assert_shown(pins, 12 * 19_200);
    let golden = place.bytes("out/golden.png");
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
    let place = Place::new();
    let line = "board ulx3s-12 scenes/ellipsoid.toml --out . --flat --sources-only";
    Run::of(place.command(line).env("PATH", "")).ended(0);
    let cases = r#"
        ulx3s-12.core | name: imogene:board:ulx3s-12: | flow: trellis | board.lpf: {file_type: LPF} | "--12k"
        board.lpf | LOCATE COMP "clock" SITE "G2"; | LOCATE COMP "channel_3" SITE "A17"; | IOBUF PORT "channel_0" IO_TYPE=LVCMOS33D DRIVE=4; | FREQUENCY PORT "clock" 25 MHZ;
        board.v | .CLKI_DIV(7), .CLKFB_DIV(47) | .CLKOP_DIV(4) | .CLKOS_DIV(20) | .CLKOS2_DIV(3)
    "#;
    for row in rows(cases) {
        let (file, parts) = (row[0], &row[1..]);
        let text = place.text(file);
        for part in parts {
            assert!(text.contains(part), "{file}: {part}");
        }
    }
    let page = place.text("board.md");
    assert!(page.contains("run imogene:board:ulx3s-12\n"), "{page}");
}

/// The top level with the stated models of the cells, in Verilator.
#[test]
fn what_a_board_is_made_of_is_lint_clean() {
    let place = Place::new();
    let scene = "scenes/ellipsoid.toml";
    let models = repository("synth/board/src/top/models.v");
    for board in "ulx3s-12 icebreaker hx8k-evb tang-nano-9k basys3".split(' ') {
        // One machine for all of them.
        let machine = match place.has("ulx3s-12/machine.toml") {
            true => "--machine ulx3s-12/machine.toml",
            false => "--flat",
        };
        let line = format!("board {board} {scene} --sources-only --out {board} {machine}");
        place.run(&line).ended(0);
        let lint = "--lint-only -Wall -Wno-DECLFILENAME --top-module board_top board.v -v";
        let lint = std::process::Command::new("verilator")
            .args(lint.split(' '))
            .arg(&models)
            // Cells of the part have pins and parameters that this design has no use for.
            .args(["-Wno-PINMISSING", "-Wno-UNUSEDPARAM"])
            .current_dir(place.path(board))
            .output()
            .expect("verilator, which scripts/setup installs");
        let said = String::from_utf8_lossy(&lint.stderr);
        assert!(lint.status.success(), "{board}: {said}");
    }
}

/// A board of a scene is refused with a message that has these parts, and nothing is written.
fn refused(scene_name: &str, line: &str, parts: &[&str]) {
    let place = Place::new();
    let line = line.replace("SCENE", &format!("scenes/{scene_name}"));
    place.run(&format!("board {line} --out out")).refused(parts);
    assert!(!place.has("out"));
}

#[test]
fn what_is_refused_says_what_would_do() {
    let cases = "
        ulx3s-99 SCENE                     | ulx3s-99     | ulx3s-85
        hx8k-evb SCENE --mode 1280x720     | 1280x720     | it has 640x480
        tinytapeout SCENE --animation=1..2 | tinytapeout  | a tile moves by itself
        ulx3s-12 SCENE --layout            | ulx3s-12     | for a tile
        hx8k-evb SCENE --samples           | hx8k-evb     | DVI channels
        simulation SCENE --animation 1..2  | cone.toml    | image
        simulation SCENE --machine machines/zone-160x120.toml    | zone-160x120 | a board takes a beam machine
    ";
    for [line, wrong, right] in columns(cases) {
        refused("cone.toml", line, &[wrong, right]);
    }
}

/// What is in the part, not what was meant: a whole frame out of the bitstreams of two iCE40 and a Gowin, and out of
/// the routed cells of an ECP5.
#[test]
fn what_is_in_the_part_shows_the_golden_picture() {
    if !is_full() {
        return;
    }
    for (name, witness) in [
        ("hx8k-evb", "bitstream"),
        ("icebreaker", "bitstream"),
        ("tang-nano-9k", "bitstream"),
        ("ulx3s-12", "netlist"),
    ] {
        let place = Place::new();
        // Multipliers of the part and tables of colours; in the last the registers that multipliers have, too.
        let (scene, options) = match name {
            "icebreaker" => ("boards/egg.toml", "--lit-sphere=32:nearest"),
            "ulx3s-12" => ("boards/egg.toml", "--lit-sphere=32"),
            _ => ("ellipsoid.toml", "--flat"),
        };
        let found = board(&place, name, scene, options);
        assert_shown(&found["pins"], 2 * 307_200);
        assert_shown(&found[witness], 2 * 307_200);
        let clock = &found["routed"]["clocks"][0];
        let [achieved, wanted] = ["achieved_mhz", "wanted_mhz"].map(|key| clock[key].as_f64());
        assert!(achieved > wanted, "{clock}");
        pictures_are_equal(&place, &["pins.png", &format!("{witness}.png")]);
    }
}

/// No open program places and routes it: Yosys counts what it takes.
#[test]
fn a_board_of_sources_alone_is_counted() {
    if !is_full() {
        return;
    }
    let place = Place::new();
    let found = board(&place, "basys3", "ellipsoid.toml", "--flat");
    assert_shown(&found["pins"], 2 * 307_200);
    assert!(found["routed"].is_null());
    for kind in ["LUT", "FF", "RAMB36"] {
        let [used, there] = [0, 1].map(|at| found["synthesised"][kind][at].as_u64());
        assert!(used > Some(0) && used < there, "{kind}: {used:?}");
    }
    let excess = "does not fit xc7a35t cpg236: it takes";
    let parts = [excess, "DSP48 of 90", "--flat"];
    refused("cone.toml", "basys3 SCENE --no-simulation", &parts);
}

/// The shading processor takes more than the part has: that is said, and nothing is written.
#[test]
fn a_machine_that_does_not_fit_is_refused_with_what_runs_out() {
    if !is_full() {
        return;
    }
    let excess = "does not fit hx8k ct256: it takes";
    let parts = [excess, "of 7680", "--flat"];
    let tables = "hx8k-evb SCENE --lit-sphere=16 --no-simulation";
    refused("cut-sphere.toml", tables, &parts);
}

#[test]
fn a_tile_shows_its_golden_frames_and_has_the_files_of_its_project() {
    let place = Place::new();
    let found = board(&place, "tinytapeout", "ellipsoid.toml", "--no-bitstream");
    assert_eq!(found["pins"]["frames"], 3);
    assert_shown(&found["pins"], 3 * 307_200);
    let read = |name: &str| place.text(&format!("out/{name}"));
    let info = read("info.yaml");
    assert_has(&info, r#"tiles: "1x2" | clock_hz: 25175000 | ui[0]: "" "#);
    assert_has(&info, r#"uo[7]: "hsync" | uo[0]: "red_1""#);
    let top = "tt_um_imogene_ellipsoid";
    for name in ["info.yaml", "src/project.v", "test/tb.v"] {
        assert!(read(name).contains(top), "{name}");
    }
    // A chip has no values at power-up.
    assert!(!read("src/project.v").contains("initial"));
    serde_json::from_str::<Value>(&read("src/config.json")).expect("JSON");
    assert!(read("test/test.py").contains("COLOURS = [[4, 0], [5, 1], [6, 2]]"));
    for number in 0..3 {
        let reference = format!("out/test/reference/frame{number}.png");
        assert!(place.has(&reference), "frame {number}");
    }
}

#[test]
fn what_a_tile_cannot_draw_is_refused() {
    let parts = ["at most 3 planes; the scene has 2 objects"];
    let line = "tinytapeout SCENE --sources-only";
    refused("cut-sphere.toml", line, &parts);
}

/// Beside its own narrow image, within the wide screen.
#[test]
fn a_tile_draws_what_is_on_its_screen() {
    let place = Place::new();
    let mut text = std::fs::read_to_string(scene("ellipsoid.toml")).expect("a scene");
    for (old, new) in [
        ("width = 480, height = 360", "width = 100, height = 400"),
        ("eye = [4.13, 3.07, 9.21]", "eye = [-0.44, 3.07, 11.25]"),
        ("target = [0.02, 0.03, 0.0]", "target = [-4.55, 0.03, 2.04]"),
        ("view_height = 4.2", "view_height = 12"),
    ] {
        assert!(text.contains(old), "{old}");
        text = text.replace(old, new);
    }
    place.write("narrow.toml", text);
    let line = "board tinytapeout narrow.toml --sources-only --out out";
    place.run(line).ended(0);
}

/// In the cells of 180 nm with their delays, from unknown states on; the area is that of the shuttle's cells.
#[test]
fn the_cells_of_a_tile_show_the_golden_frames() {
    if !is_full() {
        return;
    }
    let found = board(&Place::new(), "tinytapeout", "ellipsoid.toml", "--layout");
    assert!(found["percent_of_tiles"].as_f64() < Some(80.0), "{found}");
    for kind in ["gate_pins", "layout_pins"] {
        assert_eq!(found[kind]["frames"], 3, "{kind}");
        assert_eq!(found[kind]["differing"], 0, "{kind}");
    }
    assert_eq!(found["layout"]["unrouted"], 0);
    assert_eq!(found["layout"]["differences"], 0);
}
