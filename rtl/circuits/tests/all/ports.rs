//! Ports of the units: each says what it carries, under a name of its own.

use imogene_circuits::units::design;
use imogene_contract::{request::Request, unit::Unit};
use std::collections::HashSet;

/// A unit with other values of these parameters, where it has them and takes them.
fn with(unit: Unit, planes: u32, objects: u32) -> Request {
    let mut values = vec![("planes", Some(planes)), ("objects", Some(objects))];
    values.retain(|value| Request::given(unit.name(), 24, &[*value]).is_ok());
    Request::given(unit.name(), 24, &values).expect("legal values")
}

#[test]
fn every_port_has_a_meaning_and_a_name_of_its_own() {
    for unit in Unit::ALL {
        for request in [Request::new(unit), with(unit, 0, 1), with(unit, 1, 5)] {
            let command = request.command();
            let ports = &design(&request).top.ports;
            for port in ports {
                let (name, meaning) = (&port.name, &port.meaning);
                assert!(!meaning.is_empty(), "{name} of `{command}`");
                assert!(!meaning.contains('#'), "{name} of `{command}`: {meaning}");
            }
            let names: HashSet<&String> = ports.iter().map(|port| &port.name).collect();
            assert_eq!(names.len(), ports.len(), "names of `{command}`");
        }
    }
}

#[test]
fn every_unit_is_built_at_every_depth_word() {
    for unit in Unit::ALL {
        for depth_word in unit.least_word()..=32 {
            let request = Request::of(unit, depth_word);
            request.check().expect("defaults are legal");
            assert_eq!(design(&request).top.name, unit.name());
        }
    }
}
