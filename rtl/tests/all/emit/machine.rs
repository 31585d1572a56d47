//! Machines that are emitted, and those that are refused.

use imogene_circuits::video::Output;
use imogene_contract::slots::FittedSlot;
use imogene_contract::video::VideoMode;
use imogene_contract::{MachineWords, Request, RootForm, Unit};
use imogene_rtl::emit::emit;
use imogene_rtl::emit::machine::{Kind, MachineRequest, ZoneShape, emit_machine};

const ZONE: ZoneShape = ZoneShape {
    zone_bits: 8,
    samples: 1,
};
/// Words that do not follow from a depth word.
const OWN: MachineWords = MachineWords {
    depth: 18,
    root: 17,
    dropped_rows: 1,
    root_form: RootForm::Restoring,
    plane: 29,
    normal: 14,
    guard_linear: 10,
    guard_quadratic: 3,
};

fn request(kind: Kind) -> MachineRequest {
    MachineRequest {
        kind,
        volumes: 1,
        volume_planes: 4,
        ..MachineRequest::fitted(MachineWords::of(24), 4, vec![FittedSlot::quadric(1); 2])
    }
}

/// A deciding beam with slots of these planes.
fn beam(words: MachineWords, planes: &[u32]) -> MachineRequest {
    let slots = planes.iter().map(|&planes| FittedSlot::quadric(planes));
    MachineRequest::fitted(words, 1, slots.collect())
}

#[test]
fn machines_are_emitted() {
    let screen = |kernel, has_overlay| Output {
        mode: VideoMode::VGA,
        kernel,
        has_overlay,
    };
    let samples = ZoneShape { samples: 4, ..ZONE };
    let kinds = [
        (Kind::ZoneCore(ZONE), "zone_core"),
        (Kind::ZoneMachine(ZONE), "zone_machine"),
        (Kind::ZoneMachine(samples), "zone_machine"),
        (Kind::ZoneDisplay(ZONE, screen(0, false)), "zone_display"),
        (Kind::BeamDisplay(8, screen(2, true)), "beam_display"),
        (Kind::BeamStream(8, 64, 48), "beam_stream"),
    ];
    let words = [MachineWords::of(24), OWN];
    for ((kind, top), words) in kinds.into_iter().zip(words.into_iter().cycle()) {
        let request = request(kind);
        let emitted = emit_machine(&MachineRequest { words, ..request }).unwrap();
        assert_eq!(emitted.top, top);
        let text = emitted.bundle();
        assert!(text.contains(" [0:255];"), "{top}");
        let has_own = text.contains("guard bits 10 of f1, 3 of f2");
        assert_eq!(has_own, words == OWN, "{top}");
    }
}

/// Slots of every kind, and quadrics and patches in shorter words, of a machine with a core alone.
#[test]
fn slots_of_every_kind_and_own_words_are_emitted() {
    let of = |words: MachineWords, text: &str| {
        let slots = imogene_contract::slots::parse(text).unwrap();
        emit_machine(&MachineRequest::fitted(words, 4, slots))
    };
    let others = "2:r5:p18,patch2,polyhedron6,facet3,curved_facet2,sphere,cylinder,first_generation,quotient1";
    let emitted = of(MachineWords::of(16), others).unwrap();
    let text = emitted.bundle();
    let shorter = "r and p bits of a shorter root and shorter planes: 2:r5:p18 patch2 polyhedron6";
    assert!(text.contains(shorter));
    // Ten bits of f2, of which the words lie on a longer bus.
    assert!(text.contains("[9:0] f2_"), "{text}");
    let latency = |text: &str| of(OWN, text).unwrap().latency;
    let whole = latency("2:r9:p18,patch2:r16,1:r16");
    assert_eq!(latency("2:r9:p18,patch2:r16,1"), whole);
    let refused = |text: &str| of(OWN, text).unwrap_err().to_string();
    let root = "root of a slot = 18 is out of range; legal values are 4 to 17";
    assert!(refused("2:r18").contains(root));
    assert!(refused("2:p17").contains("legal values are 18 to 29"));
    assert!(refused("sphere").contains("root beside another kind of slot"));
}

/// Equal slots make the machine of the catalogue, module for module.
#[test]
fn equal_slots_are_the_machine_of_the_catalogue() {
    let fitted = emit_machine(&beam(MachineWords::of(16), &[2; 3])).unwrap();
    let catalogue = emit(&Request {
        planes: 2,
        objects: 3,
        ..Request::of(Unit::Beam, 16)
    });
    let catalogue = catalogue.unwrap();
    assert_eq!(fitted.modules, catalogue.modules);
    assert_eq!(fitted.latency, catalogue.latency);
}

#[test]
fn a_machine_has_the_words_that_were_asked_for() {
    let words = MachineWords {
        root: 15,
        dropped_rows: 2,
        plane: 23,
        normal: 11,
        guard_linear: 3,
        guard_quadratic: 5,
        ..MachineWords::of(19)
    };
    let emitted = emit_machine(&beam(words, &[1, 3])).unwrap();
    let width = |name: &str| {
        let port = emitted.ports.iter().find(|port| port.name == name);
        port.unwrap().width
    };
    assert_eq!(["depth", "nx", "load_data"].map(width), [19, 11, 35]);
    assert_eq!(emitted.latency, 1 + (13 + 11) + 1);
    let text = emitted.bundle();
    assert!(text.contains("root 15, of which the last 2 digits are zero"));
    let linear = MachineWords {
        root_form: RootForm::Linear(2),
        ..words
    };
    let emitted = emit_machine(&beam(linear, &[1, 3])).unwrap();
    assert_eq!(emitted.latency, 1 + (5 + 11) + 1);
    let text = emitted.bundle();
    assert!(text.contains("root form linear2") && text.contains("module square_root_linear"));
}

#[test]
fn a_machine_of_different_slots_waits_for_the_longest() {
    let emitted = |slots: &[u32]| emit_machine(&beam(MachineWords::of(16), slots)).unwrap();
    let fitted = emitted(&[0, 9, 3]);
    // Raster control, root, what is around it, two levels of planes beyond those of four, the tree of three inputs.
    assert_eq!(fitted.latency, 1 + (16 + 11 + 2) + 2);
    assert!(fitted.bundle().contains("slots, by their planes: 0 9 3"));
    assert_eq!(emitted(&[0, 4, 3]).latency, 1 + (16 + 11) + 2);
}

fn shaped(zone_bits: usize, samples: usize) -> Kind {
    Kind::ZoneMachine(ZoneShape { zone_bits, samples })
}

/// What makes a request a bad one.
type Change = fn(&mut MachineRequest);

#[test]
fn numbers_out_of_range_are_refused() {
    let cases: [(Change, &str); 14] = [
        (|r| r.slots.clear(), "objects = 0"),
        (|r| r.slots[1].planes = 13, "planes = 13"),
        (|r| r.volumes = 257, "volumes = 257"),
        (|r| r.volume_planes = 13, "volume planes = 13"),
        (|r| r.rows_per_stage = 25, "rows per stage = 25"),
        (
            |r| r.words = MachineWords::of(7),
            "legal values are 8 to 32",
        ),
        (|r| r.words = MachineWords::of(33), "depth word = 33"),
        (|r| r.words.guard_linear = 17, "guard bits of f1 = 17"),
        (|r| r.words.guard_quadratic = 17, "guard bits of f2 = 17"),
        (
            |r| (r.words.root, r.words.guard_quadratic) = (30, 5),
            "root = 30",
        ),
        (|r| r.lights = 17, "lights = 17"),
        (|r| r.prefix = "9".into(), "prefix `9`"),
        (|r| r.kind = shaped(15, 1), "zone bits = 15"),
        (|r| r.kind = shaped(8, 3), "samples = 3"),
    ];
    for (change, named) in cases {
        for kind in [Kind::Beam, Kind::ZoneMachine(ZONE)] {
            let mut request = request(kind);
            change(&mut request);
            let text = emit_machine(&request).unwrap_err().to_string();
            assert!(text.contains(named), "{text}");
        }
    }
    // The words of f2 leave room for fewer guard bits.
    let words = MachineWords {
        guard_quadratic: 5,
        ..MachineWords::of(30)
    };
    let text = emit_machine(&beam(words, &[0])).unwrap_err();
    assert!(text.to_string().contains("legal values are 0 to 4"));
}
