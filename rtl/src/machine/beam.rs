//! Beam machine: one image, no frame memory.

use super::coefficient_store::CoefficientStore;
use super::decider::Decider;
use super::raster_control::RasterControl;
use crate::kernel::*;
use crate::object::quadric_processor::QuadricProcessor;
use crate::unit::delay::WordDelay;

/// Gives the visible surface of up to 256 quadric objects, pixel by pixel: a raster control, a coefficient store and a quadric
/// processor for each object, and the decider.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `go`, `width`, `height` | in | begin a zone, as for the raster control |
/// | `load_valid` | in | write a coefficient word |
/// | `load_object` | in | 8 bits, slot |
/// | `load_address` | in | 8 bits, as for the coefficient store |
/// | `load_data` | in | `F` bits |
/// | `valid` | out | this clock carries a result |
/// | `depth` | out | `W` bits; `ZMAX` is background |
/// | `id` | out | 8 bits, slot of the visible object |
/// | `number` | out | 4 bits, its face |
/// | `nx`, `ny`, `nz` | out | 16 bits, the normal of the face |
///
/// Latency from `go` to the first pixel `1 + (ceil(W / rows_per_stage) + planes + 7) + ceil(log2 objects)`. At equal depth
/// the smaller slot wins. A slot never loaded is absent.
pub struct Beam<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Begin a zone.
    pub go: Signal<In, Bit>,
    /// Pixels of a line.
    pub width: Signal<In, Word<12>>,
    /// Lines of the zone.
    pub height: Signal<In, Word<12>>,
    /// Write a coefficient word.
    pub load_valid: Signal<In, Bit>,
    /// Slot of the word.
    pub load_object: Signal<In, Word<8>>,
    /// Address of the word.
    pub load_address: Signal<In, Word<8>>,
    /// The word.
    pub load_data: Signal<In, Word<F>>,
    /// This clock carries a result.
    pub valid: Signal<Out, Bit>,
    /// Visible depth.
    pub depth: Signal<Out, Int<W>>,
    /// Visible object.
    pub id: Signal<Out, Word<8>>,
    /// Visible face.
    pub number: Signal<Out, Word<4>>,
    /// Normal x.
    pub nx: Signal<Out, Int<16>>,
    /// Normal y.
    pub ny: Signal<Out, Int<16>>,
    /// Normal z.
    pub nz: Signal<Out, Int<16>>,
    /// Raster control.
    pub raster: RasterControl,
    /// Coefficients of each object.
    pub stores: Vec<CoefficientStore<S, F, P>>,
    /// Processor of each object.
    pub processors: Vec<QuadricProcessor<W, W1, S, F, P>>,
    /// Nearest object.
    pub decider: Decider<W>,
    valid_delay: WordDelay<Bit>,
    slot: Vec<Constant<Word<8>>>,
    _objects: usize,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] Beam [W, W1, S, F, P]
    inputs { clock, go, width, height, load_valid, load_object, load_address, load_data }
    parts { valid, depth, id, number, nx, ny, nz, raster, stores, processors, decider,
        valid_delay, slot }
    data { _objects, _planes }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    Beam<W, W1, S, F, P>
{
    /// A machine with `objects` slots of `planes` planes, its root networks with `rows_per_stage` rows between registers.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a count is out of range.
    pub fn new(objects: usize, planes: usize, rows_per_stage: usize) -> Self {
        Self {
            clock: Signal::default(),
            go: Signal::default(),
            width: Signal::default(),
            height: Signal::default(),
            load_valid: Signal::default(),
            load_object: Signal::default(),
            load_address: Signal::default(),
            load_data: Signal::default(),
            valid: Signal::default(),
            depth: Signal::default(),
            id: Signal::default(),
            number: Signal::default(),
            nx: Signal::default(),
            ny: Signal::default(),
            nz: Signal::default(),
            raster: RasterControl::new(),
            stores: repeat(objects, || CoefficientStore::new(planes)),
            processors: repeat(objects, || QuadricProcessor::new(planes, rows_per_stage)),
            decider: Decider::new(objects),
            valid_delay: WordDelay::new(Decider::<W>::latency(objects)),
            slot: (0..objects as u64).map(constant).collect(),
            _objects: objects,
            _planes: planes,
            _asleep: false,
        }
    }

    /// Clocks from `go` to the first pixel.
    pub const fn latency(objects: usize, planes: usize, rows_per_stage: usize) -> usize {
        RasterControl::latency()
            + QuadricProcessor::<W, W1, S, F, P>::latency(planes, rows_per_stage)
            + Decider::<W>::latency(objects)
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for Beam<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("beam");
        clock!(self, clock, raster, decider, valid_delay);
        self.raster.go.next = self.go.val();
        self.raster.width.next = self.width.val();
        self.raster.height.next = self.height.val();
        for i in 0..self._objects {
            self.stores[i].clock.next = self.clock.val();
            self.stores[i].write.next =
                self.load_valid.val() & (self.load_object.val() == self.slot[i].val());
            self.stores[i].address.next = self.load_address.val();
            self.stores[i].data.next = self.load_data.val();
            self.processors[i].clock.next = self.clock.val();
            self.processors[i].valid.next = self.raster.valid.val();
            self.processors[i].start.next = self.raster.start.val();
            self.processors[i].line.next = self.raster.line.val();
            self.processors[i].x.next = self.raster.x.val();
            self.processors[i].y.next = self.raster.y.val();
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
                self.processors[i].plane_a[j].next = self.stores[i].plane_a[j].val();
                self.processors[i].plane_b[j].next = self.stores[i].plane_b[j].val();
                self.processors[i].plane_c[j].next = self.stores[i].plane_c[j].val();
                self.processors[i].plane_nx[j].next = self.stores[i].plane_nx[j].val();
                self.processors[i].plane_ny[j].next = self.stores[i].plane_ny[j].val();
                self.processors[i].plane_nz[j].next = self.stores[i].plane_nz[j].val();
            }
            self.decider.input_depth[i].next = self.processors[i].zf.val();
            self.decider.input_id[i].next = self.slot[i].val();
            self.decider.input_number[i].next = self.processors[i].number.val();
            self.decider.input_nx[i].next = self.processors[i].nx.val();
            self.decider.input_ny[i].next = self.processors[i].ny.val();
            self.decider.input_nz[i].next = self.processors[i].nz.val();
        }
        self.valid_delay.word.next = self.processors[0].out_valid.val();
        self.valid.next = self.valid_delay.late.val();
        self.depth.next = self.decider.depth.val();
        self.id.next = self.decider.id.val();
        self.number.next = self.decider.number.val();
        self.nx.next = self.decider.nx.val();
        self.ny.next = self.decider.ny.val();
        self.nz.next = self.decider.nz.val();
    }
}

clocked!(Beam<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
