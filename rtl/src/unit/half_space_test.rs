//! Is a point of the line of sight on the kept side of a plane.

use crate::format::{BACK_PLANE, FRONT_PLANE, PERPENDICULAR};
use crate::kernel::*;

/// Says whether the visible point lies on the kept side of a plane.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `kind` | in | 2 bits: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0) |
/// | `zp` | in | `P = W + 12` bits, depth of the plane, not clamped |
/// | `z` | in | `W` bits, visible depth |
/// | `entered` | in | `S = W + 2` bits, visible depth less the margin |
/// | `holds` | out | the point is kept |
///
/// Latency 1. Where a volume begins, `entered` is asked; where it ends, `z`. Sections 3.2.1 and 4.1.3.
pub struct HalfSpaceTest<const W: usize, const S: usize, const P: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Kind of the plane.
    pub kind: Signal<In, Word<2>>,
    /// Depth of the plane.
    pub zp: Signal<In, Int<P>>,
    /// Visible depth.
    pub z: Signal<In, Int<W>>,
    /// Visible depth less the margin.
    pub entered: Signal<In, Int<S>>,
    /// The point is kept.
    pub holds: Signal<Out, Bit>,
    leaving: Signal<Local, Int<P>>,
    entering: Signal<Local, Int<P>>,
    removed: Signal<Local, Bit>,
    kept: DFF<Bit>,
    front: Constant<Word<2>>,
    back: Constant<Word<2>>,
    perpendicular: Constant<Word<2>>,
    sign: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize, const P: usize] HalfSpaceTest [W, S, P]
    inputs { clock, kind, zp, z, entered }
    parts { holds, leaving, entering, removed, kept, front, back, perpendicular, sign }
    data { }
}

impl<const W: usize, const S: usize, const P: usize> HalfSpaceTest<W, S, P> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new() -> Self {
        assert!(
            S == W + 2 && P == W + 12,
            "a depth sum has 2 bits and a plane 12 bits more than a depth"
        );
        fields! {
            [clock, kind, zp, z, entered, holds, leaving, entering, removed, kept]
            front: constant(FRONT_PLANE),
            back: constant(BACK_PLANE),
            perpendicular: constant(PERPENDICULAR),
            sign: constant(P as u64 - 1),
        }
    }

    /// Clocks from the plane to the answer.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize, const S: usize, const P: usize> Default for HalfSpaceTest<W, S, P> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize, const P: usize> Logic for HalfSpaceTest<W, S, P> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("half_space_test");
        clock!(self, clock, kept);
        self.leaving.next = signed_bit_cast::<P, W>(self.z.val());
        self.entering.next = signed_bit_cast::<P, S>(self.entered.val());
        self.removed.next = ((self.kind.val() == self.front.val())
            & (self.entering.val() < self.zp.val()))
            | ((self.kind.val() == self.back.val()) & (self.zp.val() < self.leaving.val()))
            | ((self.kind.val() == self.perpendicular.val())
                & self.zp.val().get_bit(self.sign.val().index()));
        self.kept.d.next = !self.removed.val();
        self.holds.next = self.kept.q.val();
    }
}

clocked!(HalfSpaceTest<const W: usize, const S: usize, const P: usize>);
