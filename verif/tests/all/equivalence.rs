//! The emitted text against rust-hdl's own, by Yosys and ABC. Needs the package 'yosys' and fails without it. Every
//! unit at the base format and at the shortest under `IMOGENE_PROOFS=1`; small units at the base format otherwise.

use super::{is_proof_run, root, verilog};
use imogene_contract::{Request, Unit};
use imogene_hdl::Levels;
use imogene_rtl::emit::{design, emit, raw};
use imogene_verif::engine::design::DesignError;
use imogene_verif::equivalence::{Text, Verdict, compare, memory_bits};

/// Units that take seconds.
const SMALL: [Unit; 7] = [
    Unit::Pe1,
    Unit::Pe2,
    Unit::CutPlane,
    Unit::PlaneDepth,
    Unit::QuadricCut,
    Unit::Decider,
    Unit::RasterControl,
];

/// Compares the emitted text of a unit with rust-hdl's own.
fn compare_unit(request: &Request) -> Result<Verdict, DesignError> {
    let printed = raw(request)?;
    let emitted = emit(request)?;
    let theirs = Text {
        top: "top",
        verilog: &printed,
    };
    let ours = Text {
        top: &emitted.top,
        verilog: &emitted.bundle(),
    };
    Ok(compare(theirs, ours)?)
}

/// A unit and what was found of it.
struct Row {
    unit: Unit,
    /// Of its registers.
    bits: u32,
    /// What was found; nothing of a unit with a memory, which has too many bits.
    verdict: Option<Verdict>,
}

impl Row {
    /// Compares a unit at a depth word.
    fn of(unit: Unit, depth_word: u32) -> Result<Row, DesignError> {
        let request = Request::of(unit, depth_word);
        let design = design(&request)?;
        Ok(Row {
            unit,
            bits: Levels::of(&design)
                .flops
                .iter()
                .map(|flop| flop.width)
                .sum(),
            verdict: match memory_bits(&design.top) {
                0 => Some(compare_unit(&request)?),
                _ => None,
            },
        })
    }

    /// The row of the table of all units.
    fn markdown(&self) -> String {
        let verdict = match self.verdict {
            Some(Verdict::Equal) => "equal",
            Some(Verdict::Differs(_)) => "differs",
            Some(Verdict::Open) => "open",
            None => "has a memory",
        };
        format!("| {} | {} | {verdict} |", self.unit.name(), self.bits)
    }
}

/// The rows of the table at a depth word, of units that are all proven equal where rust-hdl prints them.
fn rows(depth_word: u32) -> Vec<String> {
    let units = if is_proof_run() {
        &Unit::ALL[..]
    } else {
        &SMALL
    };
    let row = |&unit: &Unit| {
        let row = Row::of(unit, depth_word).unwrap_or_else(|error| panic!("{error}"));
        let line = row.markdown();
        println!("{depth_word}: {line}");
        let is_equal = row.verdict.is_none_or(|verdict| verdict == Verdict::Equal);
        assert!(is_equal && row.bits > 0, "{}", unit.name());
        line
    };
    units.iter().map(row).collect()
}

#[test]
fn units_of_the_base_format_are_the_circuits_that_rust_hdl_prints() {
    let page = std::fs::read_to_string(root().join("docs/emission.md")).expect("a page");
    let mut missing = rows(24);
    missing.retain(|line| !page.contains(line));
    assert!(missing.is_empty(), "docs/emission.md lacks {missing:#?}");
}

#[test]
fn units_of_short_words_are_the_circuits_that_rust_hdl_prints() {
    if is_proof_run() {
        rows(16);
    }
}

#[test]
fn a_changed_text_is_not_equal() {
    let own = verilog("pe1", 24);
    let verdict = |other: &str| {
        let [one, other] = [&own, other].map(|verilog| Text {
            top: "pe1",
            verilog,
        });
        compare(one, other).unwrap_or_else(|error| panic!("{error}"))
    };
    assert_eq!(verdict(&own), Verdict::Equal);
    let changes = [
        ("first ? line_begin :", "start ? line_begin :"),
        ("line_begin + b", "line_begin - b"),
        ("pixel_value = 26'sd0", "pixel_value = 26'sd1"),
        ("start ? c : next_line", "line ? c : next_line"),
        ("value = pixel_value", "value = line_begin"),
        ("start | line", "start & line"),
    ];
    for (from, to) in changes {
        assert!(own.contains(from), "{from} is not in\n{own}");
        let found = verdict(&own.replacen(from, to, 1));
        assert!(matches!(found, Verdict::Differs(_)), "{to}: {found:?}");
    }
}
