//! Depth interval of a quadric on one pixel.

use crate::format::{CAP, FAR_ROOT, FRONT, NEAR_ROOT, PATCH, PRISM, SIDE, far_end, near_end};
use crate::kernel::*;

/// Turns the two depths of a quadric into the two halves of the depth interval of its object.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `near_sum`, `far_sum` | in | `S = W + 2` bits, `f1 - r` and `f1 + r` |
/// | `is_inside` | in | `f2 >= 0` |
/// | `in_box` | in | the pixel lies in the object's screen box |
/// | `object_class` | in | 2 bits: 0 side, 1 front, 2 patch, 3 prism |
/// | `zf_a`, `zb_a`, `zf_b`, `zb_b` | out | `W` bits, front and back depth of half A and half B |
/// | `nf_a`, `nb_a`, `nf_b`, `nb_b` | out | 4 bits, face numbers |
///
/// Latency 1. Depths are clamped to `[ZLOW, ZMAX]`; a solid that reaches nearer than `ZLOW` gets the cap, number 15. An
/// absent half has both depths at `ZMAX` and both numbers 0. `f2 = 0` counts as inside. Section 2.4.2.
pub struct DepthInterval<const W: usize, const S: usize> {
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
    /// Class of the object.
    pub object_class: Signal<In, Word<2>>,
    /// Front depth of half A.
    pub zf_a: Signal<Out, Int<W>>,
    /// Front face of half A.
    pub nf_a: Signal<Out, Word<4>>,
    /// Back depth of half A.
    pub zb_a: Signal<Out, Int<W>>,
    /// Back face of half A.
    pub nb_a: Signal<Out, Word<4>>,
    /// Front depth of half B.
    pub zf_b: Signal<Out, Int<W>>,
    /// Front face of half B.
    pub nf_b: Signal<Out, Word<4>>,
    /// Back depth of half B.
    pub zb_b: Signal<Out, Int<W>>,
    /// Back face of half B.
    pub nb_b: Signal<Out, Word<4>>,
    near_is_low: Signal<Local, Bit>,
    near_is_far: Signal<Local, Bit>,
    far_is_low: Signal<Local, Bit>,
    far_is_far: Signal<Local, Bit>,
    near_depth: Signal<Local, Int<W>>,
    far_depth: Signal<Local, Int<W>>,
    near_face: Signal<Local, Word<4>>,
    far_face: Signal<Local, Word<4>>,
    near_visible: Signal<Local, Bit>,
    far_visible: Signal<Local, Bit>,
    is_side: Signal<Local, Bit>,
    is_front: Signal<Local, Bit>,
    is_patch: Signal<Local, Bit>,
    is_prism: Signal<Local, Bit>,
    side_present: Signal<Local, Bit>,
    kept_zf_a: DFF<Int<W>>,
    kept_nf_a: DFF<Word<4>>,
    kept_zb_a: DFF<Int<W>>,
    kept_nb_a: DFF<Word<4>>,
    kept_zf_b: DFF<Int<W>>,
    kept_nf_b: DFF<Word<4>>,
    kept_zb_b: DFF<Int<W>>,
    kept_nb_b: DFF<Word<4>>,
    low_sum: Constant<Int<S>>,
    far_end_sum: Constant<Int<S>>,
    low: Constant<Int<W>>,
    absent: Constant<Int<W>>,
    near_root: Constant<Word<4>>,
    far_root: Constant<Word<4>>,
    cap: Constant<Word<4>>,
    no_face: Constant<Word<4>>,
    side: Constant<Word<2>>,
    front: Constant<Word<2>>,
    patch: Constant<Word<2>>,
    prism: Constant<Word<2>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] DepthInterval [W, S]
    inputs { clock, near_sum, far_sum, is_inside, in_box, object_class }
    parts { zf_a, nf_a, zb_a, nb_a, zf_b, nf_b, zb_b, nb_b, near_is_low, near_is_far, far_is_low,
        far_is_far, near_depth, far_depth, near_face, far_face, near_visible, far_visible,
        is_side, is_front, is_patch, is_prism, side_present, kept_zf_a, kept_nf_a, kept_zb_a,
        kept_nb_a, kept_zf_b, kept_nf_b, kept_zb_b, kept_nb_b, low_sum, far_end_sum, low, absent,
        near_root, far_root, cap, no_face, side, front, patch, prism }
    data { }
}

impl<const W: usize, const S: usize> DepthInterval<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        Self {
            clock: Signal::default(),
            near_sum: Signal::default(),
            far_sum: Signal::default(),
            is_inside: Signal::default(),
            in_box: Signal::default(),
            object_class: Signal::default(),
            zf_a: Signal::default(),
            nf_a: Signal::default(),
            zb_a: Signal::default(),
            nb_a: Signal::default(),
            zf_b: Signal::default(),
            nf_b: Signal::default(),
            zb_b: Signal::default(),
            nb_b: Signal::default(),
            near_is_low: Signal::default(),
            near_is_far: Signal::default(),
            far_is_low: Signal::default(),
            far_is_far: Signal::default(),
            near_depth: Signal::default(),
            far_depth: Signal::default(),
            near_face: Signal::default(),
            far_face: Signal::default(),
            near_visible: Signal::default(),
            far_visible: Signal::default(),
            is_side: Signal::default(),
            is_front: Signal::default(),
            is_patch: Signal::default(),
            is_prism: Signal::default(),
            side_present: Signal::default(),
            kept_zf_a: DFF::default(),
            kept_nf_a: DFF::default(),
            kept_zb_a: DFF::default(),
            kept_nb_a: DFF::default(),
            kept_zf_b: DFF::default(),
            kept_nf_b: DFF::default(),
            kept_zb_b: DFF::default(),
            kept_nb_b: DFF::default(),
            low_sum: signed_constant(near_end(W)),
            far_end_sum: signed_constant(far_end(W)),
            low: signed_constant(near_end(W)),
            absent: signed_constant(far_end(W)),
            near_root: constant(NEAR_ROOT),
            far_root: constant(FAR_ROOT),
            cap: constant(CAP),
            no_face: constant(0),
            side: constant(SIDE),
            front: constant(FRONT),
            patch: constant(PATCH),
            prism: constant(PRISM),
            _asleep: false,
        }
    }

    /// Clocks from the sums to the interval.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize, const S: usize> Default for DepthInterval<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for DepthInterval<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("depth_interval");
        clock!(
            self, clock, kept_zf_a, kept_nf_a, kept_zb_a, kept_nb_a, kept_zf_b, kept_nf_b,
            kept_zb_b, kept_nb_b
        );
        self.near_is_low.next = self.near_sum.val() < self.low_sum.val();
        self.near_is_far.next = self.near_sum.val() >= self.far_end_sum.val();
        self.far_is_low.next = self.far_sum.val() < self.low_sum.val();
        self.far_is_far.next = self.far_sum.val() >= self.far_end_sum.val();
        if self.near_is_low.val() {
            self.near_depth.next = self.low.val();
            self.near_face.next = self.cap.val();
        } else if self.near_is_far.val() {
            self.near_depth.next = self.absent.val();
            self.near_face.next = self.near_root.val();
        } else {
            self.near_depth.next = self.near_sum.val().get_bits::<W>(0);
            self.near_face.next = self.near_root.val();
        }
        if self.far_is_low.val() {
            self.far_depth.next = self.low.val();
            self.far_face.next = self.cap.val();
        } else if self.far_is_far.val() {
            self.far_depth.next = self.absent.val();
            self.far_face.next = self.far_root.val();
        } else {
            self.far_depth.next = self.far_sum.val().get_bits::<W>(0);
            self.far_face.next = self.far_root.val();
        }
        self.near_visible.next = !(self.near_is_low.val() | self.near_is_far.val());
        self.far_visible.next = !(self.far_is_low.val() | self.far_is_far.val());
        self.is_side.next = self.object_class.val() == self.side.val();
        self.is_front.next = self.object_class.val() == self.front.val();
        self.is_patch.next = self.object_class.val() == self.patch.val();
        self.is_prism.next = self.object_class.val() == self.prism.val();
        self.side_present.next =
            self.is_side.val() & !(self.near_is_far.val() | self.far_is_low.val());
        self.kept_zf_a.d.next = self.absent.val();
        self.kept_nf_a.d.next = self.no_face.val();
        self.kept_zb_a.d.next = self.absent.val();
        self.kept_nb_a.d.next = self.no_face.val();
        self.kept_zf_b.d.next = self.absent.val();
        self.kept_nf_b.d.next = self.no_face.val();
        self.kept_zb_b.d.next = self.absent.val();
        self.kept_nb_b.d.next = self.no_face.val();
        if self.in_box.val() {
            if self.is_inside.val() {
                if self.side_present.val() {
                    self.kept_zf_a.d.next = self.near_depth.val();
                    self.kept_nf_a.d.next = self.near_face.val();
                    self.kept_zb_a.d.next = self.far_depth.val();
                    self.kept_nb_a.d.next = self.far_root.val();
                }
                if self.is_front.val() {
                    if !self.near_is_low.val() {
                        self.kept_zf_a.d.next = self.low.val();
                        self.kept_nf_a.d.next = self.cap.val();
                        self.kept_zb_a.d.next = self.near_depth.val();
                        self.kept_nb_a.d.next = self.near_root.val();
                    }
                    if !self.far_is_far.val() {
                        self.kept_zf_b.d.next = self.far_depth.val();
                        self.kept_nf_b.d.next = self.far_face.val();
                        self.kept_zb_b.d.next = self.absent.val();
                        self.kept_nb_b.d.next = self.cap.val();
                    }
                }
                if self.is_patch.val() {
                    if self.near_visible.val() {
                        self.kept_zf_a.d.next = self.near_depth.val();
                        self.kept_nf_a.d.next = self.near_root.val();
                        self.kept_zb_a.d.next = self.near_depth.val();
                        self.kept_nb_a.d.next = self.near_root.val();
                        if self.far_visible.val() {
                            self.kept_zb_a.d.next = self.far_depth.val();
                            self.kept_nb_a.d.next = self.far_root.val();
                        }
                    } else if self.far_visible.val() {
                        self.kept_zf_a.d.next = self.far_depth.val();
                        self.kept_nf_a.d.next = self.far_root.val();
                        self.kept_zb_a.d.next = self.far_depth.val();
                        self.kept_nb_a.d.next = self.far_root.val();
                    }
                }
                if self.is_prism.val() {
                    self.kept_zf_a.d.next = self.low.val();
                    self.kept_nf_a.d.next = self.cap.val();
                    self.kept_zb_a.d.next = self.absent.val();
                    self.kept_nb_a.d.next = self.cap.val();
                }
            } else if self.is_front.val() {
                self.kept_zf_a.d.next = self.low.val();
                self.kept_nf_a.d.next = self.cap.val();
                self.kept_zb_a.d.next = self.absent.val();
                self.kept_nb_a.d.next = self.cap.val();
            }
        }
        self.zf_a.next = self.kept_zf_a.q.val();
        self.nf_a.next = self.kept_nf_a.q.val();
        self.zb_a.next = self.kept_zb_a.q.val();
        self.nb_a.next = self.kept_nb_a.q.val();
        self.zf_b.next = self.kept_zf_b.q.val();
        self.nf_b.next = self.kept_nf_b.q.val();
        self.zb_b.next = self.kept_zb_b.q.val();
        self.nb_b.next = self.kept_nb_b.q.val();
    }
}

clocked!(DepthInterval<const W: usize, const S: usize>);
