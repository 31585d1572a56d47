//! Video modes: the clocks of a line and the lines of a frame.

/// Bits of a position in the raster, blanking included.
pub const POSITION: usize = 13;
/// Clocks of the pipeline that the video units of the catalogue stand around.
pub const LEAD: usize = 40;
/// Modules of the merger of the catalogue.
pub const MERGED: usize = 4;
/// Clocks in which a line leaves it.
pub const MERGED_WORDS: usize = 4;

/// The parts of a line in clocks, or of a frame in lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// Shown.
    pub active: u64,
    /// Blank, from the end of the shown part to the synchronisation.
    pub front: u64,
    /// Synchronisation.
    pub sync: u64,
    /// Blank, from the synchronisation to the shown part.
    pub back: u64,
}

impl Span {
    /// A span of these parts, in the order in which they are published.
    pub const fn new(active: u64, front: u64, sync: u64, back: u64) -> Span {
        Span {
            active,
            front,
            sync,
            back,
        }
    }

    /// All but the shown part.
    pub const fn blank(&self) -> u64 {
        self.front + self.sync + self.back
    }

    /// All.
    pub const fn total(&self) -> u64 {
        self.blank() + self.active
    }
}

/// The raster of a screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct VideoMode {
    /// A line, in clocks.
    pub line: Span,
    /// A frame, in lines.
    pub frame: Span,
    /// `hsync` is high in the synchronisation, not low.
    pub hsync_high: bool,
    /// The same of `vsync`.
    pub vsync_high: bool,
}

impl VideoMode {
    /// 160 x 120 with hardly any blanking, for simulation.
    pub const SMALL: VideoMode = VideoMode {
        line: Span::new(160, 2, 3, 3),
        frame: Span::new(120, 1, 1, 0),
        hsync_high: false,
        vsync_high: true,
    };
    /// 640 x 480 at 60 Hz, 25.175 MHz.
    pub const VGA: VideoMode = VideoMode {
        line: Span::new(640, 16, 96, 48),
        frame: Span::new(480, 10, 2, 33),
        hsync_high: false,
        vsync_high: false,
    };
    /// 1280 x 720 at 60 Hz, 74.25 MHz.
    pub const HD: VideoMode = VideoMode {
        line: Span::new(1280, 110, 40, 220),
        frame: Span::new(720, 5, 5, 20),
        hsync_high: true,
        vsync_high: true,
    };
    /// 1920 x 1080 at 60 Hz, 148.5 MHz.
    pub const FULL_HD: VideoMode = VideoMode {
        line: Span::new(1920, 88, 44, 148),
        frame: Span::new(1080, 4, 5, 36),
        hsync_high: true,
        vsync_high: true,
    };
    /// The modes by their number.
    pub const ALL: [VideoMode; 4] = [Self::SMALL, Self::VGA, Self::HD, Self::FULL_HD];

    /// Clocks of a frame.
    pub const fn clocks(&self) -> u64 {
        self.line.total() * self.frame.total()
    }

    /// Clocks of the vertical blanking: from the end of the last pixel of a frame to the beginning of the first line
    /// that is shown.
    pub const fn retrace(&self) -> u64 {
        self.frame.blank() * self.line.total()
    }
}
