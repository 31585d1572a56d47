//! The contract of every unit against its Verilog.

use imogene_contract::words::DEPTH_WORDS;
use imogene_contract::{Request, Unit};
use imogene_package::contract::{RESET, contract};
use imogene_rtl::emit::{Direction, emit};
use serde_json::Value;
use std::collections::BTreeMap;

/// Shapes that change the ports: the base, none, and others.
const SHAPES: [(u32, u32); 3] = [(3, 4), (0, 1), (1, 5)];

fn requests() -> impl Iterator<Item = Request> {
    let all = Unit::ALL.into_iter();
    all.flat_map(|unit| {
        DEPTH_WORDS.into_iter().flat_map(move |depth_word| {
            SHAPES.map(|(planes, objects)| Request {
                // A polyhedron has a plane at least.
                planes: u32::max(planes, u32::from(unit == Unit::PolyhedronProcessor)),
                objects,
                ..Request::of(unit, depth_word)
            })
        })
    })
}

/// The formulas of one depth word give the widths of the circuit at all others.
#[test]
fn every_port_has_a_meaning_and_its_formula_gives_its_width() {
    let line = |line: &str, word: usize| match line.split_once('W') {
        None => line.parse::<usize>().expect("a number"),
        Some((most, "")) if most.ends_with(" - ") => {
            let most = most.trim_end_matches(" - ").parse::<usize>();
            most.expect("a number") - word
        }
        Some((times, plus)) => {
            let times = times.parse().unwrap_or(1);
            times * word + plus.trim_start_matches(" + ").parse().unwrap_or(0)
        }
    };
    let width = |formula: &str, word: usize| {
        let Some((which, lines)) = formula.split_once('(') else {
            return Some(line(formula, word));
        };
        let lines = lines.trim_end_matches(')').split(", ");
        let lines = lines.map(|of| line(of, word));
        match which {
            "min" => lines.min(),
            _ => lines.max(),
        }
    };
    for request in requests() {
        let base = Request {
            depth_word: 24,
            ..request
        };
        let stated = contract(&base).expect("a legal request").ports;
        let emitted = emit(&request).expect("a legal request").ports;
        assert_eq!(stated.len(), emitted.len());
        for (entry, port) in stated.iter().zip(&emitted) {
            let place = format!("{request:?}: {}", entry.name);
            assert!(!entry.meaning.is_empty(), "{place}");
            assert_eq!(entry.name, port.name, "{place}");
            let expected = width(&entry.formula, request.depth_word as usize);
            assert_eq!(expected, Some(port.width), "{place}");
        }
    }
}

#[test]
fn directions_and_formats_are_those_of_the_verilog_text() {
    for unit in Unit::ALL {
        let request = Request::new(unit);
        let contract = contract(&request).expect("a legal request");
        let emitted = emit(&request).expect("a legal request");
        let (_, module) = emitted.modules.last().expect("a module");
        let declared = declared(module);
        assert_eq!(contract.ports.len(), emitted.ports.len());
        for (entry, port) in contract.ports.iter().zip(&emitted.ports) {
            let place = format!("{}: {}", unit.name(), entry.name);
            let is_input = port.direction == Direction::In;
            assert_eq!(entry.direction == "input", is_input, "{place}");
            let kind = &declared[&entry.name];
            assert!(kind.starts_with(entry.direction), "{place}: {kind}");
            let is_signed = kind.contains(" signed");
            assert_eq!(entry.format == "two's complement", is_signed, "{place}");
            let is_wide = kind.contains(&format!("[{}:0]", entry.width - 1));
            assert_eq!(entry.width > 1, is_wide, "{place}: {kind}");
            assert_eq!(entry.format == "flag", entry.width == 1, "{place}");
        }
    }
}

/// What stands before the name of each port; several of a kind stand behind one declaration.
fn declared(module: &str) -> BTreeMap<String, String> {
    let (_, head) = module.split_once("(\n").expect("a port list");
    let (head, _) = head.split_once("\n);").expect("its end");
    let mut kind = String::new();
    let mut ports = BTreeMap::new();
    for port in head.split(',') {
        let (port, _) = port.split_once(" = ").unwrap_or((port, ""));
        let words: Vec<&str> = port.split_whitespace().collect();
        let (name, before) = words.split_last().expect("a name");
        if !before.is_empty() {
            kind = before.join(" ");
        }
        ports.insert((*name).to_owned(), kind.clone());
    }
    ports
}

#[test]
fn markdown_and_json_say_the_same() {
    for unit in Unit::ALL {
        let contract = contract(&Request::new(unit)).expect("a legal request");
        let page = contract.markdown();
        let json: Value = serde_json::from_str(&contract.json()).expect("one JSON document");
        for key in "computes source throughput reset ties error command".split(' ') {
            let text = json[key].as_str().expect("a text");
            assert!(page.contains(text), "{}: {key}", unit.name());
        }
        let ports = json["ports"].as_array().expect("a list of ports");
        assert_eq!(ports.len(), contract.ports.len());
        for port in ports {
            let text = |key: &str| port[key].as_str().unwrap_or_else(|| panic!("no {key}"));
            let [name, direction] = ["name", "direction"].map(text);
            let [formula, format, meaning] = ["formula", "format", "meaning"].map(text);
            let width = &port["width"];
            let row = format!(
                "| `{name}` | {direction} | {width} | `{formula}` | {format} | {meaning} |"
            );
            assert!(page.contains(&row), "{}: {row}", unit.name());
        }
        assert!(page.contains(RESET));
    }
}
