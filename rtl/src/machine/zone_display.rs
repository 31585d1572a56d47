//! Zone machine with a frame store and the pins of a screen.

use super::frame_store::FrameStore;
use super::video_output::{OVERLAY_BITS, OutputShape, VideoOutput};
use super::zone_core::ZoneShape;
use super::zone_machine::ZoneMachine;
use crate::kernel::*;

/// Bits of the address of a pixel of the screen at most.
pub const SCREEN_BITS: usize = 22;

/// A zone machine whose pixels are kept in one of two frames while the other is shown.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge, the pixel clock |
/// | `s_tvalid`, `s_tready`, `s_tdest`, `s_tuser`, `s_tdata` | in, out | command stream, as for the zone control |
/// | `overlay_write`, `overlay_address`, `overlay_data`, `overlay_enable`, `overlay_colour` | in | as for the video output; ignored without an overlay |
/// | `hsync`, `vsync`, `de`, `red`, `green`, `blue` | out | the pins |
/// | `swapped` | out | a new frame is shown from the next picture on |
///
/// The frames change places in the vertical blanking after the last pixel of a frame came in; until then the old one is shown again.
pub struct ZoneDisplay<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// A beat is there.
    pub s_tvalid: Signal<In, Bit>,
    /// What it carries.
    pub s_tdest: Signal<In, Word<4>>,
    /// Unit and address.
    pub s_tuser: Signal<In, Word<24>>,
    /// Data.
    pub s_tdata: Signal<In, Word<F>>,
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
    /// The beat is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A new frame is shown.
    pub swapped: Signal<Out, Bit>,
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
    machine: ZoneMachine<W, W1, S, F, P>,
    frames: FrameStore<SCREEN_BITS>,
    screen: VideoOutput,
    width: Constant<Word<12>>,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] ZoneDisplay [W, W1, S, F, P]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour }
    parts { s_tready, swapped, hsync, vsync, de, red, green, blue, machine, frames, screen, width }
    data { }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    ZoneDisplay<W, W1, S, F, P>
{
    /// A machine of a shape with `lights` lights, and its screen.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a number is out of range.
    pub fn new(shape: &ZoneShape, lights: usize, output: &OutputShape) -> Self {
        let pixels = output.width() * output.height();
        let bits = pixels.next_power_of_two().trailing_zeros() as usize;
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour, s_tready, swapped, hsync, vsync, de, red, green, blue]
            machine: ZoneMachine::new(shape, lights),
            frames: FrameStore::of_address_bits(bits),
            screen: VideoOutput::new(output, FrameStore::<SCREEN_BITS>::latency()),
            width: constant(output.width() as u64),
        }
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for ZoneDisplay<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("zone_display");
        clock!(self, clock, machine, frames, screen);
        self.machine.s_tvalid.next = self.s_tvalid.val();
        self.machine.s_tdest.next = self.s_tdest.val();
        self.machine.s_tuser.next = self.s_tuser.val();
        self.machine.s_tdata.next = self.s_tdata.val();
        self.s_tready.next = self.machine.s_tready.val();
        self.frames.width.next = self.width.val();
        self.frames.s_tvalid.next = self.machine.m_tvalid.val();
        self.frames.s_tdata.next = self.machine.m_tdata.val();
        self.frames.s_tuser.next = self.machine.m_tuser.val();
        self.frames.s_tlast.next = self.machine.m_tlast.val();
        self.machine.m_tready.next = self.frames.s_tready.val();
        self.frames.retrace.next = self.screen.retrace.val();
        self.frames.need.next = self.screen.need.val();
        self.frames.x.next = self.screen.need_x.val();
        self.frames.y.next = self.screen.need_y.val();
        self.screen.r.next = self.frames.r.val();
        self.screen.g.next = self.frames.g.val();
        self.screen.b.next = self.frames.b.val();
        self.screen.overlay_write.next = self.overlay_write.val();
        self.screen.overlay_address.next = self.overlay_address.val();
        self.screen.overlay_data.next = self.overlay_data.val();
        self.screen.overlay_enable.next = self.overlay_enable.val();
        self.screen.overlay_colour.next = self.overlay_colour.val();
        self.swapped.next = self.frames.swapped.val();
        self.hsync.next = self.screen.hsync.val();
        self.vsync.next = self.screen.vsync.val();
        self.de.next = self.screen.de.val();
        self.red.next = self.screen.red.val();
        self.green.next = self.screen.green.val();
        self.blue.next = self.screen.blue.val();
    }
}

clocked!(ZoneDisplay<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
