//! Transistors beside Table 5.10 of the source, which counts a processor of patches with four planes.

use super::Table;
use super::rows::Section;
use crate::target::Target;
use std::fmt::Write;

/// An adder with its register in the source: 13 of them take 19 344.
const ADDER: u64 = 19_344 / 13;

/// PE1 of the source: 8 of them take 32 928.
const PE1: u64 = 32_928 / 8;
const PE2: u64 = 15_120;
const ROOT: u64 = 96_598;

/// The three multipliers of the source.
const MULTIPLIERS: u64 = 47_616;

/// A unit in the source.
struct Counterpart {
    unit: &'static str,
    /// What stands for it there.
    there: &'static str,
    transistors: u64,
    /// Bits there and here, where the unit has a width.
    bits: Option<(u64, u64)>,
}

const COUNTERPARTS: [Counterpart; 5] = [
    Counterpart {
        unit: "pe1",
        there: "PE1",
        transistors: PE1,
        bits: Some((24, 26)),
    },
    Counterpart {
        unit: "pe2",
        there: "PE2",
        transistors: PE2,
        bits: Some((48, 48)),
    },
    Counterpart {
        unit: "square_root",
        there: "root",
        transistors: ROOT,
        bits: Some((48, 48)),
    },
    Counterpart {
        unit: "quadric_pe",
        there: "PE1, PE2, root, 2 adders with registers",
        transistors: PE1 + PE2 + ROOT + 2 * ADDER,
        bits: None,
    },
    Counterpart {
        unit: "normal_unit",
        there: "3 multipliers, 3 adders with registers",
        transistors: MULTIPLIERS + 3 * ADDER,
        bits: None,
    },
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
        let here = row.figures.transistors.unwrap_or_default();
        text += &line(&row.unit, here);
    }
    text + COMPARABILITY
}

/// The line of a unit.
fn line(unit: &str, here: u64) -> String {
    let mut text = String::new();
    let found = COUNTERPARTS.iter().find(|known| known.unit == unit);
    let (name, there) = found.map_or(("-", "-".to_owned()), |known| {
        (known.there, known.transistors.to_string())
    });
    let _ = match found.and_then(|known| Some((known.bits?, known.transistors))) {
        Some(((bits_there, bits), transistors)) => writeln!(
            text,
            "| `{unit}` | {name} | {bits} | {here} | {} | {bits_there} | {there} | {} |",
            here / bits,
            transistors / bits_there
        ),
        None => writeln!(
            text,
            "| `{unit}` | {name} | - | {here} | - | - | {there} | - |"
        ),
    };
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lines_of_the_source_add_up_to_its_sum() {
        assert_eq!(PE1, 4_116);
        assert_eq!(ADDER, 864 + 624);
        let sum = 8 * PE1 + PE2 + ROOT + MULTIPLIERS + 13 * ADDER + 1_022 + 13_104;
        assert_eq!(sum, 225_732);
    }

    #[test]
    fn every_unit_of_the_section_has_a_counterpart() {
        for unit in super::super::rows::GATES {
            assert!(COUNTERPARTS.iter().any(|known| known.unit == unit.name()));
        }
    }

    #[test]
    fn a_line_has_both_counts() {
        assert_eq!(
            line("pe1", 5_200),
            "| `pe1` | PE1 | 26 | 5200 | 200 | 24 | 4116 | 171 |\n"
        );
        assert_eq!(
            line("normal_unit", 7),
            "| `normal_unit` | 3 multipliers, 3 adders with registers | - | 7 | - | - | 52080 | - |\n"
        );
    }
}
