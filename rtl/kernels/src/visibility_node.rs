//! The nearer of two objects.
#![expect(
    missing_docs,
    reason = "the derive of an interface writes a method `join` without a comment"
)]

use rust_hdl::prelude::*;

/// What an object says of a pixel.
#[derive(LogicInterface, Default)]
#[join = "Nearest"]
pub struct Candidate<const D: usize, const N: usize> {
    /// Depth, the far end where it is absent.
    pub depth: Signal<In, Signed<D>>,
    /// Number of the object.
    pub id: Signal<In, Bits<8>>,
    /// Number of the face.
    pub number: Signal<In, Bits<4>>,
    /// Normal x.
    pub nx: Signal<In, Signed<N>>,
    /// Normal y.
    pub ny: Signal<In, Signed<N>>,
    /// Normal z.
    pub nz: Signal<In, Signed<N>>,
}

/// The same of the object that is chosen.
#[derive(LogicInterface, Default)]
#[join = "Candidate"]
pub struct Nearest<const D: usize, const N: usize> {
    /// Depth, the far end where none is there.
    pub depth: Signal<Out, Signed<D>>,
    /// Number of the object.
    pub id: Signal<Out, Bits<8>>,
    /// Number of the face.
    pub number: Signal<Out, Bits<4>>,
    /// Normal x.
    pub nx: Signal<Out, Signed<N>>,
    /// Normal y.
    pub ny: Signal<Out, Signed<N>>,
    /// Normal z.
    pub nz: Signal<Out, Signed<N>>,
}

/// The nearer of two candidates, of two equally near the one with the smaller id, of two alike `a`. Latency 1.
#[derive(LogicBlock, Default)]
pub struct VisibilityNode<const D: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// One.
    pub a: Candidate<D, N>,
    /// The other.
    pub b: Candidate<D, N>,
    /// The nearer one.
    pub nearest: Nearest<D, N>,
    kept_depth: DFF<Signed<D>>,
    kept_id: DFF<Bits<8>>,
    kept_number: DFF<Bits<4>>,
    kept_nx: DFF<Signed<N>>,
    kept_ny: DFF<Signed<N>>,
    kept_nz: DFF<Signed<N>>,
    is_nearer: Signal<Local, Bit>,
    is_as_near: Signal<Local, Bit>,
}

impl<const D: usize, const N: usize> Logic for VisibilityNode<D, N> {
    #[hdl_gen]
    fn update(&mut self) {
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
        self.is_nearer.next = self.b.depth.val() < self.a.depth.val();
        self.is_as_near.next = self.b.depth.val() == self.a.depth.val();
        if self.is_nearer.val() | (self.is_as_near.val() & (self.b.id.val() < self.a.id.val())) {
            self.kept_depth.d.next = self.b.depth.val();
            self.kept_id.d.next = self.b.id.val();
            self.kept_number.d.next = self.b.number.val();
            self.kept_nx.d.next = self.b.nx.val();
            self.kept_ny.d.next = self.b.ny.val();
            self.kept_nz.d.next = self.b.nz.val();
        } else {
            self.kept_depth.d.next = self.a.depth.val();
            self.kept_id.d.next = self.a.id.val();
            self.kept_number.d.next = self.a.number.val();
            self.kept_nx.d.next = self.a.nx.val();
            self.kept_ny.d.next = self.a.ny.val();
            self.kept_nz.d.next = self.a.nz.val();
        }
        self.nearest.depth.next = self.kept_depth.q.val();
        self.nearest.id.next = self.kept_id.q.val();
        self.nearest.number.next = self.kept_number.q.val();
        self.nearest.nx.next = self.kept_nx.q.val();
        self.nearest.ny.next = self.kept_ny.q.val();
        self.nearest.nz.next = self.kept_nz.q.val();
    }
}
