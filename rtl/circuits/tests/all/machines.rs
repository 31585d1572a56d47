//! Whole machines of words and slots that no format of the catalogue has.

use imogene_circuits::arith::Network;
use imogene_circuits::machine::{BeamMachine, Objects, Volumes};
use imogene_circuits::machines::{beam_display, beam_stream};
use imogene_circuits::object::Widths;
use imogene_circuits::shade::{Lights, Shading};
use imogene_circuits::video::Output;
use imogene_contract::command_stream::kind;
use imogene_contract::shading::BACKGROUND;
use imogene_contract::slots::FittedSlot;
use imogene_contract::video::{Span, VideoMode};
use imogene_contract::{DeciderForm, MachineWords, RootForm};
use imogene_hdl::{Design, Port, Simulator};

/// A colour as pixels have it, and as the word of the background, which has red in its low bits.
const COLOUR: u64 = 0x12_34_56;
const BACKGROUND_WORD: u64 = 0x56_34_12;

/// Guard bits, rows that are left out, slots of different planes and halves, volumes of different planes.
fn machine() -> BeamMachine {
    let words = MachineWords {
        depth: 19,
        root: 15,
        plane: 23,
        normal: 11,
        guard_linear: 3,
        guard_quadratic: 5,
        dropped_rows: 2,
        root_form: RootForm::Restoring,
    };
    BeamMachine {
        layers: vec![],
        objects: Objects {
            products: vec![],
            decider: DeciderForm::Chain,
            lanes: 1,
            words,
            rows_per_stage: 4,
            slots: [0, 2, 3].map(FittedSlot::quadric).to_vec(),
        },
        volumes: Volumes {
            widths: Widths::of(&words),
            root: Network::of(&words, 4),
            planes: vec![1, 0],
            lanes: 1,
        },
        shading: Shading {
            lights: Lights { count: 1, suns: 0 },
            tables: None,
        },
        loader_places: 3,
        modules: 1,
        line_shift: 0,
    }
}

/// Sends the background as a whole frame; then the pixels of some clocks from the one on at which it is at work.
fn pixels(design: &Design, valid: &str, levels: &[&str]) -> Vec<u64> {
    let mut simulator = Simulator::new(design);
    // A screen has no receiver that could wait.
    let is_stream = design.top.ports.iter().any(|port| port.name == "m_tready");
    let word = [
        ("s_tlast", 1),
        ("s_tdest", kind::SHADING.into()),
        ("s_tuser", BACKGROUND),
        ("s_tdata", BACKGROUND_WORD),
    ];
    let ready = is_stream.then_some(("m_tready", 1));
    for (name, value) in word.into_iter().chain(ready) {
        let port = simulator.port(name);
        simulator.set(port, value);
    }
    let levels: Vec<Port> = levels.iter().map(|name| simulator.port(name)).collect();
    let [host, valid, swapped] = ["s_tvalid", valid, "swapped"].map(|name| simulator.port(name));
    let (mut is_new, mut found) = (false, vec![]);
    for clock in 0..1000 {
        simulator.set(host, u64::from(clock == 0));
        simulator.clock();
        is_new |= simulator.get(swapped) == 1;
        if is_new && simulator.get(valid) == 1 {
            let levels = levels.iter().map(|port| simulator.get(*port));
            found.push(levels.fold(0, |colour, level| colour << 8 | level));
        }
    }
    found
}

#[test]
fn a_screen_shows_the_background_of_a_machine_of_any_words() {
    let output = Output {
        mode: VideoMode {
            line: Span::new(8, 1, 2, 3),
            frame: Span::new(6, 1, 1, 9),
            hsync_high: false,
            vsync_high: true,
        },
        kernel: 2,
        has_overlay: true,
    };
    let design = beam_display(&machine(), &output);
    let found = pixels(&design, "de", &["red", "green", "blue"]);
    assert!(found.len() >= 2 * 8 * 6);
    assert!(found.iter().all(|colour| *colour == COLOUR));
}

#[test]
fn a_machine_of_any_words_streams_its_background() {
    assert_eq!(machine().bus(), 35);
    let found = pixels(&beam_stream(&machine(), (8, 6)), "m_tvalid", &["m_tdata"]);
    assert!(found.len() >= 2 * 8 * 6);
    assert!(found.iter().all(|colour| *colour == COLOUR));
}
