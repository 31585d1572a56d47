//! What a person and a script are told of a molecule.

use super::bonds::TOLERANCE;
use super::choose::{Chosen, LeftOut};
use super::options::Options;
use super::scene::Drawn;
use super::structure::Structure;
use super::words::listed;
use crate::kit::short;
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
        let assemblies = structure.assemblies.names().into_iter();
        Contents {
            atoms: structure.models.iter().map(|m| m.atoms.len()).sum(),
            models: structure.models.iter().map(|m| m.number).collect(),
            assemblies: assemblies.map(str::to_owned).collect(),
        }
    }
}

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
    let spheres = atoms().count();
    let shown: Vec<i64> = chosen.iter().map(|c| c.number).collect();
    let (low, high) = (drawn.extent.0.map(short), drawn.extent.1.map(short));
    let guessed = atoms().map(|atom| atom.element);
    let guessed = guessed.filter(|e| e.is_guessed() && e.symbol != "?");
    let guessed: BTreeSet<&str> = guessed.map(|e| e.symbol).collect();
    let value = json!({
        "title": drawn.scene.title,
        "atoms_read": read.atoms,
        "atoms_drawn": spheres,
        "left_out": left_out,
        "models": read.models,
        "models_drawn": shown,
        "assemblies": read.assemblies,
        "assembly_drawn": options.assembly,
        "chains": chains,
        "elements": elements,
        "elements_from_names": structure.named_element,
        "elements_unknown": structure.no_element,
        "bonds": drawn.bonds.pairs.len(),
        "bonds_from_file_alone": drawn.bonds.connected,
        "spheres": spheres,
        "cylinders": drawn.scene.objects.len() - spheres,
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
            counted(spheres, "atom")
        ),
        None => format!("{spheres} of {atoms} drawn, {of_all}{bonds}"),
    }];
    // How many there are of something, and what became of them.
    let told = |count: usize, one: &str, rest: &str| {
        (count > 0).then(|| format!("{} {rest}", counted(count, one)))
    };
    let assemblies = listed(read.assemblies.iter().cloned());
    let as_they_stand = options.assembly.is_none() && !read.assemblies.is_empty();
    let no_occupancy = structure.no_occupancy;
    let names = Vec::from_iter(guessed).join(", ");
    let models = "of other models left out; --model N or --model all draws them";
    let residues = "of other residues left out";
    let stand = format!(
        "the coordinates as they stand; --assembly {assemblies} draws what it makes of them"
    );
    let blocks = "further data blocks left out: the first that has atoms is drawn";
    let cells = "to other cells of the crystal left out";
    let draws = "left out; --alternates all draws them";
    let from_name = "without an element's symbol: element from the atom's name";
    let unknown = "of no known element: drawn with a van der Waals radius of 2.0 and a covalent one of 1.5 angstroms, in pink";
    let occupancies = format!("occupancies that are no numbers, taken as 1: {no_occupancy}");
    let radius = format!("no published radius of {names}: 2.0 angstroms, or 1.5 covalent, instead");
    let farther = format!(
        "that only the file says: farther apart than the covalent radii and {TOLERANCE} angstroms, or of a kind that is not looked for"
    );
    let thinned = "left out at atoms that have sixteen already";
    let lines = [
        told(left_out.other_models, "atom", models),
        told(left_out.other_chains, "atom", "of other chains left out"),
        told(left_out.other_residues, "atom", residues),
        as_they_stand.then_some(stand),
        structure.other_blocks.then(|| blocks.to_owned()),
        told(structure.other_cells, "bond", cells),
        told(left_out.alternate_locations, "alternate location", draws),
        told(left_out.hydrogens, "hydrogen", "left out"),
        told(left_out.water, "atom", "of water left out"),
        told(structure.named_element, "atom", from_name),
        told(structure.no_element, "atom", unknown),
        (no_occupancy > 0).then_some(occupancies),
        (!names.is_empty()).then_some(radius),
        told(drawn.bonds.connected, "bond", &farther),
        told(drawn.bonds.left_out, "bond", thinned),
    ];
    notes.extend(lines.into_iter().flatten());
    (value, notes)
}
