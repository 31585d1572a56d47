//! The visible point in the unit of a volume's quadric.

use crate::kernel::*;

/// Registers the visible depth, and what has to lie behind the beginning of a volume, both in units of `2^shift`, rounded down.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `depth` | in | `W` bits, visible depth |
/// | `margin` | in | `W` bits, unsigned |
/// | `depth_shift` | in | 4 bits |
/// | `z` | out | `S = W + 2` bits, `depth >> depth_shift` |
/// | `entered` | out | `S` bits, `(depth - margin) >> depth_shift` |
///
/// Latency 1. A depth of the quadric is at or before another one exactly if it is at or before that one rounded down to its unit.
pub struct CoarsePoint<const W: usize, const S: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Visible depth.
    pub depth: Signal<In, Int<W>>,
    /// Counts behind the beginning.
    pub margin: Signal<In, Word<W>>,
    /// Places the depths are shifted to the right.
    pub depth_shift: Signal<In, Word<4>>,
    /// The depth.
    pub z: Signal<Out, Int<S>>,
    /// Depth less margin.
    pub entered: Signal<Out, Int<S>>,
    wide_depth: Signal<Local, Int<S>>,
    wide_margin: Signal<Local, Word<S>>,
    raised_depth: Signal<Local, Word<S>>,
    raised_entered: Signal<Local, Word<S>>,
    offset: Signal<Local, Word<S>>,
    kept_z: DFF<Int<S>>,
    kept_entered: DFF<Int<S>>,
    top: Constant<Word<S>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] CoarsePoint [W, S]
    inputs { clock, depth, margin, depth_shift }
    parts { z, entered, wide_depth, wide_margin, raised_depth, raised_entered, offset, kept_z,
        kept_entered, top }
    data { }
}

impl<const W: usize, const S: usize> CoarsePoint<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        fields! {
            [clock, depth, margin, depth_shift, z, entered, wide_depth, wide_margin, raised_depth,
                raised_entered, offset, kept_z, kept_entered]
            top: constant(1 << (S - 1)),
        }
    }
}

impl<const W: usize, const S: usize> Default for CoarsePoint<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for CoarsePoint<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("coarse_point");
        clock!(self, clock, kept_z, kept_entered);
        self.wide_depth.next = signed_bit_cast::<S, W>(self.depth.val());
        self.wide_margin.next = bit_cast::<S, W>(self.margin.val());
        // A number raised by half the range of its word is not negative, so that a plain shift rounds it down.
        self.raised_depth.next = unsigned_cast(self.wide_depth.val()) + self.top.val();
        self.raised_entered.next = self.raised_depth.val() - self.wide_margin.val();
        self.offset.next = self.top.val() >> self.depth_shift.val();
        self.kept_z.d.next =
            signed_cast((self.raised_depth.val() >> self.depth_shift.val()) - self.offset.val());
        self.kept_entered.d.next =
            signed_cast((self.raised_entered.val() >> self.depth_shift.val()) - self.offset.val());
        self.z.next = self.kept_z.q.val();
        self.entered.next = self.kept_entered.q.val();
    }
}

clocked!(CoarsePoint<const W: usize, const S: usize>);
