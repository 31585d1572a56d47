//! Intersection of half-spaces along the line of sight.

use super::half_space_node::HalfSpaceNode;
use super::half_space_register::HalfSpaceRegister;
use crate::format::{
    BACK_PLANE, CAP, FIRST_PLANE, FRONT_PLANE, MOST_PLANES, PERPENDICULAR, far_end, near_end,
    saturated_near,
};
use crate::kernel::*;
use crate::tree::{Tree, table};

/// Gives the interval of depth that all planes keep: a tree over the greatest depth of the front planes and the least of the back
/// planes, then the two ends of the depth word.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `plane_i_kind` | in | 2 bits: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0) |
/// | `plane_i_zp` | in | `W` bits, clamped depth of plane i |
/// | `is_there` | in | the pixel lies in the screen box; beside the output of the tree, one clock before the results |
/// | `zf`, `zb` | out | `W` bits; `ZMAX` twice where absent |
/// | `nf`, `nb` | out | 4 bits, 2 + i for plane i, 15 at an end of the depth word, 0 where absent |
///
/// Latency `ceil(log2 planes) + 1`. The source cuts the whole line in a chain; a chain that begins with the whole line only looks for
/// these two extremes. Annex A.
pub struct HalfSpaces<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Kind of each plane.
    pub plane_kind: Vec<Signal<In, Word<2>>>,
    /// Depth of each plane.
    pub plane_zp: Vec<Signal<In, Int<W>>>,
    /// The pixel lies in the screen box.
    pub is_there: Signal<In, Bit>,
    /// Front depth.
    pub zf: Signal<Out, Int<W>>,
    /// Front face.
    pub nf: Signal<Out, Word<4>>,
    /// Back depth.
    pub zb: Signal<Out, Int<W>>,
    /// Back face.
    pub nb: Signal<Out, Word<4>>,
    branch_front: Vec<Signal<Local, Int<W>>>,
    branch_back: Vec<Signal<Local, Int<W>>>,
    branch_front_number: Vec<Signal<Local, Word<4>>>,
    branch_back_number: Vec<Signal<Local, Word<4>>>,
    branch_removed: Vec<Signal<Local, Bit>>,
    nodes: Vec<HalfSpaceNode<W>>,
    registers: Vec<HalfSpaceRegister<W>>,
    front: Signal<Local, Int<W>>,
    back: Signal<Local, Int<W>>,
    front_depth: Signal<Local, Int<W>>,
    back_depth: Signal<Local, Int<W>>,
    front_number: Signal<Local, Word<4>>,
    back_number: Signal<Local, Word<4>>,
    front_face: Signal<Local, Word<4>>,
    back_face: Signal<Local, Word<4>>,
    is_front_face: Signal<Local, Bit>,
    is_back_face: Signal<Local, Bit>,
    present: Signal<Local, Bit>,
    kept_zf: DFF<Int<W>>,
    kept_zb: DFF<Int<W>>,
    kept_nf: DFF<Word<4>>,
    kept_nb: DFF<Word<4>>,
    node_a: Vec<Constant<Word<16>>>,
    node_b: Vec<Constant<Word<16>>>,
    node_out: Vec<Constant<Word<16>>>,
    register_in: Vec<Constant<Word<16>>>,
    register_out: Vec<Constant<Word<16>>>,
    plane_number: Vec<Constant<Word<4>>>,
    last: Constant<Word<16>>,
    front_kind: Constant<Word<2>>,
    back_kind: Constant<Word<2>>,
    perpendicular: Constant<Word<2>>,
    lowest: Constant<Int<W>>,
    low: Constant<Int<W>>,
    far_limit: Constant<Int<W>>,
    cap: Constant<Word<4>>,
    no_face: Constant<Word<4>>,
    sign: Constant<Word<8>>,
    _planes: usize,
    _nodes: usize,
    _registers: usize,
    _asleep: bool,
}

block! {
    [const W: usize] HalfSpaces [W]
    inputs { clock, plane_kind, plane_zp, is_there }
    parts { zf, nf, zb, nb, branch_front, branch_back, branch_front_number, branch_back_number,
        branch_removed, nodes, registers, front, back, front_depth, back_depth, front_number,
        back_number, front_face, back_face, is_front_face, is_back_face, present, kept_zf,
        kept_zb, kept_nf, kept_nb, node_a, node_b, node_out, register_in, register_out,
        plane_number, last, front_kind, back_kind, perpendicular, lowest, low, far_limit, cap, no_face,
        sign }
    data { _planes, _nodes, _registers }
}

impl<const W: usize> HalfSpaces<W> {
    /// A unit for `planes` planes.
    ///
    /// # Panics
    ///
    /// When `planes` is not in `1..=12`.
    pub fn new(planes: usize) -> Self {
        assert!(
            (1..=MOST_PLANES).contains(&planes),
            "half-spaces are 1 to {MOST_PLANES}"
        );
        let tree = Tree::new(planes);
        fields! {
            [clock, is_there, zf, nf, zb, nb, front, back, front_depth, back_depth, front_number,
                back_number, front_face, back_face, is_front_face, is_back_face, present, kept_zf,
                kept_zb, kept_nf, kept_nb]
            plane_kind: repeat(planes, Default::default),
            plane_zp: repeat(planes, Default::default),
            branch_front: repeat(tree.branches, Default::default),
            branch_back: repeat(tree.branches, Default::default),
            branch_front_number: repeat(tree.branches, Default::default),
            branch_back_number: repeat(tree.branches, Default::default),
            branch_removed: repeat(tree.branches, Default::default),
            nodes: repeat(tree.nodes.len(), HalfSpaceNode::default),
            registers: repeat(tree.registers.len(), HalfSpaceRegister::default),
            node_a: table(&tree.nodes, 0),
            node_b: table(&tree.nodes, 1),
            node_out: table(&tree.nodes, 2),
            register_in: table(&tree.registers, 0),
            register_out: table(&tree.registers, 1),
            plane_number: (0..planes as u64)
                .map(|i| constant(FIRST_PLANE + i))
                .collect(),
            last: constant(tree.branches as u64 - 1),
            front_kind: constant(FRONT_PLANE),
            back_kind: constant(BACK_PLANE),
            perpendicular: constant(PERPENDICULAR),
            lowest: signed_constant(saturated_near(W)),
            low: signed_constant(near_end(W)),
            far_limit: signed_constant(far_end(W)),
            cap: constant(CAP),
            no_face: constant(0),
            sign: constant(W as u64 - 1),
            _planes: planes,
            _nodes: tree.nodes.len(),
            _registers: tree.registers.len(),
        }
    }

    /// Clocks from the planes to the output of the tree.
    pub const fn tree_latency(planes: usize) -> usize {
        planes.next_power_of_two().trailing_zeros() as usize
    }

    /// Clocks from the planes to the interval.
    pub const fn latency(planes: usize) -> usize {
        Self::tree_latency(planes) + 1
    }
}

impl<const W: usize> Logic for HalfSpaces<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("half_spaces");
        clock!(self, clock, kept_zf, kept_nf, kept_zb, kept_nb);
        // What a plane says by itself; where it says nothing, a depth that loses to every plane.
        for i in 0..self._planes {
            self.branch_front[i].next = self.lowest.val();
            self.branch_front_number[i].next = self.plane_number[i].val();
            self.branch_back[i].next = self.far_limit.val();
            self.branch_back_number[i].next = self.plane_number[i].val();
            self.branch_removed[i].next = (self.plane_kind[i].val() == self.perpendicular.val())
                & self.plane_zp[i].val().get_bit(self.sign.val().index());
            if self.plane_kind[i].val() == self.front_kind.val() {
                self.branch_front[i].next = self.plane_zp[i].val();
            }
            if self.plane_kind[i].val() == self.back_kind.val() {
                self.branch_back[i].next = self.plane_zp[i].val();
            }
        }
        for i in 0..self._nodes {
            self.branch_front[self.node_out[i].val().index()].next = self.nodes[i].front.val();
            self.branch_front_number[self.node_out[i].val().index()].next =
                self.nodes[i].front_number.val();
            self.branch_back[self.node_out[i].val().index()].next = self.nodes[i].back.val();
            self.branch_back_number[self.node_out[i].val().index()].next =
                self.nodes[i].back_number.val();
            self.branch_removed[self.node_out[i].val().index()].next = self.nodes[i].removed.val();
        }
        for i in 0..self._registers {
            self.branch_front[self.register_out[i].val().index()].next =
                self.registers[i].front.val();
            self.branch_front_number[self.register_out[i].val().index()].next =
                self.registers[i].front_number.val();
            self.branch_back[self.register_out[i].val().index()].next =
                self.registers[i].back.val();
            self.branch_back_number[self.register_out[i].val().index()].next =
                self.registers[i].back_number.val();
            self.branch_removed[self.register_out[i].val().index()].next =
                self.registers[i].removed.val();
        }
        for i in 0..self._nodes {
            self.nodes[i].clock.next = self.clock.val();
            self.nodes[i].a_front.next = self.branch_front[self.node_a[i].val().index()].val();
            self.nodes[i].a_front_number.next =
                self.branch_front_number[self.node_a[i].val().index()].val();
            self.nodes[i].a_back.next = self.branch_back[self.node_a[i].val().index()].val();
            self.nodes[i].a_back_number.next =
                self.branch_back_number[self.node_a[i].val().index()].val();
            self.nodes[i].a_removed.next = self.branch_removed[self.node_a[i].val().index()].val();
            self.nodes[i].b_front.next = self.branch_front[self.node_b[i].val().index()].val();
            self.nodes[i].b_front_number.next =
                self.branch_front_number[self.node_b[i].val().index()].val();
            self.nodes[i].b_back.next = self.branch_back[self.node_b[i].val().index()].val();
            self.nodes[i].b_back_number.next =
                self.branch_back_number[self.node_b[i].val().index()].val();
            self.nodes[i].b_removed.next = self.branch_removed[self.node_b[i].val().index()].val();
        }
        for i in 0..self._registers {
            self.registers[i].clock.next = self.clock.val();
            self.registers[i].a_front.next =
                self.branch_front[self.register_in[i].val().index()].val();
            self.registers[i].a_front_number.next =
                self.branch_front_number[self.register_in[i].val().index()].val();
            self.registers[i].a_back.next =
                self.branch_back[self.register_in[i].val().index()].val();
            self.registers[i].a_back_number.next =
                self.branch_back_number[self.register_in[i].val().index()].val();
            self.registers[i].a_removed.next =
                self.branch_removed[self.register_in[i].val().index()].val();
        }
        self.front.next = self.branch_front[self.last.val().index()].val();
        self.front_number.next = self.branch_front_number[self.last.val().index()].val();
        self.back.next = self.branch_back[self.last.val().index()].val();
        self.back_number.next = self.branch_back_number[self.last.val().index()].val();
        self.is_front_face.next = self.low.val() < self.front.val();
        self.is_back_face.next = self.back.val() < self.far_limit.val();
        self.front_depth.next = self.low.val();
        self.front_face.next = self.cap.val();
        if self.is_front_face.val() {
            self.front_depth.next = self.front.val();
            self.front_face.next = self.front_number.val();
        }
        self.back_depth.next = self.far_limit.val();
        self.back_face.next = self.cap.val();
        if self.is_back_face.val() {
            self.back_depth.next = self.back.val();
            self.back_face.next = self.back_number.val();
        }
        self.present.next = self.is_there.val()
            & !self.branch_removed[self.last.val().index()].val()
            & (self.front_depth.val() <= self.back_depth.val())
            & (self.front_depth.val() < self.far_limit.val());
        self.kept_zf.d.next = self.far_limit.val();
        self.kept_nf.d.next = self.no_face.val();
        self.kept_zb.d.next = self.far_limit.val();
        self.kept_nb.d.next = self.no_face.val();
        if self.present.val() {
            self.kept_zf.d.next = self.front_depth.val();
            self.kept_nf.d.next = self.front_face.val();
            self.kept_zb.d.next = self.back_depth.val();
            self.kept_nb.d.next = self.back_face.val();
        }
        self.zf.next = self.kept_zf.q.val();
        self.nf.next = self.kept_nf.q.val();
        self.zb.next = self.kept_zb.q.val();
        self.nb.next = self.kept_nb.q.val();
    }
}

clocked!(HalfSpaces<const W: usize>);
