//! Mutation scores: every mutant of a unit's circuit, and of its netlist, is killed by the unit's stimulus or proven
//! to change nothing. Those of the netlist need the packages 'yosys', 'verilator' and 'g++' and fail without them: all
//! units of the published table under `IMOGENE_FULL=1`, the cut plane otherwise.

mod circuit;
mod netlist;

use super::is_full_run;
use super::machines::{drawn, small};
use imogene_contract::Request;
use imogene_hdl::Design;
use imogene_plan::description::MachineDescription;
use imogene_plan::display::Image;
use imogene_rtl::emit::{Emitted, design, emit};
use imogene_verif::mutation::machine::{self as of_machine, Shown};
use imogene_verif::mutation::{
    MutationReport, Options, circuit as of_circuit, netlist as of_netlist, table,
};
use imogene_verif::subject::Subject;
use imogene_verif::unit::subject;

fn unit(name: &str) -> (Subject, Emitted) {
    let request = Request::given(name, 16, &[]).expect("a unit of the catalogue");
    let subject = subject(&request).expect("its defaults are legal");
    (subject, emit(&request).expect("a legal request"))
}

/// A unit with its circuit.
fn circuit(name: &str, width: u32) -> (Subject, Design) {
    let request = Request::given(name, width, &[]).expect("a unit of the catalogue");
    let subject = subject(&request).expect("its defaults are legal");
    (subject, design(&request).expect("a legal request"))
}

fn circuit_score(subject: &Subject, design: &Design, options: &Options) -> MutationReport {
    let report = of_circuit::run(subject, design, options, || ());
    report.unwrap_or_else(|error| panic!("{error}"))
}

fn score(subject: &Subject, emitted: &Emitted, text: &str, mutants: usize) -> MutationReport {
    let options = Options {
        mutants,
        ..Options::default()
    };
    of_netlist::run(subject, (&emitted.top, text), &options, || ())
        .unwrap_or_else(|error| panic!("{error}"))
}

/// Units on which nothing may survive; of the others, survivors are published with the reason.
const COMPLETE: &str = "pe1 pe2 square_root square_root_non_restoring cut_plane";

#[test]
fn every_mutant_is_killed_or_equivalent() {
    let (names, mutants) = if is_full_run() {
        (table::NETLISTS.to_vec(), 1_000)
    } else {
        (vec!["cut_plane"], 150)
    };
    for name in names {
        let (subject, emitted) = unit(name);
        let report = score(&subject, &emitted, &emitted.bundle(), mutants);
        // Those of clocks are left out.
        let (asked, found) = (mutants.min(report.candidates), report.mutants);
        assert!(found <= asked && found > asked * 9 / 10, "{name}: {found}");
        let counted = report.killed + report.equivalent + report.surviving.len();
        assert_eq!(counted, report.mutants, "{name}");
        let survivors = table::survivors(std::slice::from_ref(&report));
        println!("{name}: {} %, {survivors}", report.score);
        let is_complete = report.surviving.is_empty();
        let must_be = COMPLETE.split(' ').any(|unit| unit == name);
        assert!(is_complete || !must_be, "{survivors}");
        assert!(report.score >= 99.0, "{name}: {survivors}");
    }
}

/// A stimulus that tests almost nothing must leave survivors, and none of them may be called equivalent.
#[test]
fn a_weak_stimulus_has_a_low_score() {
    let (mut subject, emitted) = unit("cut_plane");
    let text = &emitted.bundle();
    let strong = score(&subject, &emitted, text, 60);
    subject.stimulus = Box::new(|subject, clocks| {
        use proptest::strategy::{Just, Strategy};
        Just(vec![vec![1; subject.inputs.len()]; clocks]).boxed()
    });
    let weak = score(&subject, &emitted, text, 60);
    assert_eq!(weak.equivalent, strong.equivalent);
    assert!(weak.score < 60.0, "{}", weak.score);
    assert!(weak.surviving.len() > 10, "{weak:?}");
    let page = table::markdown(&[weak], table::OF_NETLISTS, "the test");
    assert!(page.contains("too weak"), "{page}");
}

#[test]
fn a_unit_that_is_wrong_without_a_mutation_has_no_score() {
    let (subject, emitted) = unit("cut_plane");
    let wrong = emitted.bundle().replacen("zp == zb", "zp != zb", 1);
    let options = Options {
        mutants: 5,
        ..Options::default()
    };
    let outcome = of_netlist::run(&subject, (&emitted.top, &wrong), &options, || ());
    let message = outcome.expect_err("a wrong unit").to_string();
    assert!(message.contains("without a mutation differs"), "{message}");
}

/// Every mutant of these circuits is killed, proven equivalent, or proven forgotten; in the full run of more units,
/// both widths, and whole processors.
#[test]
fn no_mutant_of_an_arithmetic_circuit_survives() {
    let names = "pe1 pe2 cut_plane plane_depth normal_unit";
    let more = "quadric_cut patch_decider visibility_node decider card_decider csg_product square_root_iterative";
    let processors = "facet_processor sphere_processor polyhedral_volume tmds_encoder";
    let of_width = |names: &'static str, width| names.split(' ').map(move |name| (name, width));
    let mut units: Vec<(&str, u32)> = of_width(names, 16).collect();
    if is_full_run() {
        units.extend(of_width(names, 24).chain(of_width(processors, 16)));
        units.extend(of_width(more, 16).chain(of_width(more, 24)));
    }
    let options = Options {
        stimuli: 20_000,
        ..Options::default()
    };
    for (name, width) in units {
        let (subject, design) = circuit(name, width);
        let report = circuit_score(&subject, &design, &options);
        assert_eq!(report.mutants as u64, of_circuit::count(&design), "{name}");
        assert!(report.mutants > 500 && report.killed > 400, "{name}");
        let survivors = table::survivors(std::slice::from_ref(&report));
        assert!(report.surviving.is_empty(), "{survivors}");
    }
}

/// All words of 16 bits kill what a stimulus that never changes leaves.
#[test]
fn all_short_words_decide() {
    let request = Request::given("square_root_linear", 8, &[("corrections", Some(0))]);
    let request = request.expect("a unit of the catalogue");
    let mut subject = subject(&request).expect("a legal request");
    let design = design(&request).expect("a legal request");
    let options = Options {
        stimuli: 300,
        ..Options::default()
    };
    let strong = circuit_score(&subject, &design, &options);
    subject.stimulus = Box::new(|_, clocks| {
        use proptest::strategy::{Just, Strategy};
        Just(vec![vec![77]; clocks]).boxed()
    });
    let weak = circuit_score(&subject, &design, &options);
    for report in [&strong, &weak] {
        let survivors = table::survivors(std::slice::from_ref(report));
        assert!(report.surviving.is_empty(), "{survivors}");
    }
    assert_eq!(weak.killed, strong.killed);
    assert_eq!(weak.equivalent, strong.equivalent);
}

/// Where a picture begins in every clock many mutants survive, and as many are equivalent as with a strong stimulus.
#[test]
fn a_weak_stimulus_leaves_mutants_of_the_circuit() {
    let (mut subject, design) = circuit("pe2", 8);
    let options = Options {
        stimuli: 300,
        // Most of what is tried cannot be proven.
        effort: 400,
        ..Options::default()
    };
    let strong = circuit_score(&subject, &design, &options);
    subject.stimulus = Box::new(|subject, clocks| {
        use proptest::strategy::{Just, Strategy};
        let words = 0..subject.inputs.len() as i64;
        let clock = |clock: i64| -> Vec<i64> {
            let words = words
                .clone()
                .map(|word| (clock * 74 + word * 26) % 200 - 100);
            [1, 1, 0].into_iter().chain(words.skip(3)).collect()
        };
        Just((0..clocks as i64).map(clock).collect()).boxed()
    });
    let weak = circuit_score(&subject, &design, &options);
    assert!(weak.score < 80.0, "{}", weak.score);
    // What a stimulus kills no proof may call equivalent.
    assert!(strong.equivalent > 0);
    assert_eq!(weak.equivalent, strong.equivalent);
    assert_eq!(weak.mutants, strong.mutants);
}

/// A machine of one object and one light, and what it shows.
fn shown_ellipsoid() -> (MachineDescription, Image) {
    let machine = MachineDescription {
        objects: 1,
        planes: 2,
        lights: 0,
        ..small("beam-160x120.toml", 12, 8, 30)
    };
    let image = drawn("ellipsoid.toml", &machine);
    (machine, image)
}

fn machine_score(machine: &MachineDescription, images: &[Image]) -> Result<MutationReport, String> {
    let shown = Shown {
        machine,
        images,
        runs: 2,
        effort: 1_000,
    };
    let design = of_machine::design(machine, images).expect("a legal machine");
    let report = MutationReport::of("beam", "");
    let report = of_machine::run(&shown, &design, report, || ());
    let report = report.map_err(|error| error.to_string())?;
    assert_eq!(report.mutants as u64, of_machine::count(&design));
    Ok(report)
}

/// Most mutants are killed or forgotten, and each has one fate. An empty picture kills fewer.
#[test]
fn the_pins_show_mutants_of_a_machine() {
    let (machine, image) = shown_ellipsoid();
    let report = machine_score(&machine, &[image.clone(), image]).expect("a machine that runs");
    assert!(report.killed > 1_000, "{report:?}");
    assert!(report.forgotten > 100, "{report:?}");
    let judged = report.killed + report.equivalent + report.forgotten;
    assert_eq!(judged + report.surviving.len(), report.mutants);
    assert!(report.score > 50.0, "{}", report.score);
    let weak = machine_score(&machine, &[]).expect("a machine that runs");
    assert!(weak.killed < report.killed / 2, "{}", weak.killed);
}

#[test]
fn a_machine_that_is_wrong_without_a_mutation_has_no_score() {
    let (machine, mut image) = shown_ellipsoid();
    image.picture[0] ^= 1;
    let message = machine_score(&machine, &[image]).expect_err("a wrong picture");
    assert!(message.contains("without a mutation differs"), "{message}");
}
