//! Shadow and light volumes side by side, with their words and the shadow stage.

use super::slot::Lanes;
use super::{LoadBus, Volume, shadow_clocks, shadow_stage, volume_store};
use crate::arith::Network;
use crate::object::{VolumePoint, Widths, quadric_volume};
use crate::raster::{Scan, lane_scans, lanes_latency};
use crate::rows::{PerLane, in_lane};
use imogene_hdl::{Bits, Bundle, Value, bundle, module};

bundle! {
    /// The load bus of volumes.
    VolumeLoad(width) {
        valid: Bits(1), "write a word";
        volume: Bits(8), "slot of the volume";
        address: Bits(8), "address of the word in its store";
        data: Bits(width), "the word";
    }

    /// What is known of the visible point of a pixel before volumes.
    Lit(depth) {
        depth: Int(depth), "visible depth";
        flags_in: Bits(16), "sources that may reach it";
    }
}

/// What volume processors side by side are built for.
#[derive(Clone, Debug)]
pub struct Volumes {
    /// Bits of the words of a volume.
    pub widths: Widths,
    /// The root of a volume.
    pub root: Network,
    /// Planes of each.
    pub planes: Vec<u64>,
    /// Pixels of a line that are drawn at once, a power of two.
    pub lanes: u32,
}

impl Volumes {
    /// Clocks from the flags of the raster to those of the sources.
    pub fn clocks(&self) -> u32 {
        self.flags_offset() + shadow_clocks(self.planes.len())
    }

    /// Clocks from the flags of the raster to the visible depth.
    pub fn depth_offset(&self) -> u32 {
        lanes_latency(self.lanes) + self.root.latency()
    }

    /// Clocks from the flags of the raster to those of the sources before these volumes.
    pub fn flags_offset(&self) -> u32 {
        self.depth_offset() + 5
    }
}

/// Takes away the flags of the sources that do not reach the visible point of each lane, of at least one volume; and
/// whether there is a pixel.
///
/// The visible depth comes [`Volumes::depth_offset`] clocks after the flags of its pixel, the flags of the sources
/// [`Volumes::flags_offset`]; `take` before the first flags of a pass: the words loaded become those of the volumes.
/// Latency [`Volumes::clocks`].
pub fn volume_array(
    at: &str,
    scan: Scan,
    lit: PerLane<Lit>,
    (take, load): (Bits, VolumeLoad),
    volumes: &Volumes,
) -> PerLane<(Bits, Bits)> {
    let inputs = (scan, lit, ("take", take), ("load", load));
    module("volume_array", at, inputs, |(scan, lit, take, load)| {
        let scans = lane_scans(scan.delayed(lanes_latency(volumes.lanes)), volumes.lanes);
        let lanes = Lanes {
            raster: scan,
            scans: &scans,
        };
        let volume = |(index, planes): (usize, &u64)| {
            let bus = LoadBus {
                write: load.valid & load.volume.is(index as u64),
                address: load.address,
                data: load.data,
            };
            let bus = bus.registered();
            let words = (volumes.root.depth, volumes.widths);
            let stored = volume_store(&format!("stores_{index}"), take, bus, words, *planes);
            let processors = lanes.of(&format!("volumes_{index}"), stored.words);
            let answers = processors.into_iter().zip(&lit.0);
            let answers = answers.map(|((at, scan, words), lit)| {
                let point = VolumePoint {
                    depth: lit.depth,
                    margin: stored.margin,
                };
                let answer = quadric_volume(&at, scan, point, words, volumes.root);
                let volume = Volume {
                    inside: answer.is_inside,
                    kind: stored.is_light,
                    source: stored.source,
                    enabled: stored.is_present,
                };
                (answer.out_valid, volume)
            });
            answers.collect()
        };
        let answers = volumes.planes.iter().enumerate().map(volume);
        let answers: Vec<Vec<(Bits, Volume)>> = answers.collect();
        PerLane::of(volumes.lanes, |lane| {
            let answers = answers.iter().map(|volume| volume[lane as usize]);
            let (valid, asked): (Vec<Bits>, Vec<Volume>) = answers.unzip();
            let valid = valid[0].delayed_as("valid_late", shadow_clocks(asked.len()));
            let at = in_lane("stage", lane, volumes.lanes);
            let flags = shadow_stage(&at, lit.0[lane as usize].flags_in, asked);
            (("out_valid", valid), ("source_flags", flags))
        })
    })
}
