//! Machines whose words no catalogue has, in Verilator against the golden machine: every output of every clock.

use super::scene;
use imogene_contract::MachineWords;
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_prepare::{PreparedScene, prepare};
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use imogene_verif::engine::Engine;
use imogene_verif::engine::machine::MachineDesign;
use imogene_verif::engine::simulator::Simulator;
use imogene_verif::report::Report;
use imogene_verif::scene::{Fault, Options, run_on};

const SIZE: (u32, u32) = (64, 48);

/// A row of the table below.
type Row = (&'static str, u32, [u32; 2], u32, [u32; 2], u32, u32);

/// Scene, depth word, bits more than the scene needs of root and planes, normal, guard bits, dropped rows, rows per
/// stage.
const MACHINES: [Row; 6] = [
    ("teapot", 17, [0, 0], 16, [0, 0], 0, 1),
    ("teapot", 23, [1, 2], 13, [4, 7], 2, 3),
    ("teapot", 11, [0, 0], 10, [0, 16], 0, 2),
    ("front-view", 22, [0, 1], 12, [2, 3], 1, 1),
    ("hyperboloid-two-sheets", 26, [2, 0], 11, [9, 2], 5, 4),
    ("orthographic", 14, [0, 0], 15, [1, 0], 0, 14),
];

/// The scene in the narrowest words of this depth word in which it can be prepared, and some bits more.
fn prepared(index: usize) -> (PreparedScene, Vec<FittedSlot>, u32) {
    let (name, depth, [more_root, more_plane], normal, [g1, g2], dropped_rows, rows) =
        MACHINES[index];
    let file = scene(&format!("{name}.toml"));
    let widest = MachineWords::of(depth);
    let (framed, wide) = crate::prepared(&file, SIZE, Format::fitted(&widest).unwrap());
    let quadrics = || wide.quadrics().map(|(_, object)| &object.needed);
    let quadratic = quadrics().map(|n| n.quadratic).max().unwrap();
    let plane = quadrics().map(|n| n.plane).max().unwrap();
    let widths = MachineWords {
        root: (quadratic.div_ceil(2) + more_root).min(depth),
        plane: (plane.max(depth) + more_plane).min(depth + 12),
        normal,
        guard_linear: g1,
        guard_quadratic: g2,
        dropped_rows,
        ..widest
    };
    let prepared = prepare(&framed, Format::fitted(&widths).unwrap()).unwrap();
    let slots = prepared.fitted_slots();
    (prepared, slots, rows)
}

fn request(prepared: &PreparedScene, slots: &[FittedSlot], rows: u32) -> MachineRequest {
    MachineRequest::fitted(prepared.format.widths(), rows as usize, slots.to_vec())
}

fn run(index: usize, fault: Option<Fault>) -> Report {
    let (prepared, slots, rows) = prepared(index);
    let engine = Engine::Verilog(Simulator::Verilator);
    let request = request(&prepared, &slots, rows);
    let design = MachineDesign::compile(engine, &request, vec![], &[]).unwrap();
    let options = Options {
        fault,
        ..Options::plain(rows as usize, 1)
    };
    let outcome = run_on(&design, &slots, &prepared, &options, || ());
    outcome.unwrap().0
}

#[test]
fn machines_of_any_words_are_the_golden_machine() {
    for (index, words) in MACHINES.iter().enumerate() {
        let (prepared, slots, rows) = prepared(index);
        let emitted = emit_machine(&request(&prepared, &slots, rows)).unwrap();
        let latency = beam::latency(&slots, &prepared.format, rows);
        assert_eq!(emitted.latency as u32, latency);
        let report = run(index, None);
        let first = &report.first_mismatches;
        assert_eq!(report.mismatches, 0, "{words:?}: {first:?}");
        assert_eq!(report.pixels, u64::from(SIZE.0 * SIZE.1));
        let (width, height) = (SIZE.0 as usize, SIZE.1 as usize);
        let seen = beam::render(&prepared.slots(), &prepared.format, width, height, || ());
        assert!(seen.covered() > 0, "nothing to compare");
    }
}

/// Four depth words more in each step of f1 along the line.
#[test]
fn a_wrong_bit_in_a_fitted_machine_is_found() {
    let fault = Fault {
        object: 0,
        address: 0,
        bit: 6,
    };
    assert!(run(1, Some(fault)).mismatches > 0);
}
