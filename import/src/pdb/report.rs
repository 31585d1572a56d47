//! What a person and a script are told of a molecule.

use super::bonds::TOLERANCE;
use super::choose::{Chosen, LeftOut};
use super::options::Options;
use super::scene::Drawn;
use super::structure::{Remark, Structure};
use super::words::listed;
use imogene_files::text::counted;
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// What a file holds.
#[derive(Clone, Debug, Serialize)]
pub struct Contents {
    /// Atoms of all models.
    pub atoms: usize,
    /// Numbers of the models.
    pub models: Vec<i64>,
    /// Names of the assemblies that it describes.
    pub assemblies: Vec<String>,
}

impl Contents {
    /// Counts of a structure.
    pub fn of(structure: &Structure) -> Contents {
        Contents {
            atoms: structure.models.iter().map(|m| m.atoms.len()).sum(),
            models: structure.models.iter().map(|m| m.number).collect(),
            assemblies: structure
                .assemblies
                .names()
                .into_iter()
                .map(str::to_owned)
                .collect(),
        }
    }
}

/// The report, and its notes.
pub fn report(
    structure: &Structure,
    read: &Contents,
    chosen: &[Chosen],
    left_out: &LeftOut,
    drawn: &Drawn,
    options: &Options,
) -> (Value, Vec<String>) {
    let atoms = || chosen.iter().flat_map(|c| &c.atoms);
    let mut elements: BTreeMap<&str, usize> = BTreeMap::new();
    let mut chains = BTreeSet::new();
    for atom in atoms() {
        *elements.entry(atom.element.symbol).or_default() += 1;
        chains.insert(structure.words.text(atom.chain));
    }
    let remark = |remark| structure.count(remark);
    let shown: Vec<i64> = chosen.iter().map(|c| c.number).collect();
    let short = |v: f64| (v * 1e4).round() / 1e4;
    let (low, high) = (drawn.extent.0.map(short), drawn.extent.1.map(short));
    let guessed: BTreeSet<&str> = atoms()
        .filter(|a| a.element.is_guessed() && a.element.symbol != "?")
        .map(|a| a.element.symbol)
        .collect();
    let value = json!({
        "title": drawn.scene.title,
        "atoms_read": read.atoms,
        "atoms_drawn": drawn.spheres,
        "left_out": left_out,
        "models": read.models,
        "models_drawn": shown,
        "assemblies": read.assemblies,
        "assembly_drawn": options.assembly,
        "chains": chains,
        "elements": elements,
        "elements_from_names": remark(Remark::NamedElement),
        "elements_unknown": remark(Remark::NoElement),
        "bonds": drawn.bonds.pairs.len(),
        "bonds_from_file_alone": drawn.bonds.connected,
        "spheres": drawn.spheres,
        "cylinders": drawn.cylinders,
        "box": { "low": low, "high": high },
    });
    let bonds = match drawn.bonds.pairs.len() {
        0 => String::new(),
        count => format!(", {}", counted(count, "bond")),
    };
    let of_all = format!("{} of {}", shown.len(), counted(read.models.len(), "model"));
    let atoms = counted(read.atoms, "atom");
    let mut notes = vec![match &options.assembly {
        Some(name) => format!(
            "assembly {name}: {} drawn, of {atoms} in the file, {of_all}{bonds}",
            counted(drawn.spheres, "atom")
        ),
        None => format!("{} of {atoms} drawn, {of_all}{bonds}", drawn.spheres),
    }];
    let mut note = |count: usize, text: String| {
        if count > 0 {
            notes.push(text);
        }
    };
    let other = left_out.other_models;
    note(
        other,
        format!(
            "{} of other models left out; --model N or --model all draws them",
            counted(other, "atom")
        ),
    );
    for (other, of) in [
        (left_out.other_chains, "chains"),
        (left_out.other_residues, "residues"),
    ] {
        note(
            other,
            format!("{} of other {of} left out", counted(other, "atom")),
        );
    }
    if options.assembly.is_none() && !read.assemblies.is_empty() {
        let names = listed(read.assemblies.iter().cloned());
        note(
            1,
            format!(
                "the coordinates as they stand; --assembly {names} draws what it makes of them"
            ),
        );
    }
    note(
        remark(Remark::OtherBlocks),
        "further data blocks left out: the first that has atoms is drawn".to_owned(),
    );
    let other = remark(Remark::OtherCells);
    note(
        other,
        format!(
            "{} to other cells of the crystal left out",
            counted(other, "bond")
        ),
    );
    let other = left_out.alternate_locations;
    note(
        other,
        format!(
            "{} left out; --alternates all draws them",
            counted(other, "alternate location")
        ),
    );
    let other = left_out.hydrogens;
    note(other, format!("{} left out", counted(other, "hydrogen")));
    let other = left_out.water;
    note(
        other,
        format!("{} of water left out", counted(other, "atom")),
    );
    let other = remark(Remark::NamedElement);
    note(
        other,
        format!(
            "{} without an element's symbol: element from the atom's name",
            counted(other, "atom")
        ),
    );
    let other = remark(Remark::NoElement);
    note(
        other,
        format!(
            "{} of no known element: drawn with a van der Waals radius of 2.0 and a covalent one of 1.5 angstroms, in pink",
            counted(other, "atom")
        ),
    );
    let other = remark(Remark::NoOccupancy);
    note(
        other,
        format!("occupancies that are no numbers, taken as 1: {other}"),
    );
    let names: Vec<&str> = guessed.into_iter().collect();
    note(
        names.len(),
        format!(
            "no published radius of {}: 2.0 angstroms, or 1.5 covalent, instead",
            names.join(", ")
        ),
    );
    let other = drawn.bonds.connected;
    note(
        other,
        format!(
            "{} that only the file says: farther apart than the covalent radii and {TOLERANCE} angstroms, or of a kind that is not looked for",
            counted(other, "bond")
        ),
    );
    let other = drawn.bonds.left_out;
    note(
        other,
        format!(
            "{} left out at atoms that have sixteen already",
            counted(other, "bond")
        ),
    );
    (value, notes)
}
