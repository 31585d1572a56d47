//! Interlaced machines: both fields of a picture leave it, and each of their pixels is that of the whole picture.

use super::machines::{host, run, small};
use super::prepared;
use imogene_contract::RootForm;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::beat::kind;
use imogene_plan::description::MachineDescription;
use imogene_plan::display::{Image, images};
use imogene_plan::needs::enough;
use imogene_plan::pace::clocks_per_frame;
use imogene_plan::zone::refine::Refinement;
use imogene_verif::display::pins;
use imogene_verif::display::request::{request_for, timing};
use imogene_verif::engine::Engine;

/// The fields of a scene on a machine of so many pixels per clock that has what the scene wants.
fn fields(
    name: &str,
    asked: &MachineDescription,
    pixels_per_clock: u32,
) -> (MachineDescription, Vec<Image>) {
    let asked = MachineDescription {
        pixels_per_clock,
        ..asked.clone()
    };
    let scene = super::scene(&format!("{name}.toml"));
    let size = asked.drawn_size().expect("a mode");
    let (framed, prepared) = prepared(&scene, size, asked.format().expect("a format"));
    let machine = enough(&asked, &[(&framed, &prepared)]).expect("a machine");
    machine.check("fields").expect("lines that are long enough");
    let images = images(&framed, &prepared, &machine, Refinement::Box);
    (machine, images.expect("fits the machine"))
}

/// Quadrics cut by planes, solids, glass, shadows, meshes, paraboloids; lights far and near; with stalls on both sides.
#[test]
fn fields_are_the_lines_of_the_whole_picture() {
    let asked = MachineDescription {
        objects: 1,
        planes: 0,
        interlaced: true,
        ..small("beam-stream.toml", 120, 20, 40)
    };
    assert_eq!(asked.format().expect("a format"), Format::BASE);
    let scenes = "teapot solids/bracket glass/still-life shadows/ball-before-ball light/colonnade \
                  processors/mesh processors/paraboloids";
    for name in scenes.split_whitespace() {
        for pixels_per_clock in [1, 2] {
            let (machine, images) = fields(name, &asked, pixels_per_clock);
            assert_eq!(images.len(), 2);
            assert_eq!(images[0].picture, images[1].picture);
            let stalling = host(Engine::BuiltIn, Some(7), 0);
            let outcome = run(&machine, &images, &stalling);
            assert_eq!(outcome.shown.last(), Some(&Some(1)), "{name}");
            // The words of a field show its lines and no others.
            let mut exchanged = images.clone();
            (exchanged[0].pixels, exchanged[1].pixels) = (images[1].pixels, images[0].pixels);
            let wrong = pins::run(&machine, &exchanged, &stalling, || ());
            let wrong = wrong.expect("a machine that runs").report.mismatches;
            assert!(wrong > 50, "{name}: {wrong}");
        }
    }
}

/// Tables of colours turn normals towards the viewer by the line of sight, which goes with the line of the picture.
#[test]
fn fields_are_lit_by_tables() {
    let asked = MachineDescription {
        output: imogene_plan::description::Output::Stream,
        interlaced: true,
        ..small("beam-lit-sphere.toml", 64, 48, 40)
    };
    let (machine, images) = fields("teapot", &asked, 1);
    run(&machine, &images, &host(Engine::BuiltIn, None, 0));
}

/// Graphics modules with every second or fourth line, of frames and of fields; one or two pixels of a line at once, and
/// one every so many clocks. The words of one module are those of no other.
#[test]
fn modules_draw_the_lines_of_the_whole_picture() {
    let asked = MachineDescription {
        objects: 1,
        planes: 0,
        ..small("beam-stream.toml", 120, 24, 40)
    };
    let scenes = [
        ("teapot", 2, 1, false),
        ("glass/still-life", 4, 1, false),
        ("shadows/ball-before-ball", 2, 2, true),
        ("light/colonnade", 4, 2, true),
    ];
    for (name, modules, pixels_per_clock, interlaced) in scenes {
        let asked = MachineDescription {
            modules,
            interlaced,
            ..asked.clone()
        };
        let (machine, images) = fields(name, &asked, pixels_per_clock);
        let stalling = host(Engine::BuiltIn, Some(7), 0);
        run(&machine, &images, &stalling);
        let mut exchanged = images;
        for beat in &mut exchanged[0].beats {
            if beat.kind == kind::COMMAND && beat.data.is_power_of_two() {
                beat.data = if beat.data == 1 { 2 } else { 1 };
            }
        }
        let wrong = pins::run(&machine, &exchanged[..1], &stalling, || ());
        let wrong = wrong.expect("a machine that runs").report.mismatches;
        assert!(wrong > 50, "{name}: {wrong}");
    }
    let serial = MachineDescription {
        modules: 4,
        root_form: RootForm::Iterative,
        ..asked
    };
    let (machine, images) = fields("teapot", &serial, 1);
    run(&machine, &images, &host(Engine::BuiltIn, None, 0));
}

/// The clocks of a frame with new words are those stated, and become fewer as modules become more.
#[test]
fn modules_take_the_clocks_stated() {
    let clocks = [1, 2, 4].map(|modules| {
        let asked = MachineDescription {
            modules,
            ..small("beam-stream.toml", 128, 96, 40)
        };
        let scene = super::scene("teapot.toml");
        let size = asked.drawn_size().expect("a mode");
        let (framed, prepared) = prepared(&scene, size, asked.format().expect("a format"));
        let machine = enough(&asked, &[(&framed, &prepared)]).expect("a machine");
        let images = images(&framed, &prepared, &machine, Refinement::Box).expect("images");
        let cycles = [4, 5].map(|times| {
            let images = vec![images[0].clone(); times];
            run(&machine, &images, &host(Engine::BuiltIn, None, 0))
                .report
                .cycles
        });
        let timing = timing(&request_for(&machine, &[], "")).expect("a machine");
        let stated = clocks_per_frame(&machine, &framed, &prepared, &timing).expect("words");
        assert_eq!(cycles[1] - cycles[0], stated, "{modules} modules");
        stated
    });
    assert!(clocks[0] > clocks[1] && clocks[1] > clocks[2], "{clocks:?}");
}
