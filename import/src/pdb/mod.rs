//! Molecules: atoms of structure files of the Protein Data Bank as spheres and cylinders.
//!
//! The formats are those of the wwPDB: PDB, "Protein Data Bank Contents Guide", version 3.3, with what older files and
//! other programs write; PDBx/mmCIF; and BinaryCIF.

mod assembly;
mod bcif;
mod bonds;
mod choose;
mod cif;
mod columns;
mod element;
mod framing;
mod lines;
mod options;
mod report;
mod scene;
mod structure;
mod words;

pub use crate::kind::Format;
pub use options::{Alternates, Colouring, ModelChoice, Options, Residues, Style};
pub use report::Contents;

use crate::error::{Error, ImportError, Result};
use crate::kit::Imported;
use imogene_scene::{Molecule, SceneFile};
use structure::Structure;

impl Format {
    fn read(self, bytes: &[u8]) -> Result<Structure> {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        match self {
            Format::Bcif => bcif::read(bytes),
            _ if text.starts_with(&[0xff, 0xfe]) || text.starts_with(&[0xfe, 0xff]) => Err(
                Error::whole("this is text in UTF-16", "text in UTF-8 would be accepted"),
            ),
            Format::Pdb => lines::read(text),
            Format::Mmcif => cif::read(text),
        }
    }
}

/// Reads the bytes of a structure; `file` is the name that messages give it.
pub fn read(
    bytes: &[u8],
    format: Format,
    file: &str,
    options: &Options,
) -> Result<Imported, ImportError> {
    let refused = ImportError::of(file);
    let mut structure = format.read(bytes).map_err(&refused)?;
    let count = Contents::of(&structure);
    let (chosen, left_out) = choose::choose(&mut structure, options).map_err(&refused)?;
    let drawn = scene::build(&structure, &chosen, file, options).map_err(&refused)?;
    let (report, notes) = report::report(&structure, &count, &chosen, &left_out, &drawn, options);
    Ok(Imported {
        scene: drawn.scene,
        report,
        notes,
    })
}

/// What the bytes of a structure hold; `file` is the name that messages give it.
pub fn contents(bytes: &[u8], format: Format, file: &str) -> Result<Contents, ImportError> {
    let structure = format.read(bytes).map_err(ImportError::of(file))?;
    Ok(Contents::of(&structure))
}

/// Adds the objects of a molecule to a scene, as [`read`] makes them, and the materials that the scene has not.
pub fn add(
    scene: &mut SceneFile,
    molecule: &Molecule,
    bytes: &[u8],
    format: Format,
    file: &str,
) -> Result<(), ImportError> {
    let accepted = "see docs/scene-format.md for the keys of [[molecules]]";
    let options = Options::of(molecule).map_err(|problem| Error::whole(problem, accepted));
    let options = options.map_err(ImportError::of(file))?;
    let read = read(bytes, format, file, &options)?.scene;
    let known = scene.materials.len();
    for material in read.materials {
        let mut own = scene.materials[..known].iter();
        if own.all(|m| m.name != material.name) {
            scene.materials.push(material);
        }
    }
    scene.objects.reserve(read.objects.len());
    for mut object in read.objects {
        if let Some(name) = &molecule.name {
            object.name = format!("{name}/{}", object.name);
        }
        object.group.clone_from(&molecule.group);
        scene.objects.push(object);
    }
    Ok(())
}
