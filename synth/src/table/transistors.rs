//! Transistors beside Table 5.10 of the source, which counts a processor of patches with four planes.

use super::Table;
use super::rows::Section;
use crate::target::Target;

/// An adder with its register in the source: 13 of them take 19 344.
pub const ADDER: u64 = 19_344 / 13;

/// PE1 of the source: 8 of them take 32 928.
pub const PE1: u64 = 32_928 / 8;
/// PE2 of the source.
pub const PE2: u64 = 15_120;
/// Root network of the source.
pub const ROOT: u64 = 96_598;

/// The three multipliers of the source.
pub const MULTIPLIERS: u64 = 47_616;

/// A unit, what stands for it in the source, its transistors there, and the bits there and here where it has a width.
type Counterpart = (&'static str, &'static str, u64, Option<(u64, u64)>);

const COUNTERPARTS: [Counterpart; 5] = [
    ("pe1", "PE1", PE1, Some((24, 26))),
    ("pe2", "PE2", PE2, Some((48, 48))),
    ("square_root", "root", ROOT, Some((48, 48))),
    (
        "quadric_pe",
        "PE1, PE2, root, 2 adders with registers",
        PE1 + PE2 + ROOT + 2 * ADDER,
        None,
    ),
    (
        "normal_unit",
        "3 multipliers, 3 adders with registers",
        MULTIPLIERS + 3 * ADDER,
        None,
    ),
];

const INTRODUCTION: &str = "
Static CMOS gates of Yosys (`stat -tech cmos`: flip-flop 16, inverter 2, 2-input NAND or NOR 4, XOR 12), beside Table 5.10 of the
source (ES2 SOLO 1400, library ECPD15). Where that table has no line for a unit, the lines it is made of are added up.

| unit | there | bits here | transistors here | per bit | bits there | transistors there | per bit |
|---|---|---|---|---|---|---|---|
";

const COMPARABILITY: &str = "
The whole table of the source, a processor of patches with four planes, 225 732 transistors: 8 PE1 32 928, PE2 15 120, root 96 598,
3 multipliers 47 616, 13 adders with registers 19 344, logic of the planes 1 022, registers of synchronisation 13 104. The last two are
no unit here: the cut planes here are those of the second generation, which carry depths and normals along.

The two columns are comparable in kind, not in detail. The source counts library cells of its time, a full adder of 36 and a
flip-flop of 26 transistors; here there are neither adder cells nor pass gates, and the flip-flop is cheaper. PE1 has 24 bits there
and 26 here, as wide as a depth sum. An elementary processor here holds still on a clock without a pixel, which costs gates in every
bit of its registers. The root here has a register stage per row and hands on its remainder. The normal unit here also shifts the
root, negates products and chooses the normals of planes.
";

/// Text of the section.
pub fn write(table: &Table) -> String {
    let mut text = INTRODUCTION.to_owned();
    for row in table.section(Section::Transistors, Target::Transistors) {
        text += &line(&row.unit, row.figures.transistors.unwrap_or_default());
    }
    text + COMPARABILITY
}

fn line(unit: &str, here: u64) -> String {
    match COUNTERPARTS.iter().find(|known| known.0 == unit) {
        Some((_, name, there, Some((bits_there, bits)))) => format!(
            "| `{unit}` | {name} | {bits} | {here} | {} | {bits_there} | {there} | {} |\n",
            here / bits,
            there / bits_there
        ),
        Some((_, name, there, None)) => {
            format!("| `{unit}` | {name} | - | {here} | - | - | {there} | - |\n")
        }
        None => format!("| `{unit}` | - | - | {here} | - | - | - | - |\n"),
    }
}
