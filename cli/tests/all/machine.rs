//! `imogene machine`: from a scene and a description to the picture from the pins.

use crate::common::{Place, Run, assert_has, columns, run, scene};

/// A beam machine with a screen of 40 x 30 pixels, and a zone machine for it.
const SMALL: [&str; 2] = [
    "machine = \"beam\"\nobjects = 10\nloader_words = 1024\ndepth_word = 18\nwidths = { g1 = 2, g2 = 3, normal = 14 }\n",
    "machine = \"zone\"\nobjects = 3\nzone = { width = 16, height = 16 }\nsupersampling = 2\noverlay = true\n",
];
const COMMON: &str = "planes = 3\nrows_per_stage = 6\nlights = 2\nmode = { columns = [40, 4, 4, 4], lines = [30, 2, 2, 40] }\n";

#[test]
fn the_pins_show_the_golden_picture() {
    let place = Place::new();
    place.write_mask("mask.png", 40, 30);
    for own in SMALL {
        place.write("m.toml", format!("{own}{COMMON}"));
        let overlay = match own.contains("overlay") {
            true => "--overlay mask.png",
            false => "",
        };
        let machine = "machine scenes/teapot.toml --machine m.toml --engine built-in --out out";
        let value = place.json(&format!("{machine} {overlay}"));
        assert_eq!(value["equal"], true);
        assert_eq!(value["pixels_per_frame"], 1200);
        assert_eq!(value["report"]["mismatches"], 0);
        assert!(place.bytes("out/pins.png") == place.bytes("out/golden.png"));
        place.assert_files(&value);
    }
}

/// A machine for one ellipsoid.
const TINY: &str = "machine = \"beam\"\nobjects = 1\nplanes = 2\nlights = 2\nrows_per_stage = 24\n\
                    mode = { columns = [8, 4, 4, 4], lines = [6, 2, 2, 20] }\n";

/// A run of that machine.
fn tiny(place: &Place, more: &str) -> Run {
    place.write("tiny.toml", TINY);
    let machine = "machine scenes/ellipsoid.toml --machine tiny.toml --out out";
    place.run(&format!("{machine} {more}"))
}

#[test]
fn waveforms_go_from_the_bus_to_the_pins() {
    let place = Place::new();
    let run = |more: &str| tiny(&place, &format!("--vcd pins.vcd {more}"));
    let window = "--vcd-from frame:1,line:3 --vcd-clocks 20";
    let nets = "--vcd-nets core.objects.decider,loader.comes";
    run(&format!("{window} {nets}")).ended(0);
    let text = place.text("pins.vcd");
    assert_has(&text, "beam_display | s_tvalid | hsync | loader | comes");
    let rises = text.lines().filter(|line| *line == "1!").count();
    assert_eq!(rises, 20);
    assert!(place.has("pins.gtkw"));
    std::fs::remove_file(place.path("pins.vcd")).expect("it is there");

    // What never comes is said; what cannot come is refused.
    let late = run("--vcd-from frame:99").ended(0);
    late.says(&["ended before frame:99"]);
    run("--vcd-at-mismatch").ended(0);
    assert!(!place.has("pins.vcd"), "nothing differs");
    let cases = "
        --vcd-from line:6     | accepted: 0,0 to 7,5
        --vcd-from 6          | frame:2,line:120
        --vcd-nets core.shade | core has objects, pixel_count, shading,
    ";
    for [more, wanted] in columns(cases) {
        run(more).refused(&[wanted]);
    }
}

#[test]
fn many_frames_of_a_scene_are_waited_for() {
    let value = tiny(&Place::new(), "--engine built-in --frames 24 --json");
    let value = value.ended(0).json();
    let shown = value["shown"].as_array().expect("frames");
    assert_eq!(shown.iter().filter(|frame| **frame == 0).count(), 24);
}

/// What the program says of scenes on a machine of which it writes the Verilog alone, and how it ends.
fn emitted(place: &Place, scenes: &str, description: &str) -> Run {
    let machine = format!("--machine {description} --emit-only --out out");
    place.run(&format!("machine {scenes} {machine}"))
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
    let place = Place::new();
    let tiny = "planes = 0\nmode = { columns = [40, 4, 4, 4], lines = [30, 2, 2, 2] }\n";
    let beam = format!("machine = \"beam\"\nobjects = 1\n{tiny}");
    let zone =
        "machine = \"zone\"\nobjects = 1\nvolume_planes = 0\nzone = { width = 16, height = 16 }\n";
    let zone = &format!("{zone}{tiny}");
    let large =
        "machine = \"beam\"\nobjects = 2\nplanes = 3\nloader_words = 50\nmode = \"640x480\"\n";
    let stream = format!("{beam}output = \"stream\"\n");
    let slotted = beam.replace("objects = 1\nplanes = 0", "slots = \"3,0\"");
    let short = slotted.replace("3,0", "3:r9,0:p24");
    let suns = format!("{beam}suns = 1\n");
    let solid = zone.replace("objects = 1\n", "objects = 4\nproducts = \"2-1\"\n");
    let sphere = format!("{beam}lights = 0\nlit_sphere = {{ side = 128, materials = 1 }}\n");
    #[rustfmt::skip]
    let cases = [
        ("orthographic", &*sphere, "objects = | lit_sphere = {"),
        ("solids/bracket", zone, "products = \"1-4\" | objects = 6 # was 1 | planes = 6 # was 0"),
        ("solids/printed-example solids/bracket", &solid, "products = \"2-4\" # was \"2-1\" | objects = 7 # was 4"),
        ("teapot", &suns, "objects = 10 # | planes = | lights = 2 # was 1"),
        ("teapot", &beam, "objects = 10 # | planes = | lights = 2 # was 1 | mode ="),
        ("crossing-cylinders teapot", &stream, "objects = 10 # | planes = | lights = 2 # was 1"),
        ("teapot", &slotted, "slots = \"3,2, | objects = 10 # was 2 | lights = 2"),
        // What is too short becomes as long as the part of the scene needs; a slot that is added has the longest words.
        ("teapot", &short, "slots = \"3:r21,2:p24,2, | objects = 10 # was 2"),
        ("teapot", large, "objects = 10 # | lights = 2 # was 1 | loader_words ="),
        ("shadows/robot teapot", &beam, "objects = 39 # | volumes = 157 # | mode ="),
        ("shadows/robot", zone, "volumes = 1 # | volume_planes = | planes = | lights = 2 #"),
        ("processors/mesh", &beam, "slots = \"78xfacet3\" | objects = 78 # was 1"),
        ("zones/molecule-480", &beam, "machine = \"zone\" | zone = | lights = 2 #"),
        ("zones/molecule-480", large, "machine = \"zone\" | # and no loader_words"),
    ];
    for (names, description, wanted) in cases {
        let scenes = names.split(' ').map(|name| format!("scenes/{name}.toml"));
        let scenes = scenes.collect::<Vec<String>>().join(" ");
        place.write("machine.toml", description);
        let said = emitted(&place, &scenes, "machine.toml").ended(2).said;
        assert!(!place.has("out"), "nothing is written");
        let (first, advice) = said.split_once('\n').expect("lines of an advice");
        let lacks = "machine.toml: the machine has too little";
        assert!(first.contains(lacks), "{said}");
        for line in wanted.split(" | ") {
            let is_advised = advice.lines().any(|found| found.starts_with(line));
            assert!(is_advised, "{line}: {said}");
        }
        place.write("machine.toml", advised(description, advice));
        emitted(&place, &scenes, "machine.toml").ended(0);
        std::fs::remove_dir_all(place.path("out")).expect("a folder");
    }
}

#[test]
fn more_planes_than_any_machine_has_are_not_advised() {
    let place = Place::new();
    let text = std::fs::read_to_string(scene("cut-sphere.toml")).expect("a scene");
    // An object has at most 12 cuts, but its shadow needs a plane more.
    let cut = |i: u32| {
        let (y, x) = (f64::from(i) / 12.0 * std::f64::consts::TAU + 0.05).sin_cos();
        let (u, v) = (0.8 * x, 0.8 * y);
        format!("{{ point = [{u}, {v}, 0], normal = [{x}, {y}, 0.1] }}")
    };
    let cuts = (0..12).map(cut).collect::<Vec<_>>().join(", ");
    let shadows = "kind = \"directional\"\nshadows = true";
    let cut = format!(
        "{}\n[[objects]]\nname = \"many sides\"\nkind = \"sphere\"\nradius = 1\nmaterial = \"lemon\"\ncuts = [{cuts}]\n",
        text.replacen("kind = \"directional\"", shadows, 1)
    );
    place.write("planes.toml", cut);
    let shadow = "the shadow of object 'many sides'";
    let refused = emitted(&place, "planes.toml", "machines/zone-160x120.toml");
    let refused = refused.refused(&["planes.toml", shadow, "has 13 planes"]);
    assert!(!refused.said.contains(" = "), "{}", refused.said);
    // What is possible instead.
    place.run("render planes.toml --size 40x30").ended(0);
}

#[test]
fn an_animation_is_shown_frame_by_frame() {
    let place = Place::new();
    let machine = "--machine machines/zone-320x240.toml --emit-only";
    let machine = format!("{machine} --out {}", place.folder().display());
    let run = |range: &str| {
        let line = format!("machine scenes/animation/arm.toml --json --animation {range}");
        run(&format!("{line} {machine}"))
    };
    let value = run("9..11").ended(0).json();
    let shown = [9, 10, 11].map(|n| format!("scenes/animation/arm.toml --frame {n}"));
    assert_eq!(value["scenes"], serde_json::json!(shown));
    // The arm moves, so that every frame has clocks of its own. It swings back too: frames further apart may agree.
    let clocks = value["zone_clocks"].as_array().expect("a list");
    assert!(clocks.len() == 3 && clocks[0] != clocks[1] && clocks[1] != clocks[2]);
    run("20..99").refused(&["numbers from 1 to 27"]);
}

#[test]
fn what_a_machine_cannot_show_is_refused_and_leaves_nothing() {
    let place = Place::new();
    let refused = |scenes: &str, machine: &str, says: &str| {
        let line = format!("machine {scenes} --machine {machine} --out out");
        place.run(&line).refused(&[says]);
        assert!(!place.has("out"), "{says}");
    };
    let cases = r#"
        scenes/teapot.toml | no/machine.toml | give the path
        scenes/shadows/robot.toml | machines/beam-lit-sphere.toml | lights = 2 # was 0
        scenes/glass/still-life.toml | machines/beam-lit-sphere.toml | layers = 3
        scenes/teapot.toml scenes/crossing-cylinders.toml | machines/beam-lit-sphere.toml | crossing-cylinders.toml: lights or materials are other ones
        scenes/shadows/robot.toml | machines/beam-160x120.toml | objects = 39 # was 10
        scenes/shadows/sphere-surface.toml | machines/beam-160x120.toml | machine = "zone" # was "beam"
        scenes/processors/mesh.toml | machines/zone-160x120.toml | slots = "4x3,facet3"
        scenes/teapot.toml --overlay docs/images/trace.png | machines/zone-160x120.toml | overlay = true
    "#;
    for [scenes, machine, says] in columns(cases) {
        refused(scenes, machine, says);
    }
    let cases = r#"
        depth_word = 7 | scenes/teapot.toml | depth word of 7 bits: accepted are 8 to 32
        depth_word = 40 | scenes/teapot.toml | depth word of 40 bits: accepted are 8 to 32
        widths = { g1 = 17 } | scenes/teapot.toml | guard bits 17:0: at most 16 each
        depth_word = 31; widths = { g2 = 3 } | scenes/teapot.toml | accepts at most 2
        widths = { plane = 20 } | scenes/teapot.toml | plane word of 20 bits: accepted are 24 to 36
        root_form = "linear" | scenes/teapot.toml | 0 to 2 corrections
        root_form = "iterative" | scenes/teapot.toml | output = "stream" in a beam machine
        root_form = "rows8" | scenes/teapot.toml | `dropped` of the widths
        widths = { root = 16 }; root_form = "leading17" | scenes/teapot.toml | leading root of 17 bits: accepted are 1 to 16
        widths = { root = 16, dropped = 5 }; root_form = "quadratic1" | scenes/teapot.toml | quadratic root of 11 bits: accepted are 12 to 32
        overlay = true | scenes/teapot.toml --overlay docs/images/trace.png | the screen has 40 x 30
        overlay = true | scenes/teapot.toml --overlay docs/README.md | a PNG picture
    "#;
    for [line, scenes, says] in columns(cases) {
        let lines = line.replace("; ", "\n");
        let text = format!("machine = \"beam\"\nobjects = 10\n{COMMON}{lines}\n");
        place.write("own.toml", text);
        refused(scenes, "own.toml", says);
    }
}
