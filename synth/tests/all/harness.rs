//! The register harness is Verilog that fits every unit.

use imogene_contract::{Request, Unit};
use imogene_rtl::emit::{Direction, Emitted, Port, emit};
use imogene_synth::harness;
use std::process::Command;

fn emitted(unit: Unit) -> Emitted {
    emit(&Request::new(unit)).expect("the base request is legal")
}

#[test]
fn every_port_is_connected_once() {
    for unit in Unit::ALL {
        let unit = emitted(unit);
        let text = harness::verilog(&unit);
        for port in &unit.ports {
            let connection = format!(".{}(", port.name);
            assert_eq!(text.matches(&connection).count(), 1, "{connection}\n{text}");
        }
    }
}

#[test]
fn the_registers_have_a_bit_for_every_bit_of_a_port() {
    let unit = emitted(Unit::Pe1);
    let bits = |direction| -> usize {
        let ports = unit.ports.iter().filter(|port| port.direction == direction);
        ports.map(|port| port.width).sum()
    };
    let text = harness::verilog(&unit);
    // The clock is an input that is not in the chain.
    let inputs = bits(Direction::In) - 1;
    for (name, bits) in [("inputs", inputs), ("outputs", bits(Direction::Out))] {
        let declared = format!("reg  [{}:0] {name}", bits - 1);
        assert!(text.contains(&declared), "{text}");
    }
}

#[test]
fn icarus_accepts_it_without_a_warning() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for unit in [
        Unit::Pe1,
        Unit::QuadricPe,
        Unit::NormalUnit,
        Unit::Decider,
        Unit::RasterControl,
    ] {
        let unit = emitted(unit);
        let mut text = harness::verilog(&unit);
        text += &unit.bundle();
        let path = folder.path().join("harness.v");
        std::fs::write(&path, text).expect("a file");
        let output = Command::new("iverilog")
            .args(["-g2005", "-Wall", "-t", "null", "-s", harness::TOP])
            .arg(&path)
            .output()
            .expect("iverilog is installed by scripts/setup");
        let said = String::from_utf8_lossy(&output.stderr);
        let is_sound = output.status.success() && said.is_empty();
        assert!(is_sound, "{}: {said}", unit.top);
    }
}

#[test]
fn a_name_that_is_not_plain_is_escaped() {
    let port = |name: &str, direction| Port {
        name: name.into(),
        meaning: String::new(),
        direction,
        width: 1,
        signed: false,
    };
    let ports = [
        port("a_1$x", Direction::In),
        port("bus.data", Direction::Out),
    ];
    let text = harness::around("1st", &ports, None);
    for part in [".a_1$x(", ".\\bus.data (", "    \\1st  unit (\n"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}
