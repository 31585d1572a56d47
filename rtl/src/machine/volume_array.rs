//! Shadow and light volumes side by side, with their words and the shadow stage.

use super::shadow_stage::ShadowStage;
use super::volume_store::VolumeStore;
use crate::kernel::*;
use crate::object::quadric_volume::QuadricVolume;
use crate::unit::delay::WordDelay;

/// Takes away the flags of the sources that do not reach the visible point, for as many volumes as there are processors.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line`, `x`, `y` | in | raster flags and pixel |
/// | `depth` | in | `W` bits, visible depth, `ceil(W / rows_per_stage) + 1` clocks after the flags of its pixel |
/// | `flags_in` | in | 16 bits, flags before these volumes, `ceil(W / rows_per_stage) + 4` clocks after the flags of the raster |
/// | `take` | in | before the first flags of a pass: the words loaded become those of the volumes |
/// | `load_valid`, `load_volume`, `load_address`, `load_data` | in | write a word, as for the volume store |
/// | `out_valid` | out | this clock carries a result |
/// | `source_flags` | out | 16 bits |
///
/// Latency `ceil(W / rows_per_stage) + 4` and that of the shadow stage, 1 for up to 8 volumes.
pub struct VolumeArray<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// Visible depth.
    pub depth: Signal<In, Int<W>>,
    /// Flags before these volumes.
    pub flags_in: Signal<In, Word<16>>,
    /// Begin a pass.
    pub take: Signal<In, Bit>,
    /// Write a word.
    pub load_valid: Signal<In, Bit>,
    /// Volume of the word.
    pub load_volume: Signal<In, Word<8>>,
    /// Address of the word.
    pub load_address: Signal<In, Word<8>>,
    /// The word.
    pub load_data: Signal<In, Word<F>>,
    /// This clock carries a result.
    pub out_valid: Signal<Out, Bit>,
    /// Flags after these volumes.
    pub source_flags: Signal<Out, Word<16>>,
    stores: Vec<VolumeStore<W, S, F, P>>,
    volumes: Vec<QuadricVolume<W, W1, S, F, P>>,
    stage: ShadowStage,
    valid_delay: WordDelay<Bit>,
    place: Vec<Constant<Word<8>>>,
    _volumes: usize,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] VolumeArray [W, W1, S, F, P]
    inputs { clock, valid, start, line, x, y, depth, flags_in, take, load_valid, load_volume, load_address, load_data }
    parts { out_valid, source_flags, stores, volumes, stage, valid_delay, place }
    data { _volumes, _planes }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    VolumeArray<W, W1, S, F, P>
{
    /// `volumes` processors of `planes` planes, with `rows_per_stage` rows between the registers of their root networks.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a count is out of range.
    pub fn new(volumes: usize, planes: usize, rows_per_stage: usize) -> Self {
        fields! {
            [clock, valid, start, line, x, y, depth, flags_in, take, load_valid, load_volume, load_address, load_data, out_valid, source_flags]
            stores: repeat(volumes, || VolumeStore::new(planes)),
            volumes: repeat(volumes, || QuadricVolume::new(planes, rows_per_stage)),
            stage: ShadowStage::new(volumes),
            valid_delay: WordDelay::new(ShadowStage::latency(volumes)),
            place: (0..volumes as u64).map(constant).collect(),
            _volumes: volumes,
            _planes: planes,
        }
    }

    /// Clocks from the flags of the raster to those of the sources.
    pub const fn latency(volumes: usize, rows_per_stage: usize) -> usize {
        QuadricVolume::<W, W1, S, F, P>::latency(rows_per_stage) + ShadowStage::latency(volumes)
    }

    /// Clocks from the flags of the raster to the visible depth.
    pub const fn depth_offset(rows_per_stage: usize) -> usize {
        W.div_ceil(rows_per_stage) + 1
    }

    /// Clocks from the flags of the raster to those before these volumes.
    pub const fn flags_offset(rows_per_stage: usize) -> usize {
        QuadricVolume::<W, W1, S, F, P>::latency(rows_per_stage)
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for VolumeArray<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("volume_array");
        clock!(self, clock, stage, valid_delay);
        for i in 0..self._volumes {
            self.stores[i].clock.next = self.clock.val();
            self.stores[i].take.next = self.take.val();
            self.stores[i].write.next =
                self.load_valid.val() & (self.load_volume.val() == self.place[i].val());
            self.stores[i].address.next = self.load_address.val();
            self.stores[i].data.next = self.load_data.val();
            self.volumes[i].clock.next = self.clock.val();
            self.volumes[i].valid.next = self.valid.val();
            self.volumes[i].start.next = self.start.val();
            self.volumes[i].line.next = self.line.val();
            self.volumes[i].x.next = self.x.val();
            self.volumes[i].y.next = self.y.val();
            self.volumes[i].depth.next = self.depth.val();
            self.volumes[i].f1_a.next = self.stores[i].f1_a.val();
            self.volumes[i].f1_b.next = self.stores[i].f1_b.val();
            self.volumes[i].f1_c.next = self.stores[i].f1_c.val();
            self.volumes[i].f2_a2.next = self.stores[i].f2_a2.val();
            self.volumes[i].f2_b2.next = self.stores[i].f2_b2.val();
            self.volumes[i].f2_c.next = self.stores[i].f2_c.val();
            self.volumes[i].f2_i0.next = self.stores[i].f2_i0.val();
            self.volumes[i].f2_p0.next = self.stores[i].f2_p0.val();
            self.volumes[i].f2_f.next = self.stores[i].f2_f.val();
            self.volumes[i].box_x0.next = self.stores[i].box_x0.val();
            self.volumes[i].box_x1.next = self.stores[i].box_x1.val();
            self.volumes[i].box_y0.next = self.stores[i].box_y0.val();
            self.volumes[i].box_y1.next = self.stores[i].box_y1.val();
            self.volumes[i].object_class.next = self.stores[i].object_class.val();
            self.volumes[i].depth_shift.next = self.stores[i].depth_shift.val();
            self.volumes[i].margin.next = self.stores[i].margin.val();
            for j in 0..self._planes {
                self.volumes[i].plane_kind[j].next = self.stores[i].plane_kind[j].val();
                self.volumes[i].plane_a[j].next = self.stores[i].plane_a[j].val();
                self.volumes[i].plane_b[j].next = self.stores[i].plane_b[j].val();
                self.volumes[i].plane_c[j].next = self.stores[i].plane_c[j].val();
            }
            self.stage.volume_inside[i].next = self.volumes[i].is_inside.val();
            self.stage.volume_kind[i].next = self.stores[i].is_light.val();
            self.stage.volume_source[i].next = self.stores[i].source.val();
            self.stage.volume_enabled[i].next = self.stores[i].is_present.val();
        }
        self.stage.flags_in.next = self.flags_in.val();
        self.valid_delay.word.next = self.volumes[0].out_valid.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.source_flags.next = self.stage.flags.val();
    }
}

clocked!(VolumeArray<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
