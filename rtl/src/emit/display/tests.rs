//! Machines that are emitted, and those that are refused.

use super::*;

const ZONE: ZoneShape = ZoneShape {
    zone_bits: 8,
    samples: 1,
};
fn processors() -> Processors {
    Processors {
        words: MachineWords::of(24),
        rows_per_stage: 4,
        slots: vec![Slot::full(1); 2],
        volumes: 1,
        volume_planes: 4,
    }
}
/// Words that do not follow from a depth word.
const OWN: MachineWords = MachineWords {
    depth: 18,
    root: 17,
    dropped_rows: 1,
    plane: 29,
    normal: 14,
    guard_linear: 10,
    guard_quadratic: 3,
};

fn request(kind: DisplayKind) -> DisplayRequest {
    DisplayRequest {
        kind,
        processors: processors(),
        lights: 1,
        prefix: String::new(),
        command: "a command".into(),
    }
}

#[test]
fn machines_are_emitted() {
    let screen = |kernel, has_overlay| OutputShape {
        mode: VideoMode::VGA,
        kernel,
        has_overlay,
    };
    let kinds = [
        (DisplayKind::ZoneCore(ZONE), "zone_core"),
        (DisplayKind::ZoneMachine(ZONE), "zone_machine"),
        (
            DisplayKind::ZoneMachine(ZoneShape { samples: 4, ..ZONE }),
            "zone_machine",
        ),
        (
            DisplayKind::ZoneDisplay(ZONE, screen(0, false)),
            "zone_display",
        ),
        (DisplayKind::BeamDisplay(8, screen(2, true)), "beam_display"),
        (DisplayKind::BeamStream(8, 64, 48), "beam_stream"),
    ];
    for ((kind, top), words) in kinds
        .into_iter()
        .zip([MachineWords::of(24), OWN].into_iter().cycle())
    {
        let mut request = request(kind);
        request.processors.words = words;
        let emitted = emit_display(&request).unwrap();
        assert_eq!(emitted.top, top);
        let text = emitted.bundle();
        assert!(text.contains(" [0:255];"), "{top}");
        assert_eq!(
            text.contains("guard bits 10 of f1, 3 of f2"),
            words == OWN,
            "{top}"
        );
        if let Ok(folder) = std::env::var("IMOGENE_EMIT") {
            std::fs::write(format!("{folder}/{top}.v"), text).unwrap();
        }
    }
}

/// What makes a request a bad one.
type Change = fn(&mut DisplayRequest);

#[test]
fn numbers_out_of_range_are_refused() {
    let refused = |change: Change| {
        let mut request = request(DisplayKind::ZoneMachine(ZONE));
        change(&mut request);
        emit_display(&request).unwrap_err().to_string()
    };
    let cases: [(Change, &str); 9] = [
        (|r| r.processors.slots.clear(), "objects = 0"),
        (|r| r.processors.slots[1].planes = 13, "planes = 13"),
        (|r| r.processors.rows_per_stage = 25, "rows per stage = 25"),
        (
            |r| r.processors.words = MachineWords::of(7),
            "depth word = 7",
        ),
        (
            |r| r.processors.words = MachineWords::of(40),
            "depth word = 40",
        ),
        (
            |r| r.processors.words.guard_quadratic = 17,
            "guard bits of f2 = 17",
        ),
        (|r| r.lights = 5, "lights = 5"),
        (
            |r| {
                r.kind = DisplayKind::ZoneMachine(ZoneShape {
                    zone_bits: 15,
                    ..ZONE
                })
            },
            "zone bits = 15",
        ),
        (
            |r| r.kind = DisplayKind::ZoneMachine(ZoneShape { samples: 3, ..ZONE }),
            "samples = 3",
        ),
    ];
    for (change, named) in cases {
        let text = refused(change);
        assert!(text.contains(named), "{text}");
    }
}
