//! Ends of the depth word for a surface of one depth.

use crate::format::{far_end, near_end};
use crate::kernel::*;

/// Says whether a surface of one depth is between the ends of the depth word, and gives its depth.
///
/// | port | direction | format |
/// |---|---|---|
/// | `z` | in | `S = W + 2` bits |
/// | `is_there` | in | the pixel lies in the outline and in the screen box |
/// | `is_present` | out | `ZLOW <= z < ZMAX` there |
/// | `depth` | out | `W` bits; `ZMAX` where absent |
///
/// Latency 0: two comparators without register.
pub struct OneFace<const W: usize, const S: usize> {
    /// Depth.
    pub z: Signal<In, Int<S>>,
    /// The pixel lies in the outline and in the screen box.
    pub is_there: Signal<In, Bit>,
    /// The surface is visible.
    pub is_present: Signal<Out, Bit>,
    /// Depth, or the far end.
    pub depth: Signal<Out, Int<W>>,
    present: Signal<Local, Bit>,
    low_sum: Constant<Int<S>>,
    end_sum: Constant<Int<S>>,
    absent: Constant<Int<W>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize] OneFace [W, S]
    inputs { z, is_there }
    parts { is_present, depth, present, low_sum, end_sum, absent }
    data { }
}

impl<const W: usize, const S: usize> OneFace<W, S> {
    /// A unit of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When `S` is not `W + 2`.
    pub fn new() -> Self {
        assert!(S == W + 2, "a depth sum has two bits more than a depth");
        fields! {
            [z, is_there, is_present, depth, present]
            low_sum: signed_constant(near_end(W)),
            end_sum: signed_constant(far_end(W)),
            absent: signed_constant(far_end(W)),
        }
    }
}

impl<const W: usize, const S: usize> Default for OneFace<W, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize> Logic for OneFace<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("one_face");
        self.present.next = self.is_there.val()
            & (self.z.val() >= self.low_sum.val())
            & (self.z.val() < self.end_sum.val());
        self.is_present.next = self.present.val();
        if self.present.val() {
            self.depth.next = self.z.val().get_bits::<W>(0);
        } else {
            self.depth.next = self.absent.val();
        }
    }
}
