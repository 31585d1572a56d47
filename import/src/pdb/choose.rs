//! Which atoms of a file are drawn: models, chains, residues, alternate locations, hydrogens, water, copies. Of the
//! alternate locations of an atom one is drawn, and those of a residue belong together.

use super::assembly::Moved;
use super::options::{Alternates, ModelChoice, Options, Residues};
use super::structure::{Atom, Structure, is_water};
use super::words::{Word, Words, listed};
use crate::error::{Error, Result};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

const MOST_ATOMS: usize = 50_000_000;

/// Atoms that are not drawn, by reason.
#[derive(Clone, Debug, Default, Serialize)]
pub struct LeftOut {
    pub other_models: usize,
    pub other_chains: usize,
    pub other_residues: usize,
    pub alternate_locations: usize,
    pub hydrogens: usize,
    pub water: usize,
}

pub struct Chosen {
    pub number: i64,
    /// Its atoms, copy by copy.
    pub atoms: Vec<Atom>,
    /// Where each copy ends in them; one copy without an assembly.
    pub copies: Vec<usize>,
}

pub fn choose(structure: &mut Structure, options: &Options) -> Result<(Vec<Chosen>, LeftOut)> {
    let mut left_out = LeftOut::default();
    let wanted = models(structure, options.model)?;
    let selection = Selection::new(structure, &wanted, options)?;
    let assembly = options.assembly.as_deref();
    let parts = assembly.map(|name| structure.assemblies.find(name));
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
        left_out.other_chains += keep(&mut atoms, |atom| selection.has_chain(atom));
        left_out.other_residues += keep(&mut atoms, |atom| selection.has_residue(atom));
        left_out.alternate_locations += locate(&mut atoms, &options.alternates, words);
        let is_water = |atom: &Atom| is_water(words.text(atom.residue));
        left_out.water += keep(&mut atoms, |atom| options.water || !is_water(atom));
        let is_hydrogen = |atom: &Atom| atom.element.is_hydrogen();
        left_out.hydrogens += keep(&mut atoms, |atom| options.hydrogens || !is_hydrogen(atom));
        let end = atoms.len();
        let (atoms, copies) = match &parts {
            Some(parts) => copied(&atoms, parts, words)?,
            None => (atoms, vec![end]),
        };
        chosen.push(Chosen {
            number: model.number,
            atoms,
            copies,
        });
    }
    if chosen.iter().all(|c| c.atoms.is_empty()) {
        return Err(nothing_left(&left_out, options));
    }
    Ok((chosen, left_out))
}

fn nothing_left(left_out: &LeftOut, options: &Options) -> Error {
    let hydrogens = "hydrogens are drawn without --without-hydrogens";
    let as_they_stand = "the coordinates as they stand without --assembly";
    let reasons = [
        (left_out.water, "water is drawn without --without-water"),
        (left_out.hydrogens, hydrogens),
        (left_out.other_residues, "other residues without --residue"),
        (left_out.other_chains, "other chains without --chain"),
        (options.assembly.iter().count(), as_they_stand),
    ];
    let ways = reasons.iter().filter(|(count, _)| *count > 0);
    let ways: Vec<&str> = ways.map(|(_, way)| *way).collect();
    Error::whole("the options leave no atom", ways.join(", "))
}

fn models(structure: &Structure, choice: ModelChoice) -> Result<Vec<usize>> {
    match choice {
        ModelChoice::First => Ok(vec![0]),
        ModelChoice::All => Ok((0..structure.models.len()).collect()),
        ModelChoice::Number(number) => {
            let numbers = || structure.models.iter().map(|m| m.number);
            let found = numbers().position(|n| n == number);
            found.map(|index| vec![index]).ok_or_else(|| {
                let problem = format!("it has no model {number}");
                let numbers = listed(numbers().map(|n| n.to_string()));
                Error::whole(problem, format!("{numbers} or all would be accepted"))
            })
        }
    }
}

/// Leaves those of some atoms that are asked for; how many others there were.
fn keep(atoms: &mut Vec<Atom>, asked: impl FnMut(&Atom) -> bool) -> usize {
    let before = atoms.len();
    atoms.retain(asked);
    before - atoms.len()
}

/// The copies of an assembly, and where each ends. As in the archive `A-2` is what operator 2 makes of chain A.
fn copied(atoms: &[Atom], parts: &[Moved], words: &mut Words) -> Result<(Vec<Atom>, Vec<usize>)> {
    let (mut copies, mut ends) = (vec![], vec![]);
    for (chains, operators) in parts {
        let chains: HashSet<Word> = chains.iter().copied().collect();
        let is_member = |atom: &&Atom| chains.is_empty() || chains.contains(&atom.part);
        let members: Vec<&Atom> = atoms.iter().filter(is_member).collect();
        if copies.len() + members.len() * operators.len() > MOST_ATOMS {
            let problem = format!("the assembly has more than {MOST_ATOMS} atoms");
            let accepted = "--chain and --residue take a part of it";
            return Err(Error::whole(problem, accepted));
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

/// The chains and residues that are asked for; all if there are none.
struct Selection {
    chains: Vec<Word>,
    /// By number and name.
    residues: Option<HashSet<(Word, Word)>>,
}

impl Selection {
    /// Each chain and residue must be in one of the models at these places.
    fn new(structure: &Structure, models: &[usize], options: &Options) -> Result<Selection> {
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
                Error::whole(problem, format!("{there} would be accepted"))
            })
        };
        let mut selection = Selection {
            chains: options.chains.iter().map(chain).collect::<Result<_>>()?,
            residues: None,
        };
        if options.residues.is_empty() {
            return Ok(selection);
        }
        let members = atoms().filter(|atom| selection.has_chain(atom));
        let there: BTreeSet<(Word, Word)> = members.map(|a| (a.number, a.residue)).collect();
        let mut asked = HashSet::new();
        for residues in &options.residues {
            let own = there.iter().filter(|one| matches(residues, **one, words));
            let found: Vec<(Word, Word)> = own.copied().collect();
            if found.is_empty() {
                return Err(no_residue(residues, &there, words));
            }
            asked.extend(found);
        }
        selection.residues = Some(asked);
        Ok(selection)
    }

    fn has_chain(&self, atom: &Atom) -> bool {
        self.chains.is_empty() || self.chains.contains(&atom.chain)
    }

    fn has_residue(&self, atom: &Atom) -> bool {
        let residues = self.residues.as_ref();
        residues.is_none_or(|asked| asked.contains(&(atom.number, atom.residue)))
    }
}

fn matches(residues: &Residues, (number, name): (Word, Word), words: &Words) -> bool {
    match residues {
        Residues::Called(text) => {
            let is = |word| words.text(word).eq_ignore_ascii_case(text);
            is(number) || is(name)
        }
        Residues::Range(first, last) => {
            digits(words.text(number)).is_some_and(|n| (*first..=*last).contains(&n))
        }
    }
}

/// The number of a residue without its insertion code.
fn digits(text: &str) -> Option<i64> {
    let is_code = |c: char| !c.is_ascii_digit();
    text.trim_end_matches(is_code).parse().ok()
}

fn no_residue(residues: &Residues, there: &BTreeSet<(Word, Word)>, words: &Words) -> Error {
    let numbers = || there.iter().filter_map(|(n, _)| digits(words.text(*n)));
    let names: BTreeSet<&str> = there.iter().map(|(_, name)| words.text(*name)).collect();
    let numbers = match (numbers().min(), numbers().max()) {
        (Some(least), Some(most)) => format!("numbers from {least} to {most} and the "),
        _ => "the ".to_owned(),
    };
    let problem = format!("it has no residue {residues} in what is asked for");
    let accepted = format!("{numbers}names {} would be accepted", listed(names));
    Error::whole(problem, accepted)
}

/// Leaves one location of each atom, of one alternate for a residue if it can be; how many others there were.
fn locate(atoms: &mut Vec<Atom>, choice: &Alternates, words: &Words) -> usize {
    let asked = match choice {
        Alternates::All => return 0,
        Alternates::Best => None,
        // A name that no atom has is no alternate's.
        Alternates::Named(name) => words.find(name),
    };
    // Its name is no part of a residue, because alternate locations may be of different residues.
    let residue = |atom: &Atom| (atom.chain, atom.number);
    let disordered = atoms.iter().filter(|atom| !atom.alternate.is_empty());
    let mut residues: HashMap<(Word, Word), Vec<usize>> =
        disordered.map(|atom| (residue(atom), vec![])).collect();
    if residues.is_empty() {
        return 0;
    }
    for (index, atom) in atoms.iter().enumerate() {
        if let Some(members) = residues.get_mut(&residue(atom)) {
            members.push(index);
        }
    }
    let mut kept = vec![true; atoms.len()];
    for members in residues.into_values() {
        one_location(atoms, &members, asked, &mut kept);
    }
    let mut flags = kept.into_iter();
    keep(atoms, |_| flags.next().expect("one for each atom"))
}

/// The alternates of a residue, the best first: the one asked for, then those of the highest mean occupancy, then
/// those that most atoms have first in the file, then those that stand first in it.
fn ranking(groups: &BTreeMap<Word, Vec<usize>>, atoms: &[Atom], asked: Option<Word>) -> Vec<Word> {
    // The atoms of each alternate, and their places among the locations of their atom.
    let mut alternates: BTreeMap<Word, Vec<(usize, usize)>> = BTreeMap::new();
    for members in groups.values() {
        // An atom with one location and no letter belongs to all alternates.
        if matches!(members[..], [only] if atoms[only].alternate.is_empty()) {
            continue;
        }
        for (k, index) in members.iter().enumerate() {
            let own = alternates.entry(atoms[*index].alternate).or_default();
            own.push((*index, k));
        }
    }
    let mut ranked: Vec<Word> = alternates.keys().copied().collect();
    let mean = |own: &[(usize, usize)]| {
        let occupancy = |(index, _): &(usize, usize)| f64::from(atoms[*index].occupancy);
        own.iter().map(occupancy).sum::<f64>() / own.len() as f64
    };
    let firsts = |own: &[(usize, usize)]| own.iter().filter(|(_, k)| *k == 0).count();
    ranked.sort_by(|a, b| {
        let [own, other] = [a, b].map(|alternate| &alternates[alternate][..]);
        (Some(*a) != asked)
            .cmp(&(Some(*b) != asked))
            .then(mean(other).total_cmp(&mean(own)))
            .then(firsts(other).cmp(&firsts(own)))
            .then(own.iter().min().cmp(&other.iter().min()))
    });
    ranked
}

fn one_location(atoms: &[Atom], members: &[usize], asked: Option<Word>, keep: &mut [bool]) {
    let mut groups: BTreeMap<Word, Vec<usize>> = BTreeMap::new();
    for index in members {
        groups.entry(atoms[*index].name).or_default().push(*index);
    }
    let ranked = ranking(&groups, atoms, asked);
    // Of alternates that are different residues only one is drawn.
    let mut own = members.iter().map(|index| &atoms[*index]);
    let best = own.find(|atom| Some(&atom.alternate) == ranked.first());
    let residue = best.map(|atom| atom.residue);
    for locations in groups.values() {
        let rank = |index: &usize| {
            let place = ranked.iter().position(|a| *a == atoms[*index].alternate);
            place.unwrap_or(ranked.len())
        };
        let of_residue =
            |i: &&usize| atoms[**i].alternate.is_empty() || Some(atoms[**i].residue) == residue;
        // The same name and letter twice is no alternate: both are drawn.
        let first = locations.iter().filter(of_residue).map(rank).min();
        for index in locations {
            keep[*index] = Some(rank(index)) == first && of_residue(&index);
        }
    }
}
