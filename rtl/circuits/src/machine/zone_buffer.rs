//! What is known of the pixels of a zone between passes.

use super::Surface;
use super::decider::is_before;
use crate::object::Normal;
use imogene_hdl::{Bits, Int, Value, bundle, bundles, join, memory, module, net, ports};

bundle! {
    /// Steps of the streams of pixels through a zone.
    Steps() {
        begin_pass: Bits(1), "the next pixel of every stream is the first of the zone";
        is_first: Bits(1), "of a pass: what the buffer held is forgotten";
        drawn_soon: Bits(1), "a pixel of a drawing pass comes in two clocks";
        depth_soon: Bits(1), "a lighting pass wants the depth of its next pixel in two clocks";
        flags_soon: Bits(1), "a lighting pass wants the flags of its next pixel in two clocks";
        show_soon: Bits(1), "a showing pass wants all of its next pixel in two clocks";
    }
}

bundles! {
    /// A pixel of a zone.
    Kept {
        surface: Surface as "", "nearest surface";
        flags: Bits as "flags", "sources that reach it";
    }
}

/// Keeps the nearest surface and the source flags of every pixel of a zone of at most `2^places` pixels.
///
/// `drawn` says with its surface that a pixel of a drawing pass is here, `lit` with its flags one of a lighting pass. A
/// surface replaces the one in the buffer if it is nearer, or at equal depth if its id is smaller, so that the order
/// of passes does not matter. Latency 2 from a wanted pixel to its values, as from a drawn pixel to the buffer.
/// `docs/zone-machine.md`.
pub fn zone_buffer(
    at: &str,
    steps: Steps,
    (drawn, surface): (Bits, Surface),
    (lit, lit_flags): (Bits, Bits),
    places: u32,
) -> Kept {
    let drawn = (("drawn", drawn), surface);
    let inputs = (steps, drawn, ports!(lit, lit_flags));
    module("zone_buffer", at, inputs, |(steps, drawn, lit)| {
        let ((drawn, surface), (lit, lit_flags)) = (drawn, lit);
        // Places advance with each pixel of their stream.
        let place = |step: Bits| {
            let place = Bits::register(places);
            let next = place + Bits::new(1, places);
            let next = steps.begin_pass.select(Bits::new(0, places), next);
            place.load_when(steps.begin_pass | step, next);
            place
        };
        let Surface { depth, id, normal } = surface;
        let [nx, ny, nz] = normal.parts();
        net! {
            let kept_drawn = drawn.reg();
            let kept_wins = Bits::register(1);
            let kept_surface = join([depth.bits(), id]).reg();
            let kept_normal = join([nz, ny, nx].map(Int::bits)).reg();
            let read_place = place(steps.drawn_soon | steps.depth_soon | steps.show_soon);
            let flags_place = place(steps.flags_soon | steps.show_soon);
            let write_place = place(kept_drawn);
            let lit_place = place(lit);
        }
        let words = 1 << places;
        let keep = |name: &str, word: Bits| {
            memory(name, words, (kept_wins, write_place, word), read_place).reg()
        };
        let old = keep("surfaces", kept_surface);
        let normals = keep("normals", kept_normal);
        net! {
            let old_depth = old.high(depth.width()).int();
            let old_id = old.low(id.width());
            let wins = steps.is_first | is_before((depth, id), (old_depth, old_id));
        }
        kept_wins.load(drawn & wins);
        let width = nx.width();
        let component = |index: u32| normals.slice((index + 1) * width - 1, index * width).int();
        let surface = Surface {
            depth: old_depth,
            id: old_id,
            normal: Normal::of([0, 1, 2].map(component)),
        };
        let flags = memory("flags", words, (lit, lit_place, lit_flags), flags_place).reg();
        ("seen", Kept { surface, flags })
    })
}
