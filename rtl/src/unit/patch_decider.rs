//! Decision of a patch: the first face that every plane keeps.

use super::patch_plane::PatchPlane;
use crate::format::{FAR_ROOT, MOST_PLANES, NEAR_ROOT, far_end, near_end};
use crate::kernel::*;

/// Decides which face of a bare surface is seen, all planes at once.
///
/// Each plane keeps or removes each of the two faces without looking at the other face or at another plane: two signals of each
/// plane (the source's E_F and E_B) and two wide ANDs stand in the place of a chain of cuts.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `near_sum`, `far_sum` | in | `S = W + 2` bits, `f1 - r` and `f1 + r` |
/// | `is_inside` | in | `f2 >= 0` |
/// | `in_box` | in | the pixel lies in the object's screen box |
/// | `plane_i_kind` | in | 2 bits: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0) |
/// | `plane_i_zp` | in | `W` bits, clamped depth of plane i, beside the sums |
/// | `zf`, `zb` | out | `W` bits: both faces, or one of them twice |
/// | `number` | out | 4 bits, face at `zf`: 0 near root, 1 far root |
///
/// Latency 2. A face in a plane is kept; a face outside `[ZLOW, ZMAX)` is not there. Absent is `ZMAX` twice with number 0. Section 2.4.3.
pub struct PatchDecider<const W: usize, const S: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth of the near root.
    pub near_sum: Signal<In, Int<S>>,
    /// Depth of the far root.
    pub far_sum: Signal<In, Int<S>>,
    /// The discriminant is not negative.
    pub is_inside: Signal<In, Bit>,
    /// The pixel lies in the screen box.
    pub in_box: Signal<In, Bit>,
    /// Kind of each plane.
    pub plane_kind: Vec<Signal<In, Word<2>>>,
    /// Depth of each plane.
    pub plane_zp: Vec<Signal<In, Int<W>>>,
    /// Front depth.
    pub zf: Signal<Out, Int<W>>,
    /// Back depth.
    pub zb: Signal<Out, Int<W>>,
    /// Front face.
    pub number: Signal<Out, Word<4>>,
    is_there: Signal<Local, Bit>,
    /// What each plane keeps.
    pub planes: Vec<PatchPlane<W, S>>,
    near_exists: DFF<Bit>,
    far_exists: DFF<Bit>,
    near_depth: DFF<Int<W>>,
    far_depth: DFF<Int<W>>,
    near_left: Signal<Local, Bit>,
    far_left: Signal<Local, Bit>,
    kept_zf: DFF<Int<W>>,
    kept_zb: DFF<Int<W>>,
    kept_number: DFF<Word<4>>,
    low: Constant<Int<S>>,
    far_limit: Constant<Int<S>>,
    absent: Constant<Int<W>>,
    near_root: Constant<Word<4>>,
    far_root: Constant<Word<4>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] PatchDecider [W, S]
    inputs { clock, near_sum, far_sum, is_inside, in_box, plane_kind, plane_zp }
    parts { zf, zb, number, is_there, planes, near_exists, far_exists, near_depth, far_depth,
        near_left, far_left, kept_zf, kept_zb, kept_number, low, far_limit, absent, near_root, far_root }
    data { _planes }
}

impl<const W: usize, const S: usize> PatchDecider<W, S> {
    /// A decider of `planes` planes.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2` or `planes` exceeds 12.
    pub fn new(planes: usize) -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        assert!(
            planes <= MOST_PLANES,
            "an object has at most {MOST_PLANES} planes"
        );
        fields! {
            [clock, near_sum, far_sum, is_inside, in_box, zf, zb, number, is_there, near_exists,
                far_exists, near_depth, far_depth, near_left, far_left, kept_zf, kept_zb,
                kept_number]
            plane_kind: repeat(planes, Default::default),
            plane_zp: repeat(planes, Default::default),
            planes: repeat(planes, PatchPlane::new),
            low: signed_constant(near_end(W)),
            far_limit: signed_constant(far_end(W)),
            absent: signed_constant(far_end(W)),
            near_root: constant(NEAR_ROOT),
            far_root: constant(FAR_ROOT),
            _planes: planes,
        }
    }

    /// Clocks from the sums to the decision.
    pub const fn latency() -> usize {
        2
    }
}

impl<const W: usize, const S: usize> Logic for PatchDecider<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("patch_decider");
        clock!(
            self,
            clock,
            near_exists,
            far_exists,
            near_depth,
            far_depth,
            kept_zf,
            kept_zb,
            kept_number
        );
        self.is_there.next = self.is_inside.val() & self.in_box.val();
        // The two ends are planes of constant depth: asked beside the planes, not before them.
        self.near_exists.d.next = self.is_there.val()
            & (self.near_sum.val() >= self.low.val())
            & (self.near_sum.val() < self.far_limit.val());
        self.far_exists.d.next = self.is_there.val()
            & (self.far_sum.val() >= self.low.val())
            & (self.far_sum.val() < self.far_limit.val());
        self.near_depth.d.next = self.near_sum.val().get_bits::<W>(0);
        self.far_depth.d.next = self.far_sum.val().get_bits::<W>(0);
        for i in 0..self._planes {
            self.planes[i].clock.next = self.clock.val();
            self.planes[i].kind.next = self.plane_kind[i].val();
            self.planes[i].zp.next = self.plane_zp[i].val();
            self.planes[i].near_sum.next = self.near_sum.val();
            self.planes[i].far_sum.next = self.far_sum.val();
        }
        self.near_left.next = self.near_exists.q.val();
        self.far_left.next = self.far_exists.q.val();
        for i in 0..self._planes {
            if !self.planes[i].keeps_near.val() {
                self.near_left.next = false;
            }
            if !self.planes[i].keeps_far.val() {
                self.far_left.next = false;
            }
        }
        self.kept_zf.d.next = self.absent.val();
        self.kept_zb.d.next = self.absent.val();
        self.kept_number.d.next = self.near_root.val();
        if self.far_left.val() {
            self.kept_zf.d.next = self.far_depth.q.val();
            self.kept_zb.d.next = self.far_depth.q.val();
            self.kept_number.d.next = self.far_root.val();
        }
        if self.near_left.val() {
            self.kept_zf.d.next = self.near_depth.q.val();
            self.kept_number.d.next = self.near_root.val();
            if !self.far_left.val() {
                self.kept_zb.d.next = self.near_depth.q.val();
            }
        }
        self.zf.next = self.kept_zf.q.val();
        self.zb.next = self.kept_zb.q.val();
        self.number.next = self.kept_number.q.val();
    }
}

clocked!(PatchDecider<const W: usize, const S: usize>);
