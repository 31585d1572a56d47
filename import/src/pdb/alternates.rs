//! Alternate locations: of each atom one is drawn, and those of a residue belong together.

use super::options::Alternates;
use super::structure::Atom;
use super::words::{Word, Words};
use std::collections::{BTreeMap, HashMap};

/// Leaves one location of each atom, all of a residue from the same alternate as far as it has them; how many others
/// there were.
pub fn locate(atoms: &mut Vec<Atom>, choice: &Alternates, words: &Words) -> usize {
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
    let mut keep = vec![true; atoms.len()];
    for members in residues.into_values() {
        one_location(atoms, &members, asked, &mut keep);
    }
    let before = atoms.len();
    let mut flags = keep.into_iter();
    atoms.retain(|_| flags.next().expect("one for each atom"));
    before - atoms.len()
}

/// What speaks for an alternate of a residue.
#[derive(Default)]
struct Votes {
    occupancy: f64,
    atoms: usize,
    /// Atoms of which it is the location that stands first in the file.
    firsts: usize,
    /// Where it stands first in the file.
    order: Option<usize>,
}

/// The alternates of a residue, the best first: the one asked for, then those of the highest mean occupancy, then
/// those listed first.
fn ranking(groups: &BTreeMap<Word, Vec<usize>>, atoms: &[Atom], asked: Option<Word>) -> Vec<Word> {
    let mut votes: BTreeMap<Word, Votes> = BTreeMap::new();
    for members in groups.values() {
        // An atom with one location and no letter belongs to all alternates.
        if let [only] = members[..]
            && atoms[only].alternate.is_empty()
        {
            continue;
        }
        for (k, index) in members.iter().enumerate() {
            let entry = votes.entry(atoms[*index].alternate).or_default();
            entry.occupancy += f64::from(atoms[*index].occupancy);
            entry.atoms += 1;
            entry.firsts += usize::from(k == 0);
            entry.order = Some(entry.order.map_or(*index, |order| order.min(*index)));
        }
    }
    let asked = |alternate: Word| asked != Some(alternate);
    let mut ranked: Vec<(Word, Votes)> = votes.into_iter().collect();
    ranked.sort_by(|(a, v), (b, w)| {
        let (mean, other) = (v.occupancy / v.atoms as f64, w.occupancy / w.atoms as f64);
        asked(*a)
            .cmp(&asked(*b))
            .then(other.total_cmp(&mean))
            .then(w.firsts.cmp(&v.firsts))
            .then(v.order.cmp(&w.order))
    });
    ranked.into_iter().map(|(alternate, _)| alternate).collect()
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
            let alternate = atoms[*index].alternate;
            let place = ranked.iter().position(|a| *a == alternate);
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
