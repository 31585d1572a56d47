//! The part of a zone machine that decides: from the command stream to the visible surface of every pixel.

use super::object_array::ObjectArray;
use super::raster_control::RasterControl;
use super::show_control::ShowControl;
use super::stream_slice::StreamSlice;
use super::volume_array::VolumeArray;
use super::zone_buffer::ZoneBuffer;
use super::zone_control::ZoneControl;
use crate::format::far_end;
use crate::kernel::*;
use crate::unit::delay::WordDelay;

/// Bits of the address of a pixel in a zone, at most.
pub const ZONE_BITS: usize = 14;

/// How many processors of what kind a zone machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ZoneShape {
    /// Object processors.
    pub objects: usize,
    /// Cut planes of each.
    pub planes: usize,
    /// Volume processors; may be none.
    pub volumes: usize,
    /// Planes of each.
    pub volume_planes: usize,
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Bits of the address of a pixel in a zone.
    pub zone_bits: usize,
    /// Samples of a pixel along each side: 1, 2 or 4.
    pub samples: usize,
}

/// Time-shares its processors over the objects and volumes of one zone after another, and hands on what is visible in a finished zone.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `s_tvalid`, `s_tready`, `s_tdest`, `s_tuser`, `s_tdata` | in, out | command stream, as for the zone control |
/// | `room` | in | a pixel started on this clock will find a place behind the shading processor |
/// | `started` | out | a pixel is started on this clock |
/// | `valid` | out | a clock later: its surface is on the ports below |
/// | `x`, `y` | out | 12 bits, its place on the screen |
/// | `depth`, `id`, `nx`, `ny`, `nz` | out | its surface; `ZMAX` is background |
/// | `source_flags` | out | 16 bits, the sources that reach it |
/// | `sample` | out | 6 bits: which sample of the pixel it is, as for the zone control; also of one that is started |
/// | `pass_ends` | out | it is the last pixel of the pass |
/// | `frame_ends` | out | it is the last pixel of the frame |
/// | `load_shading`, `load_material`, `load_address`, `load_data` | out | words of the tables behind the core |
///
/// A drawing pass over a zone of n pixels takes `n` clocks and [`Self::draw_clocks`], a lighting pass `n` and [`Self::light_clocks`], a showing pass `n`
/// and [`Self::SHOW_CLOCKS`], from the clock that takes the command to the first that takes the next.
pub struct ZoneCore<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
{
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
    /// There is room for a pixel.
    pub room: Signal<In, Bit>,
    /// The beat is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A pixel is started.
    pub started: Signal<Out, Bit>,
    /// A pixel is here.
    pub valid: Signal<Out, Bit>,
    /// Its column.
    pub x: Signal<Out, Word<12>>,
    /// Its line.
    pub y: Signal<Out, Word<12>>,
    /// Its depth.
    pub depth: Signal<Out, Int<W>>,
    /// Its object.
    pub id: Signal<Out, Word<12>>,
    /// Its normal, x.
    pub nx: Signal<Out, Int<16>>,
    /// Its normal, y.
    pub ny: Signal<Out, Int<16>>,
    /// Its normal, z.
    pub nz: Signal<Out, Int<16>>,
    /// The sources that reach it.
    pub source_flags: Signal<Out, Word<16>>,
    /// Which sample it is.
    pub sample: Signal<Out, Word<6>>,
    /// It is the last of the pass.
    pub pass_ends: Signal<Out, Bit>,
    /// It is the last of the frame.
    pub frame_ends: Signal<Out, Bit>,
    /// A word for the shading processor.
    pub load_shading: Signal<Out, Bit>,
    /// A material.
    pub load_material: Signal<Out, Bit>,
    /// Its address.
    pub load_address: Signal<Out, Word<16>>,
    /// The word.
    pub load_data: Signal<Out, Word<F>>,
    slice: StreamSlice<F>,
    control: ZoneControl<F>,
    raster: RasterControl,
    objects: ObjectArray<W, W1, S, F, P>,
    volumes: Vec<VolumeArray<W, W1, S, F, P>>,
    zone_buffer: ZoneBuffer<W, P, { ZONE_BITS }>,
    show: ShowControl,
    draw_valid: Signal<Local, Bit>,
    light_valid: Signal<Local, Bit>,
    soon: WordDelay<Bit>,
    depth_soon: Vec<WordDelay<Bit>>,
    flags_soon: Vec<WordDelay<Bit>>,
    draw_end: WordDelay<Bit>,
    light_end: Vec<WordDelay<Bit>>,
    light_ends: Signal<Local, Bit>,
    word_address: Signal<Local, Word<8>>,
    background: Constant<Int<W>>,
    all_sources: Constant<Word<16>>,
    _lit: usize,
    _dark: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] ZoneCore [W, W1, S, F, P]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, room }
    parts { s_tready, started, valid, x, y, depth, id, nx, ny, nz, source_flags, sample, pass_ends, frame_ends, load_shading, load_material, load_address, load_data,
        slice, control, raster, objects, volumes, zone_buffer, show, draw_valid, light_valid, soon, depth_soon, flags_soon, draw_end, light_end, light_ends,
        word_address, background, all_sources }
    data { _lit, _dark }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    ZoneCore<W, W1, S, F, P>
{
    /// Clocks of a showing pass besides its pixels.
    pub const SHOW_CLOCKS: usize = 4;

    /// The core of a shape; a pixel is through the shading processor `drain` clocks after the core has handed it on.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a number of the shape is out of range.
    pub fn new(shape: &ZoneShape, drain: usize) -> Self {
        let rows = shape.rows_per_stage;
        let lit = shape.volumes.min(1);
        let drawn = ObjectArray::<W, W1, S, F, P>::latency(shape.objects, shape.planes, rows);
        let flags = VolumeArray::<W, W1, S, F, P>::latency(shape.volumes.max(1), rows);
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, room, s_tready, started, valid, x, y, depth, id, nx, ny, nz, source_flags, sample, pass_ends, frame_ends,
                load_shading, load_material, load_address, load_data, slice, raster, show, draw_valid, light_valid, light_ends, word_address]
            control: ZoneControl::new(Self::settle_clocks(shape), drain),
            objects: ObjectArray::new(shape.objects, shape.planes, rows, true),
            volumes: repeat(lit, || VolumeArray::new(shape.volumes, shape.volume_planes, rows)),
            zone_buffer: ZoneBuffer::new(shape.zone_bits),
            soon: WordDelay::new(drawn - 1),
            depth_soon: repeat(lit, || WordDelay::new(VolumeArray::<W, W1, S, F, P>::depth_offset(rows) - 1)),
            flags_soon: repeat(lit, || WordDelay::new(VolumeArray::<W, W1, S, F, P>::flags_offset(rows) - 1)),
            draw_end: WordDelay::new(drawn + 1),
            light_end: repeat(lit, || WordDelay::new(flags)),
            background: signed_constant(far_end(W)),
            all_sources: constant(0xffff),
            _lit: lit,
            _dark: 1 - lit,
        }
    }

    /// Clocks from a drawing or lighting command until words of processors are taken again: all processors have started.
    pub fn settle_clocks(shape: &ZoneShape) -> usize {
        let drawn = ObjectArray::<W, W1, S, F, P>::latency(
            shape.objects,
            shape.planes,
            shape.rows_per_stage,
        );
        let flags =
            VolumeArray::<W, W1, S, F, P>::latency(shape.volumes.max(1), shape.rows_per_stage);
        drawn.max(flags) + 3
    }

    /// Clocks of a drawing pass besides its pixels.
    pub const fn draw_clocks(shape: &ZoneShape) -> usize {
        ObjectArray::<W, W1, S, F, P>::latency(shape.objects, shape.planes, shape.rows_per_stage)
            + 4
    }

    /// Clocks of a lighting pass besides its pixels.
    pub const fn light_clocks(shape: &ZoneShape) -> usize {
        match shape.volumes {
            0 => 3,
            volumes => VolumeArray::<W, W1, S, F, P>::latency(volumes, shape.rows_per_stage) + 3,
        }
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for ZoneCore<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("zone_core");
        clock!(
            self,
            clock,
            slice,
            control,
            raster,
            objects,
            zone_buffer,
            show,
            soon,
            draw_end
        );
        self.slice.s_tvalid.next = self.s_tvalid.val();
        self.control.s_tvalid.next = self.slice.m_tvalid.val();
        self.slice.s_tdest.next = self.s_tdest.val();
        self.control.s_tdest.next = self.slice.m_tdest.val();
        self.slice.s_tuser.next = self.s_tuser.val();
        self.control.s_tuser.next = self.slice.m_tuser.val();
        self.slice.s_tdata.next = self.s_tdata.val();
        self.control.s_tdata.next = self.slice.m_tdata.val();
        self.slice.m_tready.next = self.control.s_tready.val();
        self.s_tready.next = self.slice.s_tready.val();
        self.raster.go.next = self.control.go.val();
        self.raster.width.next = self.control.width.val();
        self.raster.height.next = self.control.height.val();
        self.word_address.next = self.control.load_address.val().get_bits::<8>(0);
        // Drawing.
        self.draw_valid.next = self.raster.valid.val() & self.control.is_drawing.val();
        self.objects.valid.next = self.draw_valid.val();
        self.objects.start.next = self.raster.start.val();
        self.objects.line.next = self.raster.line.val();
        self.objects.x.next = self.raster.x.val();
        self.objects.y.next = self.raster.y.val();
        self.objects.take.next = self.control.take_objects.val();
        self.objects.load_valid.next = self.control.load_object.val();
        self.objects.load_object.next = self.control.load_unit.val();
        self.objects.load_address.next = self.word_address.val();
        self.objects.load_data.next = self.control.load_data.val();
        self.soon.word.next = self.draw_valid.val();
        self.draw_end.word.next = self.raster.last.val() & self.control.is_drawing.val();
        self.zone_buffer.begin_pass.next = self.control.begin_pass.val();
        self.zone_buffer.is_first.next = self.control.is_first.val();
        self.zone_buffer.drawn_soon.next = self.soon.late.val();
        self.zone_buffer.drawn.next = self.objects.out_valid.val();
        self.zone_buffer.depth.next = self.objects.depth.val();
        self.zone_buffer.id.next = self.objects.id.val();
        self.zone_buffer.nx.next = self.objects.nx.val();
        self.zone_buffer.ny.next = self.objects.ny.val();
        self.zone_buffer.nz.next = self.objects.nz.val();
        // Lighting.
        self.light_valid.next = self.raster.valid.val() & self.control.is_lighting.val();
        for _i in 0..self._dark {
            self.zone_buffer.depth_soon.next = false;
            self.zone_buffer.flags_soon.next = false;
            self.zone_buffer.lit.next = false;
            self.zone_buffer.lit_flags.next = self.all_sources.val();
            self.light_ends.next = self.raster.last.val() & self.control.is_lighting.val();
        }
        for i in 0..self._lit {
            self.volumes[i].clock.next = self.clock.val();
            self.volumes[i].valid.next = self.light_valid.val();
            self.volumes[i].start.next = self.raster.start.val();
            self.volumes[i].line.next = self.raster.line.val();
            self.volumes[i].x.next = self.raster.x.val();
            self.volumes[i].y.next = self.raster.y.val();
            self.volumes[i].take.next = self.control.take_volumes.val();
            self.volumes[i].load_valid.next = self.control.load_volume.val();
            self.volumes[i].load_volume.next = self.control.load_unit.val();
            self.volumes[i].load_address.next = self.word_address.val();
            self.volumes[i].load_data.next = self.control.load_data.val();
            self.depth_soon[i].clock.next = self.clock.val();
            self.depth_soon[i].word.next = self.light_valid.val();
            self.flags_soon[i].clock.next = self.clock.val();
            self.flags_soon[i].word.next = self.light_valid.val();
            self.light_end[i].clock.next = self.clock.val();
            self.light_end[i].word.next = self.raster.last.val() & self.control.is_lighting.val();
            self.zone_buffer.depth_soon.next = self.depth_soon[i].late.val();
            self.zone_buffer.flags_soon.next = self.flags_soon[i].late.val();
            self.volumes[i].depth.next = self.zone_buffer.seen_depth.val();
            if self.control.is_first.val() {
                self.volumes[i].flags_in.next = self.all_sources.val();
            } else {
                self.volumes[i].flags_in.next = self.zone_buffer.seen_flags.val();
            }
            self.zone_buffer.lit.next = self.volumes[i].out_valid.val();
            self.zone_buffer.lit_flags.next = self.volumes[i].source_flags.val();
            self.light_ends.next = self.light_end[i].late.val();
        }
        // Showing.
        self.show.go.next = self.control.show_go.val();
        self.show.room.next = self.room.val();
        self.show.x0.next = self.control.x0.val();
        self.show.y0.next = self.control.y0.val();
        self.show.width.next = self.control.width.val();
        self.show.height.next = self.control.height.val();
        self.zone_buffer.show_soon.next = self.show.issue.val();
        self.started.next = self.show.issue.val();
        self.valid.next = self.show.valid.val();
        self.x.next = self.show.x.val();
        self.y.next = self.show.y.val();
        if self.control.was_drawn.val() {
            self.depth.next = self.zone_buffer.seen_depth.val();
        } else {
            self.depth.next = self.background.val();
        }
        self.id.next = self.zone_buffer.seen_id.val();
        self.nx.next = self.zone_buffer.seen_nx.val();
        self.ny.next = self.zone_buffer.seen_ny.val();
        self.nz.next = self.zone_buffer.seen_nz.val();
        if self.control.was_lit.val() {
            self.source_flags.next = self.zone_buffer.seen_flags.val();
        } else {
            self.source_flags.next = self.all_sources.val();
        }
        self.sample.next = self.control.sample.val();
        self.pass_ends.next = self.show.is_last.val();
        self.frame_ends.next = self.show.is_last.val() & self.control.is_last_zone.val();
        self.control.pass_ends.next =
            self.draw_end.late.val() | self.light_ends.val() | self.show.ends.val();
        self.load_shading.next = self.control.load_shading.val();
        self.load_material.next = self.control.load_material.val();
        self.load_address.next = self.control.load_address.val();
        self.load_data.next = self.control.load_data.val();
    }
}

clocked!(ZoneCore<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
