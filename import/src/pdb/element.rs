//! Elements: radii and colours, and which element an atom is.
//!
//! Covalent radii: B. Cordero et al., "Covalent radii revisited", Dalton Trans. 2008, 2832. Van der Waals radii: A.
//! Bondi, J. Phys. Chem. 68 (1964) 441, and for the elements that he has not, S. Alvarez, "A cartography of the van der
//! Waals territories", Dalton Trans. 2013, 42, 8617. Colours: those of the program Jmol.

use crate::kit::short;

/// What is known of an element; radii in picometres, 0 where the sources have none.
#[derive(Debug, PartialEq, Eq)]
pub struct Element {
    pub symbol: &'static str,
    /// Covalent, and two of van der Waals: by Bondi, and by Alvarez.
    radii: [u16; 3],
    colour: u32,
}

/// What stands in for elements that the tables lack: about the middle of the metals, in a pink that no other has.
pub const UNKNOWN: Element = element("?", [150, 0, 200], 0xff1493);

const fn element(symbol: &'static str, radii: [u16; 3], colour: u32) -> Element {
    Element {
        symbol,
        radii,
        colour,
    }
}

/// The elements up to einsteinium; place 0 is hydrogen.
#[rustfmt::skip]
pub const ELEMENTS: [Element; 99] = [
    element("H", [31, 120, 120], 0xffffff),
    element("He", [28, 140, 143], 0xd9ffff),
    element("Li", [128, 182, 212], 0xcc80ff),
    element("Be", [96, 0, 198], 0xc2ff00),
    element("B", [84, 0, 191], 0xffb5b5),
    element("C", [76, 170, 177], 0x909090),
    element("N", [71, 155, 166], 0x3050f8),
    element("O", [66, 152, 150], 0xff0d0d),
    element("F", [57, 147, 146], 0x90e050),
    element("Ne", [58, 154, 158], 0xb3e3f5),
    element("Na", [166, 227, 250], 0xab5cf2),
    element("Mg", [141, 173, 251], 0x8aff00),
    element("Al", [121, 0, 225], 0xbfa6a6),
    element("Si", [111, 210, 219], 0xf0c8a0),
    element("P", [107, 180, 190], 0xff8000),
    element("S", [105, 180, 189], 0xffff30),
    element("Cl", [102, 175, 182], 0x1ff01f),
    element("Ar", [106, 188, 183], 0x80d1e3),
    element("K", [203, 275, 273], 0x8f40d4),
    element("Ca", [176, 0, 262], 0x3dff00),
    element("Sc", [170, 0, 258], 0xe6e6e6),
    element("Ti", [160, 0, 246], 0xbfc2c7),
    element("V", [153, 0, 242], 0xa6a6ab),
    element("Cr", [139, 0, 245], 0x8a99c7),
    element("Mn", [139, 0, 245], 0x9c7ac7),
    element("Fe", [132, 0, 244], 0xe06633),
    element("Co", [126, 0, 240], 0xf090a0),
    element("Ni", [124, 163, 240], 0x50d050),
    element("Cu", [132, 140, 238], 0xc88033),
    element("Zn", [122, 139, 239], 0x7d80b0),
    element("Ga", [122, 187, 232], 0xc28f8f),
    element("Ge", [120, 0, 229], 0x668f8f),
    element("As", [119, 185, 188], 0xbd80e3),
    element("Se", [120, 190, 182], 0xffa100),
    element("Br", [120, 185, 186], 0xa62929),
    element("Kr", [116, 202, 225], 0x5cb8d1),
    element("Rb", [220, 0, 321], 0x702eb0),
    element("Sr", [195, 0, 284], 0x00ff00),
    element("Y", [190, 0, 275], 0x94ffff),
    element("Zr", [175, 0, 252], 0x94e0e0),
    element("Nb", [164, 0, 256], 0x73c2c9),
    element("Mo", [154, 0, 245], 0x54b5b5),
    element("Tc", [147, 0, 244], 0x3b9e9e),
    element("Ru", [146, 0, 246], 0x248f8f),
    element("Rh", [142, 0, 244], 0x0a7d8c),
    element("Pd", [139, 163, 215], 0x006985),
    element("Ag", [145, 172, 253], 0xc0c0c0),
    element("Cd", [144, 158, 249], 0xffd98f),
    element("In", [142, 193, 243], 0xa67573),
    element("Sn", [139, 217, 242], 0x668080),
    element("Sb", [139, 0, 247], 0x9e63b5),
    element("Te", [138, 206, 199], 0xd47a00),
    element("I", [139, 198, 204], 0x940094),
    element("Xe", [140, 216, 206], 0x429eb0),
    element("Cs", [244, 0, 348], 0x57178f),
    element("Ba", [215, 0, 303], 0x00c900),
    element("La", [207, 0, 298], 0x70d4ff),
    element("Ce", [204, 0, 288], 0xffffc7),
    element("Pr", [203, 0, 292], 0xd9ffc7),
    element("Nd", [201, 0, 295], 0xc7ffc7),
    element("Pm", [199, 0, 0], 0xa3ffc7),
    element("Sm", [198, 0, 290], 0x8fffc7),
    element("Eu", [198, 0, 287], 0x61ffc7),
    element("Gd", [196, 0, 283], 0x45ffc7),
    element("Tb", [194, 0, 279], 0x30ffc7),
    element("Dy", [192, 0, 287], 0x1fffc7),
    element("Ho", [192, 0, 281], 0x00ff9c),
    element("Er", [189, 0, 283], 0x00e675),
    element("Tm", [190, 0, 279], 0x00d452),
    element("Yb", [187, 0, 280], 0x00bf38),
    element("Lu", [187, 0, 274], 0x00ab24),
    element("Hf", [175, 0, 263], 0x4dc2ff),
    element("Ta", [170, 0, 253], 0x4da6ff),
    element("W", [162, 0, 257], 0x2194d6),
    element("Re", [151, 0, 249], 0x267dab),
    element("Os", [144, 0, 248], 0x266696),
    element("Ir", [141, 0, 241], 0x175487),
    element("Pt", [136, 175, 229], 0xd0d0e0),
    element("Au", [136, 166, 232], 0xffd123),
    element("Hg", [132, 155, 245], 0xb8b8d0),
    element("Tl", [145, 196, 247], 0xa6544d),
    element("Pb", [146, 202, 260], 0x575961),
    element("Bi", [148, 0, 254], 0x9e4fb5),
    element("Po", [140, 0, 0], 0xab5c00),
    element("At", [150, 0, 0], 0x754f45),
    element("Rn", [150, 0, 0], 0x428296),
    element("Fr", [260, 0, 0], 0x420066),
    element("Ra", [221, 0, 0], 0x007d00),
    element("Ac", [215, 0, 280], 0x70abfa),
    element("Th", [206, 0, 293], 0x00baff),
    element("Pa", [200, 0, 288], 0x00a1ff),
    element("U", [196, 186, 271], 0x008fff),
    element("Np", [190, 0, 282], 0x0080ff),
    element("Pu", [187, 0, 281], 0x006bff),
    element("Am", [180, 0, 283], 0x545cf2),
    element("Cm", [169, 0, 305], 0x785ce3),
    element("Bk", [0, 0, 340], 0x8a4fe3),
    element("Cf", [0, 0, 305], 0xa136d4),
    element("Es", [0, 0, 270], 0xb31fd4),
];

impl Element {
    /// Radius of its sphere when it touches what it is not bonded to, in angstroms.
    pub fn van_der_waals(&self) -> f64 {
        known(&self.radii[1..], UNKNOWN.radii[2])
    }

    /// Its share of the length of a bond, in angstroms.
    pub fn covalent(&self) -> f64 {
        known(&self.radii[..1], UNKNOWN.radii[0])
    }

    /// Red, green and blue, 0 to 1.
    pub fn colour(&self) -> [f64; 3] {
        // Four digits, so that a scene file says 0.5647 and not sixteen digits of 144/255; 8 bits stay the same.
        [16, 8, 0].map(|shift| short(f64::from(self.colour >> shift & 0xff) / 255.0))
    }

    /// Hydrogen, deuterium or tritium.
    pub fn is_hydrogen(&self) -> bool {
        self.symbol == "H"
    }

    /// One of the radii is that of [`UNKNOWN`], because the sources have none.
    pub fn is_guessed(&self) -> bool {
        self.radii[0] == 0 || self.radii[1..] == [0, 0] || *self == UNKNOWN
    }
}

/// The first radius that the sources have, or that of what is unknown, in angstroms.
fn known(radii: &[u16], unknown: u16) -> f64 {
    f64::from(*radii.iter().find(|radius| **radius > 0).unwrap_or(&unknown)) / 100.0
}

/// The element of a symbol in any case; deuterium and tritium are hydrogen.
pub fn of_symbol(symbol: &str) -> Option<&'static Element> {
    if ["D", "T"].iter().any(|s| s.eq_ignore_ascii_case(symbol)) {
        return ELEMENTS.first();
    }
    let mut all = ELEMENTS.iter();
    all.find(|e| e.symbol.eq_ignore_ascii_case(symbol))
}

/// Residues of proteins and nucleic acids, and water: all their atoms have one-letter elements, selenium apart.
const STANDARD: [&str; 44] = [
    "ALA", "ARG", "ASN", "ASP", "ASX", "CYS", "GLN", "GLU", "GLX", "GLY", "HIS", "ILE", "LEU",
    "LYS", "MET", "PHE", "PRO", "PYL", "SER", "THR", "TRP", "TYR", "VAL", "A", "C", "G", "U", "I",
    "DA", "DC", "DG", "DT", "DU", "DI", "T", "HOH", "WAT", "H2O", "DOD", "HID", "HIE", "HIP",
    "CYX", "ACE",
];

/// The element of an atom by its name in columns 13 to 16: the symbol is right-justified in the first two, so that
/// ` CA ` is carbon and `CA  ` calcium. A name of four characters has no room for that, and is hydrogen if it begins
/// with H or D (`HG11`). In residues of proteins and nucleic acids the first letter decides, because programs shift
/// names to the left; an ion has the name of its residue, wherever that stands.
pub fn of_name(name: [u8; 4], residue: &str) -> Option<&'static Element> {
    let standard = STANDARD.iter().any(|r| r.eq_ignore_ascii_case(residue));
    let text = std::str::from_utf8(&name).ok()?.trim();
    if text.len() == 2 && text.eq_ignore_ascii_case(residue) && !standard {
        return of_symbol(text);
    }
    let first_letter = || {
        let letter = name.iter().find(|c| c.is_ascii_alphabetic())?;
        of_symbol(char::from(*letter).encode_utf8(&mut [0; 4]))
    };
    let two_letters = || of_symbol(text.get(..2)?);
    let [a, b, _, d] = name;
    let is_long = d != b' ' && a != b' ' && b != b' ';
    let is_hydrogen = is_long && matches!(a.to_ascii_uppercase(), b'H' | b'D');
    if !a.is_ascii_alphabetic() || standard || is_hydrogen {
        first_letter().or_else(two_letters)
    } else {
        two_letters().or_else(first_letter)
    }
}
