//! Depth interval of a solid seen from outside.

use crate::format::{CAP, NEAR_ROOT, far_end, near_end};
use crate::kernel::*;

/// Clamps the two depths of a solid of class side to the depth word.
///
/// | port | direction | format |
/// |---|---|---|
/// | `near_sum`, `far_sum` | in | `S = W + 2` bits |
/// | `is_there` | in | the pixel lies in the outline and in the screen box |
/// | `is_present` | out | something of the solid lies between the ends of the depth word |
/// | `zf`, `zb` | out | `W` bits, front and back depth; `ZMAX` where absent |
/// | `number` | out | 4 bits, face at `zf`: 0 near root, 15 the cap of a solid that reaches nearer than `ZLOW` |
///
/// Latency 0: comparators without register. The same interval as that of the depth interval unit for class side. Section 2.4.2.
pub struct SideInterval<const W: usize, const S: usize> {
    /// Near depth.
    pub near_sum: Signal<In, Int<S>>,
    /// Far depth.
    pub far_sum: Signal<In, Int<S>>,
    /// The pixel lies in the outline and in the screen box.
    pub is_there: Signal<In, Bit>,
    /// Something lies between the ends.
    pub is_present: Signal<Out, Bit>,
    /// Front depth.
    pub zf: Signal<Out, Int<W>>,
    /// Back depth.
    pub zb: Signal<Out, Int<W>>,
    /// Front face.
    pub number: Signal<Out, Word<4>>,
    present: Signal<Local, Bit>,
    low_sum: Constant<Int<S>>,
    end_sum: Constant<Int<S>>,
    low: Constant<Int<W>>,
    absent: Constant<Int<W>>,
    near_root: Constant<Word<4>>,
    cap: Constant<Word<4>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] SideInterval [W, S]
    inputs { near_sum, far_sum, is_there }
    parts { is_present, zf, zb, number, present, low_sum, end_sum, low, absent, near_root, cap }
    data { }
}

impl<const W: usize, const S: usize> SideInterval<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        fields! {
            [near_sum, far_sum, is_there, is_present, zf, zb, number, present]
            low_sum: signed_constant(near_end(W)),
            end_sum: signed_constant(far_end(W)),
            low: signed_constant(near_end(W)),
            absent: signed_constant(far_end(W)),
            near_root: constant(NEAR_ROOT),
            cap: constant(CAP),
        }
    }
}

impl<const W: usize, const S: usize> Default for SideInterval<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for SideInterval<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("side_interval");
        self.present.next = self.is_there.val()
            & (self.near_sum.val() < self.end_sum.val())
            & (self.far_sum.val() >= self.low_sum.val());
        self.is_present.next = self.present.val();
        self.zf.next = self.absent.val();
        self.zb.next = self.absent.val();
        self.number.next = self.near_root.val();
        if self.present.val() {
            self.zf.next = self.near_sum.val().get_bits::<W>(0);
            if self.near_sum.val() < self.low_sum.val() {
                self.zf.next = self.low.val();
                self.number.next = self.cap.val();
            }
            if self.far_sum.val() < self.end_sum.val() {
                self.zb.next = self.far_sum.val().get_bits::<W>(0);
            }
        }
    }
}
