//! Choice between the two halves of a depth interval.

use crate::kernel::*;

/// Hands on the half that lies in front.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `zf_a`, `zb_a`, `zf_b`, `zb_b` | in | `W` bits, depths of half A and half B |
/// | `nf_a`, `nb_a`, `nf_b`, `nb_b` | in | 4 bits, face numbers |
/// | `zf`, `zb` | out | `W` bits |
/// | `nf`, `nb` | out | 4 bits |
///
/// Latency 1. The half with the smaller `zf` wins, half A if they are equal. Section 2.4.2.
#[derive(Default)]
pub struct TwoVolumeMerge<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Front depth of half A.
    pub zf_a: Signal<In, Int<W>>,
    /// Front face of half A.
    pub nf_a: Signal<In, Word<4>>,
    /// Back depth of half A.
    pub zb_a: Signal<In, Int<W>>,
    /// Back face of half A.
    pub nb_a: Signal<In, Word<4>>,
    /// Front depth of half B.
    pub zf_b: Signal<In, Int<W>>,
    /// Front face of half B.
    pub nf_b: Signal<In, Word<4>>,
    /// Back depth of half B.
    pub zb_b: Signal<In, Int<W>>,
    /// Back face of half B.
    pub nb_b: Signal<In, Word<4>>,
    /// Front depth.
    pub zf: Signal<Out, Int<W>>,
    /// Front face.
    pub nf: Signal<Out, Word<4>>,
    /// Back depth.
    pub zb: Signal<Out, Int<W>>,
    /// Back face.
    pub nb: Signal<Out, Word<4>>,
    b_in_front: Signal<Local, Bit>,
    kept_zf: DFF<Int<W>>,
    kept_nf: DFF<Word<4>>,
    kept_zb: DFF<Int<W>>,
    kept_nb: DFF<Word<4>>,
    _asleep: bool,
}

block! {
    [const W: usize] TwoVolumeMerge [W]
    inputs { clock, zf_a, nf_a, zb_a, nb_a, zf_b, nf_b, zb_b, nb_b }
    parts { zf, nf, zb, nb, b_in_front, kept_zf, kept_nf, kept_zb, kept_nb }
    data { }
}

impl<const W: usize> TwoVolumeMerge<W> {
    /// Clocks from the halves to the choice.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize> Logic for TwoVolumeMerge<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("two_volume_merge");
        clock!(self, clock, kept_zf, kept_nf, kept_zb, kept_nb);
        self.b_in_front.next = self.zf_b.val() < self.zf_a.val();
        if self.b_in_front.val() {
            self.kept_zf.d.next = self.zf_b.val();
            self.kept_nf.d.next = self.nf_b.val();
            self.kept_zb.d.next = self.zb_b.val();
            self.kept_nb.d.next = self.nb_b.val();
        } else {
            self.kept_zf.d.next = self.zf_a.val();
            self.kept_nf.d.next = self.nf_a.val();
            self.kept_zb.d.next = self.zb_a.val();
            self.kept_nb.d.next = self.nb_a.val();
        }
        self.zf.next = self.kept_zf.q.val();
        self.nf.next = self.kept_nf.q.val();
        self.zb.next = self.kept_zb.q.val();
        self.nb.next = self.kept_nb.q.val();
    }
}

clocked!(TwoVolumeMerge<const W: usize>);
