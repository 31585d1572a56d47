//! Which atoms of a model are asked for by chain and residue.

use super::choose::LeftOut;
use super::options::{Options, Residues};
use super::structure::{Atom, Structure};
use super::words::{Word, Words, listed};
use crate::error::{ImportError, Result, unusable};
use std::collections::{BTreeSet, HashMap, HashSet};

/// Chains and residues that are drawn.
pub struct Selection<'a> {
    chains: Vec<Word>,
    residues: &'a [Residues],
    /// What is known of a residue, by number and name.
    known: HashMap<(Word, Word), bool>,
}

impl<'a> Selection<'a> {
    /// Of all chains and residues that are asked for; each must be in one of the models at these places.
    pub fn new(
        structure: &Structure,
        models: &[usize],
        options: &'a Options,
        file: &str,
    ) -> Result<Selection<'a>> {
        let words = &structure.words;
        let atoms = || models.iter().flat_map(|m| &structure.models[*m].atoms);
        let mut there: HashSet<Word> = HashSet::new();
        if !options.chains.is_empty() {
            there.extend(atoms().map(|atom| atom.chain));
        }
        let chain = |name: &String| {
            let word = words.find(name).filter(|word| there.contains(word));
            word.ok_or_else(|| {
                let there: BTreeSet<&str> = there.iter().map(|word| words.text(*word)).collect();
                let there = listed(there.into_iter().filter(|chain| !chain.is_empty()));
                let problem = format!("it has no chain {name}");
                unusable(file, problem, format!("{there} would be accepted"))
            })
        };
        let selection = Selection {
            chains: options.chains.iter().map(chain).collect::<Result<_>>()?,
            residues: &options.residues,
            known: HashMap::new(),
        };
        if selection.residues.is_empty() {
            return Ok(selection);
        }
        let members = atoms().filter(|atom| selection.has_chain(atom));
        let there: BTreeSet<(Word, Word)> = members.map(|a| (a.number, a.residue)).collect();
        for residues in selection.residues {
            if !there.iter().any(|one| matches(residues, *one, words)) {
                return Err(no_residue(residues, &there, words, file));
            }
        }
        Ok(selection)
    }

    fn has_chain(&self, atom: &Atom) -> bool {
        self.chains.is_empty() || self.chains.contains(&atom.chain)
    }

    fn has_residue(&mut self, atom: &Atom, words: &Words) -> bool {
        let residue = (atom.number, atom.residue);
        self.residues.is_empty()
            || *self.known.entry(residue).or_insert_with(|| {
                let mut asked = self.residues.iter();
                asked.any(|residues| matches(residues, residue, words))
            })
    }

    /// Leaves the atoms that are asked for.
    pub fn apply(&mut self, atoms: &mut Vec<Atom>, words: &Words, left_out: &mut LeftOut) {
        atoms.retain(|atom| {
            let other_chain = !self.has_chain(atom);
            let other_residue = !other_chain && !self.has_residue(atom, words);
            left_out.other_chains += usize::from(other_chain);
            left_out.other_residues += usize::from(other_residue);
            !other_chain && !other_residue
        });
    }
}

fn matches(residues: &Residues, (number, name): (Word, Word), words: &Words) -> bool {
    match residues {
        Residues::Called(text) => {
            let is = |word| words.text(word).eq_ignore_ascii_case(text);
            is(number) || is(name)
        }
        Residues::Range(first, last) => {
            let number = digits(words.text(number));
            number.is_some_and(|n| (*first..=*last).contains(&n))
        }
    }
}

/// The number of a residue without its insertion code.
fn digits(text: &str) -> Option<i64> {
    let is_code = |c: char| !c.is_ascii_digit();
    text.trim_end_matches(is_code).parse().ok()
}

fn no_residue(
    residues: &Residues,
    there: &BTreeSet<(Word, Word)>,
    words: &Words,
    file: &str,
) -> ImportError {
    let numbers = || there.iter().filter_map(|(n, _)| digits(words.text(*n)));
    let names: BTreeSet<&str> = there.iter().map(|(_, name)| words.text(*name)).collect();
    let numbers = match (numbers().min(), numbers().max()) {
        (Some(least), Some(most)) => format!("numbers from {least} to {most} and the "),
        _ => "the ".to_owned(),
    };
    let problem = format!("it has no residue {residues} in what is asked for");
    let accepted = format!("{numbers}names {} would be accepted", listed(names));
    unusable(file, problem, accepted)
}
