//! Peers beside units, with the real tools: only with `IMOGENE_FULL=1`, as `scripts/test --full` sets it, and then a
//! missing tool fails.

use crate::is_full;
use imogene_contract::{Request, Unit};
use imogene_rtl::emit::emit;
use imogene_synth::peer::{Comparison, Peer, compare};
use imogene_synth::{SynthError, Target};
use std::path::{Path, PathBuf};

fn data(name: &str) -> PathBuf {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");
    Path::new(folder).join(name)
}

fn root() -> Peer {
    Peer {
        files: vec![data("peer_root.v")],
        top: "peer_root".into(),
        ..Peer::default()
    }
}

fn adder() -> Peer {
    Peer {
        files: vec![data("peer_adder.sv")],
        top: "peer_adder".into(),
        clock: Some("core_clk".into()),
        include: vec![data("peer_include")],
        ..Peer::default()
    }
}

fn run(peer: &Peer, unit: Unit, target: Target, seeds: usize) -> Result<Comparison, SynthError> {
    compare(peer, &Request::new(unit), target, seeds)
}

/// The message of a refused peer, which says all of these.
fn refusal(peer: &Peer, parts: &[&str]) -> String {
    let message = match run(peer, Unit::Pe1, Target::Ice40Hx8k, 0) {
        Err(SynthError::Peer(error)) => error.to_string(),
        other => panic!("no refusal: {other:?}"),
    };
    for part in parts {
        assert!(message.contains(part), "{message}");
    }
    message
}

#[test]
fn a_unit_beside_itself_is_itself() {
    if !is_full() {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("pe1.v");
    let verilog = emit(&Request::new(Unit::Pe1)).expect("a legal request");
    std::fs::write(&file, verilog.bundle()).expect("a file");
    let peer = Peer {
        files: vec![file],
        top: "pe1".into(),
        ..root()
    };
    let comparison = run(&peer, Unit::Pe1, Target::Ice40Hx8k, 1).expect("both are measured");
    assert_eq!(comparison.peer.figures, comparison.unit.figures);
    assert!(comparison.unit.figures.fmax_mhz.is_some());
    assert_eq!(comparison.peer.verilog, comparison.unit.verilog);
    for name in ["LUT", "FF", "carry", "cells", "Fmax"] {
        assert_eq!(comparison.ratios[name], Some(1.0), "{name}");
    }
}

#[test]
fn parameters_of_a_verilog_peer_change_its_figures() {
    if !is_full() {
        return;
    }
    let flip_flops = |peer: &Peer| {
        let comparison = run(peer, Unit::Pe1, Target::Ecp5With45k, 0).expect("both are measured");
        let figures = comparison.peer.figures;
        assert_eq!(figures.fmax_mhz, None);
        figures.ff.expect("flip-flops")
    };
    let narrow = flip_flops(&root());
    let mut wide = root();
    wide.parameters = vec![("WIDTH".into(), "16".into())];
    // Every row keeps the pairs that are left, the root so far and the remainder: three triangles, so four times as
    // many.
    let wide = flip_flops(&wide);
    assert!(wide > 3 * narrow && wide < 5 * narrow, "{narrow} {wide}");
}

#[test]
fn a_system_verilog_peer_has_the_clock_and_files_it_names() {
    if !is_full() {
        return;
    }
    let mut peer = adder();
    peer.parameters = vec![("WIDTH".into(), "12".into())];
    let comparison = run(&peer, Unit::Pe1, Target::Ice40Hx8k, 1).expect("both are measured");
    assert_eq!(comparison.peer.clock, "core_clk");
    // Two stages of 12 bits.
    assert_eq!(comparison.peer.figures.ff, Some(24));
    assert!(comparison.peer.figures.fmax_mhz > Some(50.0));
    assert_eq!(comparison.peer.latency, None);
}

#[test]
fn what_yosys_refuses_is_said_in_one_line() {
    if !is_full() {
        return;
    }
    let mut peer = root();
    peer.top = "root_of_all".into();
    refusal(&peer, &["root_of_all", "peer_root", "peer_root_row"]);
    let mut peer = adder();
    peer.clock = None;
    let ports = ["`clk` or `clock`", "input core_clk", "input a (8 bits)"];
    refusal(&peer, &ports);
    let mut peer = adder();
    peer.include.clear();
    refusal(&peer, &["peer_width.svh"]);
    let mut peer = root();
    peer.parameters = vec![("DEPTH".into(), "3".into())];
    refusal(&peer, &["DEPTH"]);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("broken.v");
    std::fs::write(&file, "module broken(input clk").expect("a file");
    let mut peer = root();
    peer.files = vec![file];
    let message = refusal(&peer, &["broken.v:1", "syntax error"]);
    assert_eq!(message.lines().count(), 1, "{message}");
}
