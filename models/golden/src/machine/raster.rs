//! Raster control: scans a zone left to right, top to bottom, one pixel per clock, zones without a bubble.

/// One pixel of the scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RasterPixel {
    /// Column.
    pub x: u16,
    /// Line.
    pub y: u16,
    /// First pixel of the zone.
    pub start: bool,
    /// First pixel of any other line.
    pub line: bool,
    /// Last pixel of the zone.
    pub last: bool,
}

/// The scan's state: the pixels that are still to come.
#[derive(Clone, Debug, Default)]
pub struct RasterControl {
    zone: Option<(u16, u16)>,
    next: u32,
}

impl RasterControl {
    /// One clock; the pixel that is there after the edge. `go` is obeyed when no pixel or the last one is there before
    /// the edge.
    pub fn clock(&mut self, go: bool, width: u16, height: u16) -> Option<RasterPixel> {
        if let Some((w, h)) = self.zone
            && self.next == u32::from(w) * u32::from(h)
        {
            self.zone = None;
        }
        if self.zone.is_none() && go {
            self.zone = Some((width, height));
            self.next = 0;
        }
        let (w, h) = self.zone?;
        let (x, y) = (self.next % u32::from(w), self.next / u32::from(w));
        self.next += 1;
        Some(RasterPixel {
            x: x as u16,
            y: y as u16,
            start: self.next == 1,
            line: x == 0 && y > 0,
            last: self.next == u32::from(w) * u32::from(h),
        })
    }
}
