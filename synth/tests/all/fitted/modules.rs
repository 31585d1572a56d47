use imogene_contract::{Request, Unit};
use imogene_rtl::emit::{Port, emit};
use imogene_synth::fitted::modules::{Parts, closure, declared_bits, is_of, modules, ports};

#[test]
fn instances_are_counted_through_the_hierarchy() {
    let beam = emit(&Request {
        planes: 2,
        objects: 3,
        ..Request::of(Unit::Beam, 16)
    })
    .expect("a machine");
    let all = modules(&beam, Parts::Units);
    let of = |name: &str| all.iter().find(|m| m.name == name).map(|m| m.instances);
    assert_eq!(of("beam"), Some(1));
    assert_eq!(of("quadric_processor"), Some(3));
    // Two planes, in a tree of one node, in three processors.
    let nodes = of("half_space_node");
    assert_eq!((of("plane_limits"), nodes), (Some(6), Some(3)));
    assert_eq!(of("visibility_node"), Some(2));
    // The pe1 of the depth stands by itself, that of a plane is part of its unit.
    assert_eq!((of("pe1_w18"), of("pe1_w28")), (Some(3), None));
    assert!(closure(&beam, "plane_limits").contains("pe1_w28"));
    assert!(!closure(&beam, "plane_limits").contains("pe2"));
}

#[test]
fn declared_bits_are_counted_with_arrays() {
    let text = "module cut (\n    input wire clock, valid,\n    input wire [15:0] a, b,\n    \
                output reg signed [7:0] c = 8'sd0\n);\n    wire [3:0] row [0:4], last;\n    \
                assign c = a, b;\nendmodule\n";
    assert_eq!(declared_bits(text), 2 + 32 + 8 + 20 + 4);
}

#[test]
fn variants_are_of_their_kind() {
    for name in ["normal_unit", "normal_unit_w12_v2", "normal_unit_3"] {
        assert!(is_of(name, "normal_unit"), "{name}");
    }
    assert!(!is_of("normal_unit_w12", "normal") && !is_of("pe2", "pe"));
}

#[test]
fn ports_are_those_of_the_emitter() {
    let unit = emit(&Request::new(Unit::CutPlane)).expect("a unit");
    let (_, text) = unit.modules.last().expect("the unit itself");
    let without_meaning = |port: &Port| Port {
        meaning: String::new(),
        ..port.clone()
    };
    let expected: Vec<Port> = unit.ports.iter().map(without_meaning).collect();
    assert_eq!(ports(text), expected);
}
