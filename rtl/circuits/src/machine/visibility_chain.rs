//! Deciders that run past the processors.

use super::decider::{Candidate, NEAREST, REGISTER, decider, visibility_node};
use crate::rows::numbered;
use crate::tree::{levels, register};
use imogene_contract::DeciderForm;
use imogene_hdl::module;

/// The nearest of all candidates, cell by cell: input i comes i clocks after input 0 of the same pixel, so that no
/// wires but those to the next processor leave a cell. Latency as many clocks as inputs. Chaillou 1991, IV.3.2.
pub fn visibility_chain(at: &str, inputs: Vec<Candidate>) -> Candidate {
    let inputs = ("input", inputs, "object on input #, # clocks after input 0");
    module("visibility_chain", at, inputs, |inputs| {
        let first = register(REGISTER, "beginning", inputs[0]);
        let rest = numbered("nodes", &inputs[1..]);
        let nearest = rest.fold(first, |nearest, (at, input)| {
            visibility_node(&at, nearest, *input)
        });
        ("", nearest, NEAREST)
    })
}

/// The nearest of the candidates of some cards: a chain on each, and a decider of what leaves them. Input `i` comes `i
/// mod processors` clocks after input 0; the cards start together. Latency `processors + ceil(log2 cards)`. Chaillou
/// 1991, IV.3.6.
pub fn card_decider(at: &str, inputs: Vec<Candidate>, processors: usize) -> Candidate {
    let meaning =
        "object on input #; input M k + p, place p of card k, comes p clocks after input 0";
    let inputs = ("input", inputs, meaning);
    module("card_decider", at, inputs, |inputs| {
        let cards = numbered("chains", inputs.chunks(processors));
        let chains = cards.map(|(at, inputs)| visibility_chain(&at, inputs.to_vec()));
        ("", decider("decider", chains.collect()), NEAREST)
    })
}

/// The nearest of all candidates by a decider of a form, of which each comes [`lag`] clocks after the first.
pub(super) fn decided(at: &str, inputs: Vec<Candidate>, form: DeciderForm) -> Candidate {
    match (form, processors(form, inputs.len())) {
        (DeciderForm::Tree, _) => decider(at, inputs),
        (_, all) if all == inputs.len() => visibility_chain(at, inputs),
        (_, some) => card_decider(at, inputs, some),
    }
}

/// Clocks that a candidate of so many comes after the first of all: the chains of all cards end together.
pub(super) fn lag(form: DeciderForm, index: usize, candidates: usize) -> u32 {
    if form == DeciderForm::Tree {
        return 0;
    }
    let processors = processors(form, candidates);
    let rest = candidates - index / processors * processors;
    (processors - rest.min(processors) + index % processors) as u32
}

/// Clocks of a decider of a form from the first candidate.
pub(super) fn decider_clocks(form: DeciderForm, candidates: usize) -> u32 {
    if form == DeciderForm::Tree {
        return levels(candidates);
    }
    let processors = processors(form, candidates);
    processors as u32 + levels(candidates.div_ceil(processors))
}

/// Processors of a card, of which there may be one.
fn processors(form: DeciderForm, candidates: usize) -> usize {
    match form {
        DeciderForm::Cards(processors) => candidates.min(processors as usize),
        _ => candidates,
    }
}
