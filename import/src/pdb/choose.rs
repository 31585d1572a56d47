//! Which atoms of a file are drawn: models, chains, residues, alternate locations, hydrogens, water, copies.

use super::alternates::locate;
use super::assembly::Moved;
use super::options::{ModelChoice, Options, Residues};
use super::structure::{Atom, Structure, is_water};
use super::words::{Word, Words, listed};
use crate::error::{ImportError, Result, unusable};
use serde::Serialize;
use std::collections::{BTreeSet, HashMap, HashSet};

/// Most atoms of a picture.
const MOST_ATOMS: usize = 50_000_000;

/// Atoms that are not drawn, by reason.
#[derive(Clone, Debug, Default, Serialize)]
pub struct LeftOut {
    /// In models that were not asked for.
    pub other_models: usize,
    /// In chains that were not asked for.
    pub other_chains: usize,
    /// In residues that were not asked for.
    pub other_residues: usize,
    /// Another location of an atom that is drawn elsewhere.
    pub alternate_locations: usize,
    /// Hydrogens, if they are left out.
    pub hydrogens: usize,
    /// Atoms of water, if it is left out.
    pub water: usize,
}

pub struct Chosen {
    pub number: i64,
    /// Its atoms, copy by copy.
    pub atoms: Vec<Atom>,
    /// Where each copy ends in them; one copy without an assembly.
    pub copies: Vec<usize>,
}

/// The models and atoms that the options ask for.
pub fn choose(
    structure: &mut Structure,
    file: &str,
    options: &Options,
) -> Result<(Vec<Chosen>, LeftOut)> {
    let mut left_out = LeftOut::default();
    let wanted = models(structure, file, options.model)?;
    let mut selection = Selection::new(structure, &wanted, options, file)?;
    let assembly = options.assembly.as_deref();
    let parts = assembly.map(|name| structure.assemblies.find(name, file));
    let parts = parts.transpose()?;
    let mut chosen = vec![];
    let models = std::mem::take(&mut structure.models);
    for (index, model) in models.into_iter().enumerate() {
        if !wanted.contains(&index) {
            left_out.other_models += model.atoms.len();
            continue;
        }
        let words = &mut structure.words;
        let mut atoms = model.atoms;
        selection.apply(&mut atoms, words, &mut left_out);
        left_out.alternate_locations += locate(&mut atoms, &options.alternates, words);
        keep(&mut atoms, options, words, &mut left_out);
        let (atoms, copies) = match &parts {
            Some(parts) => copied(&atoms, parts, words, file)?,
            None => {
                let end = atoms.len();
                (atoms, vec![end])
            }
        };
        chosen.push(Chosen {
            number: model.number,
            atoms,
            copies,
        });
    }
    if chosen.iter().all(|c| c.atoms.is_empty()) {
        return Err(nothing_left(&left_out, options, file));
    }
    Ok((chosen, left_out))
}

/// Why nothing is left, and what would leave something.
fn nothing_left(left_out: &LeftOut, options: &Options, file: &str) -> ImportError {
    let reasons = [
        (left_out.water, "water is drawn without --without-water"),
        (
            left_out.hydrogens,
            "hydrogens are drawn without --without-hydrogens",
        ),
        (left_out.other_residues, "other residues without --residue"),
        (left_out.other_chains, "other chains without --chain"),
        (
            usize::from(options.assembly.is_some()),
            "the coordinates as they stand without --assembly",
        ),
    ];
    let ways = reasons.iter().filter(|(count, _)| *count > 0);
    let ways: Vec<&str> = ways.map(|(_, way)| *way).collect();
    unusable(file, "the options leave no atom", ways.join(", "))
}

/// Places of the models asked for.
fn models(structure: &Structure, file: &str, choice: ModelChoice) -> Result<Vec<usize>> {
    match choice {
        ModelChoice::First => Ok(vec![0]),
        ModelChoice::All => Ok((0..structure.models.len()).collect()),
        ModelChoice::Number(number) => {
            let numbers = || structure.models.iter().map(|m| m.number);
            let found = numbers().position(|n| n == number);
            found.map(|index| vec![index]).ok_or_else(|| {
                let problem = format!("it has no model {number}");
                let numbers = listed(numbers().map(|n| n.to_string()));
                unusable(file, problem, format!("{numbers} or all would be accepted"))
            })
        }
    }
}

fn keep(atoms: &mut Vec<Atom>, options: &Options, words: &Words, left_out: &mut LeftOut) {
    atoms.retain(|atom| {
        let water = !options.water && is_water(words.text(atom.residue));
        let hydrogen = !water && !options.hydrogens && atom.element.is_hydrogen();
        left_out.water += usize::from(water);
        left_out.hydrogens += usize::from(hydrogen);
        !water && !hydrogen
    });
}

/// The copies of an assembly, and where each ends. Their chains are called as the archive calls them: `A-2` is what
/// operator 2 makes of chain A.
fn copied(
    atoms: &[Atom],
    parts: &[Moved],
    words: &mut Words,
    file: &str,
) -> Result<(Vec<Atom>, Vec<usize>)> {
    let (mut copies, mut ends) = (vec![], vec![]);
    for (chains, operators) in parts {
        let chains: HashSet<Word> = chains.iter().copied().collect();
        let is_member = |atom: &&Atom| chains.is_empty() || chains.contains(&atom.part);
        let members: Vec<&Atom> = atoms.iter().filter(is_member).collect();
        if copies.len() + members.len() * operators.len() > MOST_ATOMS {
            let problem = format!("the assembly has more than {MOST_ATOMS} atoms");
            let accepted = "--chain and --residue take a part of it";
            return Err(unusable(file, problem, accepted));
        }
        for operator in operators {
            let mut names: HashMap<Word, Word> = HashMap::new();
            for atom in &members {
                let chain = *names.entry(atom.chain).or_insert_with(|| {
                    if operator.is_identity() {
                        return atom.chain;
                    }
                    words.keep(&format!("{}-{}", words.text(atom.chain), operator.name))
                });
                copies.push(Atom {
                    place: operator.place(atom.place),
                    chain,
                    ..(*atom).clone()
                });
            }
            if ends.last() != Some(&copies.len()) {
                ends.push(copies.len());
            }
        }
    }
    Ok((copies, ends))
}

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
