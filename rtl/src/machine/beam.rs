//! Beam machine: one image, no frame memory.

use super::coefficient_store::CoefficientStore;
use super::decider::Decider;
use super::raster_control::RasterControl;
use super::slot_shape::SlotShape;
use crate::kernel::*;
use crate::object::quadric_processor::QuadricProcessor;
use crate::unit::delay::{FlagDelay, WordDelay};

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
///
/// A machine fitted to a scene ([`Beam::of_slots`]) has slots of different shapes, the words of its quadric processors, and a load bus of `B` bits.
pub struct Beam<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    const R: usize = W,
    const R2: usize = S,
    const K: usize = W,
    const E1: usize = S,
    const E2: usize = F,
    const N: usize = 16,
    const N1: usize = 15,
    const G: usize = 24,
    const B: usize = F,
> {
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
    pub load_data: Signal<In, Word<B>>,
    /// This clock carries a result.
    pub valid: Signal<Out, Bit>,
    /// Visible depth.
    pub depth: Signal<Out, Int<W>>,
    /// Visible object.
    pub id: Signal<Out, Word<8>>,
    /// Visible face.
    pub number: Signal<Out, Word<4>>,
    /// Normal x.
    pub nx: Signal<Out, Int<N>>,
    /// Normal y.
    pub ny: Signal<Out, Int<N>>,
    /// Normal z.
    pub nz: Signal<Out, Int<N>>,
    /// Raster control.
    pub raster: RasterControl,
    /// Coefficients of each object.
    pub stores: Vec<CoefficientStore<E1, E2, P, N, G, B>>,
    /// Processor of each object.
    pub processors: Vec<QuadricProcessor<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G>>,
    /// Nearest object.
    pub decider: Decider<W, N>,
    valid_delay: WordDelay<Bit>,
    slot: Vec<Constant<Word<8>>>,
    late_flags: Vec<FlagDelay>,
    late_x: Vec<WordDelay<Word<12>>>,
    late_y: Vec<WordDelay<Word<12>>>,
    tap_valid: Vec<Signal<Local, Bit>>,
    tap_start: Vec<Signal<Local, Bit>>,
    tap_line: Vec<Signal<Local, Bit>>,
    tap_x: Vec<Signal<Local, Word<12>>>,
    tap_y: Vec<Signal<Local, Word<12>>>,
    /// For each slot: how many clocks after the raster control it takes the flags.
    tap: Vec<Constant<Word<8>>>,
    /// For each plane of each slot: the slot, and the plane's number in it.
    plane_slot: Vec<Constant<Word<8>>>,
    plane_place: Vec<Constant<Word<8>>>,
    _objects: usize,
    _alike: usize,
    _different: usize,
    _taps: usize,
    _late: usize,
    _planes: usize,
    _all_planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize, const R: usize, const R2: usize, const K: usize, const E1: usize, const E2: usize, const N: usize, const N1: usize, const G: usize, const B: usize]
    Beam [W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G, B]
    inputs { clock, go, width, height, load_valid, load_object, load_address, load_data }
    parts { valid, depth, id, number, nx, ny, nz, raster, stores, processors, decider,
        valid_delay, slot, late_flags, late_x, late_y, tap_valid, tap_start, tap_line, tap_x, tap_y,
        tap, plane_slot, plane_place }
    data { _objects, _alike, _different, _taps, _late, _planes, _all_planes }
}

impl<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    const R: usize,
    const R2: usize,
    const K: usize,
    const E1: usize,
    const E2: usize,
    const N: usize,
    const N1: usize,
    const G: usize,
    const B: usize,
> Beam<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G, B>
{
    /// A machine with `objects` slots of `planes` planes, its root networks with `rows_per_stage` rows between registers.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a count is out of range.
    pub fn new(objects: usize, planes: usize, rows_per_stage: usize) -> Self {
        Self::of_slots(&vec![SlotShape::full(planes); objects], rows_per_stage)
    }

    /// A machine with slots of given shapes. A slot that is shorter than the longest gets the flags later.
    ///
    /// # Panics
    ///
    /// As [`Self::new`].
    pub fn of_slots(slots: &[SlotShape], rows_per_stage: usize) -> Self {
        let objects = slots.len();
        let longest = slots.iter().map(SlotShape::clocks).max().unwrap_or(0);
        let waits = slots.iter().map(|slot| longest - slot.clocks());
        let most = waits.clone().max().unwrap_or(0);
        let are_alike = slots.windows(2).all(|pair| pair[0] == pair[1]);
        let of_each = |count: usize| if are_alike { 0 } else { count };
        let taps = of_each(most + 1);
        let planes = slots.iter().enumerate().flat_map(|(slot, shape)| {
            (0..of_each(shape.planes)).map(move |place| (slot as u64, place as u64))
        });
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
            stores: slots
                .iter()
                .map(|slot| CoefficientStore::new(slot.planes))
                .collect(),
            processors: slots
                .iter()
                .map(|slot| QuadricProcessor::of_shape(slot, rows_per_stage))
                .collect(),
            decider: Decider::new(objects),
            valid_delay: WordDelay::new(<Decider<W, N>>::latency(objects)),
            slot: (0..objects as u64).map(constant).collect(),
            late_flags: repeat(most, || FlagDelay::new(1)),
            late_x: repeat(most, || WordDelay::new(1)),
            late_y: repeat(most, || WordDelay::new(1)),
            tap_valid: repeat(taps, Signal::default),
            tap_start: repeat(taps, Signal::default),
            tap_line: repeat(taps, Signal::default),
            tap_x: repeat(taps, Signal::default),
            tap_y: repeat(taps, Signal::default),
            tap: waits
                .take(of_each(objects))
                .map(|clocks| constant(clocks as u64))
                .collect(),
            plane_slot: planes.clone().map(|(slot, _)| constant(slot)).collect(),
            plane_place: planes.clone().map(|(_, place)| constant(place)).collect(),
            _objects: objects,
            _alike: objects - of_each(objects),
            _different: of_each(objects),
            _taps: taps.min(1),
            _late: most,
            _planes: if are_alike {
                slots.first().map_or(0, |slot| slot.planes)
            } else {
                0
            },
            _all_planes: planes.count(),
            _asleep: false,
        }
    }

    /// Clocks from `go` to the first pixel of a machine of slots: those of the longest.
    pub fn latency_of_slots(slots: &[SlotShape], rows_per_stage: usize) -> usize {
        let clocks = |slot| {
            QuadricProcessor::<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G>::latency_of(
                slot,
                rows_per_stage,
            )
        };
        let longest = slots.iter().map(clocks).max().unwrap_or(0);
        RasterControl::latency() + longest + <Decider<W, N>>::latency(slots.len())
    }

    /// Clocks from `go` to the first pixel.
    pub const fn latency(objects: usize, planes: usize, rows_per_stage: usize) -> usize {
        RasterControl::latency()
            + QuadricProcessor::<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G>::latency(
                planes,
                rows_per_stage,
            )
            + <Decider<W, N>>::latency(objects)
    }
}

impl<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    const R: usize,
    const R2: usize,
    const K: usize,
    const E1: usize,
    const E2: usize,
    const N: usize,
    const N1: usize,
    const G: usize,
    const B: usize,
> Logic for Beam<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G, B>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("beam");
        clock!(self, clock, raster, decider, valid_delay);
        self.raster.go.next = self.go.val();
        self.raster.width.next = self.width.val();
        self.raster.height.next = self.height.val();
        for i in 0..self._alike {
            self.processors[i].valid.next = self.raster.valid.val();
            self.processors[i].start.next = self.raster.start.val();
            self.processors[i].line.next = self.raster.line.val();
            self.processors[i].x.next = self.raster.x.val();
            self.processors[i].y.next = self.raster.y.val();
        }
        for i in 0..self._taps {
            self.tap_valid[i].next = self.raster.valid.val();
            self.tap_start[i].next = self.raster.start.val();
            self.tap_line[i].next = self.raster.line.val();
            self.tap_x[i].next = self.raster.x.val();
            self.tap_y[i].next = self.raster.y.val();
        }
        for i in 0..self._late {
            self.late_flags[i].clock.next = self.clock.val();
            self.late_flags[i].valid.next = self.tap_valid[i].val();
            self.late_flags[i].start.next = self.tap_start[i].val();
            self.late_flags[i].line.next = self.tap_line[i].val();
            self.late_x[i].clock.next = self.clock.val();
            self.late_x[i].word.next = self.tap_x[i].val();
            self.late_y[i].clock.next = self.clock.val();
            self.late_y[i].word.next = self.tap_y[i].val();
            self.tap_valid[i + 1].next = self.late_flags[i].late_valid.val();
            self.tap_start[i + 1].next = self.late_flags[i].late_start.val();
            self.tap_line[i + 1].next = self.late_flags[i].late_line.val();
            self.tap_x[i + 1].next = self.late_x[i].late.val();
            self.tap_y[i + 1].next = self.late_y[i].late.val();
        }
        for i in 0..self._different {
            self.processors[i].valid.next = self.tap_valid[self.tap[i].val().index()].val();
            self.processors[i].start.next = self.tap_start[self.tap[i].val().index()].val();
            self.processors[i].line.next = self.tap_line[self.tap[i].val().index()].val();
            self.processors[i].x.next = self.tap_x[self.tap[i].val().index()].val();
            self.processors[i].y.next = self.tap_y[self.tap[i].val().index()].val();
        }
        for i in 0..self._objects {
            self.stores[i].clock.next = self.clock.val();
            self.stores[i].write.next =
                self.load_valid.val() & (self.load_object.val() == self.slot[i].val());
            self.stores[i].address.next = self.load_address.val();
            self.stores[i].data.next = self.load_data.val();
            self.processors[i].clock.next = self.clock.val();
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
        for i in 0..self._all_planes {
            self.processors[self.plane_slot[i].val().index()].plane_kind
                [self.plane_place[i].val().index()]
            .next = self.stores[self.plane_slot[i].val().index()].plane_kind
                [self.plane_place[i].val().index()]
            .val();
            self.processors[self.plane_slot[i].val().index()].plane_a
                [self.plane_place[i].val().index()]
            .next = self.stores[self.plane_slot[i].val().index()].plane_a
                [self.plane_place[i].val().index()]
            .val();
            self.processors[self.plane_slot[i].val().index()].plane_b
                [self.plane_place[i].val().index()]
            .next = self.stores[self.plane_slot[i].val().index()].plane_b
                [self.plane_place[i].val().index()]
            .val();
            self.processors[self.plane_slot[i].val().index()].plane_c
                [self.plane_place[i].val().index()]
            .next = self.stores[self.plane_slot[i].val().index()].plane_c
                [self.plane_place[i].val().index()]
            .val();
            self.processors[self.plane_slot[i].val().index()].plane_nx
                [self.plane_place[i].val().index()]
            .next = self.stores[self.plane_slot[i].val().index()].plane_nx
                [self.plane_place[i].val().index()]
            .val();
            self.processors[self.plane_slot[i].val().index()].plane_ny
                [self.plane_place[i].val().index()]
            .next = self.stores[self.plane_slot[i].val().index()].plane_ny
                [self.plane_place[i].val().index()]
            .val();
            self.processors[self.plane_slot[i].val().index()].plane_nz
                [self.plane_place[i].val().index()]
            .next = self.stores[self.plane_slot[i].val().index()].plane_nz
                [self.plane_place[i].val().index()]
            .val();
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

clocked!(Beam<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize, const R: usize, const R2: usize, const K: usize, const E1: usize, const E2: usize, const N: usize, const N1: usize, const G: usize, const B: usize>);
