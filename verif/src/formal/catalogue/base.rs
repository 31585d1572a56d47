//! What the proofs of the list have in common.

use crate::formal::job::{self, Design, Job, Method};
use imogene_contract::{Request, Unit};

/// The format whose proofs run without `--full`.
pub(super) const BASE: usize = 24;

/// A job bound to an emitted unit of the base format; the rest is set by the functions below.
pub(super) fn job(
    name: String,
    statement: &'static str,
    properties: &'static str,
    unit: Unit,
) -> Job {
    Job {
        name,
        statement,
        method: Method::Induction { depth: 1 },
        widths: String::new(),
        full: false,
        design: Design::Emitted(Request::new(unit)),
        properties,
        definitions: Vec::new(),
        words: |_| Vec::new(),
        top: unit.name(),
    }
}

/// Widths and counts under the names that the properties give them.
pub(super) type Definitions = Vec<(&'static str, usize)>;

pub(super) fn at_format(mut job: Job, depth_word: usize, definitions: &[(&str, usize)]) -> Job {
    if let Design::Emitted(request) = &mut job.design {
        request.depth_word = depth_word as u32;
    }
    job.full = depth_word != BASE;
    job.definitions = define(definitions);
    let widths = definitions.iter();
    let widths = widths.map(|(name, value)| format!("{name} = {value}"));
    job.widths = widths.collect::<Vec<_>>().join(", ");
    job
}

pub(super) fn define(definitions: &[(&str, usize)]) -> job::Definitions {
    let pair = |(name, value): &(&str, usize)| ((*name).to_owned(), value.to_string());
    definitions.iter().map(pair).collect()
}

pub(super) fn integers(name: &str, statement: &'static str, text: &'static str) -> Job {
    Job {
        method: Method::Integers,
        design: Design::Text(text),
        widths: "any".into(),
        ..job(name.to_owned(), statement, "", Unit::Pe1)
    }
}
