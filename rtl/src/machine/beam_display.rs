//! Beam machine with its loader, shading and the pins of a screen.

use super::frame_loader::FrameLoader;
use super::object_array::ObjectArray;
use super::shading_processor::ShadingProcessor;
use super::video_output::{OVERLAY_BITS, OutputShape, VideoOutput};
use super::volume_array::VolumeArray;
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;
use crate::unit::delay::{FlagDelay, WordDelay};

/// How many processors of what kind a beam machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BeamShape {
    /// Object processors, one for each object.
    pub objects: usize,
    /// Cut planes of each.
    pub planes: usize,
    /// Volume processors, one for each shadow or light volume; may be none.
    pub volumes: usize,
    /// Planes of each.
    pub volume_planes: usize,
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Bits of the address of a word that waits for the vertical blanking.
    pub loader_bits: usize,
}

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
    objects: ObjectArray<W, W1, S, F, P>,
    volumes: Vec<VolumeArray<W, W1, S, F, P>>,
    volume_flags: Vec<FlagDelay>,
    volume_x: Vec<WordDelay<Word<12>>>,
    volume_y: Vec<WordDelay<Word<12>>>,
    materials: BlockMemory<12, 8>,
    shading: ShadingProcessor<W>,
    screen: VideoOutput,
    late_valid: WordDelay<Bit>,
    late_x: WordDelay<Word<12>>,
    late_y: WordDelay<Word<12>>,
    late_depth: WordDelay<Int<W>>,
    late_nx: WordDelay<Int<16>>,
    late_ny: WordDelay<Int<16>>,
    late_nz: WordDelay<Int<16>>,
    late_material: WordDelay<Word<8>>,
    word_address: Signal<Local, Word<8>>,
    source_flags: Signal<Local, Word<16>>,
    all_sources: Constant<Word<16>>,
    _lit: usize,
    _dark: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] BeamDisplay [W, W1, S, F, P]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour }
    parts { s_tready, swapped, refused, hsync, vsync, de, red, green, blue, loader, objects, volumes, volume_flags, volume_x, volume_y, materials, shading, screen, late_valid,
        late_x, late_y, late_depth, late_nx, late_ny, late_nz, late_material, word_address, source_flags, all_sources }
    data { _lit, _dark }
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
        let rows = shape.rows_per_stage;
        let lit = shape.volumes.min(1);
        let drawn = ObjectArray::<W, W1, S, F, P>::latency(shape.objects, shape.planes, rows);
        let volume_start = drawn - VolumeArray::<W, W1, S, F, P>::depth_offset(rows);
        let decided = Self::decided(shape);
        let source = Self::source(shape);
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, overlay_write, overlay_address, overlay_data, overlay_enable, overlay_colour, s_tready, swapped, refused, hsync, vsync, de, red, green, blue, word_address, source_flags]
            loader: FrameLoader::new(shape.loader_bits),
            objects: ObjectArray::new(shape.objects, shape.planes, rows, false),
            volumes: repeat(lit, || VolumeArray::new(shape.volumes, shape.volume_planes, rows)),
            volume_flags: repeat(lit, || FlagDelay::new(volume_start)),
            volume_x: repeat(lit, || WordDelay::new(volume_start)),
            volume_y: repeat(lit, || WordDelay::new(volume_start)),
            materials: BlockMemory::of_address_bits(8),
            shading: ShadingProcessor::new(lights),
            screen: VideoOutput::new(output, source),
            late_valid: WordDelay::new(decided - drawn),
            late_x: WordDelay::new(decided),
            late_y: WordDelay::new(decided),
            late_depth: WordDelay::new(decided - drawn),
            late_nx: WordDelay::new(decided - drawn),
            late_ny: WordDelay::new(decided - drawn),
            late_nz: WordDelay::new(decided - drawn),
            late_material: WordDelay::new(decided - drawn - 1),
            all_sources: constant(0xffff),
            _lit: lit,
            _dark: 1 - lit,
        }
    }

    /// Clocks from a wanted pixel to what the shading processor is told of it.
    fn decided(shape: &BeamShape) -> usize {
        let rows = shape.rows_per_stage;
        let drawn = ObjectArray::<W, W1, S, F, P>::latency(shape.objects, shape.planes, rows);
        if shape.volumes == 0 {
            return drawn + 1;
        }
        drawn - VolumeArray::<W, W1, S, F, P>::depth_offset(rows)
            + VolumeArray::<W, W1, S, F, P>::latency(shape.volumes, rows)
    }

    /// Clocks from a wanted pixel to its colour.
    pub fn source(shape: &BeamShape) -> usize {
        Self::decided(shape) + ShadingProcessor::<W>::latency()
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for BeamDisplay<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("beam_display");
        clock!(
            self,
            clock,
            loader,
            objects,
            materials,
            shading,
            screen,
            late_valid,
            late_x,
            late_y,
            late_depth,
            late_nx,
            late_ny,
            late_nz,
            late_material
        );
        self.loader.s_tvalid.next = self.s_tvalid.val();
        self.loader.s_tdest.next = self.s_tdest.val();
        self.loader.s_tuser.next = self.s_tuser.val();
        self.loader.s_tdata.next = self.s_tdata.val();
        self.loader.s_tlast.next = self.s_tlast.val();
        self.loader.retrace.next = self.screen.retrace.val();
        self.s_tready.next = self.loader.s_tready.val();
        self.swapped.next = self.loader.take.val();
        self.refused.next = self.loader.refused.val();
        self.word_address.next = self.loader.load_address.val().get_bits::<8>(0);
        self.objects.valid.next = self.screen.need.val();
        self.objects.start.next = self.screen.start.val();
        self.objects.line.next = self.screen.line.val();
        self.objects.x.next = self.screen.need_x.val();
        self.objects.y.next = self.screen.need_y.val();
        self.objects.take.next = self.loader.take.val();
        self.objects.load_valid.next = self.loader.load_object.val();
        self.objects.load_object.next = self.loader.load_unit.val();
        self.objects.load_address.next = self.word_address.val();
        self.objects.load_data.next = self.loader.load_data.val();
        self.materials.write.next = self.loader.load_material.val();
        self.materials.write_address.next = self.loader.load_address.val().get_bits::<12>(0);
        self.materials.write_data.next = self.loader.load_data.val().get_bits::<8>(0);
        self.materials.read_address.next = self.objects.id.val();
        self.late_material.word.next = self.materials.read_data.val();
        self.late_valid.word.next = self.objects.out_valid.val();
        self.late_depth.word.next = self.objects.depth.val();
        self.late_nx.word.next = self.objects.nx.val();
        self.late_ny.word.next = self.objects.ny.val();
        self.late_nz.word.next = self.objects.nz.val();
        self.late_x.word.next = self.screen.need_x.val();
        self.late_y.word.next = self.screen.need_y.val();
        for _i in 0..self._dark {
            self.source_flags.next = self.all_sources.val();
        }
        for i in 0..self._lit {
            self.volume_flags[i].clock.next = self.clock.val();
            self.volume_flags[i].valid.next = self.screen.need.val();
            self.volume_flags[i].start.next = self.screen.start.val();
            self.volume_flags[i].line.next = self.screen.line.val();
            self.volume_x[i].clock.next = self.clock.val();
            self.volume_x[i].word.next = self.screen.need_x.val();
            self.volume_y[i].clock.next = self.clock.val();
            self.volume_y[i].word.next = self.screen.need_y.val();
            self.volumes[i].clock.next = self.clock.val();
            self.volumes[i].valid.next = self.volume_flags[i].late_valid.val();
            self.volumes[i].start.next = self.volume_flags[i].late_start.val();
            self.volumes[i].line.next = self.volume_flags[i].late_line.val();
            self.volumes[i].x.next = self.volume_x[i].late.val();
            self.volumes[i].y.next = self.volume_y[i].late.val();
            self.volumes[i].depth.next = self.objects.depth.val();
            self.volumes[i].flags_in.next = self.all_sources.val();
            self.volumes[i].take.next = self.loader.take.val();
            self.volumes[i].load_valid.next = self.loader.load_volume.val();
            self.volumes[i].load_volume.next = self.loader.load_unit.val();
            self.volumes[i].load_address.next = self.word_address.val();
            self.volumes[i].load_data.next = self.loader.load_data.val();
            self.source_flags.next = self.volumes[i].source_flags.val();
        }
        self.shading.load_valid.next = self.loader.load_shading.val();
        self.shading.load_address.next = self.loader.load_address.val();
        self.shading.load_data.next = self.loader.load_data.val().get_bits::<32>(0);
        self.shading.valid.next = self.late_valid.late.val();
        self.shading.x.next = self.late_x.late.val();
        self.shading.y.next = self.late_y.late.val();
        self.shading.material.next = self.late_material.late.val();
        self.shading.flags.next = self.source_flags.val();
        self.shading.depth.next = self.late_depth.late.val();
        self.shading.nx.next = self.late_nx.late.val();
        self.shading.ny.next = self.late_ny.late.val();
        self.shading.nz.next = self.late_nz.late.val();
        self.screen.r.next = self.shading.red.val();
        self.screen.g.next = self.shading.green.val();
        self.screen.b.next = self.shading.blue.val();
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
