//! Node of the tree that intersects half-spaces.

use crate::kernel::*;

/// Intersects what two groups of half-spaces leave of the line of sight: the greater front depth and the smaller back depth.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `a_front`, `a_back`, `b_front`, `b_back` | in | `W` bits |
/// | `a_front_number` .. `b_back_number` | in | 4 bits |
/// | `a_removed`, `b_removed` | in | a perpendicular plane removes the pixel |
/// | `front`, `back`, `front_number`, `back_number`, `removed` | out | the intersection |
///
/// Latency 1. At equal depths branch a, which holds the smaller indices, wins. Annex A.
#[derive(Default)]
pub struct HalfSpaceNode<const W: usize> {
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
    /// Greatest depth of a front plane of branch b.
    pub b_front: Signal<In, Int<W>>,
    /// Its face.
    pub b_front_number: Signal<In, Word<4>>,
    /// Least depth of a back plane of branch b.
    pub b_back: Signal<In, Int<W>>,
    /// Its face.
    pub b_back_number: Signal<In, Word<4>>,
    /// A perpendicular plane removes the pixel.
    pub b_removed: Signal<In, Bit>,
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
    b_is_deeper: Signal<Local, Bit>,
    b_is_nearer: Signal<Local, Bit>,
    kept_front: DFF<Int<W>>,
    kept_back: DFF<Int<W>>,
    kept_front_number: DFF<Word<4>>,
    kept_back_number: DFF<Word<4>>,
    kept_removed: DFF<Bit>,
    _asleep: bool,
}

block! {
    [const W: usize] HalfSpaceNode [W]
    inputs { clock, a_front, a_front_number, a_back, a_back_number, a_removed, b_front,
        b_front_number, b_back, b_back_number, b_removed }
    parts { front, front_number, back, back_number, removed, b_is_deeper, b_is_nearer, kept_front,
        kept_back, kept_front_number, kept_back_number, kept_removed }
    data { }
}

impl<const W: usize> HalfSpaceNode<W> {}

impl<const W: usize> Logic for HalfSpaceNode<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("half_space_node");
        clock!(
            self,
            clock,
            kept_front,
            kept_front_number,
            kept_back,
            kept_back_number,
            kept_removed
        );
        self.b_is_deeper.next = self.a_front.val() < self.b_front.val();
        self.b_is_nearer.next = self.b_back.val() < self.a_back.val();
        if self.b_is_deeper.val() {
            self.kept_front.d.next = self.b_front.val();
            self.kept_front_number.d.next = self.b_front_number.val();
        } else {
            self.kept_front.d.next = self.a_front.val();
            self.kept_front_number.d.next = self.a_front_number.val();
        }
        if self.b_is_nearer.val() {
            self.kept_back.d.next = self.b_back.val();
            self.kept_back_number.d.next = self.b_back_number.val();
        } else {
            self.kept_back.d.next = self.a_back.val();
            self.kept_back_number.d.next = self.a_back_number.val();
        }
        self.kept_removed.d.next = self.a_removed.val() | self.b_removed.val();
        self.front.next = self.kept_front.q.val();
        self.front_number.next = self.kept_front_number.q.val();
        self.back.next = self.kept_back.q.val();
        self.back_number.next = self.kept_back_number.q.val();
        self.removed.next = self.kept_removed.q.val();
    }
}

clocked!(HalfSpaceNode<const W: usize>);
