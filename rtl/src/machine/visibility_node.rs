//! One node of the decider.

use crate::kernel::*;

/// Hands on the nearer of two objects.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `a_depth`, `b_depth` | in | `W` bits |
/// | `a_id`, `b_id` | in | `I` bits, 8 in the catalogue |
/// | `a_number`, `b_number` | in | 4 bits |
/// | `a_nx` .. `b_nz` | in | 16 bits |
/// | `depth`, `id`, `number`, `nx`, `ny`, `nz` | out | the winner |
///
/// Latency 1. The smaller depth wins, at equal depth the smaller id, so that the order of the inputs does not matter.
#[derive(Default)]
pub struct VisibilityNode<const W: usize, const N: usize = 16, const I: usize = 8> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth of the first object.
    pub a_depth: Signal<In, Int<W>>,
    /// Id of the first object.
    pub a_id: Signal<In, Word<I>>,
    /// Face of the first object.
    pub a_number: Signal<In, Word<4>>,
    /// Normal x of the first object.
    pub a_nx: Signal<In, Int<N>>,
    /// Normal y of the first object.
    pub a_ny: Signal<In, Int<N>>,
    /// Normal z of the first object.
    pub a_nz: Signal<In, Int<N>>,
    /// Depth of the second object.
    pub b_depth: Signal<In, Int<W>>,
    /// Id of the second object.
    pub b_id: Signal<In, Word<I>>,
    /// Face of the second object.
    pub b_number: Signal<In, Word<4>>,
    /// Normal x of the second object.
    pub b_nx: Signal<In, Int<N>>,
    /// Normal y of the second object.
    pub b_ny: Signal<In, Int<N>>,
    /// Normal z of the second object.
    pub b_nz: Signal<In, Int<N>>,
    /// Depth of the winner.
    pub depth: Signal<Out, Int<W>>,
    /// Id of the winner.
    pub id: Signal<Out, Word<I>>,
    /// Face of the winner.
    pub number: Signal<Out, Word<4>>,
    /// Normal x of the winner.
    pub nx: Signal<Out, Int<N>>,
    /// Normal y of the winner.
    pub ny: Signal<Out, Int<N>>,
    /// Normal z of the winner.
    pub nz: Signal<Out, Int<N>>,
    b_is_nearer: Signal<Local, Bit>,
    depths_are_equal: Signal<Local, Bit>,
    b_has_smaller_id: Signal<Local, Bit>,
    b_wins: Signal<Local, Bit>,
    kept_depth: DFF<Int<W>>,
    kept_id: DFF<Word<I>>,
    kept_number: DFF<Word<4>>,
    kept_nx: DFF<Int<N>>,
    kept_ny: DFF<Int<N>>,
    kept_nz: DFF<Int<N>>,
    _asleep: bool,
}

block! {
    [const W: usize, const N: usize, const I: usize] VisibilityNode [W, N, I]
    inputs { clock, a_depth, a_id, a_number, a_nx, a_ny, a_nz, b_depth, b_id, b_number, b_nx,
        b_ny, b_nz }
    parts { depth, id, number, nx, ny, nz, b_is_nearer, depths_are_equal, b_has_smaller_id,
        b_wins, kept_depth, kept_id, kept_number, kept_nx, kept_ny, kept_nz }
    data { }
}

impl<const W: usize, const N: usize, const I: usize> VisibilityNode<W, N, I> {
    /// Clocks from the objects to the winner.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize, const N: usize, const I: usize> Logic for VisibilityNode<W, N, I> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("visibility_node");
        clock!(
            self,
            clock,
            kept_depth,
            kept_id,
            kept_number,
            kept_nx,
            kept_ny,
            kept_nz
        );
        self.b_is_nearer.next = self.b_depth.val() < self.a_depth.val();
        self.depths_are_equal.next = self.b_depth.val() == self.a_depth.val();
        self.b_has_smaller_id.next = self.b_id.val() < self.a_id.val();
        self.b_wins.next =
            self.b_is_nearer.val() | (self.depths_are_equal.val() & self.b_has_smaller_id.val());
        if self.b_wins.val() {
            self.kept_depth.d.next = self.b_depth.val();
            self.kept_id.d.next = self.b_id.val();
            self.kept_number.d.next = self.b_number.val();
            self.kept_nx.d.next = self.b_nx.val();
            self.kept_ny.d.next = self.b_ny.val();
            self.kept_nz.d.next = self.b_nz.val();
        } else {
            self.kept_depth.d.next = self.a_depth.val();
            self.kept_id.d.next = self.a_id.val();
            self.kept_number.d.next = self.a_number.val();
            self.kept_nx.d.next = self.a_nx.val();
            self.kept_ny.d.next = self.a_ny.val();
            self.kept_nz.d.next = self.a_nz.val();
        }
        self.depth.next = self.kept_depth.q.val();
        self.id.next = self.kept_id.q.val();
        self.number.next = self.kept_number.q.val();
        self.nx.next = self.kept_nx.q.val();
        self.ny.next = self.kept_ny.q.val();
        self.nz.next = self.kept_nz.q.val();
    }
}

clocked!(VisibilityNode<const W: usize, const N: usize, const I: usize>);

/// A register in the place of a node that has one input only.
#[derive(Default)]
pub struct VisibilityRegister<const W: usize, const N: usize = 16, const I: usize = 8> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth of the object.
    pub a_depth: Signal<In, Int<W>>,
    /// Id of the object.
    pub a_id: Signal<In, Word<I>>,
    /// Face of the object.
    pub a_number: Signal<In, Word<4>>,
    /// Normal x of the object.
    pub a_nx: Signal<In, Int<N>>,
    /// Normal y of the object.
    pub a_ny: Signal<In, Int<N>>,
    /// Normal z of the object.
    pub a_nz: Signal<In, Int<N>>,
    /// Depth, one clock later.
    pub depth: Signal<Out, Int<W>>,
    /// Id, one clock later.
    pub id: Signal<Out, Word<I>>,
    /// Face, one clock later.
    pub number: Signal<Out, Word<4>>,
    /// Normal x, one clock later.
    pub nx: Signal<Out, Int<N>>,
    /// Normal y, one clock later.
    pub ny: Signal<Out, Int<N>>,
    /// Normal z, one clock later.
    pub nz: Signal<Out, Int<N>>,
    kept_depth: DFF<Int<W>>,
    kept_id: DFF<Word<I>>,
    kept_number: DFF<Word<4>>,
    kept_nx: DFF<Int<N>>,
    kept_ny: DFF<Int<N>>,
    kept_nz: DFF<Int<N>>,
    _asleep: bool,
}

block! {
    [const W: usize, const N: usize, const I: usize] VisibilityRegister [W, N, I]
    inputs { clock, a_depth, a_id, a_number, a_nx, a_ny, a_nz }
    parts { depth, id, number, nx, ny, nz, kept_depth, kept_id, kept_number, kept_nx, kept_ny,
        kept_nz }
    data { }
}

impl<const W: usize, const N: usize, const I: usize> Logic for VisibilityRegister<W, N, I> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("visibility_register");
        clock!(
            self,
            clock,
            kept_depth,
            kept_id,
            kept_number,
            kept_nx,
            kept_ny,
            kept_nz
        );
        self.kept_depth.d.next = self.a_depth.val();
        self.kept_id.d.next = self.a_id.val();
        self.kept_number.d.next = self.a_number.val();
        self.kept_nx.d.next = self.a_nx.val();
        self.kept_ny.d.next = self.a_ny.val();
        self.kept_nz.d.next = self.a_nz.val();
        self.depth.next = self.kept_depth.q.val();
        self.id.next = self.kept_id.q.val();
        self.number.next = self.kept_number.q.val();
        self.nx.next = self.kept_nx.q.val();
        self.ny.next = self.kept_ny.q.val();
        self.nz.next = self.kept_nz.q.val();
    }
}
