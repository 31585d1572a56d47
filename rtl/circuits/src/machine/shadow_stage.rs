//! Sources that reach a point.

use super::{SOURCES, all_sources};
use imogene_hdl::{Bits, Value, bundle, module, net};

/// Words that one register takes.
const GROUP: usize = 8;

bundle! {
    /// A shadow or light volume at a point.
    Volume() {
        inside: Bits(1), "the visible point is inside";
        kind: Bits(1), "0 shadow, dark inside, 1 light, dark outside; held";
        source: Bits(4), "source that it belongs to; held";
        enabled: Bits(1), "it counts; without it it takes nothing away; held";
    }
}

/// Clocks of a shadow stage of so many volumes.
pub fn shadow_clocks(volumes: usize) -> u32 {
    let joined = volumes.div_ceil(GROUP);
    1 + if joined > 1 { shadow_clocks(joined) } else { 0 }
}

/// Which sources reach the visible point: the flag of a source stays if the point is outside every shadow volume of it
/// and inside every light volume of it.
///
/// Every volume gives a word of flags, and the words are joined eight to a register: latency 1 for up to 8 volumes,
/// else `ceil(log8 n)`. Section 4.1.3; Chaillou 1991, IV.3.4.
pub fn shadow_stage(at: &str, flags: Bits, volumes: Vec<Volume>) -> Bits {
    let meaning = "flags before these volumes: bit s is set where source s reaches the point; all ones in a first pass";
    let volumes = ("volume", volumes, "volume #");
    let inputs = (("flags_in", flags, meaning), volumes);
    module("shadow_stage", at, inputs, |(flags, volumes)| {
        let one = Bits::new(1, SOURCES);
        let word = |volume: &Volume| {
            net! {
                let takes_away = volume.enabled & (volume.inside ^ volume.kind);
                let mask = one.left_by(volume.source);
            }
            takes_away.select(!mask, all_sources())
        };
        let mut level: Vec<Bits> = volumes.iter().map(word).collect();
        level[0] = flags & level[0];
        let both = |a: Bits, b: Bits| a & b;
        loop {
            let joined = level.chunks(GROUP).map(|group| {
                let joined = group.iter().copied().reduce(both);
                joined.expect("a word").reg()
            });
            level = joined.collect();
            if level.len() == 1 {
                return ("flags", level[0], "flags after these volumes");
            }
        }
    })
}
