//! The shadow stage: from the answers of the volumes to the flags of the sources, for one pixel a clock.

use crate::object::volume::VolumeKind;

/// What the stage holds of a volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShadowWords {
    /// Shadow or light.
    pub kind: VolumeKind,
    /// The source it belongs to, below 16.
    pub source: u8,
    /// Without it the volume takes nothing away.
    pub enabled: bool,
}

/// The flags after all volumes. `before` are those that earlier passes left, or all ones.
pub fn flags(before: u16, volumes: &[ShadowWords], inside: &[bool]) -> u16 {
    let enabled = volumes.iter().zip(inside).filter(|(v, _)| v.enabled);
    enabled.fold(before, |flags, (volume, &inside)| {
        volume.kind.after(volume.source, flags, inside)
    })
}

/// Latency in clocks: a register takes the words of eight volumes, and so does each one behind it.
pub fn latency(volumes: usize) -> u32 {
    let levels = (1..).find(|&levels| 8usize.pow(levels) >= volumes);
    levels.expect("a power of eight is large enough")
}
