//! The nearest of many objects, found on the way past their processors.

use super::visibility_node::{VisibilityNode, VisibilityRegister};
use crate::format::MOST_OBJECTS;
use crate::kernel::*;

/// Hands on the nearest of `M` objects: cell i compares object i with what comes from cell i - 1 and hands on the nearer.
///
/// A cell stands beside its processor, so that no wires but those to the next processor leave it. Input i is taken i clocks after input 0 of
/// the same pixel: processor i starts i clocks later, which costs nothing.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `input_i_depth` | in | `W` bits, i clocks after input 0 |
/// | `input_i_id` | in | 8 bits |
/// | `input_i_number` | in | 4 bits |
/// | `input_i_nx`, `input_i_ny`, `input_i_nz` | in | 16 bits |
/// | `depth`, `id`, `number`, `nx`, `ny`, `nz` | out | the winner |
///
/// Latency `M` from input 0. At equal depth the smaller id wins.
pub struct VisibilityChain<const W: usize, const N: usize = 16> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth of each object.
    pub input_depth: Vec<Signal<In, Int<W>>>,
    /// Id of each object.
    pub input_id: Vec<Signal<In, Word<8>>>,
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
    pub id: Signal<Out, Word<8>>,
    /// Face of the winner.
    pub number: Signal<Out, Word<4>>,
    /// Normal x of the winner.
    pub nx: Signal<Out, Int<N>>,
    /// Normal y of the winner.
    pub ny: Signal<Out, Int<N>>,
    /// Normal z of the winner.
    pub nz: Signal<Out, Int<N>>,
    cell_depth: Vec<Signal<Local, Int<W>>>,
    cell_id: Vec<Signal<Local, Word<8>>>,
    cell_number: Vec<Signal<Local, Word<4>>>,
    cell_nx: Vec<Signal<Local, Int<N>>>,
    cell_ny: Vec<Signal<Local, Int<N>>>,
    cell_nz: Vec<Signal<Local, Int<N>>>,
    /// Cell 0, to which nothing comes.
    beginning: VisibilityRegister<W, N>,
    nodes: Vec<VisibilityNode<W, N>>,
    _nodes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const N: usize] VisibilityChain [W, N]
    inputs { clock, input_depth, input_id, input_number, input_nx, input_ny, input_nz }
    parts { depth, id, number, nx, ny, nz, cell_depth, cell_id, cell_number, cell_nx, cell_ny,
        cell_nz, beginning, nodes }
    data { _nodes }
}

impl<const W: usize, const N: usize> VisibilityChain<W, N> {
    /// A chain past `inputs` objects.
    ///
    /// # Panics
    ///
    /// When `inputs` is not in `1..=256`.
    pub fn new(inputs: usize) -> Self {
        assert!(
            (1..=MOST_OBJECTS).contains(&inputs),
            "a visibility chain has 1 to {MOST_OBJECTS} inputs"
        );
        fields! {
            [clock, depth, id, number, nx, ny, nz, beginning]
            input_depth: repeat(inputs, Default::default),
            input_id: repeat(inputs, Default::default),
            input_number: repeat(inputs, Default::default),
            input_nx: repeat(inputs, Default::default),
            input_ny: repeat(inputs, Default::default),
            input_nz: repeat(inputs, Default::default),
            cell_depth: repeat(inputs, Default::default),
            cell_id: repeat(inputs, Default::default),
            cell_number: repeat(inputs, Default::default),
            cell_nx: repeat(inputs, Default::default),
            cell_ny: repeat(inputs, Default::default),
            cell_nz: repeat(inputs, Default::default),
            nodes: repeat(inputs - 1, VisibilityNode::default),
            _nodes: inputs - 1,
        }
    }

    /// Clocks from input 0 to the winner.
    pub const fn latency(inputs: usize) -> usize {
        inputs
    }
}

impl<const W: usize, const N: usize> Logic for VisibilityChain<W, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("visibility_chain");
        self.beginning.clock.next = self.clock.val();
        self.beginning.a_depth.next = self.input_depth[0].val();
        self.beginning.a_id.next = self.input_id[0].val();
        self.beginning.a_number.next = self.input_number[0].val();
        self.beginning.a_nx.next = self.input_nx[0].val();
        self.beginning.a_ny.next = self.input_ny[0].val();
        self.beginning.a_nz.next = self.input_nz[0].val();
        self.cell_depth[0].next = self.beginning.depth.val();
        self.cell_id[0].next = self.beginning.id.val();
        self.cell_number[0].next = self.beginning.number.val();
        self.cell_nx[0].next = self.beginning.nx.val();
        self.cell_ny[0].next = self.beginning.ny.val();
        self.cell_nz[0].next = self.beginning.nz.val();
        self.depth.next = self.beginning.depth.val();
        self.id.next = self.beginning.id.val();
        self.number.next = self.beginning.number.val();
        self.nx.next = self.beginning.nx.val();
        self.ny.next = self.beginning.ny.val();
        self.nz.next = self.beginning.nz.val();
        for i in 0..self._nodes {
            self.nodes[i].clock.next = self.clock.val();
            self.nodes[i].a_depth.next = self.cell_depth[i].val();
            self.nodes[i].a_id.next = self.cell_id[i].val();
            self.nodes[i].a_number.next = self.cell_number[i].val();
            self.nodes[i].a_nx.next = self.cell_nx[i].val();
            self.nodes[i].a_ny.next = self.cell_ny[i].val();
            self.nodes[i].a_nz.next = self.cell_nz[i].val();
            self.nodes[i].b_depth.next = self.input_depth[i + 1].val();
            self.nodes[i].b_id.next = self.input_id[i + 1].val();
            self.nodes[i].b_number.next = self.input_number[i + 1].val();
            self.nodes[i].b_nx.next = self.input_nx[i + 1].val();
            self.nodes[i].b_ny.next = self.input_ny[i + 1].val();
            self.nodes[i].b_nz.next = self.input_nz[i + 1].val();
            self.cell_depth[i + 1].next = self.nodes[i].depth.val();
            self.cell_id[i + 1].next = self.nodes[i].id.val();
            self.cell_number[i + 1].next = self.nodes[i].number.val();
            self.cell_nx[i + 1].next = self.nodes[i].nx.val();
            self.cell_ny[i + 1].next = self.nodes[i].ny.val();
            self.cell_nz[i + 1].next = self.nodes[i].nz.val();
            self.depth.next = self.nodes[i].depth.val();
            self.id.next = self.nodes[i].id.val();
            self.number.next = self.nodes[i].number.val();
            self.nx.next = self.nodes[i].nx.val();
            self.ny.next = self.nodes[i].ny.val();
            self.nz.next = self.nodes[i].nz.val();
        }
    }
}

clocked!(VisibilityChain<const W: usize, const N: usize>);
