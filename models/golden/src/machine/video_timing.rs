//! The raster of a screen with its blanking, from the numbers of its mode.

use imogene_contract::video::VideoMode;

/// What is shown at a clock, counted from the beginning of a vertical blanking.
fn shown(mode: &VideoMode, clock: u64) -> Option<Shown> {
    let clock = clock % mode.clocks();
    let x = (clock % mode.line.total()).checked_sub(mode.line.blank())?;
    let y = (clock / mode.line.total()).checked_sub(mode.frame.blank())?;
    Some(Shown {
        active: true,
        start: x == 0 && y == 0,
        line: x == 0 && y > 0,
        x: x as u16,
        y: y as u16,
    })
}

/// Levels of `hsync` and `vsync` at a clock. The vertical synchronisation begins and ends where a horizontal one
/// begins.
fn sync(mode: &VideoMode, clock: u64) -> (bool, bool) {
    let clock = clock % mode.clocks();
    let line = mode.line.total();
    let within = |at: u64, from: u64, length: u64| (from..from + length).contains(&at);
    let horizontal = within(clock % line, mode.line.front, mode.line.sync);
    let front = mode.frame.front * line + mode.line.front;
    let vertical = within(clock, front, mode.frame.sync * line);
    (horizontal == mode.hsync_high, vertical == mode.vsync_high)
}

/// A pixel and its flags.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// A pixel is shown.
    pub active: bool,
    /// First pixel of the frame.
    pub start: bool,
    /// First pixel of any other line.
    pub line: bool,
    /// Column, 0 in the blanking.
    pub x: u16,
    /// Line, 0 in the blanking.
    pub y: u16,
}

/// What the timing shows in a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timing {
    /// The pixel of this clock.
    pub now: Shown,
    /// The pixel of `lead` clocks later.
    pub ahead: Shown,
    /// Horizontal synchronisation.
    pub hsync: bool,
    /// Vertical synchronisation.
    pub vsync: bool,
    /// First clock of the vertical blanking.
    pub frame_start: bool,
}

/// The timing, clock by clock.
#[derive(Clone, Debug)]
pub struct VideoTiming {
    mode: VideoMode,
    lead: u64,
    clocks: u64,
}

impl VideoTiming {
    /// The timing of a mode for a pipeline of `lead` clocks.
    pub fn new(mode: VideoMode, lead: u64) -> Self {
        VideoTiming {
            mode,
            lead,
            clocks: 0,
        }
    }

    /// One clock; what is there after the edge. Nothing moves without `enable`; before the first clock with it there
    /// are no flags and no synchronisation.
    pub fn clock(&mut self, enable: bool) -> Timing {
        self.clocks += u64::from(enable);
        let Some(at) = self.clocks.checked_sub(1) else {
            return Timing {
                now: Shown::default(),
                ahead: Shown::default(),
                hsync: !self.mode.hsync_high,
                vsync: !self.mode.vsync_high,
                frame_start: false,
            };
        };
        let (hsync, vsync) = sync(&self.mode, at);
        Timing {
            now: shown(&self.mode, at).unwrap_or_default(),
            ahead: shown(&self.mode, at + self.lead).unwrap_or_default(),
            hsync,
            vsync,
            frame_start: at % self.mode.clocks() == 0,
        }
    }
}
