//! Register of the tree that intersects half-spaces.

use crate::kernel::*;

/// Holds a branch of the tree of half-spaces for one clock: an odd one out of its level.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `a_front`, `a_back` | in | `W` bits |
/// | `a_front_number`, `a_back_number` | in | 4 bits |
/// | `a_removed` | in | a perpendicular plane removes the pixel |
/// | `front`, `back`, `front_number`, `back_number`, `removed` | out | the same |
///
/// Latency 1.
#[derive(Default)]
pub struct HalfSpaceRegister<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Greatest depth of a front plane of branch a.
    pub a_front: Signal<In, Int<W>>,
    /// Its face.
    pub a_front_number: Signal<In, Word<4>>,
    /// Least depth of a back plane of branch a.
    pub a_back: Signal<In, Int<W>>,
    /// Its face.
    pub a_back_number: Signal<In, Word<4>>,
    /// A perpendicular plane removes the pixel.
    pub a_removed: Signal<In, Bit>,
    /// Greatest depth of a front plane.
    pub front: Signal<Out, Int<W>>,
    /// Its face.
    pub front_number: Signal<Out, Word<4>>,
    /// Least depth of a back plane.
    pub back: Signal<Out, Int<W>>,
    /// Its face.
    pub back_number: Signal<Out, Word<4>>,
    /// A perpendicular plane removes the pixel.
    pub removed: Signal<Out, Bit>,
    kept_front: DFF<Int<W>>,
    kept_back: DFF<Int<W>>,
    kept_front_number: DFF<Word<4>>,
    kept_back_number: DFF<Word<4>>,
    kept_removed: DFF<Bit>,
    _asleep: bool,
}

block! {
    [const W: usize] HalfSpaceRegister [W]
    inputs { clock, a_front, a_front_number, a_back, a_back_number, a_removed }
    parts { front, front_number, back, back_number, removed, kept_front, kept_back,
        kept_front_number, kept_back_number, kept_removed }
    data { }
}

impl<const W: usize> HalfSpaceRegister<W> {}

impl<const W: usize> Logic for HalfSpaceRegister<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("half_space_register");
        clock!(
            self,
            clock,
            kept_front,
            kept_front_number,
            kept_back,
            kept_back_number,
            kept_removed
        );
        self.kept_front.d.next = self.a_front.val();
        self.kept_front_number.d.next = self.a_front_number.val();
        self.kept_back.d.next = self.a_back.val();
        self.kept_back_number.d.next = self.a_back_number.val();
        self.kept_removed.d.next = self.a_removed.val();
        self.front.next = self.kept_front.q.val();
        self.front_number.next = self.kept_front_number.q.val();
        self.back.next = self.kept_back.q.val();
        self.back_number.next = self.kept_back_number.q.val();
        self.removed.next = self.kept_removed.q.val();
    }
}

clocked!(HalfSpaceRegister<const W: usize>);
