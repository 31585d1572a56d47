//! The end of a machine: smoothing, overlay and the pins.

use super::{
    BitPlane, COORDINATE, Colour, LEVEL, OVERLAY_LATENCY, Picture, Place, Queue, Screen, overlay,
    pixel_fifo, post_filter, video_timing,
};
use crate::raster::Pixel;
use imogene_contract::video::VideoMode;
use imogene_hdl::{Bits, Value, bundle, bundles, module, net};

bundle! {
    /// The bus of the host to the overlay.
    OverlayBus() {
        write: Bits(1), "the host writes 32 pixels";
        address: Bits(16), "which";
        data: Bits(32), "the pixels";
        enable: Bits(1), "the overlay is shown";
        colour: Bits(3 * LEVEL), "its colour";
    }

    /// The pins of a screen.
    Pins() {
        hsync: Bits(1), "synchronisation of the line";
        vsync: Bits(1), "synchronisation of the frame";
        de: Bits(1), "a pixel is shown";
        red: Bits(LEVEL), "its red; 0 in the blanking";
        green: Bits(LEVEL), "its green; 0 in the blanking";
        blue: Bits(LEVEL), "its blue; 0 in the blanking";
    }
}

bundles! {
    /// A pixel that a screen wants.
    Wanted {
        need: Bits as "need", "it wants one";
        start: Bits as "start", "the first of the frame";
        line: Bits as "line", "the first of another line";
        pixel: Pixel as "need", "pixel of the screen";
        retrace: Bits as "retrace", "first clock of the vertical blanking";
    }
}

/// What stands between the pixels of a machine and its pins.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    /// The raster of the screen.
    pub mode: VideoMode,
    /// Smoothing: 0 none, 1 box of 2 x 2, 2 binomial of 3 x 3.
    pub kernel: u64,
    /// An overlay plane over the picture.
    pub has_overlay: bool,
}

impl Output {
    /// Clocks from the scan to the pins.
    pub fn latency(&self) -> u32 {
        if self.has_overlay { OVERLAY_LATENCY } else { 0 }
    }

    /// Clocks from asking for a pixel of a machine behind so many to the scan.
    pub fn lead(&self, source: u32) -> u64 {
        u64::from(source) + self.smoothing()
    }

    /// Clocks by which the smoothing delays a picture: a line and a few pixels.
    fn smoothing(&self) -> u64 {
        match self.kernel {
            0 => 0,
            _ => self.mode.line.total() + 12,
        }
    }

    /// Address bits of a memory of a line and a few pixels.
    fn line_places(&self) -> u32 {
        (self.mode.line.active + 12).next_power_of_two().ilog2()
    }

    /// Address bits of the words of the overlay.
    fn overlay_places(&self) -> u32 {
        let pixels = self.mode.line.active * self.mode.frame.active;
        pixels.div_ceil(32).next_power_of_two().ilog2().max(1)
    }
}

/// Asks for pixels, takes them `source` clocks later, and shows them with their synchronisation.
///
/// A picture of the machine behind `source` clocks stands on the pins as many clocks later as its smoothing and overlay
/// take; the synchronisation with it.
///
/// # Panics
///
/// When a number of the mode is out of its range, or the machine is longer than the vertical blanking.
pub fn video_output(
    at: &str,
    colour: Colour,
    bus: OverlayBus,
    shape: &Output,
    source: u32,
) -> (Wanted, Pins) {
    let inputs = (colour, ("overlay", bus));
    module("video_output", at, inputs, |(colour, bus)| {
        let lead = shape.lead(source);
        let screen = video_timing("timing", Bits::new(1, 1), &shape.mode, lead);
        let smooth = match shape.kernel {
            0 => colour,
            _ => smoothed(colour, &screen, shape, source),
        };
        let (de, shown) = match shape.has_overlay {
            true => covered(smooth, &screen, bus, shape),
            false => (screen.de, smooth),
        };
        let black = Colour::of([Bits::new(0, LEVEL); 3]);
        let [red, green, blue] = de.select(shown, black).parts();
        let wanted = Wanted {
            need: screen.need,
            start: screen.go,
            line: screen.need_line,
            pixel: Pixel::of([screen.need_x, screen.need_y]),
            retrace: screen.frame_start,
        };
        let pins = Pins {
            hsync: screen.hsync.delayed_as("late_hsync", shape.latency()),
            vsync: screen.vsync.delayed_as("late_vsync", shape.latency()),
            de,
            red,
            green,
            blue,
        };
        (wanted, pins)
    })
}

/// The smoothed pixel. The last line of a picture leaves the filter early; a queue keeps it until it is shown.
fn smoothed(colour: Colour, screen: &Screen, shape: &Output, source: u32) -> Colour {
    let [width, height] = [shape.mode.line, shape.mode.frame].map(|span| span.active);
    let places = shape.line_places();
    let x = screen.need_x.delayed_as("come_x", source);
    let y = screen.need_y.delayed_as("come_y", source);
    net! { let line_end = x.is(width - 1); }
    let place = Place {
        valid: screen.need.delayed_as("come_valid", source),
        x,
        y,
        line_end,
        last: line_end & y.is(height - 1),
    };
    let kernel = Bits::new(shape.kernel, 2);
    let filtered = post_filter("filter", kernel, Picture { place, colour }, places);
    let queue = Queue {
        started: filtered.place.valid,
        push: filtered.place.valid,
        data: filtered.colour.packed(),
        last: filtered.place.last,
        m_tready: screen.de,
    };
    Colour::unpacked(pixel_fifo("queue", queue, places, 1).m_tdata)
}

/// The pixel with the overlay over it, and whether it is shown.
fn covered(colour: Colour, screen: &Screen, bus: OverlayBus, shape: &Output) -> (Bits, Colour) {
    let plane = BitPlane {
        write: bus.write,
        write_address: bus.address.low(shape.overlay_places()),
        write_data: bus.data,
        enable: bus.enable,
        colour: bus.colour,
        width: Bits::new(shape.mode.line.active, COORDINATE),
    };
    let pixel = Pixel::of([screen.x, screen.y]);
    overlay("overlay", plane, (screen.de, pixel, colour))
}
