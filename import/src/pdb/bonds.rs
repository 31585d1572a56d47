//! Which atoms are bonded: those near enough for their covalent radii, and those that the file says are.

use super::structure::{Atom, End};
use crate::error::{Result, unusable};
use imogene_algebra::vector::{length, minus};
use std::collections::{HashMap, HashSet};

/// A bond is at most this much longer than the sum of the covalent radii, in angstroms (the tolerance of Open Babel
/// and Jmol).
pub const TOLERANCE: f64 = 0.45;
/// Atoms nearer than this are two locations of one, in angstroms: the shortest bond, that of H2, has 0.74.
pub const NEAREST: f64 = 0.4;
/// Most bonds of an atom; a metal in a cluster has twelve.
const MOST_BONDS: usize = 16;
/// Most atoms in a cell of the grid, which is a few angstroms wide; a crystal has about one for each six cubic
/// angstroms.
const MOST_IN_A_CELL: usize = 256;

/// The bonds of a model.
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

/// Finds the bonds of the atoms of one model, which are copies that end at `copies`; what the file says holds within
/// each copy.
pub fn find(
    atoms: &[Atom],
    copies: &[usize],
    connections: &[[End; 2]],
    file: &str,
) -> Result<Bonds> {
    let mut pairs = by_distance(atoms, file)?;
    let mut said: Vec<[usize; 2]> = vec![];
    if !connections.is_empty() {
        let starts = std::iter::once(&0).chain(copies);
        for (start, end) in starts.zip(copies) {
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
    let mut bonds = Bonds {
        connected,
        ..Bonds::default()
    };
    let mut degrees = vec![0; atoms.len()];
    for pair in pairs {
        if pair.iter().any(|atom| degrees[*atom] >= MOST_BONDS) {
            bonds.left_out += 1;
            continue;
        }
        for atom in pair {
            degrees[atom] += 1;
        }
        bonds.pairs.push(pair);
    }
    Ok(bonds)
}

/// Pairs by distance, found in a grid of cells that are as wide as the longest bond.
fn by_distance(atoms: &[Atom], file: &str) -> Result<Vec<[usize; 2]>> {
    let radii = atoms.iter().map(|a| a.element.covalent());
    let width = 2.0 * radii.fold(0.0, f64::max) + TOLERANCE;
    let cell = |atom: &Atom| -> Cell { atom.place.map(|v| (v / width).floor() as i64) };
    let mut grid: HashMap<Cell, Vec<usize>> = HashMap::new();
    for (index, atom) in atoms.iter().enumerate() {
        let members = grid.entry(cell(atom)).or_default();
        members.push(index);
        if members.len() > MOST_IN_A_CELL {
            return Err(unusable(
                file,
                format!(
                    "more than {MOST_IN_A_CELL} atoms within {width:.1} angstroms of one another, about {:.1?}: bonds cannot be told",
                    atom.place
                ),
                "--style space-filling, or one model and one alternate location, would be accepted",
            ));
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
    let given = !a.alternate.is_empty() && !b.alternate.is_empty();
    let apart = given && a.alternate != b.alternate;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pdb::element::of_symbol;
    use crate::pdb::words::{Serial, Word, Words};
    use proptest::prelude::*;

    /// An atom; a serial number that is no number is a word.
    fn atom(symbol: &str, serial: &str, alternate: &str, place: [f64; 3]) -> Atom {
        let mut words = known();
        Atom {
            place,
            element: of_symbol(symbol).expect("an element"),
            serial: Serial::of(serial.as_bytes(), &mut words),
            occupancy: 1.0,
            name: words.keep("CA"),
            alternate: words.find(alternate).expect("a known word"),
            residue: words.keep("LIG"),
            number: words.find("7").expect("a known word"),
            chain: Word::EMPTY,
            part: words.keep("A"),
        }
    }

    fn known() -> Words {
        let mut words = Words::default();
        for text in ["A", "B", "7", "CA", "LIG", "A0000"] {
            words.keep(text);
        }
        words
    }

    fn serials(a: &str, b: &str) -> [End; 2] {
        [a, b].map(|text| End::Serial(Serial::of(text.as_bytes(), &mut known())))
    }

    fn bonds_of(atoms: &[Atom], said: &[[End; 2]]) -> Bonds {
        find(atoms, &[atoms.len()], said, "x").unwrap()
    }

    #[test]
    fn bonds_end_where_the_radii_and_the_tolerance_do() {
        // C and N: 0.76 + 0.71 + 0.45 = 1.92.
        let first = || atom("C", "1", "", [0.0; 3]);
        let at = |x: f64| [first(), atom("N", "2", "", [x, 0.0, 0.0])];
        let count = |atoms: &[Atom]| bonds_of(atoms, &[]).pairs.len();
        let counts = [1.91, 1.93, 0.41, 0.39].map(|x| count(&at(x)));
        assert_eq!(counts, [1, 0, 1, 0]);
        let two = |s: &str, a, b| [atom(s, "1", a, [0.0; 3]), atom(s, "2", b, [0.8, 0.0, 0.0])];
        assert_eq!(count(&two("H", "", "")), 0);
        assert_eq!(count(&two("C", "A", "B")), 0);
        assert_eq!(count(&two("C", "A", "A")), 1);
        assert_eq!(count(&two("C", "A", "")), 1);
    }

    #[test]
    fn connections_are_taken_when_their_numbers_are_unique() {
        let far = [
            atom("C", "1", "", [0.0; 3]),
            atom("C", "A0000", "", [5.0, 0.0, 0.0]),
            atom("C", "3", "", [10.0, 0.0, 0.0]),
            atom("C", "3", "", [15.0, 0.0, 0.0]),
        ];
        let said = [("1", "A0000"), ("A0000", "1"), ("1", "3"), ("1", "9")];
        let said = said.map(|(a, b)| serials(a, b));
        let bonds = bonds_of(&far, &said);
        assert_eq!((bonds.pairs, bonds.connected), (vec![[0, 1]], 1));
    }

    /// Names hold within each copy, whatever its chains are called.
    #[test]
    fn connections_hold_within_each_copy() {
        let ends = [("1", "A", 0.0), ("2", "B", 5.0)];
        let copy = |y: f64| ends.map(|(serial, own, x)| atom("S", serial, own, [x, y, 0.0]));
        let atoms = [copy(0.0), copy(20.0)].concat();
        let words = known();
        let end = |own| End::Names(["A", "7", "CA", own].map(|t| words.find(t).unwrap()));
        let said = [[end("A"), end("B")]];
        let found = |copies: &[usize]| find(&atoms, copies, &said, "x").unwrap().pairs;
        assert_eq!(found(&[2, 4]), [[0, 1], [2, 3]]);
        // As one copy, two atoms have each name.
        assert!(found(&[4]).is_empty());
    }

    #[test]
    fn crowds_are_refused_and_stars_are_thinned() {
        let row = |count: u32, step: f64| -> Vec<Atom> {
            let atom = |k: u32| atom("C", &k.to_string(), "", [step * f64::from(k), 0.0, 0.0]);
            (0..count).map(atom).collect()
        };
        let error = find(&row(1000, 0.001), &[1000], &[], "f.pdb").unwrap_err();
        let says = "f.pdb: more than 256 atoms within 2.0 angstroms";
        assert!(error.to_string().starts_with(says), "{error}");
        let star = row(20, 100.0);
        let said: Vec<[End; 2]> = (1..20).map(|k| serials("0", &k.to_string())).collect();
        let bonds = bonds_of(&star, &said);
        assert_eq!((bonds.pairs.len(), bonds.left_out), (16, 3));
    }

    proptest! {
        /// The grid finds what trying all pairs finds.
        #[test]
        fn the_grid_misses_no_pair(places in proptest::collection::vec(([-9.0f64..9.0, -9.0..9.0, -9.0..9.0], 0usize..4), 2..60)) {
            let atoms: Vec<Atom> = places.iter().map(|(p, k)| atom(["H", "C", "S", "Fe"][*k], "1", "", *p)).collect();
            let mut expected = Vec::new();
            for i in 0..atoms.len() {
                expected.extend((i + 1..atoms.len()).filter(|j| are_bonded(&atoms[i], &atoms[*j])).map(|j| [i, j]));
            }
            let mut found = by_distance(&atoms, "x").unwrap();
            found.sort_unstable();
            prop_assert_eq!(found, expected);
        }
    }
}
