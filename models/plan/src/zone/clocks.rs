//! Clocks of a frame, counted from its plan.
//!
//! While a pass runs, the words of the next pass are loaded, a beat a clock, once all processors have started; a
//! command waits until the pass before it has ended. So a pass of `T` clocks before one that needs `L` words takes
//! `max(T, S + L)` clocks and those of the commands in between.

use super::plan::{Pass, Zone, ZonePlan};
use imogene_golden::machine::zone::beat::BEAT_BYTES;
use serde::{Deserialize, Serialize};

/// What the machine takes beside one clock for each pixel and each beat.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ZoneTiming {
    /// D_o: clocks of a draw pass after its last pixel has started, until the next command can be obeyed.
    pub draw_drain: u32,
    /// D_v: the same of a light pass.
    pub light_drain: u32,
    /// D_s: the same of a show pass.
    pub show_drain: u32,
    /// S: clocks of a draw or light pass, from its command, in which no word is taken because not all processors have
    /// started.
    pub settle: u32,
    /// C: clocks of a command, from the end of loading and of the pass before to the first pixel or the next beat; at
    /// least 1.
    pub command: u32,
}

/// Clocks and beats of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct FrameClocks {
    /// All of them: the sum of the next six.
    pub total: u64,
    /// Shading words and materials before the first zone.
    pub set_up: u64,
    /// Of all draw passes with their drain.
    pub draw: u64,
    /// Of all light passes with their drain.
    pub light: u64,
    /// Of all show passes with their drain.
    pub show: u64,
    /// Of commands.
    pub commands: u64,
    /// In which no pass runs because words are still being loaded.
    pub waiting: u64,
    /// Draw passes.
    pub draw_passes: u64,
    /// Light passes.
    pub light_passes: u64,
    /// Zones, each of which is shown once.
    pub zones: u64,
    /// Beats of the stream.
    pub beats: u64,
    /// Bytes of the stream.
    pub bytes: u64,
}

/// The clocks of a frame.
pub fn clocks(plan: &ZonePlan, timing: &ZoneTiming) -> FrameClocks {
    let set_up = (plan.shading.len() + plan.materials.len()) as u64;
    let mut clocks = FrameClocks {
        set_up,
        zones: plan.zones.len() as u64,
        beats: set_up,
        ..FrameClocks::default()
    };
    // Clocks of the pass that runs while the next words are loaded; before the first one there is none.
    let mut running = 0;
    let mut settling = 0;
    for zone in &plan.zones {
        for (index, pass) in plan.passes(zone, false).enumerate() {
            let words = plan.words_of(&pass, zone).len() as u64;
            if words > 0 {
                clocks.waiting += (settling + words).saturating_sub(running);
            }
            // The pass itself, and origin and size before the first one of a zone.
            let commands = if index == 0 { 3 } else { 1 };
            clocks.commands += commands * u64::from(timing.command);
            clocks.beats += words + commands;
            running = clocks.add_pass(&pass, zone, timing);
            settling = match pass {
                Pass::Show { .. } if plan.machine.layers.is_empty() => 0,
                _ => u64::from(timing.settle),
            };
        }
    }
    let passes = clocks.draw + clocks.light + clocks.show;
    clocks.total = clocks.set_up + passes + clocks.commands + clocks.waiting;
    clocks.bytes = clocks.beats * BEAT_BYTES;
    clocks
}

impl FrameClocks {
    /// Counts a pass; the clocks that it takes.
    fn add_pass(&mut self, pass: &Pass, zone: &Zone, timing: &ZoneTiming) -> u64 {
        let (drain, sum, passes) = match pass {
            Pass::Draw { .. } => (timing.draw_drain, &mut self.draw, &mut self.draw_passes),
            Pass::Light { .. } => (timing.light_drain, &mut self.light, &mut self.light_passes),
            // One for each zone, which are counted already.
            Pass::Show { .. } => (timing.show_drain, &mut self.show, &mut 0),
        };
        let clocks = zone.window.pixels() + u64::from(drain);
        *sum += clocks;
        *passes += 1;
        clocks
    }
}
