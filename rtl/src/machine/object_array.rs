//! Object processors side by side, with their words and the decider.

use super::coefficient_hold::CoefficientHold;
use super::coefficient_store::CoefficientStore;
use super::decider::Decider;
use crate::kernel::*;
use crate::object::quadric_processor::QuadricProcessor;
use crate::unit::delay::WordDelay;

/// Gives, for every pixel, the nearest surface of as many objects as there are processors.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line`, `x`, `y` | in | raster flags and pixel |
/// | `take` | in | begin a pass: the words loaded become those of the objects |
/// | `load_valid`, `load_object`, `load_address`, `load_data` | in | write a coefficient word, as for the beam; address 255 is the id |
/// | `out_valid` | out | this clock carries a result |
/// | `depth`, `id`, `nx`, `ny`, `nz` | out | the nearest surface; at equal depth that of the smaller id |
///
/// Latency `ceil(W / rows_per_stage) + planes + 7 + ceil(log2 objects)`.
///
/// If the words are held (a machine that shares its processors in time), `take` comes before the first flags of a pass, the next words may be loaded
/// once all processors have started, and an object that was not loaded since the last `take` is absent. Otherwise the words act as they are loaded,
/// the id of an object is its place, and `take` does nothing.
pub struct ObjectArray<
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
    /// Begin a pass.
    pub take: Signal<In, Bit>,
    /// Write a coefficient word.
    pub load_valid: Signal<In, Bit>,
    /// Object of the word.
    pub load_object: Signal<In, Word<8>>,
    /// Address of the word.
    pub load_address: Signal<In, Word<8>>,
    /// The word.
    pub load_data: Signal<In, Word<F>>,
    /// This clock carries a result.
    pub out_valid: Signal<Out, Bit>,
    /// Nearest depth.
    pub depth: Signal<Out, Int<W>>,
    /// Nearest object.
    pub id: Signal<Out, Word<12>>,
    /// Normal x.
    pub nx: Signal<Out, Int<16>>,
    /// Normal y.
    pub ny: Signal<Out, Int<16>>,
    /// Normal z.
    pub nz: Signal<Out, Int<16>>,
    write: Vec<Signal<Local, Bit>>,
    stores: Vec<CoefficientStore<S, F, P>>,
    holds: Vec<CoefficientHold<F>>,
    /// Processor of each object.
    pub processors: Vec<QuadricProcessor<W, W1, S, F, P>>,
    decider: Decider<W, 16, 12>,
    valid_delay: WordDelay<Bit>,
    place: Vec<Constant<Word<8>>>,
    own_id: Vec<Constant<Word<12>>>,
    _objects: usize,
    _planes: usize,
    _held: usize,
    _direct: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] ObjectArray [W, W1, S, F, P]
    inputs { clock, valid, start, line, x, y, take, load_valid, load_object, load_address, load_data }
    parts { out_valid, depth, id, nx, ny, nz, write, stores, holds, processors, decider, valid_delay, place, own_id }
    data { _objects, _planes, _held, _direct }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    ObjectArray<W, W1, S, F, P>
{
    /// `objects` processors of `planes` planes, with `rows_per_stage` rows between the registers of their root networks.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a count is out of range.
    pub fn new(objects: usize, planes: usize, rows_per_stage: usize, is_held: bool) -> Self {
        let held = if is_held { objects } else { 0 };
        fields! {
            [clock, valid, start, line, x, y, take, load_valid, load_object, load_address, load_data, out_valid, depth, id, nx, ny, nz]
            write: repeat(objects, Signal::default),
            stores: repeat(objects, || CoefficientStore::new(planes)),
            holds: repeat(held, || CoefficientHold::new(planes)),
            processors: repeat(objects, || QuadricProcessor::new(planes, rows_per_stage)),
            decider: Decider::new(objects),
            valid_delay: WordDelay::new(Decider::<W, 16, 12>::latency(objects)),
            place: (0..objects as u64).map(constant).collect(),
            own_id: (0..(objects - held) as u64).map(constant).collect(),
            _objects: objects,
            _planes: planes,
            _held: held,
            _direct: objects - held,
        }
    }

    /// Clocks from the flags to the nearest surface.
    pub const fn latency(objects: usize, planes: usize, rows_per_stage: usize) -> usize {
        <QuadricProcessor<W, W1, S, F, P>>::latency(planes, rows_per_stage)
            + Decider::<W, 16, 12>::latency(objects)
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for ObjectArray<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("object_array");
        clock!(self, clock, decider, valid_delay);
        for i in 0..self._objects {
            self.write[i].next =
                self.load_valid.val() & (self.load_object.val() == self.place[i].val());
            self.stores[i].clock.next = self.clock.val();
            self.stores[i].write.next = self.write[i].val();
            self.stores[i].address.next = self.load_address.val();
            self.stores[i].data.next = self.load_data.val();
            self.processors[i].clock.next = self.clock.val();
            self.processors[i].valid.next = self.valid.val();
            self.processors[i].start.next = self.start.val();
            self.processors[i].line.next = self.line.val();
            self.processors[i].x.next = self.x.val();
            self.processors[i].y.next = self.y.val();
            self.processors[i].f1_a.next = self.stores[i].f1_a.val();
            self.processors[i].f1_b.next = self.stores[i].f1_b.val();
            self.processors[i].f1_c.next = self.stores[i].f1_c.val();
            self.processors[i].f2_a2.next = self.stores[i].f2_a2.val();
            self.processors[i].f2_b2.next = self.stores[i].f2_b2.val();
            self.processors[i].f2_c.next = self.stores[i].f2_c.val();
            self.processors[i].f2_i0.next = self.stores[i].f2_i0.val();
            self.processors[i].f2_p0.next = self.stores[i].f2_p0.val();
            self.processors[i].f2_f.next = self.stores[i].f2_f.val();
            self.processors[i].gx_a.next = self.stores[i].gx_a.val();
            self.processors[i].gx_b.next = self.stores[i].gx_b.val();
            self.processors[i].gx_c.next = self.stores[i].gx_c.val();
            self.processors[i].gy_a.next = self.stores[i].gy_a.val();
            self.processors[i].gy_b.next = self.stores[i].gy_b.val();
            self.processors[i].gy_c.next = self.stores[i].gy_c.val();
            self.processors[i].gz_a.next = self.stores[i].gz_a.val();
            self.processors[i].gz_b.next = self.stores[i].gz_b.val();
            self.processors[i].gz_c.next = self.stores[i].gz_c.val();
            for j in 0..self._planes {
                self.processors[i].plane_a[j].next = self.stores[i].plane_a[j].val();
                self.processors[i].plane_b[j].next = self.stores[i].plane_b[j].val();
                self.processors[i].plane_c[j].next = self.stores[i].plane_c[j].val();
            }
            self.decider.input_depth[i].next = self.processors[i].zf.val();
            self.decider.input_number[i].next = self.processors[i].number.val();
            self.decider.input_nx[i].next = self.processors[i].nx.val();
            self.decider.input_ny[i].next = self.processors[i].ny.val();
            self.decider.input_nz[i].next = self.processors[i].nz.val();
        }
        for i in 0..self._direct {
            self.processors[i].kx.next = self.stores[i].kx.val();
            self.processors[i].ky.next = self.stores[i].ky.val();
            self.processors[i].kz.next = self.stores[i].kz.val();
            self.processors[i].box_x0.next = self.stores[i].box_x0.val();
            self.processors[i].box_x1.next = self.stores[i].box_x1.val();
            self.processors[i].box_y0.next = self.stores[i].box_y0.val();
            self.processors[i].box_y1.next = self.stores[i].box_y1.val();
            self.processors[i].object_class.next = self.stores[i].object_class.val();
            self.processors[i].shift.next = self.stores[i].shift.val();
            for j in 0..self._planes {
                self.processors[i].plane_kind[j].next = self.stores[i].plane_kind[j].val();
                self.processors[i].plane_nx[j].next = self.stores[i].plane_nx[j].val();
                self.processors[i].plane_ny[j].next = self.stores[i].plane_ny[j].val();
                self.processors[i].plane_nz[j].next = self.stores[i].plane_nz[j].val();
            }
            self.decider.input_id[i].next = self.own_id[i].val();
        }
        for i in 0..self._held {
            self.holds[i].clock.next = self.clock.val();
            self.holds[i].take.next = self.take.val();
            self.holds[i].write.next = self.write[i].val();
            self.holds[i].address.next = self.load_address.val();
            self.holds[i].data.next = self.load_data.val();
            self.holds[i].next_kx.next = self.stores[i].kx.val();
            self.processors[i].kx.next = self.holds[i].kx.val();
            self.holds[i].next_ky.next = self.stores[i].ky.val();
            self.processors[i].ky.next = self.holds[i].ky.val();
            self.holds[i].next_kz.next = self.stores[i].kz.val();
            self.processors[i].kz.next = self.holds[i].kz.val();
            self.holds[i].next_box_x0.next = self.stores[i].box_x0.val();
            self.processors[i].box_x0.next = self.holds[i].box_x0.val();
            self.holds[i].next_box_x1.next = self.stores[i].box_x1.val();
            self.processors[i].box_x1.next = self.holds[i].box_x1.val();
            self.holds[i].next_box_y0.next = self.stores[i].box_y0.val();
            self.processors[i].box_y0.next = self.holds[i].box_y0.val();
            self.holds[i].next_box_y1.next = self.stores[i].box_y1.val();
            self.processors[i].box_y1.next = self.holds[i].box_y1.val();
            self.holds[i].next_object_class.next = self.stores[i].object_class.val();
            self.processors[i].object_class.next = self.holds[i].object_class.val();
            self.holds[i].next_shift.next = self.stores[i].shift.val();
            self.processors[i].shift.next = self.holds[i].shift.val();
            for j in 0..self._planes {
                self.holds[i].next_plane_kind[j].next = self.stores[i].plane_kind[j].val();
                self.processors[i].plane_kind[j].next = self.holds[i].plane_kind[j].val();
                self.holds[i].next_plane_nx[j].next = self.stores[i].plane_nx[j].val();
                self.processors[i].plane_nx[j].next = self.holds[i].plane_nx[j].val();
                self.holds[i].next_plane_ny[j].next = self.stores[i].plane_ny[j].val();
                self.processors[i].plane_ny[j].next = self.holds[i].plane_ny[j].val();
                self.holds[i].next_plane_nz[j].next = self.stores[i].plane_nz[j].val();
                self.processors[i].plane_nz[j].next = self.holds[i].plane_nz[j].val();
            }
            self.decider.input_id[i].next = self.holds[i].id.val();
        }
        self.valid_delay.word.next = self.processors[0].out_valid.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.depth.next = self.decider.depth.val();
        self.id.next = self.decider.id.val();
        self.nx.next = self.decider.nx.val();
        self.ny.next = self.decider.ny.val();
        self.nz.next = self.decider.nz.val();
    }
}

clocked!(ObjectArray<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
