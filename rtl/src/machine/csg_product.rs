//! One product of a solid: what several convex objects have in common, without what others take away.

use super::csg_node::{Overlap, OverlapRegister};
use crate::format::far_end;
use crate::kernel::*;
use crate::tree::{Tree, table};

/// Tells whether the line of sight behind a place is inside one of several intervals; for a solid of no thickness, whether the place is.
///
/// No clock.
pub struct IntervalCover<const W: usize> {
    /// Depth of the place.
    pub place: Signal<In, Int<W>>,
    /// What is there has no thickness.
    pub is_sheet: Signal<In, Bit>,
    /// Fronts of the intervals.
    pub other_zf: Vec<Signal<In, Int<W>>>,
    /// Backs of the intervals.
    pub other_zb: Vec<Signal<In, Int<W>>>,
    /// One covers the place.
    pub is_covered: Signal<Out, Bit>,
    begins: Vec<Signal<Local, Bit>>,
    goes_on: Vec<Signal<Local, Bit>>,
    ends_here: Vec<Signal<Local, Bit>>,
    covered: Vec<Signal<Local, Bit>>,
    _first: usize,
    _others: usize,
    _asleep: bool,
}

block! {
    [const W: usize] IntervalCover [W]
    inputs { place, is_sheet, other_zf, other_zb }
    parts { is_covered, begins, goes_on, ends_here, covered }
    data { _first, _others }
}

impl<const W: usize> IntervalCover<W> {
    fn new(others: usize) -> Self {
        fields! {
            [place, is_sheet, is_covered]
            other_zf: repeat(others, Default::default),
            other_zb: repeat(others, Default::default),
            begins: repeat(others, Default::default),
            goes_on: repeat(others, Default::default),
            ends_here: repeat(others, Default::default),
            covered: repeat(others, Default::default),
            _first: others.min(1),
            _others: others,
        }
    }
}

impl<const W: usize> Logic for IntervalCover<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("interval_cover");
        self.is_covered.next = false;
        for i in 0..self._others {
            self.begins[i].next = self.other_zf[i].val() <= self.place.val();
            self.goes_on[i].next = self.place.val() < self.other_zb[i].val();
            self.ends_here[i].next =
                self.is_sheet.val() & (self.place.val() == self.other_zb[i].val());
        }
        for i in 0..self._first {
            self.covered[i].next =
                self.begins[i].val() & (self.goes_on[i].val() | self.ends_here[i].val());
        }
        for i in 1..self._others {
            self.covered[i].next = self.covered[i - 1].val()
                | (self.begins[i].val() & (self.goes_on[i].val() | self.ends_here[i].val()));
        }
        for i in 0..self._others {
            self.is_covered.next = self.covered[i].val();
        }
    }
}

/// Gives the depths at which a product can be seen first: the front of the intersection, and the back of every object taken away.
///
/// A candidate survives if nothing that is taken away covers the line behind it; a back, if it lies within the intersection. The nearest survivor is
/// the front of the product: where the line before a front that is not the intersection's is outside, it is inside some object taken away that
/// ends there. Others have the depth `ZMAX` and a face of zeros.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `intersected_i_zf`, `intersected_i_zb` | in | `W` bits; a front of `ZMAX` is absent |
/// | `intersected_i_face` | in | 13 bits |
/// | `subtracted_j_zf`, `subtracted_j_zb` | in | `W` bits, `ceil(log2 I)` clocks after the intersected |
/// | `subtracted_j_face` | in | 13 bits |
/// | `candidate_k_depth`, `candidate_k_face` | out | k = 0: the front; 1 + j: the back of j |
///
/// Latency `ceil(log2 I) + 1`.
pub struct CsgProduct<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Fronts of the intersected objects.
    pub intersected_zf: Vec<Signal<In, Int<W>>>,
    /// Their backs.
    pub intersected_zb: Vec<Signal<In, Int<W>>>,
    /// Faces of the fronts.
    pub intersected_face: Vec<Signal<In, Word<13>>>,
    /// Fronts of the objects taken away.
    pub subtracted_zf: Vec<Signal<In, Int<W>>>,
    /// Their backs.
    pub subtracted_zb: Vec<Signal<In, Int<W>>>,
    /// Faces of the backs.
    pub subtracted_face: Vec<Signal<In, Word<13>>>,
    /// Depths of the candidates.
    pub candidate_depth: Vec<Signal<Out, Int<W>>>,
    /// Their faces.
    pub candidate_face: Vec<Signal<Out, Word<13>>>,
    branch_zf: Vec<Signal<Local, Int<W>>>,
    branch_zb: Vec<Signal<Local, Int<W>>>,
    branch_face: Vec<Signal<Local, Word<13>>>,
    nodes: Vec<Overlap<W>>,
    registers: Vec<OverlapRegister<W>>,
    front: Signal<Local, Int<W>>,
    back: Signal<Local, Int<W>>,
    front_face: Signal<Local, Word<13>>,
    front_is_seen: Signal<Local, Bit>,
    front_cover: IntervalCover<W>,
    covers: Vec<IntervalCover<W>>,
    is_within: Vec<Signal<Local, Bit>>,
    kept_depth: Vec<DFF<Int<W>>>,
    kept_face: Vec<DFF<Word<13>>>,
    node_a: Vec<Constant<Word<16>>>,
    node_b: Vec<Constant<Word<16>>>,
    node_out: Vec<Constant<Word<16>>>,
    register_in: Vec<Constant<Word<16>>>,
    register_out: Vec<Constant<Word<16>>>,
    pair_back: Vec<Constant<Word<16>>>,
    pair_place: Vec<Constant<Word<16>>>,
    pair_other: Vec<Constant<Word<16>>>,
    last: Constant<Word<16>>,
    far: Constant<Int<W>>,
    no_face: Constant<Word<13>>,
    _intersected: usize,
    _subtracted: usize,
    _nodes: usize,
    _registers: usize,
    _pairs: usize,
    _asleep: bool,
}

block! {
    [const W: usize] CsgProduct [W]
    inputs { clock, intersected_zf, intersected_zb, intersected_face, subtracted_zf, subtracted_zb,
        subtracted_face }
    parts { candidate_depth, candidate_face, branch_zf, branch_zb, branch_face, nodes, registers,
        front, back, front_face, front_is_seen, front_cover, covers, is_within, kept_depth,
        kept_face, node_a, node_b, node_out, register_in, register_out, pair_back, pair_place,
        pair_other, last, far, no_face }
    data { _intersected, _subtracted, _nodes, _registers, _pairs }
}

/// Every object taken away with every other: the two, and the place of the second among the others of the first.
fn pairs(subtracted: usize) -> Vec<[usize; 3]> {
    let of = |one: usize| {
        let others = (0..subtracted).filter(move |&other| other != one);
        others
            .enumerate()
            .map(move |(place, other)| [one, place, other])
    };
    (0..subtracted).flat_map(of).collect()
}

impl<const W: usize> CsgProduct<W> {
    /// A product of so many objects intersected and taken away.
    pub fn new(intersected: usize, subtracted: usize) -> Self {
        let tree = Tree::new(intersected);
        let pairs = pairs(subtracted);
        fields! {
            [clock, front, back, front_face, front_is_seen]
            intersected_zf: repeat(intersected, Default::default),
            intersected_zb: repeat(intersected, Default::default),
            intersected_face: repeat(intersected, Default::default),
            subtracted_zf: repeat(subtracted, Default::default),
            subtracted_zb: repeat(subtracted, Default::default),
            subtracted_face: repeat(subtracted, Default::default),
            candidate_depth: repeat(subtracted + 1, Default::default),
            candidate_face: repeat(subtracted + 1, Default::default),
            branch_zf: repeat(tree.branches, Default::default),
            branch_zb: repeat(tree.branches, Default::default),
            branch_face: repeat(tree.branches, Default::default),
            nodes: repeat(tree.nodes.len(), Overlap::default),
            registers: repeat(tree.registers.len(), OverlapRegister::default),
            front_cover: IntervalCover::new(subtracted),
            covers: repeat(subtracted, || IntervalCover::new(subtracted - 1)),
            is_within: repeat(subtracted, Default::default),
            kept_depth: repeat(subtracted + 1, Default::default),
            kept_face: repeat(subtracted + 1, Default::default),
            node_a: table(&tree.nodes, 0),
            node_b: table(&tree.nodes, 1),
            node_out: table(&tree.nodes, 2),
            register_in: table(&tree.registers, 0),
            register_out: table(&tree.registers, 1),
            pair_back: table(&pairs, 0),
            pair_place: table(&pairs, 1),
            pair_other: table(&pairs, 2),
            last: constant(tree.branches as u64 - 1),
            far: signed_constant(far_end(W)),
            no_face: constant(0),
            _intersected: intersected,
            _subtracted: subtracted,
            _nodes: tree.nodes.len(),
            _registers: tree.registers.len(),
            _pairs: pairs.len(),
        }
    }
}

impl<const W: usize> Logic for CsgProduct<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("csg_product");
        for i in 0..self._intersected {
            self.branch_zf[i].next = self.intersected_zf[i].val();
            self.branch_zb[i].next = self.intersected_zb[i].val();
            self.branch_face[i].next = self.intersected_face[i].val();
        }
        for i in 0..self._nodes {
            self.branch_zf[self.node_out[i].val().index()].next = self.nodes[i].zf.val();
            self.branch_zb[self.node_out[i].val().index()].next = self.nodes[i].zb.val();
            self.branch_face[self.node_out[i].val().index()].next = self.nodes[i].face.val();
        }
        for i in 0..self._registers {
            self.branch_zf[self.register_out[i].val().index()].next = self.registers[i].zf.val();
            self.branch_zb[self.register_out[i].val().index()].next = self.registers[i].zb.val();
            self.branch_face[self.register_out[i].val().index()].next =
                self.registers[i].face.val();
        }
        for i in 0..self._nodes {
            self.nodes[i].clock.next = self.clock.val();
            self.nodes[i].a_zf.next = self.branch_zf[self.node_a[i].val().index()].val();
            self.nodes[i].a_zb.next = self.branch_zb[self.node_a[i].val().index()].val();
            self.nodes[i].a_face.next = self.branch_face[self.node_a[i].val().index()].val();
            self.nodes[i].b_zf.next = self.branch_zf[self.node_b[i].val().index()].val();
            self.nodes[i].b_zb.next = self.branch_zb[self.node_b[i].val().index()].val();
            self.nodes[i].b_face.next = self.branch_face[self.node_b[i].val().index()].val();
        }
        for i in 0..self._registers {
            self.registers[i].clock.next = self.clock.val();
            self.registers[i].a_zf.next = self.branch_zf[self.register_in[i].val().index()].val();
            self.registers[i].a_zb.next = self.branch_zb[self.register_in[i].val().index()].val();
            self.registers[i].a_face.next =
                self.branch_face[self.register_in[i].val().index()].val();
        }
        self.front.next = self.branch_zf[self.last.val().index()].val();
        self.back.next = self.branch_zb[self.last.val().index()].val();
        self.front_face.next = self.branch_face[self.last.val().index()].val();
        self.front_cover.place.next = self.front.val();
        self.front_cover.is_sheet.next = self.front.val() == self.back.val();
        for i in 0..self._subtracted {
            self.front_cover.other_zf[i].next = self.subtracted_zf[i].val();
            self.front_cover.other_zb[i].next = self.subtracted_zb[i].val();
        }
        self.front_is_seen.next = (self.front.val() <= self.back.val())
            & (self.front.val() < self.far.val())
            & !self.front_cover.is_covered.val();
        self.kept_depth[0].clock.next = self.clock.val();
        self.kept_face[0].clock.next = self.clock.val();
        self.kept_depth[0].d.next = self.far.val();
        self.kept_face[0].d.next = self.no_face.val();
        if self.front_is_seen.val() {
            self.kept_depth[0].d.next = self.front.val();
            self.kept_face[0].d.next = self.front_face.val();
        }
        for i in 0..self._pairs {
            self.covers[self.pair_back[i].val().index()].other_zf
                [self.pair_place[i].val().index()]
            .next = self.subtracted_zf[self.pair_other[i].val().index()].val();
            self.covers[self.pair_back[i].val().index()].other_zb
                [self.pair_place[i].val().index()]
            .next = self.subtracted_zb[self.pair_other[i].val().index()].val();
        }
        for i in 0..self._subtracted {
            self.covers[i].place.next = self.subtracted_zb[i].val();
            self.covers[i].is_sheet.next = false;
            // What has no thickness, or is absent, takes nothing away and has no back to show.
            self.is_within[i].next = (self.subtracted_zf[i].val() < self.subtracted_zb[i].val())
                & (self.front.val() < self.subtracted_zb[i].val())
                & (self.subtracted_zb[i].val() < self.back.val());
            self.kept_depth[i + 1].clock.next = self.clock.val();
            self.kept_face[i + 1].clock.next = self.clock.val();
            self.kept_depth[i + 1].d.next = self.far.val();
            self.kept_face[i + 1].d.next = self.no_face.val();
            if self.is_within[i].val() & !self.covers[i].is_covered.val() {
                self.kept_depth[i + 1].d.next = self.subtracted_zb[i].val();
                self.kept_face[i + 1].d.next = self.subtracted_face[i].val();
            }
            self.candidate_depth[i + 1].next = self.kept_depth[i + 1].q.val();
            self.candidate_face[i + 1].next = self.kept_face[i + 1].q.val();
        }
        self.candidate_depth[0].next = self.kept_depth[0].q.val();
        self.candidate_face[0].next = self.kept_face[0].q.val();
    }
}
