//! Which atoms are bonded: those near enough for their covalent radii, and those that the file says are.

use super::structure::{Atom, End};
use crate::error::{Error, Result};
use imogene_algebra::vector::{length, minus};
use std::collections::{HashMap, HashSet};

/// Most by which a bond is longer than the sum of the covalent radii, angstroms (as in Open Babel and Jmol).
pub const TOLERANCE: f64 = 0.45;
/// Atoms nearer than this are two locations of one, in angstroms: the shortest bond, that of H2, has 0.74.
pub const NEAREST: f64 = 0.4;
/// Most bonds of an atom; a metal in a cluster has twelve.
const MOST_BONDS: usize = 16;
/// Most atoms in a cell of the grid, a few angstroms wide; a crystal has about one in six cubic angstroms.
const MOST_IN_A_CELL: usize = 256;

#[derive(Debug, Default)]
pub struct Bonds {
    /// Pairs of places in the list of atoms, the lower first, in ascending order.
    pub pairs: Vec<[usize; 2]>,
    /// How many of them only the file says, in CONECT lines or _struct_conn.
    pub connected: usize,
    /// Pairs left out because an atom had more bonds than any has.
    pub left_out: usize,
}

type Cell = [i64; 3];

/// Finds the bonds of one model's copies, which end at `copies`; what the file says holds within each copy.
pub fn find(atoms: &[Atom], copies: &[usize], connections: &[[End; 2]]) -> Result<Bonds> {
    let mut pairs = by_distance(atoms)?;
    let mut said: Vec<[usize; 2]> = vec![];
    if !connections.is_empty() {
        for (start, end) in std::iter::once(&0).chain(copies).zip(copies) {
            let found = said_of(&atoms[*start..*end], connections);
            said.extend(found.into_iter().map(|pair| pair.map(|k| k + start)));
        }
        let known: HashSet<[usize; 2]> = pairs.iter().copied().collect();
        said.retain(|pair| !known.contains(pair));
        said.sort_unstable();
        said.dedup();
    }
    let connected = said.len();
    pairs.extend(said);
    pairs.sort_unstable();
    let (found, mut degrees) = (pairs.len(), vec![0; atoms.len()]);
    pairs.retain(|pair| {
        let fits = pair.iter().all(|atom| degrees[*atom] < MOST_BONDS);
        pair.iter()
            .for_each(|atom| degrees[*atom] += usize::from(fits));
        fits
    });
    let left_out = found - pairs.len();
    Ok(Bonds {
        pairs,
        connected,
        left_out,
    })
}

/// Pairs by distance, found in a grid of cells that are as wide as the longest bond.
fn by_distance(atoms: &[Atom]) -> Result<Vec<[usize; 2]>> {
    let radii = atoms.iter().map(|a| a.element.covalent());
    let width = 2.0 * radii.fold(0.0, f64::max) + TOLERANCE;
    let cell = |atom: &Atom| -> Cell { atom.place.map(|v| (v / width).floor() as i64) };
    let mut grid: HashMap<Cell, Vec<usize>> = HashMap::new();
    for (index, atom) in atoms.iter().enumerate() {
        let members = grid.entry(cell(atom)).or_default();
        members.push(index);
        if members.len() > MOST_IN_A_CELL {
            let problem = format!(
                "more than {MOST_IN_A_CELL} atoms within {width:.1} angstroms of one another, about {:.1?}: bonds cannot be told",
                atom.place
            );
            let accepted =
                "--style space-filling, or one model and one alternate location, would be accepted";
            return Err(Error::whole(problem, accepted));
        }
    }
    let mut pairs = vec![];
    for (index, atom) in atoms.iter().enumerate() {
        let [x, y, z] = cell(atom);
        for k in 0..27 {
            let near = [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1];
            let members = grid.get(&near).into_iter().flatten();
            let later = members.filter(|other| **other > index);
            let bonded = later.filter(|other| are_bonded(atom, &atoms[**other]));
            pairs.extend(bonded.map(|other| [index, *other]));
        }
    }
    Ok(pairs)
}

fn distance(a: &Atom, b: &Atom) -> f64 {
    length(minus(a.place, b.place))
}

/// Near enough, not two hydrogens, and not of different alternates.
fn are_bonded(a: &Atom, b: &Atom) -> bool {
    let hydrogens = a.element.is_hydrogen() && b.element.is_hydrogen();
    let apart = !a.alternate.is_empty() && !b.alternate.is_empty() && a.alternate != b.alternate;
    let longest = a.element.covalent() + b.element.covalent() + TOLERANCE;
    let distance = distance(a, b);
    !hydrogens && !apart && distance >= NEAREST && distance <= longest
}

/// Pairs that the file names; what two atoms of the model are called alike says nothing.
fn said_of(atoms: &[Atom], connections: &[[End; 2]]) -> Vec<[usize; 2]> {
    let asked: HashSet<End> = connections.iter().flatten().copied().collect();
    let mut places: HashMap<End, Option<usize>> = HashMap::new();
    for (index, atom) in atoms.iter().enumerate() {
        let names = [atom.part, atom.number, atom.name, atom.alternate];
        for end in [End::Serial(atom.serial), End::Names(names)] {
            if asked.contains(&end) {
                let only = |place: &mut Option<usize>| *place = None;
                places.entry(end).and_modify(only).or_insert(Some(index));
            }
        }
    }
    let place = |end: &End| places.get(end).copied().flatten();
    let pair = |[a, b]: &[End; 2]| {
        let (a, b) = (place(a)?, place(b)?);
        (distance(&atoms[a], &atoms[b]) >= NEAREST).then(|| [a.min(b), a.max(b)])
    };
    connections.iter().filter_map(pair).collect()
}
