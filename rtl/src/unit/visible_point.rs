//! The visible point that volumes are asked about.

use crate::format::far_end;
use crate::kernel::*;

/// Registers the visible depth, and what has to lie behind the beginning of a volume.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `depth` | in | `W` bits, visible depth; `ZMAX` is background |
/// | `margin` | in | `W` bits, unsigned |
/// | `z` | out | `W` bits, the depth |
/// | `entered` | out | `S = W + 2` bits, depth less margin |
/// | `is_surface` | out | not background; one clock later |
///
/// Latency 1.
pub struct VisiblePoint<const W: usize, const S: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Visible depth.
    pub depth: Signal<In, Int<W>>,
    /// Counts behind the beginning.
    pub margin: Signal<In, Word<W>>,
    /// The depth.
    pub z: Signal<Out, Int<W>>,
    /// Depth less margin.
    pub entered: Signal<Out, Int<S>>,
    /// Not background, one clock later.
    pub is_surface: Signal<Out, Bit>,
    wide_depth: Signal<Local, Int<S>>,
    wide_margin: Signal<Local, Word<S>>,
    step: Signal<Local, Int<S>>,
    kept_z: DFF<Int<W>>,
    kept_entered: DFF<Int<S>>,
    kept_surface: DFF<Bit>,
    background: Constant<Int<W>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] VisiblePoint [W, S]
    inputs { clock, depth, margin }
    parts { z, entered, is_surface, wide_depth, wide_margin, step, kept_z, kept_entered,
        kept_surface, background }
    data { }
}

impl<const W: usize, const S: usize> VisiblePoint<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        fields! {
            [clock, depth, margin, z, entered, is_surface, wide_depth, wide_margin, step, kept_z,
                kept_entered, kept_surface]
            background: signed_constant(far_end(W)),
        }
    }
}

impl<const W: usize, const S: usize> Default for VisiblePoint<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for VisiblePoint<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("visible_point");
        clock!(self, clock, kept_z, kept_entered, kept_surface);
        self.wide_depth.next = signed_bit_cast::<S, W>(self.depth.val());
        self.wide_margin.next = bit_cast::<S, W>(self.margin.val());
        self.step.next = signed_cast(self.wide_margin.val());
        self.kept_z.d.next = self.depth.val();
        self.kept_entered.d.next = self.wide_depth.val() - self.step.val();
        self.kept_surface.d.next = self.kept_z.q.val() != self.background.val();
        self.z.next = self.kept_z.q.val();
        self.entered.next = self.kept_entered.q.val();
        self.is_surface.next = self.kept_surface.q.val();
    }
}

clocked!(VisiblePoint<const W: usize, const S: usize>);
