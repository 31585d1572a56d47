//! Options of `import` for molecules.

use clap::{Args, ValueEnum};
use imogene_import::pdb::{Alternates, Colouring, ModelChoice, Options, Style};

/// Options of molecules.
#[derive(Clone, Debug, Args)]
pub struct MoleculeOptions {
    /// How it is drawn.
    #[arg(long, value_enum, default_value_t = StyleName::SpaceFilling)]
    style: StyleName,
    /// What gives an atom its colour.
    #[arg(long, alias = "color", value_enum, default_value_t = ColourName::Element)]
    colour: ColourName,
    /// Model to draw: `first`, its number, or `all`, each where its coordinates put it.
    #[arg(long, default_value = "first", value_parser = model, value_name = "N|first|all")]
    model: ModelChoice,
    /// Alternate locations to draw: `best` of each residue by occupancy, those of a letter, or `all`.
    #[arg(long, default_value = "best", value_parser = alternates, value_name = "LETTER|best|all")]
    alternates: Alternates,
    /// Leave hydrogens out.
    #[arg(long)]
    no_hydrogens: bool,
    /// Leave water out.
    #[arg(long)]
    no_water: bool,
}

/// Styles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum StyleName {
    /// Spheres of the van der Waals radii.
    SpaceFilling,
    /// Small spheres, and cylinders for bonds.
    BallAndStick,
}

/// What gives the colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ColourName {
    /// The element.
    Element,
    /// The chain.
    Chain,
    /// The model.
    Model,
}

impl MoleculeOptions {
    /// The options of the reader.
    pub fn options(&self) -> Options {
        Options {
            style: match self.style {
                StyleName::SpaceFilling => Style::SpaceFilling,
                StyleName::BallAndStick => Style::BallAndStick,
            },
            colouring: match self.colour {
                ColourName::Element => Colouring::Element,
                ColourName::Chain => Colouring::Chain,
                ColourName::Model => Colouring::Model,
            },
            model: self.model,
            alternates: self.alternates,
            hydrogens: !self.no_hydrogens,
            water: !self.no_water,
        }
    }
}

fn model(text: &str) -> Result<ModelChoice, String> {
    match text {
        "first" => Ok(ModelChoice::First),
        "all" => Ok(ModelChoice::All),
        number => number
            .parse()
            .map(ModelChoice::Number)
            .map_err(|_| "a number, first or all would be accepted".into()),
    }
}

fn alternates(text: &str) -> Result<Alternates, String> {
    match (text, text.as_bytes()) {
        ("best", _) => Ok(Alternates::Best),
        ("all", _) => Ok(Alternates::All),
        (_, [letter]) if letter.is_ascii_graphic() => Ok(Alternates::Letter(*letter)),
        _ => Err("one letter or digit, best or all would be accepted".into()),
    }
}
