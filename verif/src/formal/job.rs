//! A proof: what it states, of which design, and how it is proved.

use super::FormalError;
use super::bind;
use super::mutants::Mutant;
use imogene_contract::Request;
use imogene_rtl::emit::emit;
use std::fmt::{self, Write};

/// How a job is proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Unbounded in time: base case and induction over so many clocks.
    Induction(usize),
    /// Every input sequence of some clocks from the initial state; without registers one clock is complete.
    Bounded(usize),
    /// Statements over the unbounded integers, each refuted in its negation.
    Integers,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Method::Induction(depth) => write!(f, "{depth}-induction"),
            Method::Bounded(1) => write!(f, "all inputs, no registers"),
            Method::Bounded(clocks) => write!(f, "bounded, {clocks} clocks"),
            Method::Integers => write!(f, "integers"),
        }
    }
}

/// What the properties are bound to.
#[derive(Clone, Copy, Debug)]
pub(super) enum Design {
    /// The Verilog emitted for a request.
    Emitted(Request),
    /// The same with every word of the first width made as wide as the second. Only for a design with one width.
    Narrowed(Request, u32, u32),
    /// A text of this folder.
    Text(&'static str),
}

/// Names and what they stand for.
pub(super) type Definitions = Vec<(&'static str, String)>;

/// A proof.
#[derive(Clone, Debug)]
pub struct Job {
    /// Name, as given to `imogene prove`.
    pub name: String,
    /// What is proved, in one line.
    pub statement: &'static str,
    /// Method.
    pub method: Method,
    /// Widths and counts, for the report.
    pub widths: String,
    /// Runs only with `--full`, or when named.
    pub full: bool,
    pub(super) design: Design,
    pub(super) properties: &'static str,
    pub(super) definitions: Definitions,
    pub(super) top: &'static str,
}

impl Job {
    /// What the tool reads, with a mutant in its design if given: SystemVerilog, SMT-LIB for [`Method::Integers`].
    pub fn source(&self, mutant: Option<&Mutant>) -> Result<String, FormalError> {
        let mut design = self.design()?;
        if let Some(mutant) = mutant {
            design = mutant.apply(&design)?;
        }
        if self.method == Method::Integers {
            return Ok(design);
        }
        let mut text = String::new();
        for (name, value) in &self.definitions {
            let _ = writeln!(text, "`define {name} {value}");
        }
        Ok(text + &bind::resolve(&self.name, &design, self.properties)?)
    }

    fn design(&self) -> Result<String, FormalError> {
        match &self.design {
            Design::Text(text) => Ok((*text).to_owned()),
            Design::Emitted(request) => Ok(emit(request)?.bundle()),
            Design::Narrowed(request, from, to) => {
                let text = emit(request)?
                    .bundle()
                    .replace(&format!("[{}:0]", from - 1), &format!("[{}:0]", to - 1))
                    .replace(&format!("{from}'"), &format!("{to}'"));
                let left = [format!("{}", from - 1), format!("{from}'")];
                let body = text.split_once("\nmodule").map_or("", |(_, body)| body);
                if left.iter().any(|number| body.contains(number.as_str())) {
                    let problem = format!("a width {from} is left after narrowing to {to} bits");
                    return Err(FormalError::Text(self.name.clone(), problem));
                }
                Ok(text)
            }
        }
    }
}

/// Words side by side.
fn joined(words: impl Iterator<Item = String>) -> String {
    format!("{{{}}}", words.collect::<Vec<_>>().join(", "))
}

/// The words of all inputs of a decider side by side, the last input first.
pub(super) fn decider_inputs(count: u32) -> Definitions {
    let words = [
        ("DEPTHS", &["depth"][..]),
        ("IDS", &["id"]),
        ("RESTS", &["number", "nx", "ny", "nz"]),
    ];
    let words = words.map(|(name, fields)| {
        let input = |i: u32| fields.iter().map(move |f| format!("input_{i}_{f}"));
        (name, joined((0..count).rev().flat_map(input)))
    });
    words.into()
}

/// Definitions for the properties of a root network: `K`, `STAGES`, `ROWS` and the words of all stages
/// side by side, the last stage first. Element 0 of an array is what the first stage takes.
pub(super) fn stage_words(bits: u32, rows: u32) -> Definitions {
    let stages = bits.div_ceil(rows);
    let numbers = [("K", bits), ("STAGES", stages), ("ROWS", rows)];
    let numbers = numbers.map(|(name, value)| (name, value.to_string()));
    let words = [
        ("PAIRS", "pairs"),
        ("ROOTS", "root"),
        ("REMAINDERS", "remainder"),
    ];
    let words = words.map(|(name, port)| {
        let stage = |k| format!("stages_{port}[{k}]");
        (name, joined((1..=stages).rev().map(stage)))
    });
    [numbers, words].concat()
}
