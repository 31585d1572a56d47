//! The decider of solids: a union of products of convex objects.

use super::csg_node::{FaceRegister, FaceWord, NearerFace};
use super::csg_product::CsgProduct;
use crate::kernel::*;
use crate::tree::{Tree, table};

/// Hands on what is seen of the union of `G` products, each of which has `I` objects intersected and `J` taken away.
///
/// Input i of product g has the index `I g + i`, or `J g + j` among those taken away. Normals are not passed on: shading makes them from id, number, depth
/// and pixel, and turns them where `is_back` is set. Of an object only that face is asked for which can be
/// seen: the front of an intersected one, the back of one taken away.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `intersected_i_zf`, `intersected_i_zb` | in | `W` bits, front and back; a front of `ZMAX` is absent |
/// | `intersected_i_id` | in | 8 bits |
/// | `intersected_i_number` | in | 4 bits, face of the front |
/// | `subtracted_j_zf`, `subtracted_j_zb` | in | `W` bits, `ceil(log2 I)` clocks after the intersected |
/// | `subtracted_j_id` | in | 8 bits |
/// | `subtracted_j_number` | in | 4 bits, face of the back |
/// | `depth` | out | `W` bits, `ZMAX` where nothing is seen |
/// | `id`, `number` | out | the face that is seen; 0 where nothing is |
/// | `is_back` | out | it is the back of an object taken away |
///
/// Latency `ceil(log2 I) + 1 + ceil(log2(G (J + 1)))` from the intersected objects. At equal depth a front goes before a back, then the smaller id.
pub struct CsgDecider<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Fronts of the intersected objects.
    pub intersected_zf: Vec<Signal<In, Int<W>>>,
    /// Their backs.
    pub intersected_zb: Vec<Signal<In, Int<W>>>,
    /// Their ids.
    pub intersected_id: Vec<Signal<In, Word<8>>>,
    /// Faces of their fronts.
    pub intersected_number: Vec<Signal<In, Word<4>>>,
    /// Fronts of the objects taken away.
    pub subtracted_zf: Vec<Signal<In, Int<W>>>,
    /// Their backs.
    pub subtracted_zb: Vec<Signal<In, Int<W>>>,
    /// Their ids.
    pub subtracted_id: Vec<Signal<In, Word<8>>>,
    /// Faces of their backs.
    pub subtracted_number: Vec<Signal<In, Word<4>>>,
    /// Depth that is seen.
    pub depth: Signal<Out, Int<W>>,
    /// Id that is seen.
    pub id: Signal<Out, Word<8>>,
    /// Face that is seen.
    pub number: Signal<Out, Word<4>>,
    /// It is a back.
    pub is_back: Signal<Out, Bit>,
    fronts: Vec<FaceWord>,
    backs: Vec<FaceWord>,
    products: Vec<CsgProduct<W>>,
    branch_depth: Vec<Signal<Local, Int<W>>>,
    branch_face: Vec<Signal<Local, Word<13>>>,
    nodes: Vec<NearerFace<W>>,
    registers: Vec<FaceRegister<W>>,
    winner: Signal<Local, Word<13>>,
    intersected_product: Vec<Constant<Word<16>>>,
    intersected_place: Vec<Constant<Word<16>>>,
    subtracted_product: Vec<Constant<Word<16>>>,
    subtracted_place: Vec<Constant<Word<16>>>,
    candidate_product: Vec<Constant<Word<16>>>,
    candidate_place: Vec<Constant<Word<16>>>,
    node_a: Vec<Constant<Word<16>>>,
    node_b: Vec<Constant<Word<16>>>,
    node_out: Vec<Constant<Word<16>>>,
    register_in: Vec<Constant<Word<16>>>,
    register_out: Vec<Constant<Word<16>>>,
    last: Constant<Word<16>>,
    by_number: Constant<Word<8>>,
    by_face: Constant<Word<8>>,
    by_none: Constant<Word<8>>,
    _products: usize,
    _intersected: usize,
    _subtracted: usize,
    _candidates: usize,
    _nodes: usize,
    _registers: usize,
    _asleep: bool,
}

block! {
    [const W: usize] CsgDecider [W]
    inputs { clock, intersected_zf, intersected_zb, intersected_id, intersected_number,
        subtracted_zf, subtracted_zb, subtracted_id, subtracted_number }
    parts { depth, id, number, is_back, fronts, backs, products,
        branch_depth, branch_face, nodes, registers, winner, intersected_product,
        intersected_place, subtracted_product, subtracted_place, candidate_product,
        candidate_place, node_a, node_b, node_out, register_in, register_out, last, by_number, by_face, by_none }
    data { _products, _intersected, _subtracted, _candidates, _nodes, _registers }
}

/// Product and place within it of each of the inputs of all products.
fn places(products: usize, each: usize) -> Vec<[usize; 2]> {
    let of = |product| (0..each).map(move |place| [product, place]);
    (0..products).flat_map(of).collect()
}

impl<const W: usize> CsgDecider<W> {
    /// A decider of so many products, with so many objects intersected and taken away in each.
    pub fn new(products: usize, intersected: usize, subtracted: usize) -> Self {
        let intersections = places(products, intersected);
        let subtractions = places(products, subtracted);
        let candidates = places(products, subtracted + 1);
        let tree = Tree::new(candidates.len());
        fields! {
            [clock, depth, id, number, is_back, winner]
            intersected_zf: repeat(intersections.len(), Default::default),
            intersected_zb: repeat(intersections.len(), Default::default),
            intersected_id: repeat(intersections.len(), Default::default),
            intersected_number: repeat(intersections.len(), Default::default),
            subtracted_zf: repeat(subtractions.len(), Default::default),
            subtracted_zb: repeat(subtractions.len(), Default::default),
            subtracted_id: repeat(subtractions.len(), Default::default),
            subtracted_number: repeat(subtractions.len(), Default::default),
            fronts: repeat(intersections.len(), FaceWord::default),
            backs: repeat(subtractions.len(), FaceWord::default),
            products: repeat(products, || CsgProduct::new(intersected, subtracted)),
            branch_depth: repeat(tree.branches, Default::default),
            branch_face: repeat(tree.branches, Default::default),
            nodes: repeat(tree.nodes.len(), NearerFace::default),
            registers: repeat(tree.registers.len(), FaceRegister::default),
            intersected_product: table(&intersections, 0),
            intersected_place: table(&intersections, 1),
            subtracted_product: table(&subtractions, 0),
            subtracted_place: table(&subtractions, 1),
            candidate_product: table(&candidates, 0),
            candidate_place: table(&candidates, 1),
            node_a: table(&tree.nodes, 0),
            node_b: table(&tree.nodes, 1),
            node_out: table(&tree.nodes, 2),
            register_in: table(&tree.registers, 0),
            register_out: table(&tree.registers, 1),
            last: constant(tree.branches as u64 - 1),
            by_number: constant(4),
            by_face: constant(12),
            by_none: constant(0),
            _products: products,
            _intersected: intersections.len(),
            _subtracted: subtractions.len(),
            _candidates: candidates.len(),
            _nodes: tree.nodes.len(),
            _registers: tree.registers.len(),
        }
    }

    /// Clocks from the intersected objects to what is seen.
    pub const fn latency(products: usize, intersected: usize, subtracted: usize) -> usize {
        let levels = intersected.next_power_of_two().trailing_zeros() as usize;
        let candidates = products * (subtracted + 1);
        levels + 1 + candidates.next_power_of_two().trailing_zeros() as usize
    }
}

impl<const W: usize> Logic for CsgDecider<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("csg_decider");
        for i in 0..self._products {
            self.products[i].clock.next = self.clock.val();
        }
        for i in 0..self._intersected {
            self.fronts[i].id.next = self.intersected_id[i].val();
            self.fronts[i].number.next = self.intersected_number[i].val();
            self.fronts[i].is_back.next = false;
            self.products[self.intersected_product[i].val().index()].intersected_zf
                [self.intersected_place[i].val().index()]
            .next = self.intersected_zf[i].val();
            self.products[self.intersected_product[i].val().index()].intersected_zb
                [self.intersected_place[i].val().index()]
            .next = self.intersected_zb[i].val();
            self.products[self.intersected_product[i].val().index()].intersected_face
                [self.intersected_place[i].val().index()]
            .next = self.fronts[i].face.val();
        }
        for i in 0..self._subtracted {
            self.backs[i].id.next = self.subtracted_id[i].val();
            self.backs[i].number.next = self.subtracted_number[i].val();
            self.backs[i].is_back.next = true;
            self.products[self.subtracted_product[i].val().index()].subtracted_zf
                [self.subtracted_place[i].val().index()]
            .next = self.subtracted_zf[i].val();
            self.products[self.subtracted_product[i].val().index()].subtracted_zb
                [self.subtracted_place[i].val().index()]
            .next = self.subtracted_zb[i].val();
            self.products[self.subtracted_product[i].val().index()].subtracted_face
                [self.subtracted_place[i].val().index()]
            .next = self.backs[i].face.val();
        }
        for i in 0..self._candidates {
            self.branch_depth[i].next = self.products[self.candidate_product[i].val().index()]
                .candidate_depth[self.candidate_place[i].val().index()]
            .val();
            self.branch_face[i].next = self.products[self.candidate_product[i].val().index()]
                .candidate_face[self.candidate_place[i].val().index()]
            .val();
        }
        for i in 0..self._nodes {
            self.branch_depth[self.node_out[i].val().index()].next = self.nodes[i].depth.val();
            self.branch_face[self.node_out[i].val().index()].next = self.nodes[i].face.val();
        }
        for i in 0..self._registers {
            self.branch_depth[self.register_out[i].val().index()].next =
                self.registers[i].depth.val();
            self.branch_face[self.register_out[i].val().index()].next =
                self.registers[i].face.val();
        }
        for i in 0..self._nodes {
            self.nodes[i].clock.next = self.clock.val();
            self.nodes[i].a_depth.next = self.branch_depth[self.node_a[i].val().index()].val();
            self.nodes[i].a_face.next = self.branch_face[self.node_a[i].val().index()].val();
            self.nodes[i].b_depth.next = self.branch_depth[self.node_b[i].val().index()].val();
            self.nodes[i].b_face.next = self.branch_face[self.node_b[i].val().index()].val();
        }
        for i in 0..self._registers {
            self.registers[i].clock.next = self.clock.val();
            self.registers[i].a_depth.next =
                self.branch_depth[self.register_in[i].val().index()].val();
            self.registers[i].a_face.next =
                self.branch_face[self.register_in[i].val().index()].val();
        }
        self.winner.next = self.branch_face[self.last.val().index()].val();
        self.depth.next = self.branch_depth[self.last.val().index()].val();
        self.id.next = self
            .winner
            .val()
            .get_bits::<8>(self.by_number.val().index());
        self.number.next = self.winner.val().get_bits::<4>(self.by_none.val().index());
        self.is_back.next = self.winner.val().get_bit(self.by_face.val().index());
    }
}

clocked!(CsgDecider<const W: usize>);
