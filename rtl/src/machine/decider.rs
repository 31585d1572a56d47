//! Decider: the nearest of many objects.

use super::visibility_node::{VisibilityNode, VisibilityRegister};
use crate::format::MOST_OBJECTS;
use crate::kernel::*;
use crate::tree::{Tree, table};

/// Hands on the nearest of `M` objects: a binary tree of [`VisibilityNode`]s; an odd one out passes a register.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `input_i_depth` | in | `W` bits |
/// | `input_i_id` | in | `I` bits, 8 in the catalogue |
/// | `input_i_number` | in | 4 bits |
/// | `input_i_nx`, `input_i_ny`, `input_i_nz` | in | 16 bits |
/// | `depth`, `id`, `number`, `nx`, `ny`, `nz` | out | the winner |
///
/// Latency `ceil(log2 M)`. At equal depth the smaller id wins.
pub struct Decider<const W: usize, const N: usize = 16, const I: usize = 8> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth of each object.
    pub input_depth: Vec<Signal<In, Int<W>>>,
    /// Id of each object.
    pub input_id: Vec<Signal<In, Word<I>>>,
    /// Face of each object.
    pub input_number: Vec<Signal<In, Word<4>>>,
    /// Normal x of each object.
    pub input_nx: Vec<Signal<In, Int<N>>>,
    /// Normal y of each object.
    pub input_ny: Vec<Signal<In, Int<N>>>,
    /// Normal z of each object.
    pub input_nz: Vec<Signal<In, Int<N>>>,
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
    branch_depth: Vec<Signal<Local, Int<W>>>,
    branch_id: Vec<Signal<Local, Word<I>>>,
    branch_number: Vec<Signal<Local, Word<4>>>,
    branch_nx: Vec<Signal<Local, Int<N>>>,
    branch_ny: Vec<Signal<Local, Int<N>>>,
    branch_nz: Vec<Signal<Local, Int<N>>>,
    nodes: Vec<VisibilityNode<W, N, I>>,
    registers: Vec<VisibilityRegister<W, N, I>>,
    node_a: Vec<Constant<Word<16>>>,
    node_b: Vec<Constant<Word<16>>>,
    node_out: Vec<Constant<Word<16>>>,
    register_in: Vec<Constant<Word<16>>>,
    register_out: Vec<Constant<Word<16>>>,
    winner: Constant<Word<16>>,
    _inputs: usize,
    _nodes: usize,
    _registers: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const N: usize, const I: usize] Decider [W, N, I]
    inputs { clock, input_depth, input_id, input_number, input_nx, input_ny, input_nz }
    parts { depth, id, number, nx, ny, nz, branch_depth, branch_id, branch_number, branch_nx,
        branch_ny, branch_nz, nodes, registers, node_a, node_b, node_out, register_in,
        register_out, winner }
    data { _inputs, _nodes, _registers }
}

impl<const W: usize, const N: usize, const I: usize> Decider<W, N, I> {
    /// A decider of `inputs` objects.
    ///
    /// # Panics
    ///
    /// When `inputs` is not in `1..=256`.
    pub fn new(inputs: usize) -> Self {
        assert!(
            (1..=MOST_OBJECTS).contains(&inputs),
            "a decider has 1 to {MOST_OBJECTS} inputs"
        );
        let tree = Tree::new(inputs);
        Self {
            clock: Signal::default(),
            input_depth: repeat(inputs, Signal::default),
            input_id: repeat(inputs, Signal::default),
            input_number: repeat(inputs, Signal::default),
            input_nx: repeat(inputs, Signal::default),
            input_ny: repeat(inputs, Signal::default),
            input_nz: repeat(inputs, Signal::default),
            depth: Signal::default(),
            id: Signal::default(),
            number: Signal::default(),
            nx: Signal::default(),
            ny: Signal::default(),
            nz: Signal::default(),
            branch_depth: repeat(tree.branches, Signal::default),
            branch_id: repeat(tree.branches, Signal::default),
            branch_number: repeat(tree.branches, Signal::default),
            branch_nx: repeat(tree.branches, Signal::default),
            branch_ny: repeat(tree.branches, Signal::default),
            branch_nz: repeat(tree.branches, Signal::default),
            nodes: repeat(tree.nodes.len(), VisibilityNode::default),
            registers: repeat(tree.registers.len(), VisibilityRegister::default),
            node_a: table(&tree.nodes, 0),
            node_b: table(&tree.nodes, 1),
            node_out: table(&tree.nodes, 2),
            register_in: table(&tree.registers, 0),
            register_out: table(&tree.registers, 1),
            winner: constant(tree.branches as u64 - 1),
            _inputs: inputs,
            _nodes: tree.nodes.len(),
            _registers: tree.registers.len(),
            _asleep: false,
        }
    }

    /// Clocks from the objects to the winner.
    pub const fn latency(inputs: usize) -> usize {
        inputs.next_power_of_two().trailing_zeros() as usize
    }
}

impl<const W: usize, const N: usize, const I: usize> Logic for Decider<W, N, I> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("decider");
        for i in 0..self._inputs {
            self.branch_depth[i].next = self.input_depth[i].val();
            self.branch_id[i].next = self.input_id[i].val();
            self.branch_number[i].next = self.input_number[i].val();
            self.branch_nx[i].next = self.input_nx[i].val();
            self.branch_ny[i].next = self.input_ny[i].val();
            self.branch_nz[i].next = self.input_nz[i].val();
        }
        for i in 0..self._nodes {
            self.branch_depth[self.node_out[i].val().index()].next = self.nodes[i].depth.val();
            self.branch_id[self.node_out[i].val().index()].next = self.nodes[i].id.val();
            self.branch_number[self.node_out[i].val().index()].next = self.nodes[i].number.val();
            self.branch_nx[self.node_out[i].val().index()].next = self.nodes[i].nx.val();
            self.branch_ny[self.node_out[i].val().index()].next = self.nodes[i].ny.val();
            self.branch_nz[self.node_out[i].val().index()].next = self.nodes[i].nz.val();
        }
        for i in 0..self._registers {
            self.branch_depth[self.register_out[i].val().index()].next =
                self.registers[i].depth.val();
            self.branch_id[self.register_out[i].val().index()].next = self.registers[i].id.val();
            self.branch_number[self.register_out[i].val().index()].next =
                self.registers[i].number.val();
            self.branch_nx[self.register_out[i].val().index()].next = self.registers[i].nx.val();
            self.branch_ny[self.register_out[i].val().index()].next = self.registers[i].ny.val();
            self.branch_nz[self.register_out[i].val().index()].next = self.registers[i].nz.val();
        }
        for i in 0..self._nodes {
            self.nodes[i].clock.next = self.clock.val();
            self.nodes[i].a_depth.next = self.branch_depth[self.node_a[i].val().index()].val();
            self.nodes[i].a_id.next = self.branch_id[self.node_a[i].val().index()].val();
            self.nodes[i].a_number.next = self.branch_number[self.node_a[i].val().index()].val();
            self.nodes[i].a_nx.next = self.branch_nx[self.node_a[i].val().index()].val();
            self.nodes[i].a_ny.next = self.branch_ny[self.node_a[i].val().index()].val();
            self.nodes[i].a_nz.next = self.branch_nz[self.node_a[i].val().index()].val();
            self.nodes[i].b_depth.next = self.branch_depth[self.node_b[i].val().index()].val();
            self.nodes[i].b_id.next = self.branch_id[self.node_b[i].val().index()].val();
            self.nodes[i].b_number.next = self.branch_number[self.node_b[i].val().index()].val();
            self.nodes[i].b_nx.next = self.branch_nx[self.node_b[i].val().index()].val();
            self.nodes[i].b_ny.next = self.branch_ny[self.node_b[i].val().index()].val();
            self.nodes[i].b_nz.next = self.branch_nz[self.node_b[i].val().index()].val();
        }
        for i in 0..self._registers {
            self.registers[i].clock.next = self.clock.val();
            self.registers[i].a_depth.next =
                self.branch_depth[self.register_in[i].val().index()].val();
            self.registers[i].a_id.next = self.branch_id[self.register_in[i].val().index()].val();
            self.registers[i].a_number.next =
                self.branch_number[self.register_in[i].val().index()].val();
            self.registers[i].a_nx.next = self.branch_nx[self.register_in[i].val().index()].val();
            self.registers[i].a_ny.next = self.branch_ny[self.register_in[i].val().index()].val();
            self.registers[i].a_nz.next = self.branch_nz[self.register_in[i].val().index()].val();
        }
        self.depth.next = self.branch_depth[self.winner.val().index()].val();
        self.id.next = self.branch_id[self.winner.val().index()].val();
        self.number.next = self.branch_number[self.winner.val().index()].val();
        self.nx.next = self.branch_nx[self.winner.val().index()].val();
        self.ny.next = self.branch_ny[self.winner.val().index()].val();
        self.nz.next = self.branch_nz[self.winner.val().index()].val();
    }
}

clocked!(Decider<const W: usize, const N: usize, const I: usize>);
