//! What one plane leaves of the two faces of a patch.

use crate::format::{BACK_PLANE, FRONT_PLANE, PERPENDICULAR};
use crate::kernel::*;

/// Says which of the two faces of a bare surface a plane keeps: the source's signals E_F and E_B.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `kind` | in | 2 bits: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0) |
/// | `zp` | in | `W` bits, clamped depth of the plane |
/// | `near_sum`, `far_sum` | in | `S = W + 2` bits, the two faces |
/// | `keeps_near`, `keeps_far` | out | the plane keeps the face |
///
/// Latency 1. A face in the plane is kept. Section 2.4.3.
pub struct PatchPlane<const W: usize, const S: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Kind of the plane.
    pub kind: Signal<In, Word<2>>,
    /// Depth of the plane.
    pub zp: Signal<In, Int<W>>,
    /// Depth of the near root.
    pub near_sum: Signal<In, Int<S>>,
    /// Depth of the far root.
    pub far_sum: Signal<In, Int<S>>,
    /// The plane keeps the near face.
    pub keeps_near: Signal<Out, Bit>,
    /// The plane keeps the far face.
    pub keeps_far: Signal<Out, Bit>,
    plane: Signal<Local, Int<S>>,
    is_front: Signal<Local, Bit>,
    is_back: Signal<Local, Bit>,
    removes_both: Signal<Local, Bit>,
    cuts_near: Signal<Local, Bit>,
    cuts_far: Signal<Local, Bit>,
    kept_near: DFF<Bit>,
    kept_far: DFF<Bit>,
    front: Constant<Word<2>>,
    back: Constant<Word<2>>,
    perpendicular: Constant<Word<2>>,
    sign: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] PatchPlane [W, S]
    inputs { clock, kind, zp, near_sum, far_sum }
    parts { keeps_near, keeps_far, plane, is_front, is_back, removes_both, cuts_near, cuts_far,
        kept_near, kept_far, front, back, perpendicular, sign }
    data { }
}

impl<const W: usize, const S: usize> PatchPlane<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        fields! {
            [clock, kind, zp, near_sum, far_sum, keeps_near, keeps_far, plane, is_front, is_back,
                removes_both, cuts_near, cuts_far, kept_near, kept_far]
            front: constant(FRONT_PLANE),
            back: constant(BACK_PLANE),
            perpendicular: constant(PERPENDICULAR),
            sign: constant(W as u64 - 1),
        }
    }

    /// Clocks from the plane to its signals.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize, const S: usize> Default for PatchPlane<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for PatchPlane<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("patch_plane");
        clock!(self, clock, kept_near, kept_far);
        self.plane.next = signed_bit_cast::<S, W>(self.zp.val());
        self.is_front.next = self.kind.val() == self.front.val();
        self.is_back.next = self.kind.val() == self.back.val();
        self.removes_both.next = (self.kind.val() == self.perpendicular.val())
            & self.zp.val().get_bit(self.sign.val().index());
        self.cuts_near.next = (self.is_front.val() & (self.near_sum.val() < self.plane.val()))
            | (self.is_back.val() & (self.plane.val() < self.near_sum.val()));
        self.cuts_far.next = (self.is_front.val() & (self.far_sum.val() < self.plane.val()))
            | (self.is_back.val() & (self.plane.val() < self.far_sum.val()));
        self.kept_near.d.next = !(self.removes_both.val() | self.cuts_near.val());
        self.kept_far.d.next = !(self.removes_both.val() | self.cuts_far.val());
        self.keeps_near.next = self.kept_near.q.val();
        self.keeps_far.next = self.kept_far.q.val();
    }
}

clocked!(PatchPlane<const W: usize, const S: usize>);
