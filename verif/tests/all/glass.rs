//! Transparent objects on machines of both kinds.

use super::machines::{host, run, small};
use super::prepared;
use imogene_golden::format::Format;
use imogene_plan::description::{MachineDescription, MachineKind, Output};
use imogene_plan::display::image;
use imogene_plan::needs::enough;
use imogene_plan::pace::clocks_per_frame;
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
        let size = asked.drawn_size().expect("a mode");
        let [glass, teapot] = &scenes
            .each_ref()
            .map(|file| prepared(file, size, Format::BASE));
        let pairs = [(&glass.0, &glass.1), (&teapot.0, &teapot.1)];
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
            let alike = image(pairs[0].0, pairs[0].1, &beam).expect("fits the machine");
            assert!(alike.picture == glass.picture);
        }
        let both = [glass.clone(), teapot, glass.clone()];
        run(&machine, &both, &host(Engine::BuiltIn, Some(3), 9000));
        run(&machine, &both, &host(Engine::BuiltIn, None, 0));
        if output == Output::Stream {
            let cycles = [2, 3].map(|times| {
                let images = vec![glass.clone(); times];
                let outcome = run(&machine, &images, &host(Engine::BuiltIn, None, 0));
                outcome.report.cycles
            });
            let timing = timing(&request_for(&machine, &[], "")).expect("a machine");
            let clocks = clocks_per_frame(&machine, pairs[0].0, pairs[0].1, &timing);
            assert_eq!(cycles[1] - cycles[0], clocks.expect("a plan"));
        }
    }
}
