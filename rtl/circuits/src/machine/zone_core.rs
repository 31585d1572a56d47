//! The part of a zone machine that decides: from the command stream to the visible surface of every pixel.

use super::layer_raster::layer_raster;
use super::{
    Beat, Lit, Objects, Raster, SOURCES, Steps, Surface, Volumes, Waits, WordBus, Zone,
    all_sources, object_array, raster_control, show_control, stream_slice, volume_array,
    zone_buffer, zone_control,
};
use crate::object::absent;
use crate::raster::{Flags, Pixel, Scan};
use crate::rows::PerLane;
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, bundles, module};

/// Clocks of a showing pass besides its pixels, without transparent objects.
pub const SHOW_CLOCKS: u32 = 6;

/// What a zone core is built for.
#[derive(Clone, Debug)]
pub struct ZoneCore {
    /// Object processors.
    pub objects: Objects,
    /// Volume processors; there may be none.
    pub volumes: Volumes,
    /// Bits of the place of a pixel in a zone.
    pub places: u32,
    /// Of a machine of transparent objects: clocks by which these know a pixel of a showing pass before its surface is
    /// read.
    pub ahead: Option<u32>,
}

impl ZoneCore {
    /// Bits of its load bus: those of the widest word of a processor.
    pub fn bus(&self) -> u32 {
        self.objects.bus().max(self.volumes.widths.bus())
    }

    /// Clocks from a drawing or lighting command until words of processors are taken again: all have started.
    pub fn settle_clocks(&self) -> u32 {
        self.objects.clocks().max(self.volumes.clocks()) + 4
    }

    /// Clocks of a showing pass besides its pixels.
    pub fn show_clocks(&self) -> u32 {
        SHOW_CLOCKS + self.ahead.unwrap_or(0)
    }

    /// Clocks of a drawing pass besides its pixels.
    pub fn draw_clocks(&self) -> u32 {
        self.objects.clocks() + 5
    }

    /// Clocks of a lighting pass besides its pixels.
    pub fn light_clocks(&self) -> u32 {
        match self.volumes.planes.len() {
            0 => 4,
            _ => self.volumes.clocks() + 4,
        }
    }
}

bundle! {
    /// A word for the tables behind a core.
    TableWord(width) {
        shading: Bits(1), "it is of the shading processor";
        material: Bits(1), "it is the material of an object";
        address: Bits(16), "its address there";
        data: Bits(width), "the word";
    }
}

bundles! {
    /// What transparent objects are told.
    Ahead {
        take: Bits as "take", "a showing pass begins: words are taken over";
        /// Pixels of the pass.
        scan: Scan as "";
        load: WordBus as "load", "the load bus";
    }

    /// What leaves a core.
    Shown {
        ready: Bits as "s_tready", "the beat is taken";
        started: Bits as "started", "a pixel is started on this clock";
        valid: Bits as "valid", "two clocks later: it is on the ports below";
        pixel: Pixel as "", "its place on the screen";
        surface: Surface as "", "its surface, at the far end the background";
        flags: Bits as "source_flags", "sources that reach it";
        sample: Bits as "sample", "which sample of the pixel it is, also of one that is started";
        pass_ends: Bits as "pass_ends", "it is the last of the pass";
        frame_ends: Bits as "frame_ends", "it is the last of the frame";
        load: TableWord as "load", "a word";
        ahead: Option<Ahead> as "ahead", "of transparent objects";
    }
}

/// Shares its processors in time among the objects and volumes of one zone after another, and hands on what is visible
/// in a finished zone.
///
/// A pixel is started where there is `room` behind the shading processor, and is through `drain` clocks after it was
/// handed on. A pass over n pixels takes, from the clock that takes its command to the first that takes the next, n
/// clocks and [`ZoneCore::draw_clocks`], [`ZoneCore::light_clocks`] or [`SHOW_CLOCKS`]. `docs/zone-machine.md`.
pub fn zone_core(at: &str, beat: Beat, room: Bits, machine: &ZoneCore, drain: u32) -> Shown {
    let inputs = (("s", beat), ("room", room));
    module("zone_core", at, inputs, |(beat, room)| {
        let [ready, pass_ends] = [(); 2].map(|()| Bits::forward(1));
        let (beat, taken) = stream_slice("slice", beat, ready);
        let settle = machine.settle_clocks();
        let waits = Waits {
            settle,
            settles_in_shows: machine.ahead.is_some(),
            drain,
        };
        let control = zone_control("control", beat, pass_ends, waits);
        ready.drive(control.ready);
        let (load, pass, window) = (control.load, control.pass, control.window);
        let zone = Zone {
            go: pass.go,
            width: window.width,
            height: window.height,
        };
        let raster = raster_control("raster", zone);
        // So many processors want registers of their own to start from. These hold their words while a pass of another
        // kind runs, so that processors without work stand still.
        let of = |runs: Bits| {
            let Raster { scan, last } = raster;
            let flags = Flags {
                valid: (scan.flags.valid & runs).reg(),
                start: scan.flags.start.reg_when(runs),
                line: scan.flags.line.map(|line| line.reg_when(runs)),
            };
            let pixel = scan.pixel.registered_when(runs);
            Raster {
                scan: Scan { flags, pixel },
                last: (last & runs).reg(),
            }
        };
        let (draw, light) = (of(pass.is_drawing), of(pass.is_lighting));
        let show = show_control("show", pass.show_go, room, window);
        let started = show.issue;
        let ahead = machine.ahead.map(|_| Ahead {
            take: pass.show_go,
            scan: layer_raster("layer_raster", pass.show_go, show.issue, window.width),
            load,
        });
        let show = match machine.ahead {
            None => show,
            Some(clocks) => show.delayed(clocks),
        };
        let (objects, clocks) = (&machine.objects, machine.objects.clocks());
        let words = (pass.take_objects, load.objects());
        let drawn = object_array("objects", draw.scan, words, objects, true).alone();
        // What the volumes are told comes from the buffer, which takes what they answer.
        let depth = Int::forward(objects.words.depth);
        let flags = Bits::forward(SOURCES);
        let known = Lit {
            depth,
            flags_in: pass.is_first.select(all_sources(), flags),
        };
        let lighting = lighting(light, known, (pass.take_volumes, load), &machine.volumes);
        let steps = Steps {
            begin_pass: pass.begin_pass,
            is_first: pass.is_first,
            drawn_soon: draw.scan.flags.valid.delayed_as("drawn_soon", clocks - 2),
            depth_soon: lighting.depth_soon,
            flags_soon: lighting.flags_soon,
            show_soon: show.issue,
        };
        let seen = zone_buffer("zone_buffer", steps, drawn, lighting.lit, machine.places);
        depth.drive(seen.surface.depth);
        flags.drive(seen.flags);
        let draw_ends = draw.last.delayed_as("draw_end", clocks + 1);
        pass_ends.drive(draw_ends | lighting.ends | show.is_last);
        let background = absent(objects.words.depth);
        Shown {
            ready: taken,
            started,
            valid: show.valid,
            pixel: show.pixel,
            surface: Surface {
                depth: pass.was_drawn.select(seen.surface.depth, background),
                ..seen.surface
            },
            flags: pass.was_lit.select(seen.flags, all_sources()),
            sample: pass.sample,
            pass_ends: show.is_last,
            frame_ends: show.is_last & pass.is_last_zone,
            load: TableWord {
                shading: load.shading,
                material: load.material,
                address: load.address,
                data: load.data,
            },
            ahead,
        }
    })
}

/// What a lighting pass does with the buffer.
struct Lighting {
    depth_soon: Bits,
    flags_soon: Bits,
    lit: (Bits, Bits),
    ends: Bits,
}

/// The volumes and the steps of the buffer for them.
fn lighting(
    light: Raster,
    known: Lit,
    (take, load): (Bits, WordBus),
    volumes: &Volumes,
) -> Lighting {
    if volumes.planes.is_empty() {
        let never = Bits::new(0, 1);
        return Lighting {
            depth_soon: never,
            flags_soon: never,
            lit: (never, all_sources()),
            ends: light.last,
        };
    }
    let soon = |name: &str, clocks: u32| light.scan.flags.valid.delayed_as(name, clocks - 2);
    Lighting {
        depth_soon: soon("depth_soon", volumes.depth_offset()),
        flags_soon: soon("flags_soon", volumes.flags_offset()),
        lit: volume_array(
            "volumes",
            light.scan,
            PerLane(vec![known]),
            (take, load.volumes()),
            volumes,
        )
        .alone(),
        ends: light.last.delayed_as("light_end", volumes.clocks()),
    }
}
