//! The count of clocks against a machine that reads the stream beat by beat.

use super::{MACHINE, machine_of, planned, scene, with_facets};
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::machine::zone::beat::{Beat, command, kind};
use imogene_plan::zone::clocks::{ZoneTiming, clocks};
use imogene_plan::zone::growth::{OBJECT_PROCESSORS, ZONE_SIDES, growth};

pub const TIMING: ZoneTiming = ZoneTiming {
    draw_drain: 41,
    light_drain: 23,
    show_drain: 60,
    settle: 44,
    command: 2,
};

/// Clocks of the stream: a word takes one, and waits until all processors have started; a command waits for the pass
/// before it.
pub fn by_beats(beats: impl Iterator<Item = Beat>, timing: &ZoneTiming) -> u64 {
    let (mut now, mut pass_ends, mut pixels, mut settled) = (0, 0, 0, 0);
    for beat in beats {
        if beat.kind != kind::COMMAND {
            now = settled.max(now) + 1;
            continue;
        }
        now = pass_ends.max(now) + u64::from(timing.command);
        let drain = match beat.address {
            command::SIZE => {
                pixels = (beat.data & 0xfff) * (beat.data >> 12);
                continue;
            }
            command::DRAW => timing.draw_drain,
            command::LIGHT => timing.light_drain,
            command::SHOW => timing.show_drain,
            _ => continue,
        };
        pass_ends = now + pixels + u64::from(drain);
        settled = match beat.address {
            command::SHOW => 0,
            _ => now + u64::from(timing.settle),
        };
    }
    pass_ends
}

#[test]
fn the_formula_is_what_the_stream_takes() {
    let mut waited = 0;
    for path in [
        "scenes/shadows/robot.toml",
        "scenes/teapot.toml",
        "scenes/processors/mesh.toml",
    ] {
        let prepared = scene(path, (72, 54), with_facets());
        for (side, k, v) in [(4, 1, 1), (8, 16, 8), (32, 4, 2), (100, 2, 3)] {
            let plan = planned(&prepared, machine_of([side, side - 1, k, v]));
            let materials = vec![0; prepared.objects.len()];
            let plan = plan.shaded(vec![(0, 0); 9], materials);
            let plan = plan.expect("one for each");
            let counted = clocks(&plan, &TIMING);
            let taken = by_beats(plan.beats(), &TIMING);
            assert_eq!(counted.total, taken, "{:?}", plan.machine);
            assert_eq!(counted.beats, plan.beats().count() as u64);
            assert_eq!(counted.bytes, 12 * counted.beats);
            let of = |kind, address| {
                let is_one = |b: &Beat| (b.kind, b.address) == (kind, address);
                plan.beats().filter(is_one).count() as u64
            };
            assert_eq!(counted.draw_passes, of(kind::COMMAND, command::DRAW));
            assert_eq!(counted.light_passes, of(kind::COMMAND, command::LIGHT));
            assert_eq!(counted.zones, of(kind::COMMAND, command::SHOW));
            waited += counted.waiting;
        }
    }
    assert!(waited > 0, "small zones wait for their words");
}

/// One object in one zone, by hand.
#[test]
fn one_zone_of_one_object() {
    let prepared = scene("scenes/ellipsoid.toml", (40, 30), Format::BASE);
    let machine = ZoneMachine {
        slots: vec![FittedSlot::quadric(3)],
        volume_planes: 0,
        ..machine_of([40, 30, 1, 0])
    };
    let plan = planned(&prepared, machine);
    assert_eq!((plan.zones.len(), plan.parts.len()), (1, 1));
    let used = plan.parts[0].quadric().expect("a quadric").planes.len() as u64;
    let words = 24 + 1 + 3 + 6 * used;
    let counted = clocks(&plan, &TIMING);
    // Words, three commands, the draw pass, one command, the show pass.
    assert_eq!(counted.total, words + 3 * 2 + (1200 + 41) + 2 + (1200 + 60));
    assert_eq!(counted.beats, words + 4);
}

#[test]
fn more_processors_take_fewer_clocks_and_the_same_words() {
    let prepared = scene("scenes/shadows/robot.toml", (160, 120), Format::BASE);
    let (sides, processors) = (&ZONE_SIDES, &OBJECT_PROCESSORS);
    let rows = growth(&prepared, &MACHINE, &TIMING, sides, processors).expect("fits");
    assert_eq!(rows.len(), 25);
    for rows in rows.chunks(OBJECT_PROCESSORS.len()) {
        for pair in rows.windows(2) {
            assert_eq!(pair[0].side, pair[1].side);
            // In small zones there are not as many parts as processors.
            let idle = pair[0].most_parts <= pair[0].object_processors;
            assert_eq!(idle, pair[0].clocks == pair[1].clocks);
            assert!(idle || pair[0].clocks.total > pair[1].clocks.total);
            // Fewer draw commands, and no other beat.
            let draws = pair[0].clocks.draw_passes - pair[1].clocks.draw_passes;
            assert_eq!(pair[0].clocks.beats, pair[1].clocks.beats + draws);
        }
    }
    // Larger zones: fewer words are loaded again, but more pixels are visited in vain.
    for (small, large) in rows.iter().zip(&rows[OBJECT_PROCESSORS.len()..]) {
        assert_eq!(small.object_processors, large.object_processors);
        assert!(small.parts > large.parts && small.most_parts < large.most_parts);
        assert!(small.clocks.bytes > large.clocks.bytes);
    }
}
