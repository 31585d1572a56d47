//! Is a point of the line of sight inside a quadric.

use crate::format::{FRONT, PRISM, SIDE};
use crate::kernel::*;

/// Says whether the visible point lies inside an unbounded quadric.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `object_class` | in | 2 bits: 0 side, 1 front, 2 patch (has no inside), 3 prism |
/// | `near_sum`, `far_sum` | in | `S = W + 2` bits |
/// | `is_inside` | in | `f2 >= 0` |
/// | `z` | in | `S` bits, visible depth in the unit of the quadric |
/// | `entered` | in | `S` bits, visible depth less the margin, likewise |
/// | `holds` | out | the point is inside |
///
/// Latency 1. Where the quadric begins, `entered` is asked; where it ends, `z`. Sections 3.2.1 and 4.1.3.
pub struct QuadricTest<const W: usize, const S: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Class of the quadric.
    pub object_class: Signal<In, Word<2>>,
    /// Depth of the near root.
    pub near_sum: Signal<In, Int<S>>,
    /// Depth of the far root.
    pub far_sum: Signal<In, Int<S>>,
    /// The discriminant is not negative.
    pub is_inside: Signal<In, Bit>,
    /// Visible depth.
    pub z: Signal<In, Int<S>>,
    /// Visible depth less the margin.
    pub entered: Signal<In, Int<S>>,
    /// The point is inside.
    pub holds: Signal<Out, Bit>,
    between: Signal<Local, Bit>,
    outside: Signal<Local, Bit>,
    kept: DFF<Bit>,
    side: Constant<Word<2>>,
    front: Constant<Word<2>>,
    prism: Constant<Word<2>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] QuadricTest [W, S]
    inputs { clock, object_class, near_sum, far_sum, is_inside, z, entered }
    parts { holds, between, outside, kept, side, front, prism }
    data { }
}

impl<const W: usize, const S: usize> QuadricTest<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        fields! {
            [clock, object_class, near_sum, far_sum, is_inside, z, entered, holds,
                between, outside, kept]
            side: constant(SIDE),
            front: constant(FRONT),
            prism: constant(PRISM),
        }
    }

    /// Clocks from the depths to the answer.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize, const S: usize> Default for QuadricTest<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for QuadricTest<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("quadric_test");
        clock!(self, clock, kept);
        self.between.next =
            (self.near_sum.val() <= self.entered.val()) & (self.z.val() <= self.far_sum.val());
        self.outside.next =
            (self.z.val() <= self.near_sum.val()) | (self.far_sum.val() <= self.entered.val());
        self.kept.d.next = false;
        if self.object_class.val() == self.side.val() {
            self.kept.d.next = self.is_inside.val() & self.between.val();
        }
        if self.object_class.val() == self.front.val() {
            self.kept.d.next = !self.is_inside.val() | self.outside.val();
        }
        if self.object_class.val() == self.prism.val() {
            self.kept.d.next = self.is_inside.val();
        }
        self.holds.next = self.kept.q.val();
    }
}

clocked!(QuadricTest<const W: usize, const S: usize>);
