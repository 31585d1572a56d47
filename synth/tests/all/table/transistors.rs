use super::invented;
use imogene_synth::table::Section;
use imogene_synth::table::rows::GATES;
use imogene_synth::table::transistors::{ADDER, MULTIPLIERS, PE1, PE2, ROOT};

#[test]
fn the_lines_of_the_source_add_up_to_its_sum() {
    assert_eq!(PE1, 4_116);
    assert_eq!(ADDER, 864 + 624);
    let sum = 8 * PE1 + PE2 + ROOT + MULTIPLIERS + 13 * ADDER + 1_022 + 13_104;
    assert_eq!(sum, 225_732);
}

/// The line of a unit with so many transistors.
fn line(unit: &str, here: u64) -> String {
    let mut table = invented();
    let mut rows = table.rows.iter_mut();
    let row = rows.find(|row| row.section == Section::Transistors && row.unit == unit);
    row.expect("a row of the unit").figures.transistors = Some(here);
    let page = table.markdown();
    let (_, section) = page.split_once("## Transistors").expect("the section");
    let start = format!("| `{unit}` |");
    let line = section.lines().find(|line| line.starts_with(&start));
    line.expect("a line of the unit").to_owned()
}

#[test]
fn every_unit_of_the_section_has_a_counterpart() {
    for unit in GATES.map(|unit| unit.name()) {
        let line = line(unit, 1);
        assert!(!line.starts_with(&format!("| `{unit}` | - |")), "{line}");
    }
}

#[test]
fn a_line_has_both_counts() {
    let of_one = "| `pe1` | PE1 | 26 | 5200 | 200 | 24 | 4116 | 171 |";
    assert_eq!(line("pe1", 5_200), of_one);
    let of_several =
        "| `normal_unit` | 3 multipliers, 3 adders with registers | - | 7 | - | - | 52080 | - |";
    assert_eq!(line("normal_unit", 7), of_several);
}
