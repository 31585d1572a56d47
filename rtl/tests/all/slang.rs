//! The emitted Verilog in slang, which keeps to the letter of SystemVerilog. Needs Python with 'pyslang', which
//! `scripts/setup --lint` installs in target/tools, and fails without it.

use crate::support::{requests, write};
use imogene_contract::object::{KINDS, ProductSlots};
use imogene_contract::slots::FittedSlot;
use imogene_contract::video::VideoMode;
use imogene_contract::{Request, Unit};
use imogene_rtl::emit::machine::{Kind, MachineRequest, MachineWords};
use imogene_rtl::emit::machine::{Output, ZoneShape, emit_machine};
use imogene_rtl::emit::{Emitted, emit};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What slang finds in files, but nets that their names declare unused.
fn found(files: &[PathBuf]) -> Vec<String> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(own.join("../target/tools/bin/python"))
        .arg(own.join("tests/all/support/slang.py"))
        .args(files)
        .output();
    const HOW: &str = "`scripts/setup --lint` installs pyslang in target/tools";
    let output = output.unwrap_or_else(|error| panic!("python cannot be run ({error}); {HOW}"));
    let said = String::from_utf8_lossy(&output.stderr);
    let read = String::from_utf8_lossy(&output.stdout);
    let wanted = format!("read {}\n", files.len());
    assert!(output.status.success() && read == wanted, "{said}\n{HOW}");
    let is_found = |line: &&str| line.contains(": warning: ") || line.contains(": error: ");
    let findings = said.lines().filter(is_found);
    let findings = findings.filter(|line| !line.contains(" net 'unused"));
    findings.map(str::to_owned).collect()
}

fn assert_clean(files: &[PathBuf]) {
    let found = found(files);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn slang_accepts_every_unit_without_a_warning() {
    let base = Unit::ALL.into_iter().map(Request::new);
    let file = |(index, request): (usize, Request)| {
        let name = format!("slang-{}-{index}", request.unit.name());
        write(&name, &emit(&request).expect("legal parameters"))
    };
    let files: Vec<PathBuf> = base.chain(requests()).enumerate().map(file).collect();
    assert_clean(&files);
}

/// A zone machine and a beam machine with a product and their screens, and one with a slot of each kind.
fn machines() -> [Emitted; 3] {
    let screen = Output {
        mode: VideoMode::VGA,
        kernel: 2,
        has_overlay: true,
    };
    let zone = ZoneShape {
        zone_bits: 8,
        samples: 2,
    };
    let quadrics = vec![FittedSlot::quadric(1); 3];
    let product = ProductSlots {
        intersected: 1,
        subtracted: 1,
    };
    let each = KINDS.map(|(kind, _, [least, _])| FittedSlot {
        kind,
        ..FittedSlot::quadric(least)
    });
    let zones = Kind::ZoneDisplay(zone, screen);
    let machines = [
        (zones, quadrics.clone(), vec![product]),
        (Kind::BeamDisplay(8, screen), quadrics, vec![product]),
        (Kind::BeamDisplay(10, screen), each.to_vec(), vec![]),
    ];
    machines.map(|(kind, slots, products)| {
        let request = MachineRequest {
            kind,
            products,
            volumes: 1,
            volume_planes: 4,
            lights: 2,
            ..MachineRequest::fitted(MachineWords::of(24), 4, slots)
        };
        emit_machine(&request).expect("legal numbers")
    })
}

#[test]
fn slang_accepts_machines_without_a_warning() {
    for emitted in machines() {
        assert_clean(&[write("slang-machine", &emitted)]);
    }
}

/// Texts with a fault each.
#[test]
fn slang_finds_faults() {
    let emitted = emit(&Request::new(Unit::SquareRoot)).expect("legal parameters");
    let difference = "dividend - divisor";
    let test = "(trial & sign) != 26'd0";
    let wires = "wire [25:0] divisor, dividend, trial,";
    let narrow = "wire [24:0] trial; wire [25:0] divisor, dividend,";
    let shifted = "dividend - (divisor << 26)";
    let faults = [
        (difference, "dividend - ", "error: expected"),
        (difference, "dividend - divider", "error: use of undeclared"),
        (difference, shifted, "shift-count-overflow"),
        (difference, "dividend", "unused-but-set-net"),
        ("live + 26'd1", "{1'b0, live} + 27'd1", "width-trunc"),
        (wires, narrow, "width-expand"),
        (test, "$signed(trial) < sign", "sign-compare"),
        (test, "trial & sign", "width-trunc"),
        ("assign divisor = {root, 2'd1};", "", "undriven-net"),
    ];
    for (index, (from, to, wanted)) in faults.into_iter().enumerate() {
        let file = write(&format!("slang-fault-{index}"), &emitted);
        let text = emitted.bundle();
        assert!(text.contains(from), "{from} is not in\n{text}");
        std::fs::write(&file, text.replacen(from, to, 1)).expect("a file");
        let found = found(&[file]);
        let is_named = found.iter().any(|line| line.contains(wanted));
        assert!(is_named, "{to}: {found:?}");
    }
}
