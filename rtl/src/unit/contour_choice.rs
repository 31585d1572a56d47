//! Choice of the faces of a quadric by contours on the screen.

use super::one_face::OneFace;
use super::side_interval::SideInterval;
use crate::format::{FAR_ROOT, FIRST_PLANE, NEAR_ROOT, far_end, near_end};
use crate::kernel::*;

/// Chooses the visible face of a quadric between two parallel planes by the signs of contours, as the first generation does.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `surface` | in | the object is a bare surface |
/// | `near_sum`, `far_sum` | in | `S = W + 2` bits, the roots |
/// | `is_there` | in | `f2 >= 0` in the screen box |
/// | `front_zp`, `back_zp` | in | `W` bits, clamped depths of the front and the back plane |
/// | `front_inside`, `back_inside` | in | the plane is inside the quadric at this pixel |
/// | `middle_kept` | in | the middle of the quadric is on the kept side of both planes |
/// | `zf`, `zb` | out | `W` bits |
/// | `number` | out | 4 bits, face at `zf`: 0 near root, 1 far root, 2 front plane, 15 near end |
///
/// Latency 1. A plane inside a solid is the face on its side; inside a bare surface it has removed the face on its side. Absent is `ZMAX`
/// twice with number 0. Section 2.4.1, its algorithm corrected.
pub struct ContourChoice<const W: usize, const S: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The object is a bare surface.
    pub surface: Signal<In, Bit>,
    /// Depth of the near root.
    pub near_sum: Signal<In, Int<S>>,
    /// Depth of the far root.
    pub far_sum: Signal<In, Int<S>>,
    /// The discriminant is not negative in the screen box.
    pub is_there: Signal<In, Bit>,
    /// Depth of the front plane.
    pub front_zp: Signal<In, Int<W>>,
    /// Depth of the back plane.
    pub back_zp: Signal<In, Int<W>>,
    /// The front plane is inside the quadric.
    pub front_inside: Signal<In, Bit>,
    /// The back plane is inside the quadric.
    pub back_inside: Signal<In, Bit>,
    /// The middle of the quadric is kept.
    pub middle_kept: Signal<In, Bit>,
    /// Front depth.
    pub zf: Signal<Out, Int<W>>,
    /// Back depth.
    pub zb: Signal<Out, Int<W>>,
    /// Front face.
    pub number: Signal<Out, Word<4>>,
    left: Signal<Local, Bit>,
    solid: SideInterval<W, S>,
    near_face: OneFace<W, S>,
    far_face: OneFace<W, S>,
    cut_zf: Signal<Local, Int<W>>,
    cut_zb: Signal<Local, Int<W>>,
    cut_number: Signal<Local, Word<4>>,
    cut_present: Signal<Local, Bit>,
    kept_zf: DFF<Int<W>>,
    kept_zb: DFF<Int<W>>,
    kept_number: DFF<Word<4>>,
    low: Constant<Int<W>>,
    absent: Constant<Int<W>>,
    near_root: Constant<Word<4>>,
    far_root: Constant<Word<4>>,
    front_plane: Constant<Word<4>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] ContourChoice [W, S]
    inputs { clock, surface, near_sum, far_sum, is_there, front_zp, back_zp, front_inside,
        back_inside, middle_kept }
    parts { zf, zb, number, left, solid, near_face, far_face, cut_zf, cut_zb, cut_number,
        cut_present, kept_zf, kept_zb, kept_number, low, absent, near_root, far_root,
        front_plane }
    data { }
}

impl<const W: usize, const S: usize> ContourChoice<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        fields! {
            [clock, surface, near_sum, far_sum, is_there, front_zp, back_zp, front_inside,
                back_inside, middle_kept, zf, zb, number, left, cut_zf, cut_zb, cut_number,
                cut_present, kept_zf, kept_zb, kept_number]
            solid: SideInterval::new(),
            near_face: OneFace::new(),
            far_face: OneFace::new(),
            low: signed_constant(near_end(W)),
            absent: signed_constant(far_end(W)),
            near_root: constant(NEAR_ROOT),
            far_root: constant(FAR_ROOT),
            front_plane: constant(FIRST_PLANE),
        }
    }

    /// Clocks from the signs to the choice.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize, const S: usize> Default for ContourChoice<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for ContourChoice<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("contour_choice");
        clock!(self, clock, kept_zf, kept_zb, kept_number);
        // No plane passes through the quadric here and one of them has it on its removed side: nothing is left.
        self.left.next = self.is_there.val()
            & (self.front_inside.val() | self.back_inside.val() | self.middle_kept.val());
        self.solid.near_sum.next = self.near_sum.val();
        self.solid.far_sum.next = self.far_sum.val();
        self.solid.is_there.next = self.left.val();
        self.cut_zf.next = self.solid.zf.val();
        self.cut_number.next = self.solid.number.val();
        self.cut_zb.next = self.solid.zb.val();
        if self.front_inside.val() & (self.low.val() < self.front_zp.val()) {
            self.cut_zf.next = self.front_zp.val();
            self.cut_number.next = self.front_plane.val();
        }
        if self.back_inside.val() & (self.back_zp.val() < self.absent.val()) {
            self.cut_zb.next = self.back_zp.val();
        }
        // Only a plane beyond an end of the depth word can leave nothing here.
        self.cut_present.next = self.solid.is_present.val()
            & (self.cut_zf.val() <= self.cut_zb.val())
            & (self.cut_zf.val() < self.absent.val());
        self.near_face.z.next = self.near_sum.val();
        self.near_face.is_there.next = self.left.val() & !self.front_inside.val();
        self.far_face.z.next = self.far_sum.val();
        self.far_face.is_there.next = self.left.val() & !self.back_inside.val();
        self.kept_zf.d.next = self.absent.val();
        self.kept_zb.d.next = self.absent.val();
        self.kept_number.d.next = self.near_root.val();
        if self.surface.val() {
            if self.far_face.is_present.val() {
                self.kept_zf.d.next = self.far_face.depth.val();
                self.kept_zb.d.next = self.far_face.depth.val();
                self.kept_number.d.next = self.far_root.val();
            }
            if self.near_face.is_present.val() {
                self.kept_zf.d.next = self.near_face.depth.val();
                self.kept_number.d.next = self.near_root.val();
                if !self.far_face.is_present.val() {
                    self.kept_zb.d.next = self.near_face.depth.val();
                }
            }
        } else if self.cut_present.val() {
            self.kept_zf.d.next = self.cut_zf.val();
            self.kept_zb.d.next = self.cut_zb.val();
            self.kept_number.d.next = self.cut_number.val();
        }
        self.zf.next = self.kept_zf.q.val();
        self.zb.next = self.kept_zb.q.val();
        self.number.next = self.kept_number.q.val();
    }
}

clocked!(ContourChoice<const W: usize, const S: usize>);
