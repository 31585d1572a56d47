//! Beam machine with its loader, shading and the pins of a screen.

use super::beam_core::{BeamCore, BeamShape};
use super::frame_loader::FrameLoader;
use super::video_output::{OVERLAY_BITS, OutputShape, VideoOutput};
use crate::kernel::*;

/// Draws every pixel on the clock on which the screen wants it: a processor for each object and each volume, the decider, the shadow stage, the shading
/// processor; no frame memory.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge, the pixel clock |
/// | `s_tvalid`, `s_tready`, `s_tdest`, `s_tuser`, `s_tdata`, `s_tlast` | in, out | words of the next frame, as for the frame loader |
/// | `overlay_write`, `overlay_address`, `overlay_data`, `overlay_enable`, `overlay_colour` | in | as for the video output; ignored without an overlay |
/// | `hsync`, `vsync`, `de`, `red`, `green`, `blue` | out | the pins |
/// | `swapped` | out | the words of a new frame are at work |
/// | `refused` | out | a frame had more words than the loader keeps |
///
/// The id of an object is the number of its processor. The words of an object stay until they are written again; a volume takes part in a frame if its control word
/// is among the words of the frame.
pub struct BeamDisplay<
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
    /// Last word of the frame.
    pub s_tlast: Signal<In, Bit>,
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
    /// The word is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A new frame is at work.
    pub swapped: Signal<Out, Bit>,
    /// A frame was too long.
    pub refused: Signal<Out, Bit>,
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
    loader: FrameLoader<F>,
    core: BeamCore<W, W1, S, F, P>,
    screen: VideoOutput,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] BeamDisplay [W, W1, S, F, P]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour }
    parts { s_tready, swapped, refused, hsync, vsync, de, red, green, blue, loader, core, screen }
    data { }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    BeamDisplay<W, W1, S, F, P>
{
    /// A machine of a shape with `lights` lights, and its screen.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a number is out of range.
    pub fn new(shape: &BeamShape, lights: usize, output: &OutputShape) -> Self {
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour, s_tready, swapped, refused, hsync, vsync, de, red, green, blue]
            loader: FrameLoader::new(shape.loader_bits),
            core: BeamCore::new(shape, lights),
            screen: VideoOutput::new(output, BeamCore::<W, W1, S, F, P>::latency(shape)),
        }
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for BeamDisplay<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("beam_display");
        clock!(self, clock, loader, core, screen);
        self.loader.s_tvalid.next = self.s_tvalid.val();
        self.loader.s_tdest.next = self.s_tdest.val();
        self.loader.s_tuser.next = self.s_tuser.val();
        self.loader.s_tdata.next = self.s_tdata.val();
        self.loader.s_tlast.next = self.s_tlast.val();
        self.loader.retrace.next = self.screen.retrace.val();
        self.s_tready.next = self.loader.s_tready.val();
        self.swapped.next = self.loader.take.val();
        self.refused.next = self.loader.refused.val();
        self.core.valid.next = self.screen.need.val();
        self.core.start.next = self.screen.start.val();
        self.core.line.next = self.screen.line.val();
        self.core.x.next = self.screen.need_x.val();
        self.core.y.next = self.screen.need_y.val();
        self.core.load_object.next = self.loader.load_object.val();
        self.core.load_volume.next = self.loader.load_volume.val();
        self.core.load_shading.next = self.loader.load_shading.val();
        self.core.load_material.next = self.loader.load_material.val();
        self.core.load_unit.next = self.loader.load_unit.val();
        self.core.load_address.next = self.loader.load_address.val();
        self.core.load_data.next = self.loader.load_data.val();
        self.core.take.next = self.loader.take.val();
        self.screen.r.next = self.core.red.val();
        self.screen.g.next = self.core.green.val();
        self.screen.b.next = self.core.blue.val();
        self.screen.overlay_write.next = self.overlay_write.val();
        self.screen.overlay_address.next = self.overlay_address.val();
        self.screen.overlay_data.next = self.overlay_data.val();
        self.screen.overlay_enable.next = self.overlay_enable.val();
        self.screen.overlay_colour.next = self.overlay_colour.val();
        self.hsync.next = self.screen.hsync.val();
        self.vsync.next = self.screen.vsync.val();
        self.de.next = self.screen.de.val();
        self.red.next = self.screen.red.val();
        self.green.next = self.screen.green.val();
        self.blue.next = self.screen.blue.val();
    }
}

clocked!(BeamDisplay<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
