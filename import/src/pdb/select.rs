//! Which atoms of a model are asked for by chain and residue.

use super::options::Residues;
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
        chains: &[String],
        residues: &'a [Residues],
        file: &str,
    ) -> Result<Selection<'a>> {
        let words = &structure.words;
        let atoms = || models.iter().flat_map(|m| &structure.models[*m].atoms);
        let mut there: HashSet<Word> = HashSet::new();
        if !chains.is_empty() {
            there.extend(atoms().map(|atom| atom.chain));
        }
        let chains: Result<Vec<Word>> = chains
            .iter()
            .map(|name| {
                let word = words.find(name).filter(|word| there.contains(word));
                word.ok_or_else(|| no_chain(name, there.iter().map(|w| words.text(*w)), file))
            })
            .collect();
        let selection = Selection {
            chains: chains?,
            residues,
            known: HashMap::new(),
        };
        selection.check_residues(words, atoms, file)?;
        Ok(selection)
    }

    fn check_residues<'b, I: Iterator<Item = &'b Atom>>(
        &self,
        words: &Words,
        atoms: impl Fn() -> I,
        file: &str,
    ) -> Result<()> {
        if self.residues.is_empty() {
            return Ok(());
        }
        let atoms = atoms().filter(|atom| self.has_chain(atom));
        let there: BTreeSet<(Word, Word)> = atoms.map(|a| (a.number, a.residue)).collect();
        for residues in self.residues {
            let found = there
                .iter()
                .any(|residue| matches(residues, *residue, words));
            if !found {
                return Err(no_residue(residues, &there, words, file));
            }
        }
        Ok(())
    }

    /// Whether an atom's chain is asked for.
    pub fn has_chain(&self, atom: &Atom) -> bool {
        self.chains.is_empty() || self.chains.contains(&atom.chain)
    }

    /// Whether its residue is asked for.
    pub fn has_residue(&mut self, atom: &Atom, words: &Words) -> bool {
        let residue = (atom.number, atom.residue);
        self.residues.is_empty()
            || *self.known.entry(residue).or_insert_with(|| {
                let mut asked = self.residues.iter();
                asked.any(|residues| matches(residues, residue, words))
            })
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

fn no_chain<'a>(name: &str, there: impl Iterator<Item = &'a str>, file: &str) -> ImportError {
    let there: BTreeSet<&str> = there.filter(|chain| !chain.is_empty()).collect();
    unusable(
        file,
        format!("it has no chain {name}"),
        format!("{} would be accepted", listed(there)),
    )
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
    unusable(
        file,
        format!("it has no residue {residues} in what is asked for"),
        format!("{numbers}names {} would be accepted", listed(names)),
    )
}
