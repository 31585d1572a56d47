//! The end of a machine: smoothing, overlay and the pins.

use super::overlay::Overlay;
use super::pixel_fifo::PixelFifo;
use super::post_filter::PostFilter;
use super::video_mode::VideoMode;
use super::video_timing::VideoTiming;
use crate::kernel::*;
use crate::unit::delay::WordDelay;

/// Bits of the address of an overlay word at most.
pub const OVERLAY_BITS: usize = 16;
/// Bits of a column at most.
const LINE_BITS: usize = 11;

/// What stands between the pixels of a machine and its pins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OutputShape {
    /// Video mode.
    pub mode: VideoMode,
    /// Smoothing: 0 none, 1 box of 2 x 2, 2 binomial of 3 x 3.
    pub kernel: usize,
    /// An overlay plane over the picture.
    pub has_overlay: bool,
}

impl OutputShape {
    /// Pixels of a line.
    pub fn width(&self) -> usize {
        self.mode.line.active as usize
    }

    /// Lines.
    pub fn height(&self) -> usize {
        self.mode.frame.active as usize
    }

    /// Clocks by which the smoothing delays a picture: a line and a few pixels.
    fn smoothing(&self) -> usize {
        match self.kernel {
            0 => 0,
            _ => self.mode.line.total() as usize + 8,
        }
    }
}

/// Asks for pixels, takes them a fixed number of clocks later, and shows them with their synchronisation.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `need`, `start`, `line`, `need_x`, `need_y` | out | a pixel is wanted, first of the frame, first of another line; 12 bits |
/// | `retrace` | out | first clock of the vertical blanking |
/// | `r`, `g`, `b` | in | 8 bits, the pixel wanted `source` clocks before |
/// | `overlay_write`, `overlay_address`, `overlay_data` | in | the host writes 32 pixels of the overlay |
/// | `overlay_enable`, `overlay_colour` | in | the overlay is shown; 24 bits |
/// | `hsync`, `vsync`, `de` | out | synchronisation, and a pixel is shown |
/// | `red`, `green`, `blue` | out | 8 bits; 0 in the blanking |
///
/// A picture of the machine behind `source` clocks stands on the pins as many clocks later as its smoothing and overlay take; the synchronisation with it.
pub struct VideoOutput {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Red of the pixel.
    pub r: Signal<In, Word<8>>,
    /// Green of the pixel.
    pub g: Signal<In, Word<8>>,
    /// Blue of the pixel.
    pub b: Signal<In, Word<8>>,
    /// Write a word of the overlay.
    pub overlay_write: Signal<In, Bit>,
    /// Which word.
    pub overlay_address: Signal<In, Word<OVERLAY_BITS>>,
    /// The word.
    pub overlay_data: Signal<In, Word<32>>,
    /// Show the overlay.
    pub overlay_enable: Signal<In, Bit>,
    /// Its colour.
    pub overlay_colour: Signal<In, Word<24>>,
    /// A pixel is wanted.
    pub need: Signal<Out, Bit>,
    /// First of the frame.
    pub start: Signal<Out, Bit>,
    /// First of another line.
    pub line: Signal<Out, Bit>,
    /// Its column.
    pub need_x: Signal<Out, Word<12>>,
    /// Its line.
    pub need_y: Signal<Out, Word<12>>,
    /// The vertical blanking begins.
    pub retrace: Signal<Out, Bit>,
    /// Horizontal synchronisation.
    pub hsync: Signal<Out, Bit>,
    /// Vertical synchronisation.
    pub vsync: Signal<Out, Bit>,
    /// A pixel is shown.
    pub de: Signal<Out, Bit>,
    /// Red.
    pub red: Signal<Out, Word<8>>,
    /// Green.
    pub green: Signal<Out, Word<8>>,
    /// Blue.
    pub blue: Signal<Out, Word<8>>,
    timing: VideoTiming,
    filters: Vec<PostFilter<LINE_BITS>>,
    queues: Vec<PixelFifo<12, 13, 24, 25>>,
    overlays: Vec<Overlay<OVERLAY_BITS>>,
    come_valid: Vec<WordDelay<Bit>>,
    come_x: Vec<WordDelay<Word<12>>>,
    come_y: Vec<WordDelay<Word<12>>>,
    late_hsync: WordDelay<Bit>,
    late_vsync: WordDelay<Bit>,
    late_de: WordDelay<Bit>,
    smooth_r: Signal<Local, Word<8>>,
    smooth_g: Signal<Local, Word<8>>,
    smooth_b: Signal<Local, Word<8>>,
    shown_r: Signal<Local, Word<8>>,
    shown_g: Signal<Local, Word<8>>,
    shown_b: Signal<Local, Word<8>>,
    filtered_r: Signal<Local, Word<8>>,
    filtered_g: Signal<Local, Word<8>>,
    filtered_b: Signal<Local, Word<8>>,
    filtered: Signal<Local, Word<24>>,
    queued: Signal<Local, Word<24>>,
    kernel: Constant<Word<2>>,
    width: Constant<Word<12>>,
    last_column: Constant<Word<12>>,
    last_row: Constant<Word<12>>,
    black: Constant<Word<8>>,
    green_bit: Constant<Word<8>>,
    red_bit: Constant<Word<8>>,
    _smooth: usize,
    _plain: usize,
    _overlaid: usize,
    _bare: usize,
    _asleep: bool,
}

block! {
    [] VideoOutput []
    inputs { clock, r, g, b, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour }
    parts { need, start, line, need_x, need_y, retrace, hsync, vsync, de, red, green, blue, timing, filters, queues, overlays, come_valid, come_x,
        come_y, late_hsync, late_vsync, late_de, smooth_r, smooth_g, smooth_b, shown_r, shown_g, shown_b, filtered_r, filtered_g, filtered_b, filtered, queued, kernel, width, last_column, last_row,
        black, green_bit, red_bit }
    data { _smooth, _plain, _overlaid, _bare }
}

impl VideoOutput {
    /// The end of a machine whose pixels come `source` clocks after they are wanted.
    ///
    /// # Panics
    ///
    /// When a number of the mode is out of its range, or the machine is longer than the vertical blanking.
    pub fn new(shape: &OutputShape, source: usize) -> Self {
        let smooth = shape.kernel.min(1);
        let overlaid = usize::from(shape.has_overlay);
        let pixels = shape.width() * shape.height();
        let words = pixels
            .div_ceil(32)
            .next_power_of_two()
            .trailing_zeros()
            .max(1) as usize;
        let behind = Self::latency(shape);
        fields! {
            [clock, r, g, b, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour, need, start, line, need_x, need_y, retrace,
                hsync, vsync, de, red, green, blue, smooth_r, smooth_g, smooth_b, shown_r, shown_g, shown_b, filtered_r, filtered_g, filtered_b, filtered, queued]
            timing: VideoTiming::new(&shape.mode, source + shape.smoothing()),
            filters: repeat(smooth, PostFilter::new),
            queues: repeat(smooth, || PixelFifo::new(1)),
            overlays: repeat(overlaid, || Overlay::of_address_bits(words)),
            come_valid: repeat(smooth, || WordDelay::new(source)),
            come_x: repeat(smooth, || WordDelay::new(source)),
            come_y: repeat(smooth, || WordDelay::new(source)),
            late_hsync: WordDelay::new(behind),
            late_vsync: WordDelay::new(behind),
            late_de: WordDelay::new(behind),
            kernel: constant(shape.kernel as u64),
            width: constant(shape.width() as u64),
            last_column: constant(shape.width() as u64 - 1),
            last_row: constant(shape.height() as u64 - 1),
            black: constant(0),
            green_bit: constant(8),
            red_bit: constant(16),
            _smooth: smooth,
            _plain: 1 - smooth,
            _overlaid: overlaid,
            _bare: 1 - overlaid,
        }
    }

    /// Clocks from the scan to the pins.
    pub fn latency(shape: &OutputShape) -> usize {
        if shape.has_overlay {
            Overlay::<OVERLAY_BITS>::latency()
        } else {
            0
        }
    }
}

impl Logic for VideoOutput {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("video_output");
        clock!(self, clock, timing, late_hsync, late_vsync, late_de);
        self.timing.enable.next = true;
        self.need.next = self.timing.need.val();
        self.start.next = self.timing.go.val();
        self.line.next = self.timing.need_line.val();
        self.need_x.next = self.timing.need_x.val();
        self.need_y.next = self.timing.need_y.val();
        self.retrace.next = self.timing.frame_start.val();
        for _i in 0..self._plain {
            self.filtered_r.next = self.r.val();
            self.filtered_g.next = self.g.val();
            self.filtered_b.next = self.b.val();
        }
        for i in 0..self._smooth {
            self.come_valid[i].clock.next = self.clock.val();
            self.come_valid[i].word.next = self.timing.need.val();
            self.come_x[i].clock.next = self.clock.val();
            self.come_x[i].word.next = self.timing.need_x.val();
            self.come_y[i].clock.next = self.clock.val();
            self.come_y[i].word.next = self.timing.need_y.val();
            self.filters[i].clock.next = self.clock.val();
            self.filters[i].kernel.next = self.kernel.val();
            self.filters[i].valid.next = self.come_valid[i].late.val();
            self.filters[i].x.next = self.come_x[i].late.val();
            self.filters[i].y.next = self.come_y[i].late.val();
            self.filters[i].line_end.next = self.come_x[i].late.val() == self.last_column.val();
            self.filters[i].last.next = (self.come_x[i].late.val() == self.last_column.val())
                & (self.come_y[i].late.val() == self.last_row.val());
            self.filters[i].r.next = self.r.val();
            self.filters[i].g.next = self.g.val();
            self.filters[i].b.next = self.b.val();
            self.filtered_r.next = self.filters[i].out_r.val();
            self.filtered_g.next = self.filters[i].out_g.val();
            self.filtered_b.next = self.filters[i].out_b.val();
        }
        self.filtered.next = bit_cast::<24, 8>(self.filtered_b.val())
            | (bit_cast::<24, 8>(self.filtered_g.val()) << self.green_bit.val())
            | (bit_cast::<24, 8>(self.filtered_r.val()) << self.red_bit.val());
        for _i in 0..self._plain {
            self.queued.next = self.filtered.val();
        }
        for i in 0..self._smooth {
            // The last line of a picture leaves the filter early; the queue keeps it until it is shown.
            self.queues[i].clock.next = self.clock.val();
            self.queues[i].started.next = self.filters[i].out_valid.val();
            self.queues[i].push.next = self.filters[i].out_valid.val();
            self.queues[i].data.next = self.filtered.val();
            self.queues[i].last.next = self.filters[i].out_last.val();
            self.queues[i].m_tready.next = self.timing.de.val();
            self.queued.next = self.queues[i].m_tdata.val();
        }
        self.smooth_b.next = self.queued.val().get_bits::<8>(0);
        self.smooth_g.next = self
            .queued
            .val()
            .get_bits::<8>(self.green_bit.val().index());
        self.smooth_r.next = self.queued.val().get_bits::<8>(self.red_bit.val().index());
        for _i in 0..self._bare {
            self.shown_r.next = self.smooth_r.val();
            self.shown_g.next = self.smooth_g.val();
            self.shown_b.next = self.smooth_b.val();
        }
        for i in 0..self._overlaid {
            self.overlays[i].clock.next = self.clock.val();
            self.overlays[i].write.next = self.overlay_write.val();
            self.overlays[i].write_address.next = self.overlay_address.val();
            self.overlays[i].write_data.next = self.overlay_data.val();
            self.overlays[i].enable.next = self.overlay_enable.val();
            self.overlays[i].colour.next = self.overlay_colour.val();
            self.overlays[i].width.next = self.width.val();
            self.overlays[i].valid.next = self.timing.de.val();
            self.overlays[i].x.next = self.timing.x.val();
            self.overlays[i].y.next = self.timing.y.val();
            self.overlays[i].r.next = self.smooth_r.val();
            self.overlays[i].g.next = self.smooth_g.val();
            self.overlays[i].b.next = self.smooth_b.val();
            self.shown_r.next = self.overlays[i].out_r.val();
            self.shown_g.next = self.overlays[i].out_g.val();
            self.shown_b.next = self.overlays[i].out_b.val();
        }
        self.late_hsync.word.next = self.timing.hsync.val();
        self.late_vsync.word.next = self.timing.vsync.val();
        self.late_de.word.next = self.timing.de.val();
        self.hsync.next = self.late_hsync.late.val();
        self.vsync.next = self.late_vsync.late.val();
        self.de.next = self.late_de.late.val();
        if self.late_de.late.val() {
            self.red.next = self.shown_r.val();
            self.green.next = self.shown_g.val();
            self.blue.next = self.shown_b.val();
        } else {
            self.red.next = self.black.val();
            self.green.next = self.black.val();
            self.blue.next = self.black.val();
        }
    }
}

clocked!(VideoOutput);
