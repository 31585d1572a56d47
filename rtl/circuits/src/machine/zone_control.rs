//! Carries out the command stream of a zone machine.

use super::{Beat, COORDINATE, Window, WordBus};
use imogene_contract::command_stream::{command, kind};
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, bundles, module, net};

bundle! {
    /// The pass over a zone.
    Pass() {
        begin_pass: Bits(1), "a pass begins, when all words have reached their stores: counters to zero";
        take_objects: Bits(1), "one clock later: a drawing pass takes its words";
        take_volumes: Bits(1), "one clock later: a lighting pass takes its words";
        go: Bits(1), "the raster of a drawing or lighting pass starts";
        show_go: Bits(1), "one clock later: a showing pass starts";
        is_drawing: Bits(1), "a drawing pass runs";
        is_lighting: Bits(1), "a lighting pass runs";
        is_first: Bits(1), "first drawing or lighting pass of the zone: what the buffer held is forgotten";
        was_drawn: Bits(1), "of a showing pass: the buffer holds surfaces";
        was_lit: Bits(1), "of a showing pass: the buffer holds flags";
        is_last_zone: Bits(1), "of a showing pass: the frame ends with this zone";
        sample: Bits(6), "of a showing pass: first in bit 0, last in 1, its column in the pixel in 3..2, line in 5..4";
    }
}

bundles! {
    /// What a zone control says.
    Control {
        ready: Bits as "s_tready", "the beat is taken";
        load: WordBus as "load", "word on the load bus";
        pass: Pass as "", "pass over the zone";
        window: Window as "", "the zone";
    }
}

/// Clocks that some beats wait.
#[derive(Clone, Copy, Debug)]
pub struct Waits {
    /// From a drawing or lighting command until all processors have started.
    pub settle: u32,
    /// The same of a showing command, in a machine of transparent objects.
    pub settles_in_shows: bool,
    /// From the end of a showing pass until its pixels are through the shading processor.
    pub drain: u32,
}

/// Takes the beats of the command stream in order: words go to the processors, commands begin passes over the zone.
///
/// A command waits for the end of the pass before it. Words of processors are taken during a pass, once the processors
/// have started; words of tables wait until the pixels of the last showing pass are shaded. Other kinds and addresses
/// are ignored. Latency 1. `docs/zone-machine.md`.
pub fn zone_control(at: &str, beat: Beat, pass_ends: Bits, waits: Waits) -> Control {
    let inputs = (("s", beat), ("pass_ends", pass_ends));
    module("zone_control", at, inputs, |(beat, pass_ends)| {
        let (address, data) = (beat.tuser.low(16), beat.tdata);
        let is = |kind: u8| beat.tdest.is(kind.into());
        let flag = || Bits::register(1);
        let counter = |clocks: u32| {
            let width = clocks.max(1).ilog2() + 2;
            Int::register(width).initially((1 << width) - 1)
        };
        net! {
            let is_drawing = flag();
            let is_lighting = flag();
            let is_showing = flag();
            let settling = counter(waits.settle);
            let draining = counter(waits.drain);
            let is_coefficient = is(kind::OBJECT) | is(kind::VOLUME);
            let is_idle = !(is_drawing | is_lighting | is_showing);
            let is_command = is(kind::COMMAND);
            let may_end = is_idle & (is_command | draining.is_negative());
            let is_ready = is_coefficient.select(settling.is_negative(), may_end);
            let taken = beat.tvalid & is_ready;
            let is_obeyed = taken & is_command;
        }
        let obeyed = |command: u16| is_obeyed & address.is(command.into());
        net! {
            let draws = obeyed(command::DRAW);
            let lights = obeyed(command::LIGHT);
            let shows = obeyed(command::SHOW);
            let scans = draws | lights;
            let begins = (scans | shows).delay(2);
        }
        is_drawing.load_when(draws | pass_ends, draws);
        is_lighting.load_when(lights | pass_ends, lights);
        is_showing.load_when(shows | pass_ends, shows);
        let settles = match waits.settles_in_shows {
            true => scans | shows,
            false => scans,
        };
        count_down(settling, settles, waits.settle);
        count_down(draining, pass_ends & is_showing, waits.drain);
        let shown = |high: u32, low: u32| data.slice(high, low).reg_when(shows);
        let tvalid = taken;
        let load = WordBus::of(Beat { tvalid, ..beat }).registered();
        // So many registers stand far away: the window follows a clock later, in time for the pass after it.
        net! { let was_obeyed = is_obeyed.reg(); }
        let coordinate = |command: u16, low: u32| {
            let is_set = was_obeyed & load.address.is(command.into());
            load.data.slice(low + COORDINATE - 1, low).reg_when(is_set)
        };
        Control {
            ready: is_ready,
            load,
            pass: Pass {
                begin_pass: begins,
                take_objects: (begins & is_drawing).reg(),
                take_volumes: (begins & is_lighting).reg(),
                go: begins & (is_drawing | is_lighting),
                show_go: (begins & is_showing).reg(),
                is_drawing,
                is_lighting,
                is_first: data.bit(0).reg_when(scans),
                was_lit: shown(0, 0),
                was_drawn: shown(1, 1),
                is_last_zone: shown(2, 2),
                sample: shown(8, 3),
            },
            window: Window {
                x0: coordinate(command::ORIGIN, 0),
                y0: coordinate(command::ORIGIN, COORDINATE),
                width: coordinate(command::SIZE, 0),
                height: coordinate(command::SIZE, COORDINATE),
            },
        }
    })
}

/// A counter that goes down through so many clocks until its sign says that they are over.
fn count_down(counter: Int, starts: Bits, clocks: u32) {
    let word = |value: i64| Int::new(value, counter.width());
    let next = starts.select(word(i64::from(clocks) - 1), counter - word(1));
    counter.load_when(starts | !counter.is_negative(), next);
}
