//! The raster of a screen with its blanking, from the numbers of its mode.

/// The parts of a line in clocks, or of a frame in lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// Shown.
    pub active: u64,
    /// From the end of the shown part to the synchronisation.
    pub front: u64,
    /// Synchronisation.
    pub sync: u64,
    /// From the synchronisation to the shown part.
    pub back: u64,
}

impl Span {
    fn blank(&self) -> u64 {
        self.front + self.sync + self.back
    }

    fn total(&self) -> u64 {
        self.blank() + self.active
    }
}

/// A video mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VideoMode {
    /// A line, in clocks.
    pub line: Span,
    /// A frame, in lines.
    pub frame: Span,
    /// Level of the horizontal synchronisation.
    pub hsync_high: bool,
    /// Level of the vertical synchronisation.
    pub vsync_high: bool,
}

const fn span(active: u64, front: u64, sync: u64, back: u64) -> Span {
    Span {
        active,
        front,
        sync,
        back,
    }
}

/// The modes by their number: 160 x 120 for simulation, then 640 x 480, 1280 x 720 and 1920 x 1080 at 60 Hz.
pub const MODES: [VideoMode; 4] = [
    VideoMode {
        line: span(160, 2, 3, 3),
        frame: span(120, 1, 1, 0),
        hsync_high: false,
        vsync_high: true,
    },
    VideoMode {
        line: span(640, 16, 96, 48),
        frame: span(480, 10, 2, 33),
        hsync_high: false,
        vsync_high: false,
    },
    VideoMode {
        line: span(1280, 110, 40, 220),
        frame: span(720, 5, 5, 20),
        hsync_high: true,
        vsync_high: true,
    },
    VideoMode {
        line: span(1920, 88, 44, 148),
        frame: span(1080, 4, 5, 36),
        hsync_high: true,
        vsync_high: true,
    },
];

impl VideoMode {
    /// Clocks of a frame.
    pub fn clocks(&self) -> u64 {
        self.line.total() * self.frame.total()
    }

    /// The pixel that is shown at a clock, counted from the beginning of a vertical blanking.
    pub fn pixel(&self, clock: u64) -> Option<(u16, u16)> {
        let clock = clock % self.clocks();
        let x = (clock % self.line.total()).checked_sub(self.line.blank())?;
        let y = (clock / self.line.total()).checked_sub(self.frame.blank())?;
        Some((x as u16, y as u16))
    }

    /// Levels of `hsync` and `vsync` at a clock. The vertical synchronisation begins and ends where a horizontal one begins.
    pub fn sync(&self, clock: u64) -> (bool, bool) {
        let clock = clock % self.clocks();
        let line = self.line.total();
        let within = |at: u64, from: u64, length: u64| (from..from + length).contains(&at);
        let horizontal = within(clock % line, self.line.front, self.line.sync);
        let vertical = within(
            clock,
            self.frame.front * line + self.line.front,
            self.frame.sync * line,
        );
        (horizontal == self.hsync_high, vertical == self.vsync_high)
    }
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

    /// One clock; what is there after the edge. Nothing moves without `enable`; before the first clock with it there are no flags and no synchronisation.
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
        let (hsync, vsync) = self.mode.sync(at);
        Timing {
            now: self.shown(at),
            ahead: self.shown(at + self.lead),
            hsync,
            vsync,
            frame_start: at % self.mode.clocks() == 0,
        }
    }

    fn shown(&self, at: u64) -> Shown {
        match self.mode.pixel(at) {
            Some((x, y)) => Shown {
                active: true,
                start: x == 0 && y == 0,
                line: x == 0 && y > 0,
                x,
                y,
            },
            None => Shown::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Clocks of a frame in which a condition holds.
    fn count(mode: VideoMode, holds: impl Fn(u64) -> bool) -> u64 {
        (0..mode.clocks()).filter(|at| holds(*at)).count() as u64
    }

    #[test]
    fn every_pixel_once_and_the_published_sync_widths() {
        let [small, vga, ..] = MODES;
        for (mode, pixels, hsync, vsync) in [
            (small, 160 * 120, 3 * 122, 168),
            (vga, 640 * 480, 96 * 525, 2 * 800),
        ] {
            assert_eq!(count(mode, |at| mode.pixel(at).is_some()), pixels);
            assert_eq!(count(mode, |at| mode.sync(at).0 == mode.hsync_high), hsync);
            assert_eq!(count(mode, |at| mode.sync(at).1 == mode.vsync_high), vsync);
        }
    }

    #[test]
    fn a_frame_begins_after_its_last_pixel() {
        for mode in MODES {
            let last = (mode.line.active as u16 - 1, mode.frame.active as u16 - 1);
            assert_eq!(mode.pixel(mode.clocks() - 1), Some(last));
            assert_eq!(mode.pixel(0), None);
        }
    }

    #[test]
    fn a_delayed_request_is_the_picture() {
        let mut timing = VideoTiming::new(MODES[0], 21);
        let shown: Vec<_> = (0..30_000).map(|_| timing.clock(true)).collect();
        for (later, now) in shown.iter().skip(21).zip(&shown) {
            assert_eq!(later.now, now.ahead);
        }
    }
}
