//! Which atoms of a file are drawn: models, alternate locations, hydrogens, water.

use super::structure::{Atom, Structure, unusable};
use super::{Alternates, ModelChoice, Options};
use crate::error::ImportError;
use serde::Serialize;
use std::collections::{BTreeMap, HashMap, HashSet};

/// Atoms that are not drawn, by reason.
#[derive(Clone, Debug, Default, Serialize)]
pub struct LeftOut {
    /// In models that were not asked for.
    pub other_models: usize,
    /// Another location of an atom that is drawn elsewhere.
    pub alternate_locations: usize,
    /// Hydrogens, if they are left out.
    pub hydrogens: usize,
    /// Atoms of water, if it is left out.
    pub water: usize,
}

/// The atoms of a model that are drawn.
pub struct Chosen {
    /// Number of the model.
    pub number: i64,
    /// Its atoms.
    pub atoms: Vec<Atom>,
}

/// The models and atoms that the options ask for.
pub fn choose(
    structure: &mut Structure,
    file: &str,
    options: &Options,
) -> Result<(Vec<Chosen>, LeftOut), ImportError> {
    let mut left_out = LeftOut::default();
    let wanted = models(structure, file, options.model)?;
    let mut chosen = Vec::new();
    for (index, model) in std::mem::take(&mut structure.models)
        .into_iter()
        .enumerate()
    {
        if !wanted.contains(&index) {
            left_out.other_models += model.atoms.len();
            continue;
        }
        let atoms = located(model.atoms, options.alternates, &mut left_out);
        let atoms = kept(atoms, options, &mut left_out);
        chosen.push(Chosen {
            number: model.number,
            atoms,
        });
    }
    if chosen.iter().all(|c| c.atoms.is_empty()) {
        return Err(unusable(
            file,
            "the options leave no atom",
            "hydrogens and water are kept without --no-hydrogens and --no-water",
        ));
    }
    Ok((chosen, left_out))
}

/// Indices of the models asked for.
fn models(
    structure: &Structure,
    file: &str,
    choice: ModelChoice,
) -> Result<HashSet<usize>, ImportError> {
    let all = 0..structure.models.len();
    match choice {
        ModelChoice::First => Ok(HashSet::from([0])),
        ModelChoice::All => Ok(all.collect()),
        ModelChoice::Number(number) => {
            let mut models = structure.models.iter();
            let found = models.position(|m| m.number == number);
            found.map(|index| HashSet::from([index])).ok_or_else(|| {
                let numbers = structure.models.iter().map(|m| m.number.to_string());
                let mut numbers: Vec<String> = numbers.take(20).collect();
                if structure.models.len() > numbers.len() {
                    numbers.push("...".into());
                }
                unusable(
                    file,
                    format!("it has no model {number}"),
                    format!("{} or all would be accepted", numbers.join(", ")),
                )
            })
        }
    }
}

fn kept(mut atoms: Vec<Atom>, options: &Options, left_out: &mut LeftOut) -> Vec<Atom> {
    atoms.retain(|atom| {
        if !options.water && atom.is_water() {
            left_out.water += 1;
            return false;
        }
        if !options.hydrogens && atom.element.is_hydrogen() {
            left_out.hydrogens += 1;
            return false;
        }
        true
    });
    atoms
}

/// A residue of a model: chain, number and insertion code. Its name is no part of it, because alternate locations may be of different residues.
type Residue = (u8, String);

/// Leaves one location of each atom, all of a residue from the same alternate as far as it has them.
fn located(atoms: Vec<Atom>, choice: Alternates, left_out: &mut LeftOut) -> Vec<Atom> {
    if choice == Alternates::All {
        return atoms;
    }
    let mut residues: HashMap<Residue, Vec<usize>> = HashMap::new();
    for (index, atom) in atoms.iter().enumerate() {
        let residue = (atom.chain, atom.number.clone());
        residues.entry(residue).or_default().push(index);
    }
    let mut keep = vec![true; atoms.len()];
    for members in residues.into_values() {
        let disordered = members.iter().any(|i| atoms[*i].alternate != b' ');
        if disordered {
            one_location(&atoms, &members, choice, &mut keep);
        }
    }
    let before = atoms.len();
    let mut flags = keep.into_iter();
    let mut atoms = atoms;
    atoms.retain(|_| flags.next().expect("one for each atom"));
    left_out.alternate_locations += before - atoms.len();
    atoms
}

/// What speaks for an alternate of a residue.
#[derive(Default)]
struct Votes {
    occupancy: f64,
    atoms: usize,
    /// Atoms of which it is the location that stands first in the file.
    firsts: usize,
    /// Where it stands first in the file.
    order: usize,
}

/// The alternates of a residue, the best first: the one asked for, then those of the highest mean occupancy, then those listed first.
fn ranking(groups: &BTreeMap<&str, Vec<usize>>, atoms: &[Atom], choice: Alternates) -> Vec<u8> {
    let mut votes: BTreeMap<u8, Votes> = BTreeMap::new();
    for members in groups.values() {
        // An atom with one location and no letter belongs to all alternates.
        if let [only] = members[..]
            && atoms[only].alternate == b' '
        {
            continue;
        }
        for (k, index) in members.iter().enumerate() {
            let entry = votes
                .entry(atoms[*index].alternate)
                .or_insert_with(|| Votes {
                    order: *index,
                    ..Votes::default()
                });
            entry.occupancy += atoms[*index].occupancy;
            entry.atoms += 1;
            entry.firsts += usize::from(k == 0);
            entry.order = entry.order.min(*index);
        }
    }
    let asked = |letter: u8| choice != Alternates::Letter(letter);
    let mut ranked: Vec<(u8, Votes)> = votes.into_iter().collect();
    ranked.sort_by(|(a, v), (b, w)| {
        let (mean, other) = (v.occupancy / v.atoms as f64, w.occupancy / w.atoms as f64);
        asked(*a)
            .cmp(&asked(*b))
            .then(other.total_cmp(&mean))
            .then(w.firsts.cmp(&v.firsts))
            .then(v.order.cmp(&w.order))
    });
    ranked.into_iter().map(|(letter, _)| letter).collect()
}

fn one_location(atoms: &[Atom], members: &[usize], choice: Alternates, keep: &mut [bool]) {
    let mut groups: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for index in members {
        groups.entry(&atoms[*index].name).or_default().push(*index);
    }
    let ranked = ranking(&groups, atoms, choice);
    // Of alternates that are different residues only one is drawn.
    let best = members
        .iter()
        .find(|i| Some(&atoms[**i].alternate) == ranked.first());
    let residue = best.map(|i| atoms[*i].residue.as_str());
    for locations in groups.values() {
        let rank = |index: &usize| {
            let letter = atoms[*index].alternate;
            let place = ranked.iter().position(|l| *l == letter);
            place.unwrap_or(ranked.len())
        };
        let of_residue = |i: &&usize| {
            let shared = atoms[**i].alternate == b' ';
            shared || Some(atoms[**i].residue.as_str()) == residue
        };
        // The same name and letter twice is no alternate: both are drawn.
        let first = locations.iter().filter(of_residue).map(rank).min();
        for index in locations {
            keep[*index] = Some(rank(index)) == first && of_residue(&index);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pdb::structure::Structure;

    fn lines(atoms: &[(&str, char, &str, f64)]) -> String {
        let line = |(name, alternate, residue, occupancy): &(&str, char, &str, f64)| {
            format!(
                "ATOM      1 {name:<4}{alternate}{residue:<3} A   7      11.104  13.207   9.327  {occupancy:.2}  0.00           C\n"
            )
        };
        atoms.iter().map(line).collect()
    }

    fn kept_of(atoms: &[(&str, char, &str, f64)], alternates: Alternates) -> String {
        let text = lines(atoms);
        let mut structure = Structure::read(text.as_bytes(), "x").expect("atoms");
        let options = Options {
            alternates,
            ..Options::default()
        };
        let (chosen, left_out) = choose(&mut structure, "x", &options).expect("atoms left");
        let names: Vec<String> = chosen[0]
            .atoms
            .iter()
            .map(|a| {
                format!("{}{}", a.name, a.alternate as char)
                    .trim()
                    .to_owned()
            })
            .collect();
        assert_eq!(names.len() + left_out.alternate_locations, atoms.len());
        names.join(" ")
    }

    #[test]
    fn a_residue_keeps_one_alternate() {
        let side = [
            (" N", ' ', "SER", 1.0),
            (" CA", 'A', "SER", 0.4),
            (" CA", 'B', "SER", 0.6),
            (" CB", 'A', "SER", 0.7),
            (" CB", 'B', "SER", 0.6),
            (" OG", 'A', "SER", 0.4),
            (" OG", 'B', "SER", 0.6),
        ];
        // B has the mean 0.6, A that of 0.5; atom by atom CB would be A's.
        assert_eq!(kept_of(&side, Alternates::Best), "N CAB CBB OGB");
        assert_eq!(kept_of(&side, Alternates::Letter(b'A')), "N CAA CBA OGA");
        assert_eq!(kept_of(&side, Alternates::Letter(b'Z')), "N CAB CBB OGB");
        assert_eq!(kept_of(&side, Alternates::All), "N CAA CAB CBA CBB OGA OGB");
    }

    #[test]
    fn of_equal_occupancies_the_first_is_kept() {
        assert_eq!(
            kept_of(
                &[("CA", 'B', "SER", 0.5), ("CA", 'A', "SER", 0.5)],
                Alternates::Best
            ),
            "CAB"
        );
        // A published file: the first location of CZ has no letter, and belongs to A.
        let arginine = [
            ("CZ", ' ', "ARG", 0.5),
            ("CZ", 'B', "ARG", 0.5),
            ("NH1", 'A', "ARG", 0.5),
            ("NH1", 'B', "ARG", 0.5),
            ("NH2", 'A', "ARG", 0.5),
            ("NH2", 'B', "ARG", 0.5),
        ];
        assert_eq!(kept_of(&arginine, Alternates::Best), "CZ NH1A NH2A");
        assert_eq!(
            kept_of(&arginine, Alternates::Letter(b'B')),
            "CZB NH1B NH2B"
        );
    }

    #[test]
    fn of_two_residues_at_one_place_one_is_kept() {
        let both = [
            ("N", ' ', "SER", 1.0),
            ("CA", 'A', "SER", 0.3),
            ("CA", 'B', "THR", 0.7),
            ("OG", 'A', "SER", 0.3),
            ("OG1", 'B', "THR", 0.7),
            ("CG2", 'B', "THR", 0.7),
        ];
        assert_eq!(kept_of(&both, Alternates::Best), "N CAB OG1B CG2B");
        assert_eq!(kept_of(&both, Alternates::Letter(b'A')), "N CAA OGA");
    }

    #[test]
    fn an_atom_that_only_the_other_alternate_has_stays() {
        let atoms = [
            ("CA", 'A', "SER", 0.6),
            ("CA", 'B', "SER", 0.4),
            ("HG", 'B', "SER", 0.4),
        ];
        assert_eq!(kept_of(&atoms, Alternates::Best), "CAA HGB");
        // A molecule of water that is there half of the time, and two atoms of the same name and letter.
        assert_eq!(kept_of(&[("O", 'A', "HOH", 0.5)], Alternates::Best), "OA");
        assert_eq!(
            kept_of(
                &[("C", 'A', "LIG", 0.5), ("C", 'A', "LIG", 0.5)],
                Alternates::Best
            ),
            "CA CA"
        );
    }
}
