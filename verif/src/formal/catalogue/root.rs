//! The proofs of the root networks.

use super::{BASE, integers, job, with};
use crate::formal::job::{Design, Job, Method, stage_words};
use imogene_contract::{Request, Unit};

const REFERENCE_ROWS: &str = concat!(
    property!("root_reference.sv"),
    "\n",
    property!("square_root_rows.sv")
);

const NON_RESTORING_ROWS: &str = concat!(
    property!("root_reference.sv"),
    "\n",
    property!("non_restoring_rows.sv")
);

/// The whole networks first: they take longest.
pub(super) fn jobs() -> Vec<Job> {
    let mut jobs = Vec::new();
    let statement = "square_root, whole: after its latency square + remainder = radicand and remainder <= 2 root, square in ghost sums";
    for (word, rows) in [(16, 1), (24, 1)] {
        let name = format!("square_root-{word}-r{rows}");
        let mut whole = network(name, statement, property!("square_root.sv"), word, rows);
        whole.full = true;
        jobs.push(whole);
    }
    let statement = "square_root: every register stage is its rows of the reference, in every state that occurs; latency";
    for (word, rows) in [(24, 1), (32, 1), (16, 1), (20, 1), (28, 1), (24, 2)] {
        let name = format!("square_root_rows-{word}-r{rows}");
        let mut stages = network(name, statement, REFERENCE_ROWS, word, rows);
        stages.full = (word, rows) != (BASE, 1);
        jobs.push(stages);
    }
    jobs.push(non_restoring());
    jobs.extend([8, 16, 24, 32, 64].map(lemma));
    jobs.push(integers(
        "root-integers",
        "the ghost square is root^2, and root^2 <= x < (root + 1)^2 follows",
        property!("root.smt2"),
    ));
    jobs
}

fn lemma(k: usize) -> Job {
    let lemma = job(
        format!("root_lemma-{k}"),
        "reference row: remainder + square = prefix and remainder <= 2 root pass through, and the digit is right",
        property!("root_lemma.sv"),
        Unit::SquareRoot,
    );
    Job {
        design: Design::Text(property!("root_reference.sv")),
        method: Method::Bounded(1),
        top: "root_lemma",
        ..with(lemma, &[("K", k)])
    }
}

fn network(
    name: String,
    statement: &'static str,
    properties: &'static str,
    depth_word: usize,
    rows_per_stage: usize,
) -> Job {
    Job {
        design: Design::Emitted(Request {
            rows_per_stage: rows_per_stage as u32,
            ..Request::of(Unit::SquareRoot, depth_word as u32)
        }),
        words: stage_words,
        widths: format!(
            "K = {depth_word}, F = {}, R = {rows_per_stage}",
            2 * depth_word
        ),
        ..job(name, statement, properties, Unit::SquareRoot)
    }
}

fn non_restoring() -> Job {
    let statement = "square_root_non_restoring: every register stage, restored, is its rows of the reference; latency";
    let name = format!("non_restoring_rows-{BASE}-r1");
    Job {
        design: Design::Emitted(Request::new(Unit::SquareRootNonRestoring)),
        top: Unit::SquareRootNonRestoring.name(),
        full: true,
        ..network(name, statement, NON_RESTORING_ROWS, BASE, 1)
    }
}
