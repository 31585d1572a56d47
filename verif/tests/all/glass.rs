//! Transparent objects on machines of both kinds.

use super::machines::{run, small};
use imogene_golden::format::Format;
use imogene_plan::description::{MachineDescription, MachineKind, Output};
use imogene_plan::display::image;
use imogene_plan::needs::enough;
use imogene_plan::pace::clocks_per_frame;
use imogene_prepare::{Framing, prepare};
use imogene_verif::display::pins::PinsRun;
use imogene_verif::display::request::{request_for, timing};
use imogene_verif::engine::Engine;

/// What a zone machine shows of glass is what a beam machine shows, in turn with a scene without any, and in the clocks
/// of the formula.
#[test]
fn glass_on_zone_machines() {
    let asked = MachineDescription {
        objects: 1,
        planes: 0,
        ..small("zone-160x120.toml", 48, 36, 12)
    };
    let scenes = ["glass/still-life.toml", "teapot.toml"].map(super::scene);
    for (supersampling, output) in [(1, Output::Pins), (1, Output::Stream), (2, Output::Stream)] {
        let asked = MachineDescription {
            supersampling,
            output,
            ..asked.clone()
        };
        let (width, height) = asked.drawn_size().expect("a mode");
        let framed = [0, 1].map(|k| scenes[k].frame(width, height).expect("a valid size"));
        let prepared = [0, 1].map(|k| prepare(&framed[k], Format::BASE).expect("fits the format"));
        let pairs = [(&framed[0], &prepared[0]), (&framed[1], &prepared[1])];
        let machine = enough(&asked, &pairs).expect("a machine");
        assert_eq!((machine.machine, machine.layers), (MachineKind::Zone, 3));
        let images = pairs.map(|(framed, prepared)| image(framed, prepared, &machine));
        let [glass, teapot] = images.map(|image| image.expect("fits the machine"));
        if supersampling == 1 {
            let beam = MachineDescription {
                machine: MachineKind::Beam,
                zone: None,
                slots: None,
                layers: 0,
                ..machine.clone()
            };
            let beam = enough(&beam, &pairs[..1]).expect("a machine");
            let alike = image(&framed[0], &prepared[0], &beam).expect("fits the machine");
            assert!(alike.picture == glass.picture);
        }
        let both = [glass.clone(), teapot, glass.clone()];
        let late = PinsRun {
            stalls: Some(3),
            late: 9000,
            ..PinsRun::plain(Engine::BuiltIn)
        };
        run(&machine, &both, &late);
        run(&machine, &both, &PinsRun::plain(Engine::BuiltIn));
        if output == Output::Stream {
            let cycles = [2, 3].map(|times| {
                let images = vec![glass.clone(); times];
                run(&machine, &images, &PinsRun::plain(Engine::BuiltIn))
                    .report
                    .cycles
            });
            let timing = timing(&request_for(&machine, &[], "")).expect("a machine");
            let clocks = clocks_per_frame(&machine, pairs[0].0, pairs[0].1, &timing);
            assert_eq!(cycles[1] - cycles[0], clocks.expect("a plan"));
        }
    }
}
