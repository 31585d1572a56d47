//! Options of `import` for molecules.

use crate::arguments::parse::{Choices, choice, name};
use clap::Args;
use imogene_import::pdb::{Alternates, Colouring, ModelChoice, Options, Residues, Style};
use imogene_scene::Molecule;
use std::str::FromStr;

/// Options of molecules.
#[derive(Clone, Debug, Args)]
pub struct MoleculeOptions {
    /// How it is drawn.
    #[arg(long, value_parser = choice(STYLES), default_value = "space-filling")]
    style: Style,
    /// What gives an atom its colour.
    #[arg(long, alias = "color", value_parser = choice(COLOURS), default_value = "element")]
    colour: Colouring,
    /// Model to draw: `first`, its number, or `all`, each where its coordinates put it.
    #[arg(long, default_value = "first", value_parser = ModelChoice::from_str, value_name = "N|first|all", allow_hyphen_values = true)]
    model: ModelChoice,
    /// Alternate locations to draw: `best` of each residue by occupancy, those of a letter, or `all`.
    #[arg(long, default_value = "best", value_parser = alternates, value_name = "LETTER|best|all")]
    alternates: String,
    /// Chains to draw, by the names that their authors gave them.
    #[arg(long, value_name = "CHAIN,...", value_delimiter = ',')]
    chain: Vec<String>,
    /// Residues to draw: numbers (with insertion code: 52A), ranges of numbers, and names.
    #[arg(long, value_name = "10-20,55,HEM,...", value_delimiter = ',', value_parser = Residues::from_str, allow_hyphen_values = true)]
    residue: Vec<Residues>,
    /// Draw an assembly, put together of copies of the chains, instead of the coordinates as they stand.
    #[arg(long, value_name = "ID")]
    assembly: Option<String>,
    /// Leave hydrogens out.
    #[arg(long, alias = "no-hydrogens")]
    without_hydrogens: bool,
    /// Leave water out.
    #[arg(long, alias = "no-water")]
    without_water: bool,
    /// Write a scene that names the structure file and is filled from it when it is read; so it is with more than 20
    /// 000 objects.
    #[arg(long, conflicts_with = "inline")]
    pub reference: bool,
    /// Write an object for each atom and bond, however many there are.
    #[arg(long)]
    pub inline: bool,
}

#[rustfmt::skip]
const STYLES: Choices<Style> = &[
    (Style::SpaceFilling, "space-filling", "Spheres of the van der Waals radii"),
    (Style::BallAndStick, "ball-and-stick", "Small spheres, and cylinders for bonds"),
];
const COLOURS: Choices<Colouring> = &[
    (Colouring::Element, "element", "The element"),
    (Colouring::Chain, "chain", "The chain"),
    (Colouring::Model, "model", "The model"),
];

impl MoleculeOptions {
    /// The table of a scene that asks for this of a file.
    pub fn molecule(&self, file: &str) -> Molecule {
        Molecule {
            file: file.to_owned(),
            style: name(STYLES, self.style).to_owned(),
            colour: name(COLOURS, self.colour).to_owned(),
            model: self.model.to_string(),
            alternates: self.alternates.clone(),
            hydrogens: !self.without_hydrogens,
            water: !self.without_water,
            chains: self.chain.clone(),
            residues: self.residue.iter().map(Residues::to_string).collect(),
            assembly: self.assembly.clone(),
            ..Molecule::default()
        }
    }

    /// The options of the reader.
    pub fn options(&self) -> Options {
        Options::of(&self.molecule("")).expect("each word was read once")
    }
}

fn alternates(text: &str) -> Result<String, String> {
    Alternates::from_str(text).map(|_| text.to_owned())
}
