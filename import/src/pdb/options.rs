//! What of a structure is drawn, and how: for callers, for the command line and for scenes that name a structure.

use imogene_scene::Molecule;
use std::fmt;
use std::str::FromStr;

/// How a molecule is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// Every atom as a sphere of its van der Waals radius.
    #[default]
    SpaceFilling,
    /// Small spheres, and cylinders for bonds.
    BallAndStick,
}

/// What gives an atom its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colouring {
    /// Its element.
    #[default]
    Element,
    /// Its chain.
    Chain,
    /// Its model.
    Model,
}

/// Which models are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ModelChoice {
    /// The first of the file.
    #[default]
    First,
    /// The first of this number.
    Number(i64),
    /// All, each where its coordinates put it.
    All,
}

/// Which locations of atoms that have several are drawn.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Alternates {
    /// In each residue the alternate of the highest mean occupancy; of equal ones that whose atoms stand first.
    #[default]
    Best,
    /// The alternate of a name, and the best where a residue has no such.
    Named(String),
    /// All.
    All,
}

/// Residues that are drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Residues {
    /// Those of a number with its insertion code, or of a name.
    Called(String),
    /// Those of numbers from the first to the last, with any insertion code.
    Range(i64, i64),
}

/// How a file is read; the default draws all atoms of the first model.
#[derive(Clone, Debug)]
pub struct Options {
    /// How it is drawn.
    pub style: Style,
    /// What gives the colours.
    pub colouring: Colouring,
    /// Which models.
    pub model: ModelChoice,
    /// Which alternate locations.
    pub alternates: Alternates,
    /// Whether hydrogens are drawn.
    pub hydrogens: bool,
    /// Whether water is drawn.
    pub water: bool,
    /// Chains by name; all if there are none.
    pub chains: Vec<String>,
    /// Residues; all if there are none.
    pub residues: Vec<Residues>,
    /// The assembly whose copies are drawn; the coordinates as they stand without one.
    pub assembly: Option<String>,
}

impl Default for Options {
    fn default() -> Self {
        Self::of(&Molecule::default()).expect("a scene's own words")
    }
}

const STYLES: [(&str, Style); 2] = [
    ("space-filling", Style::SpaceFilling),
    ("ball-and-stick", Style::BallAndStick),
];
const COLOURINGS: [(&str, Colouring); 3] = [
    ("element", Colouring::Element),
    ("chain", Colouring::Chain),
    ("model", Colouring::Model),
];

fn named<T: Copy>(table: &[(&str, T)], text: &str) -> Result<T, String> {
    let found = table.iter().find(|(name, _)| *name == text);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let names: Vec<&str> = table.iter().map(|(name, _)| *name).collect();
        let names = names.join(" or ");
        format!("`{text}` is not known; {names} would be accepted")
    })
}

impl FromStr for ModelChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "first" => Ok(Self::First),
            "all" => Ok(Self::All),
            number => match number.parse() {
                Ok(number) => Ok(Self::Number(number)),
                Err(_) => Err("a number, first or all would be accepted".into()),
            },
        }
    }
}

impl fmt::Display for ModelChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::First => f.write_str("first"),
            Self::All => f.write_str("all"),
            Self::Number(number) => write!(f, "{number}"),
        }
    }
}

impl FromStr for Alternates {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_name = !text.is_empty() && text.chars().all(|c| c.is_ascii_graphic());
        match text {
            "best" => Ok(Self::Best),
            "all" => Ok(Self::All),
            name if is_name && name.len() <= 3 => Ok(Self::Named(name.to_owned())),
            _ => Err("a letter or digit, best or all would be accepted".into()),
        }
    }
}

/// `10-20` is a range, also of negative numbers (`-5--1`); anything else is what a residue is called.
impl FromStr for Residues {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if text.is_empty() {
            return Err(
                "a number, a range such as 10-20 or a name such as HEM would be accepted".into(),
            );
        }
        // The dash of a range is no sign: it stands behind a digit.
        let dash = text.char_indices().skip(1).find(|(_, c)| *c == '-');
        let range = dash.and_then(|(at, _)| {
            let (first, last) = (&text[..at], &text[at + 1..]);
            Some((first.parse::<i64>().ok()?, last.parse::<i64>().ok()?))
        });
        match range {
            Some((first, last)) if first > last => {
                let accepted = format!("{last}-{first} would be accepted");
                Err(format!("the range {text} runs backwards; {accepted}"))
            }
            Some((first, last)) => Ok(Self::Range(first, last)),
            None => Ok(Self::Called(text.to_owned())),
        }
    }
}

impl fmt::Display for Residues {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Called(name) => f.write_str(name),
            Self::Range(first, last) => write!(f, "{first}-{last}"),
        }
    }
}

impl Options {
    /// The options that a scene's molecule asks for; errors say which key is wrong and what it takes.
    pub fn of(molecule: &Molecule) -> Result<Options, String> {
        let at = |key: &'static str| move |problem: String| format!("{key}: {problem}");
        let residues: Result<Vec<Residues>, String> =
            molecule.residues.iter().map(|text| text.parse()).collect();
        Ok(Options {
            style: named(&STYLES, &molecule.style).map_err(at("style"))?,
            colouring: named(&COLOURINGS, &molecule.colour).map_err(at("colour"))?,
            model: molecule.model.parse().map_err(at("model"))?,
            alternates: molecule.alternates.parse().map_err(at("alternates"))?,
            hydrogens: molecule.hydrogens,
            water: molecule.water,
            chains: molecule.chains.clone(),
            residues: residues.map_err(at("residues"))?,
            assembly: molecule.assembly.clone(),
        })
    }
}
