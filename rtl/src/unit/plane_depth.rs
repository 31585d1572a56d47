//! Depth of a cut plane.

use super::pe1::Pe1;
use crate::format::{far_end, saturated_near};
use crate::kernel::*;

/// Gives the depth of a plane, clamped to `[-2^(W-1), ZMAX]`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `a`, `b`, `c` | in | `P` bits, `W + 12` in the catalogue, two's complement |
/// | `depth` | out | `W` bits, two's complement |
///
/// Latency 2. The lower bound lies one below `ZLOW`, so that a back plane nearer than the near end removes everything;
/// the sign survives, as half-plane values need. Section 2.4.2.
pub struct PlaneDepth<const W: usize, const P: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Increment along the line.
    pub a: Signal<In, Int<P>>,
    /// Increment from line to line.
    pub b: Signal<In, Int<P>>,
    /// Value of the first pixel.
    pub c: Signal<In, Int<P>>,
    /// Clamped depth, or clamped half-plane value.
    pub depth: Signal<Out, Int<W>>,
    /// The unclamped plane, one clock earlier.
    pub plane: Pe1<P>,
    above: Signal<Local, Bit>,
    below: Signal<Local, Bit>,
    clamped: DFF<Int<W>>,
    largest: Constant<Int<P>>,
    smallest: Constant<Int<P>>,
    farthest: Constant<Int<W>>,
    nearest: Constant<Int<W>>,
    _asleep: bool,
}

block! {
    [const W: usize, const P: usize] PlaneDepth [W, P]
    inputs { clock, valid, start, line, a, b, c }
    parts { depth, plane, above, below, clamped, largest, smallest, farthest, nearest }
    data { }
}

impl<const W: usize, const P: usize> PlaneDepth<W, P> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `P` is not in `W..=W + 12`.
    pub fn new() -> Self {
        assert!(
            W <= P && P <= W + 12,
            "a plane has up to 12 bits more than a depth"
        );
        Self {
            clock: Signal::default(),
            valid: Signal::default(),
            start: Signal::default(),
            line: Signal::default(),
            a: Signal::default(),
            b: Signal::default(),
            c: Signal::default(),
            depth: Signal::default(),
            plane: Pe1::default(),
            above: Signal::default(),
            below: Signal::default(),
            clamped: DFF::default(),
            largest: signed_constant(far_end(W)),
            smallest: signed_constant(saturated_near(W)),
            farthest: signed_constant(far_end(W)),
            nearest: signed_constant(saturated_near(W)),
            _asleep: false,
        }
    }

    /// Clocks from the flags to the depth.
    pub const fn latency() -> usize {
        Pe1::<P>::latency() + 1
    }
}

impl<const W: usize, const P: usize> Default for PlaneDepth<W, P> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const P: usize> Logic for PlaneDepth<W, P> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("plane_depth");
        clock!(self, clock, plane, clamped);
        self.plane.valid.next = self.valid.val();
        self.plane.start.next = self.start.val();
        self.plane.line.next = self.line.val();
        self.plane.a.next = self.a.val();
        self.plane.b.next = self.b.val();
        self.plane.c.next = self.c.val();
        self.above.next = self.plane.value.val() > self.largest.val();
        self.below.next = self.plane.value.val() < self.smallest.val();
        if self.above.val() {
            self.clamped.d.next = self.farthest.val();
        } else if self.below.val() {
            self.clamped.d.next = self.nearest.val();
        } else {
            self.clamped.d.next = self.plane.value.val().get_bits::<W>(0);
        }
        self.depth.next = self.clamped.q.val();
    }
}

clocked!(PlaneDepth<const W: usize, const P: usize>);
