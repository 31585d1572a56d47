//! The formal proofs of the emitted Verilog. By default a part of them with the Yosys and z3 of the system; under
//! `IMOGENE_PROOFS=1` all of them and all mutants, with SymbiYosys.

use super::is_proof_run;
use imogene_verif::formal::mutants;
use imogene_verif::formal::runner::{ProofReport, Task, prove_all, select};
use imogene_verif::formal::toolchain::{Driver, Toolchain};

/// Proofs of the default run: each kind of property, each method.
const REPRESENTATIVE: &str = "root_lemma-64 root-integers pe1-26 pe1-integers pe2-integers \
    cut_plane-24 raster_control-12 raster_control-integers quadric_processor-n3-r1 \
    visibility_node-24";

/// Jobs whose mutants are in the default run.
const MUTATED: [&str; 4] = ["root_lemma-24", "pe1-26", "pe1-integers", "cut_plane-24"];

fn toolchain() -> Toolchain {
    let tools = match is_proof_run() {
        true => Toolchain::find(),
        false => Toolchain::system(),
    };
    let tools = tools.unwrap_or_else(|error| panic!("{error}"));
    let is_right = !is_proof_run() || tools.driver != Driver::Smtbmc;
    let remedy = "SymbiYosys is missing; `scripts/setup --formal` installs it";
    assert!(is_right, "{remedy}");
    tools
}

fn assert_all_ok(reports: &[ProofReport]) {
    let bad: Vec<_> = reports.iter().filter(|report| !report.ok).collect();
    assert!(bad.is_empty(), "{bad:#?}");
}

fn mutants_of(job: &str) -> Vec<Task> {
    let found = select(job, true).unwrap();
    let job = found.into_iter().next().unwrap();
    let task = |mutant| Task {
        job: job.clone(),
        mutant: Some(mutant),
    };
    mutants::of(&job.name).map(task).collect()
}

#[test]
fn every_property_is_proved() {
    let jobs = if is_proof_run() {
        select("all", true).unwrap()
    } else {
        let one = |name: &str| select(name, false).unwrap().remove(0);
        REPRESENTATIVE.split(' ').map(one).collect()
    };
    let tasks = jobs.into_iter().map(|job| Task { job, mutant: None });
    let tasks: Vec<Task> = tasks.collect();
    let reports = prove_all(&tasks, &toolchain(), |_| ()).unwrap();
    assert_eq!(reports.len(), tasks.len());
    assert_all_ok(&reports);
}

#[test]
fn every_mutant_is_refuted() {
    let names = match is_proof_run() {
        true => mutants::jobs(),
        false => MUTATED.into(),
    };
    let tasks: Vec<Task> = names.into_iter().flat_map(mutants_of).collect();
    assert!(tasks.len() > 15);
    let reports = prove_all(&tasks, &toolchain(), |_| ()).unwrap();
    assert_all_ok(&reports);
    assert!(reports.iter().all(|report| report.detail.is_some()));
}

#[test]
fn names_of_jobs_are_told_apart() {
    assert_eq!(select("pe1-26", false).unwrap().len(), 1);
    let pe1 = select("pe1", true).unwrap();
    assert!(pe1.len() >= 7 && pe1.iter().all(|job| job.name.starts_with("pe1-")));
    assert!(select("pe1", false).unwrap().len() < pe1.len());
    assert_eq!(select("pe1-34", false).unwrap()[0].name, "pe1-34");
    // Only for the full run, but named.
    assert!(select("square_root", false).unwrap().len() >= 2);
    let error = select("pe", true).unwrap_err().to_string();
    let is_told = error.contains("`pe`") && error.contains("pe2-48");
    assert!(is_told, "{error}");
}
