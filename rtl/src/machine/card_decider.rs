//! The nearest of the objects of many cards: a chain on each card, a tree between the cards.

use super::decider::Decider;
use super::visibility_chain::VisibilityChain;
use crate::format::MOST_OBJECTS;
use crate::kernel::*;

/// Hands on the nearest of the objects of `C` cards with `P` processors each.
///
/// On a card the decider runs past the processors as a [`VisibilityChain`], and one object leaves the card; a [`Decider`] joins the cards. Input
/// `i = P card + place` is taken `place` clocks after input 0 of the same pixel: the cards start together.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `input_i_depth` | in | `W` bits, `i mod P` clocks after input 0 |
/// | `input_i_id` | in | 8 bits |
/// | `input_i_number` | in | 4 bits |
/// | `input_i_nx`, `input_i_ny`, `input_i_nz` | in | 16 bits |
/// | `depth`, `id`, `number`, `nx`, `ny`, `nz` | out | the winner |
///
/// Latency `P + ceil(log2 C)` from input 0. At equal depth the smaller id wins.
pub struct CardDecider<const W: usize, const N: usize = 16> {
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
    chains: Vec<VisibilityChain<W, N>>,
    decider: Decider<W, N>,
    card: Vec<Constant<Word<16>>>,
    place: Vec<Constant<Word<16>>>,
    _inputs: usize,
    _cards: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const N: usize] CardDecider [W, N]
    inputs { clock, input_depth, input_id, input_number, input_nx, input_ny, input_nz }
    parts { depth, id, number, nx, ny, nz, chains, decider, card, place }
    data { _inputs, _cards }
}

impl<const W: usize, const N: usize> CardDecider<W, N> {
    /// A decider of `cards` cards with `processors` objects each.
    ///
    /// # Panics
    ///
    /// When there are not 1 to 256 objects on all cards together.
    pub fn new(processors: usize, cards: usize) -> Self {
        let inputs = processors * cards;
        assert!(
            (1..=MOST_OBJECTS).contains(&inputs),
            "all cards together have 1 to {MOST_OBJECTS} inputs"
        );
        fields! {
            [clock, depth, id, number, nx, ny, nz]
            input_depth: repeat(inputs, Default::default),
            input_id: repeat(inputs, Default::default),
            input_number: repeat(inputs, Default::default),
            input_nx: repeat(inputs, Default::default),
            input_ny: repeat(inputs, Default::default),
            input_nz: repeat(inputs, Default::default),
            chains: repeat(cards, || VisibilityChain::new(processors)),
            decider: Decider::new(cards),
            card: (0..inputs).map(|i| constant((i / processors) as u64)).collect(),
            place: (0..inputs).map(|i| constant((i % processors) as u64)).collect(),
            _inputs: inputs,
            _cards: cards,
        }
    }

    /// Clocks from input 0 to the winner.
    pub const fn latency(processors: usize, cards: usize) -> usize {
        VisibilityChain::<W, N>::latency(processors) + Decider::<W, N>::latency(cards)
    }
}

impl<const W: usize, const N: usize> Logic for CardDecider<W, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("card_decider");
        self.decider.clock.next = self.clock.val();
        for i in 0..self._inputs {
            self.chains[self.card[i].val().index()].input_depth[self.place[i].val().index()].next =
                self.input_depth[i].val();
            self.chains[self.card[i].val().index()].input_id[self.place[i].val().index()].next =
                self.input_id[i].val();
            self.chains[self.card[i].val().index()].input_number[self.place[i].val().index()]
                .next = self.input_number[i].val();
            self.chains[self.card[i].val().index()].input_nx[self.place[i].val().index()].next =
                self.input_nx[i].val();
            self.chains[self.card[i].val().index()].input_ny[self.place[i].val().index()].next =
                self.input_ny[i].val();
            self.chains[self.card[i].val().index()].input_nz[self.place[i].val().index()].next =
                self.input_nz[i].val();
        }
        for i in 0..self._cards {
            self.chains[i].clock.next = self.clock.val();
            self.decider.input_depth[i].next = self.chains[i].depth.val();
            self.decider.input_id[i].next = self.chains[i].id.val();
            self.decider.input_number[i].next = self.chains[i].number.val();
            self.decider.input_nx[i].next = self.chains[i].nx.val();
            self.decider.input_ny[i].next = self.chains[i].ny.val();
            self.decider.input_nz[i].next = self.chains[i].nz.val();
        }
        self.depth.next = self.decider.depth.val();
        self.id.next = self.decider.id.val();
        self.number.next = self.decider.number.val();
        self.nx.next = self.decider.nx.val();
        self.ny.next = self.decider.ny.val();
        self.nz.next = self.decider.nz.val();
    }
}

clocked!(CardDecider<const W: usize, const N: usize>);
