//! The emitted Verilog: accepted by the tools, readable, the same every time; bad requests are refused.

use crate::support::{requests, run, write, write_split};
use imogene_contract::{Request, RequestError, Unit};
use imogene_rtl::emit::{emit, raw};

/// Runs a tool on a unit; it has to succeed, and to say nothing.
fn accepts(tool: &str, arguments: &[&str], request: &Request) {
    let output = run(tool, tool, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    let is_accepted = output.status.success() && said.is_empty();
    assert!(is_accepted, "{request:?}: {said}");
}

#[test]
fn icarus_accepts_every_unit_without_a_warning() {
    for request in requests() {
        let emitted = emit(&request).unwrap_or_else(|error| panic!("{request:?}: {error}"));
        let name = format!("icarus-{}-{}", request.unit.name(), request.depth_word);
        let file = write(&name, &emitted);
        let file = file.to_str().unwrap();
        let top = &emitted.top;
        let arguments = ["-g2005", "-Wall", "-s", top, "-o", "/dev/null", file];
        accepts("iverilog", &arguments, &request);
    }
}

#[test]
fn verilator_accepts_every_unit_without_a_warning() {
    for request in requests() {
        let emitted = emit(&request).unwrap();
        let name = format!("verilator-{}-{}", request.unit.name(), request.depth_word);
        let directory = write_split(&name, &emitted);
        let file = directory.join(format!("{}.v", emitted.top));
        let [directory, file] = [&directory, &file].map(|path| path.to_str().unwrap());
        let arguments = ["--lint-only", "-Wall", "-Wno-fatal", "-y", directory, file];
        accepts("verilator", &arguments, &request);
    }
}

#[test]
fn the_same_request_gives_the_same_text() {
    for unit in Unit::ALL {
        let request = Request::new(unit);
        assert_eq!(emit(&request), emit(&request));
    }
}

#[test]
fn identifiers_carry_no_dollar_and_the_top_is_the_unit() {
    for request in requests() {
        let emitted = emit(&request).unwrap();
        let text = emitted.bundle();
        assert!(!text.contains('$'), "{request:?}");
        assert!(text.contains(&format!("\nmodule {} (", request.unit.name())));
        assert_eq!(emitted.top, request.unit.name());
        assert_eq!(text.matches("\nmodule ").count(), emitted.modules.len());
        assert!(text.contains(&request.command()) && text.contains("MIT OR Apache-2.0"));
    }
}

#[test]
fn equal_blocks_become_one_module() {
    let emitted = emit(&Request::new(Unit::SquareRoot)).unwrap();
    assert_eq!(emitted.modules.len(), 3, "network, stage and row");
    let beam = emit(&Request::new(Unit::Beam)).unwrap();
    let more = emit(&Request {
        objects: 8,
        ..Request::new(Unit::Beam)
    })
    .unwrap();
    // A slot more is an instance more.
    assert!(more.modules.len() <= beam.modules.len());
}

#[test]
fn ports_are_listed_as_they_stand() {
    let emitted = emit(&Request {
        planes: 2,
        ..Request::new(Unit::QuadricProcessor)
    })
    .unwrap();
    let port = |name: &str| emitted.ports.iter().find(|port| port.name == name).unwrap();
    assert_eq!((port("f2_a2").width, port("f2_a2").signed), (48, true));
    let widths = ["plane_1_c", "plane_1_kind", "zf", "out_valid"].map(|name| port(name).width);
    assert_eq!(widths, [36, 2, 24, 1]);
    assert_eq!(emitted.latency, 24 + 11);
}

#[test]
fn bad_requests_name_the_value_and_the_range() {
    let refused = |unit, depth_word, option, value| {
        let request = Request::given(unit, depth_word, &[(option, Some(value))]);
        request.unwrap_err().to_string()
    };
    for (unit, option, value, legal) in [
        ("beam", "planes", 13, "0 to 12"),
        ("beam", "rows-per-stage", 0, "1 to 24"),
        ("beam", "rows-per-stage", 25, "1 to 24"),
        ("beam", "objects", 0, "1 to 256"),
        ("beam", "objects", 257, "1 to 256"),
        ("square_root_rows", "digits", 25, "1 to 24"),
        ("square_root_linear", "corrections", 3, "0 to 2"),
    ] {
        let says = format!("{option} = {value} is out of range; legal values are {legal}");
        assert_eq!(refused(unit, 24, option, value), says);
    }
    let format = refused("beam", 33, "planes", 3);
    assert!(format.contains("format = 33 is out of range; legal values are 8 to 32"));
    let inputs = refused("card_decider", 24, "objects", 200);
    assert!(inputs.contains("objects times cards = 400 is out of range"));
    let foreign = refused("beam", 24, "corrections", 1);
    assert!(foreign.contains("the unit `beam` has no parameter `corrections`"));
    let unchecked = Request {
        planes: 13,
        ..Request::new(Unit::Beam)
    };
    assert!(matches!(
        emit(&unchecked),
        Err(RequestError::Range { value: 13, .. })
    ));
    let unit = Unit::from_name("pe3").unwrap_err();
    assert!(matches!(&unit, RequestError::Unit { name } if name == "pe3"));
    assert!(unit.to_string().contains("quadric_processor"));
}

/// rust-hdl's own text of the same block repeats every array element and every register as a module of its own.
#[test]
fn the_root_network_takes_an_eighth_of_the_lines_of_the_raw_text() {
    let raw = raw(&Request::new(Unit::SquareRoot)).unwrap();
    let raw = raw.lines().count();
    let emitted = emit(&Request::new(Unit::SquareRoot)).unwrap();
    let lines = emitted.bundle().lines().count();
    assert!(raw >= 8 * lines, "raw {raw}, emitted {lines}");
}
