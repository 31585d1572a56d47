//! Machines with a screen: the pins on every clock, and the pixels of their streams.

use super::{prepared, root, scene};
use imogene_contract::slots::{Slots, parse};
use imogene_golden::machine::overlay::OverlayPlane;
use imogene_golden::widths::OwnWidths;
use imogene_plan::description::{MachineDescription, Output, Smoothing, ZoneSize};
use imogene_plan::display::{Image, image};
use imogene_plan::needs::{enough, narrowed};
use imogene_scene::SceneFile;
use imogene_verif::display::pins::{self, PinsOutcome, PinsRun};
use imogene_verif::display::request::request_for;
use imogene_verif::engine::Engine;
use imogene_verif::engine::circuit::levelised;
use imogene_verif::engine::machine::MachineDesign;
use imogene_verif::engine::simulator::Simulator;
use std::collections::BTreeSet;
use std::slice::from_ref;

const VERILATOR: Engine = Engine::Verilog(Simulator::Verilator);

/// A machine with a screen of this size and little blanking.
pub(crate) fn small(name: &str, columns: u64, lines: u64, blank: u64) -> MachineDescription {
    let text = std::fs::read_to_string(root().join("machines").join(name)).expect("a file");
    let mode =
        format!("mode = {{ columns = [{columns}, 4, 8, 8], lines = [{lines}, 2, 2, {blank}] }}\n");
    let lines = text.lines().filter(|line| !line.starts_with("mode"));
    let text = lines.collect::<Vec<_>>().join("\n") + "\n" + &mode;
    MachineDescription::parse(&text, name).expect("a description")
}

pub(crate) fn drawn(name: &str, machine: &MachineDescription) -> Image {
    drawn_file(&scene(name), machine)
}

fn drawn_file(file: &SceneFile, machine: &MachineDescription) -> Image {
    let size = machine.drawn_size().expect("a mode");
    let (framed, prepared) = prepared(file, size, machine.format().expect("a format"));
    image(&framed, &prepared, machine).expect("fits the machine")
}

/// The picture of a scene whose first so many lights make shadows, of which there are some.
fn shaded(name: &str, lights: usize, machine: &MachineDescription) -> Image {
    let mut file = scene(name);
    for light in &mut file.lights[..lights] {
        light.shadows = true;
    }
    let image = drawn_file(&file, machine);
    let flags = &image.lighting.flags;
    assert!(flags.iter().any(|&flags| flags != u16::MAX), "a shadow");
    image
}

/// The pictures of two scenes, in turn.
fn in_turn(names: [&str; 2], machine: &MachineDescription) -> [Image; 4] {
    let [one, other] = names.map(|name| drawn(name, machine));
    [one.clone(), other.clone(), one, other]
}

/// A host that stalls by a seed, and that is late before each image.
pub(crate) fn host(engine: Engine, stalls: Option<u64>, late: u64) -> PinsRun<'static> {
    PinsRun {
        stalls,
        late,
        ..PinsRun::plain(engine)
    }
}

pub(crate) fn run(
    machine: &MachineDescription,
    images: &[Image],
    options: &PinsRun,
) -> PinsOutcome {
    let outcome = pins::run(machine, images, options, || ()).expect("a machine that runs");
    let report = &outcome.report;
    assert_eq!(report.mismatches, 0, "{}", report.first_mismatches[0]);
    let last = images.last().expect("an image");
    let golden = match options.overlay {
        Some(plane) => plane.over(&last.picture),
        None => last.picture.clone(),
    };
    assert!(outcome.picture == golden, "the picture of the pins");
    println!(
        "{} {}: {} clocks, {:.0} per second, taken in {:?}, shown {:?}",
        report.subject,
        report.engine,
        report.cycles,
        report.cycles_per_second,
        outcome.taking,
        outcome.shown
    );
    outcome
}

/// The picture of a scene, which is what a machine shows.
fn shown(name: &str, machine: &MachineDescription, engine: Engine) -> Image {
    let image = drawn(name, machine);
    run(machine, from_ref(&image), &PinsRun::plain(engine));
    image
}

fn slots(text: &str) -> Option<Slots> {
    Some(Slots(parse(text).expect("slots")))
}

#[test]
fn the_beam_machine_in_the_built_in_simulator() {
    let machine = small("beam-160x120.toml", 32, 24, 40);
    let image = shown("teapot.toml", &machine, Engine::BuiltIn);
    assert!(image.picture.iter().any(|&byte| byte > 100), "a picture");
}

/// A machine of these words with a small screen.
fn of_words(name: &str, words: &str) -> MachineDescription {
    let machine = small(name, 48, 36, 40);
    let text = format!(
        "machine = \"zone\"\nobjects = 1\nplanes = 0\nmode = \"160x120\"\nzone = {{ width = 1, height = 1 }}\n{words}\n"
    );
    let own = MachineDescription::parse(&text, "words").expect("a description");
    MachineDescription {
        depth_word: own.depth_word,
        widths: own.widths,
        root_form: own.root_form,
        rows_per_stage: 5,
        ..machine
    }
}

/// Slots of fewer bits than their machine draw the same picture; one bit less, and they are not enough.
#[test]
fn slots_of_zone_machines_in_words_of_their_own() {
    let scenes = [
        ("teapot", 4),
        ("shadows/robot", 4),
        ("glass/still-life", 2),
        ("solids/bracket", 1),
    ];
    for (name, objects) in scenes {
        let machine = MachineDescription {
            objects,
            ..of_words("zone-160x120.toml", "depth_word = 18")
        };
        let size = machine.drawn_size().expect("a mode");
        let format = machine.format().expect("a format");
        let (framed, prepared) = prepared(&scene(&format!("{name}.toml")), size, format);
        let scenes = [(&framed, &prepared)];
        let wide = enough(&machine, &scenes).expect("a machine");
        let narrow = narrowed(&wide, &scenes).expect("a machine");
        narrow.check(name).expect("a machine");
        assert_eq!(
            enough(&narrow, &scenes).expect("a machine"),
            narrow,
            "{name}"
        );
        let images = [&wide, &narrow].map(|of| image(&framed, &prepared, of).expect("a picture"));
        assert!(images[0].picture == images[1].picture, "{name}");
        run(&narrow, &images[1..], &PinsRun::plain(Engine::BuiltIn));
        let mut slots = narrow.slots();
        let longest = slots.iter().filter_map(|slot| slot.root).max();
        assert!(longest.is_some(), "{name}: no short root");
        let longest = slots.iter_mut().filter(|slot| slot.root == longest);
        longest.for_each(|slot| slot.root = slot.root.map(|bits| bits - 1));
        let less = MachineDescription {
            slots: Some(Slots(slots)),
            ..narrow
        };
        assert_ne!(enough(&less, &scenes).expect("a machine"), less, "{name}");
    }
}

#[test]
fn machines_of_any_words_in_the_built_in_simulator() {
    let own = "widths = { root = 20, plane = 29, normal = 13, g1 = 3, g2 = 5, dropped = 2 }";
    let own = format!("depth_word = 20\n{own}");
    let (zone, beam) = ("zone-160x120.toml", "beam-160x120.toml");
    let linear = format!("{own}\nroot_form = \"linear2\"");
    let leading = format!("{own}\nroot_form = \"leading8\"");
    let guarded = "depth_word = 31\nwidths = { g1 = 16, g2 = 2 }";
    let cases: [(&str, &str, &str); 14] = [
        ("shadows/robot.toml", zone, "depth_word = 18"),
        ("shadows/robot.toml", zone, &own),
        ("teapot.toml", zone, "depth_word = 8"),
        ("teapot.toml", zone, guarded),
        ("teapot.toml", beam, "depth_word = 18"),
        ("teapot.toml", beam, &own),
        ("teapot.toml", beam, "depth_word = 11"),
        ("crossing-cylinders.toml", "beam-stream.toml", &own),
        ("shadows/robot.toml", zone, &linear),
        ("shadows/robot.toml", zone, &leading),
        ("teapot.toml", zone, "root_form = \"quadratic1\""),
        ("teapot.toml", beam, &linear),
        ("teapot.toml", beam, "root_form = \"non-restoring\""),
        ("crossing-cylinders.toml", "beam-stream.toml", &leading),
    ];
    for (scene, name, words) in cases {
        let machine = of_words(name, words);
        let image = shown(scene, &machine, Engine::BuiltIn);
        assert!(image.picture.iter().any(|&byte| byte > 100), "a picture");
    }
}

#[test]
fn machines_without_lights_show_plain_colours() {
    for name in ["beam-160x120.toml", "beam-stream.toml", "zone-160x120.toml"] {
        let machine = MachineDescription {
            lights: 0,
            ..small(name, 48, 36, 40)
        };
        let image = shown("teapot.toml", &machine, Engine::BuiltIn);
        let colours: BTreeSet<&[u8]> = image.picture.chunks_exact(3).collect();
        // The background and the materials of the scene.
        assert!((2..=6).contains(&colours.len()), "{colours:?}");
    }
}

#[test]
fn slots_that_are_not_alike_show_the_golden_picture() {
    let mut machine = small("beam-160x120.toml", 48, 36, 40);
    let alike = drawn("teapot.toml", &machine);
    // As `imogene check` says of the scene in this size, a few with more than they need.
    machine.slots = slots("2,2,2,1,2,0,2,3,3,3");
    let image = shown("teapot.toml", &machine, Engine::BuiltIn);
    assert!(image.beats.len() < alike.beats.len());
}

/// Chains and cards, also of which the last is not full, of processors of different latencies, with products behind
/// some: the decider's form changes clocks and no pixel.
#[test]
fn deciders_of_every_form() {
    let beam = small("beam-160x120.toml", 48, 36, 40);
    let mixed = MachineDescription {
        objects: 5,
        planes: 6,
        slots: slots("3,patch3,polyhedron6,facet3,3"),
        volumes: 1,
        volume_planes: 10,
        ..small("zone-slots.toml", 48, 36, 12)
    };
    let solids = small("zone-solids.toml", 48, 36, 12);
    for (scene, machine) in [
        ("teapot.toml", &beam),
        ("shadows/robot.toml", &mixed),
        ("solids/bracket.toml", &solids),
    ] {
        let alike = drawn(scene, machine);
        for decider in ["chain", "cards4", "cards1"] {
            let machine = MachineDescription {
                decider: decider.parse().expect("a form"),
                ..machine.clone()
            };
            let image = shown(scene, &machine, Engine::BuiltIn);
            assert!(image.picture == alike.picture);
        }
    }
}

#[test]
fn facets_and_patches_on_the_pins_of_a_zone_machine() {
    let machine = small("zone-slots.toml", 64, 48, 12);
    let guarded = MachineDescription {
        widths: OwnWidths {
            g1: Some(10),
            ..OwnWidths::default()
        },
        objects: 2,
        slots: slots("4,4"),
        ..machine.clone()
    };
    let short = MachineDescription {
        objects: 2,
        slots: slots("patch0,4"),
        ..machine.clone()
    };
    let stream = MachineDescription {
        output: Output::Stream,
        ..machine.clone()
    };
    for (scene, machine, engine) in [
        ("processors/mesh.toml", &machine, VERILATOR),
        ("processors/mesh.toml", &stream, Engine::BuiltIn),
        ("terrain/hills.toml", &machine, Engine::BuiltIn),
        ("processors/mesh.toml", &guarded, Engine::BuiltIn),
        ("processors/patch-processor.toml", &short, Engine::BuiltIn),
    ] {
        let image = shown(scene, machine, engine);
        assert!(image.frame.covered() > 300);
    }
}

/// One solid after the other, so that a processor that is not loaded has words of the other one; then samples.
#[test]
fn solids_on_the_pins_of_a_zone_machine() {
    let machine = small("zone-solids.toml", 64, 48, 12);
    let of = |machine: &MachineDescription, name: &str| {
        let image = drawn(&format!("solids/{name}.toml"), machine);
        assert!(image.frame.covered() > 600);
        image
    };
    let [bracket, printed] = ["bracket", "printed-example"].map(|name| of(&machine, name));
    let images = [bracket.clone(), printed, bracket];
    run(&machine, &images, &PinsRun::plain(Engine::BuiltIn));
    run(&machine, &images, &PinsRun::plain(VERILATOR));
    let sampled = MachineDescription {
        supersampling: 2,
        output: Output::Stream,
        ..machine
    };
    let image = of(&sampled, "bracket");
    run(&sampled, &[image], &PinsRun::plain(Engine::BuiltIn));
}

#[test]
fn the_beam_machine_smooths_and_never_tears() {
    for smoothing in [Smoothing::None, Smoothing::Box, Smoothing::Binomial] {
        let mut machine = small("beam-160x120.toml", 48, 36, 40);
        machine.smoothing = smoothing;
        machine.overlay = smoothing == Smoothing::Box;
        let images = in_turn(["teapot.toml", "crossing-cylinders.toml"], &machine);
        let checks: Vec<bool> = (0..48 * 36).map(|place| place % 7 < 2).collect();
        let plane = OverlayPlane::new(&checks, [255, 200, 3]);
        // A host that stalls, and that is late by more than a frame before each image.
        let options = PinsRun {
            overlay: machine.overlay.then_some(&plane),
            frames: 2,
            ..host(VERILATOR, Some(5), 7000)
        };
        let outcome = run(&machine, &images, &options);
        let mut pairs = outcome.shown.windows(2);
        let repeated = pairs.any(|pair| pair[0] == pair[1] && pair[0].is_some());
        assert!(repeated, "a late host repeats a frame: {:?}", outcome.shown);
    }
}

/// No frame mixes two scenes, whenever their words come, and none is left out.
#[test]
fn words_that_come_in_the_blanking_in_time_are_shown_behind_it() {
    let machine = small("beam-160x120.toml", 16, 12, 60);
    let images = in_turn(["crossing-cylinders.toml", "ellipsoid.toml"], &machine);
    let clocks = 36 * 64;
    let shown = (0..clocks).step_by(61).map(|late| {
        let host = host(Engine::BuiltIn, None, late);
        run(&machine, &images[..2], &host).shown
    });
    let shown: Vec<Vec<Option<usize>>> = shown.collect();
    for frames in &shown {
        let mut all = frames.clone();
        all.dedup();
        let wanted = [None, Some(0), Some(1)];
        assert!(all.len() > 1 && wanted.ends_with(&all), "{frames:?}");
    }
    let (early, late) = shown.split_at(shown.partition_point(|frames| frames[0] == Some(0)));
    assert!(!early.is_empty() && late.len() > early.len(), "{shown:?}");
    assert!(late.iter().all(|frames| frames[0].is_none()));
}

#[test]
fn the_beam_machine_with_volumes() {
    let mut machine = small("beam-160x120.toml", 64, 48, 60);
    machine.volumes = 12;
    machine.volume_planes = 10;
    let image = shaded("crossing-cylinders.toml", 1, &machine);
    run(&machine, &[image], &PinsRun::plain(VERILATOR));
}

/// Polyhedra are drawn in fewer clocks than a volume takes to want their depth.
#[test]
fn short_processors_wait_for_volumes() {
    let machine = MachineDescription {
        objects: 3,
        planes: 8,
        slots: slots("polyhedron6,polyhedron8,polyhedron8"),
        volumes: 22,
        volume_planes: 8,
        lights: 2,
        ..small("beam-160x120.toml", 48, 36, 60)
    };
    let image = shaded("processors/polyhedron.toml", 2, &machine);
    run(&machine, &[image], &PinsRun::plain(Engine::BuiltIn));
}

#[test]
fn the_zone_machine_shows_whole_frames() {
    let mut machine = small("zone-160x120.toml", 48, 36, 12);
    machine.smoothing = Smoothing::Binomial;
    let images = in_turn(["shadows/robot.toml", "teapot.toml"], &machine);
    for (stalls, late) in [(None, 0), (Some(9), 5000)] {
        run(&machine, &images, &host(VERILATOR, stalls, late));
    }
}

#[test]
fn the_zone_machine_shows_the_mean_of_samples() {
    for (samples, side, output) in [(2, 32, Output::Pins), (4, 9, Output::Stream)] {
        let mut machine = small("zone-160x120.toml", 48, 36, 12);
        machine.supersampling = samples;
        machine.zone = Some(ZoneSize {
            width: side,
            height: side,
        });
        machine.output = output;
        let other = match samples {
            2 => "shadows/robot.toml",
            _ => "crossing-cylinders.toml",
        };
        let images = in_turn([other, "teapot.toml"], &machine);
        let mut sharp = machine.clone();
        sharp.supersampling = 1;
        assert_ne!(drawn("teapot.toml", &sharp).picture, images[1].picture);
        for (stalls, late) in [(None, 0), (Some(4), 3000)] {
            run(&machine, &images, &host(Engine::BuiltIn, stalls, late));
        }
    }
}

#[test]
fn a_receiver_that_stalls_gets_every_pixel_once() {
    for name in ["zone-160x120.toml", "beam-160x120.toml"] {
        let mut machine = small(name, 48, 36, 12);
        machine.output = Output::Stream;
        let images = in_turn(["crossing-cylinders.toml", "teapot.toml"], &machine);
        for (stalls, late) in [(None, 0), (Some(1), 0), (Some(2), 6000)] {
            let options = PinsRun {
                frames: 2,
                ..host(VERILATOR, stalls, late)
            };
            run(&machine, &images, &options);
        }
    }
}

/// Colours from tables in memories that are never written; with other tables they are others. Each set of lights that
/// shadows leave has its own; so has each transparent object.
#[test]
fn a_machine_with_tables_shows_their_colours() {
    let zone = "machine = \"zone\"\nzone = { width = 16, height = 16 }";
    let tables = |machine: &str, objects: &str, materials: u32| {
        let text = format!(
            "{machine}\n{objects}\nlit_sphere = {{ side = 16, materials = {materials} }}\n\
             mode = {{ columns = [64, 4, 8, 8], lines = [48, 2, 2, 12] }}\n"
        );
        MachineDescription::parse(&text, "m.toml").expect("a description")
    };
    let beam = "machine = \"beam\"";
    let teapot = "objects = 10\nplanes = 3\nlights = 0";
    let balls = "objects = 2\nplanes = 0\nvolumes = 3\nlights = 1";
    let robot = "objects = 2\nplanes = 3\nvolumes = 1\nlights = 2";
    let glass = "slots = \"6,0,2,6,0,0\"\nlayers = 3\nlights = 0";
    for (scene, machine) in [
        ("teapot", tables(beam, teapot, 2)),
        ("shadows/ball-before-ball", tables(beam, balls, 2)),
        ("shadows/robot", tables(zone, robot, 6)),
        ("glass/still-life", tables(beam, glass, 4)),
    ] {
        let name = format!("{scene}.toml");
        let mut other = shown(&name, &machine, Engine::BuiltIn);
        if scene == "teapot" {
            shown(&name, &machine, VERILATOR);
        }
        other.tables.reverse();
        let options = PinsRun::plain(Engine::BuiltIn);
        let outcome = pins::run(&machine, &[other], &options, || ()).expect("a machine that runs");
        let report = outcome.report;
        assert!(report.mismatches > 100, "{scene}: {report:?}");
    }
}

/// Parts give anything for a word that is read while it is written: loader, materials, zone buffer, frame store.
#[test]
fn no_machine_uses_what_it_reads_while_it_writes_it() {
    for name in ["beam-48x32.toml", "zone-48x32.toml"] {
        let machine = MachineDescription::read(&root().join("machines").join(name));
        let machine = machine.expect("a description");
        let scenes = ["ball-before-ball", "ball-from-the-right"];
        let images = scenes.map(|scene| drawn(&format!("shadows/{scene}.toml"), &machine));
        let design = request_for(&machine, &[], "").design().expect("a machine");
        let upset = MachineDesign::of(&design, levelised(design.clone(), true));
        let options = PinsRun::plain(Engine::BuiltIn);
        let outcome = pins::run_in(&upset, &machine, &images, &options, || ());
        let report = outcome.expect("a machine that runs").report;
        let first = report.first_mismatches;
        assert_eq!(report.mismatches, 0, "{name}: {first:?}");
    }
}
