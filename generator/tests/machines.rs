//! Machines of words that no catalogue has.

use imogene_generator::{emit_machine, emit_machines};
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::machine::{MachineRequest, MachineWords};
use imogene_rtl::emit::{EmitRequest, emit};
use imogene_rtl::machine::slot_shape::SlotShape;

fn request(words: MachineWords, slots: &[(usize, bool)]) -> MachineRequest {
    let shape = |&(planes, two_volumes): &(usize, bool)| SlotShape {
        planes,
        two_volumes,
    };
    MachineRequest {
        words,
        rows_per_stage: 1,
        slots: slots.iter().map(shape).collect(),
        prefix: String::new(),
        command: "test".into(),
    }
}

const ODD: MachineWords = MachineWords {
    depth: 19,
    root: 15,
    dropped_rows: 2,
    plane: 23,
    normal: 11,
    guard_linear: 3,
    guard_quadratic: 5,
};

const BASE: MachineWords = MachineWords {
    depth: 24,
    root: 24,
    dropped_rows: 0,
    plane: 36,
    normal: 16,
    guard_linear: 0,
    guard_quadratic: 0,
};

#[test]
fn machines_have_the_words_that_were_asked_for() {
    let requests = [
        request(ODD, &[(1, false), (3, true)]),
        request(BASE, &[(1, true); 2]),
    ];
    let emitted = emit_machines(&requests).unwrap();
    let width = |name: &str| {
        emitted[0]
            .ports
            .iter()
            .find(|p| p.name == name)
            .unwrap()
            .width
    };
    assert_eq!(
        (width("depth"), width("nx"), width("load_data")),
        (19, 11, 35)
    );
    assert_eq!(emitted[0].latency, 1 + (13 + 3 + 7) + 1);
    assert!(
        emitted[0]
            .bundle()
            .contains("root 15, of which the last 2 digits are zero")
    );
    let catalogue = EmitRequest {
        objects: 2,
        planes: 1,
        ..EmitRequest::new(Unit::Beam)
    };
    assert_eq!(emitted[1].modules, emit(&catalogue).unwrap().modules);
    // The second time nothing is compiled, and the text is the same.
    assert_eq!(emit_machine(&requests[0]).unwrap(), emitted[0]);
}

#[test]
fn a_refusal_of_the_emitter_is_passed_on() {
    let error = emit_machine(&request(ODD, &[])).unwrap_err();
    assert!(error.to_string().contains("objects"), "{error}");
}
