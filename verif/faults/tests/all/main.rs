//! Mutants of small circuits against what they must do, written by hand, and against what a proof says of them.

mod reached;

use imogene_compiled::{Program, Simulation};
use imogene_faults::{
    Change, Contract, Controls, Judge, Known, Mutant, Upset, Verdict, power_up, sites,
};
use imogene_hdl::{Bits, Design, Value, module, net};
use std::sync::Arc;

const WIDTH: u32 = 3;

/// A sum with a register behind it.
fn adder() -> Design {
    Design::of(|| {
        let inputs = (("a", Bits::input(WIDTH)), ("b", Bits::input(WIDTH)));
        module("adder", "top", inputs, |(a, b)| {
            net! { let sum = a + b; }
            ("y", sum.reg())
        });
    })
}

/// What comes out one clock after each pair of inputs, and what is there before the first.
fn run(program: &Arc<Program>, mutant: &Mutant) -> (u64, Vec<u64>) {
    let mut simulation = Simulation::new(program);
    for (register, word) in &mutant.upsets {
        simulation.upset(0, *register, *word);
    }
    let first = simulation.outputs()[0];
    let pairs = (0..1 << WIDTH).flat_map(|a| (0..1 << WIDTH).map(move |b| [a, b]));
    let results = pairs.map(|inputs| {
        simulation.set_all(inputs);
        simulation.clock();
        simulation.outputs()[0]
    });
    let results = results.collect();
    (first, results)
}

/// What a mutant must give, by its description.
fn expected(text: &str, a: u64, b: u64) -> u64 {
    let changed = |name: &str, word: u64| {
        let Some(rest) = text.strip_prefix(&format!("{name}[")) else {
            return word;
        };
        let bit = 1 << rest[..1].parse::<u32>().expect("a bit");
        match rest {
            _ if rest.contains("stuck at 0") => word & !bit,
            _ if rest.contains("stuck at 1") => word | bit,
            _ => word ^ bit,
        }
    };
    let (a, b) = (changed("a", a), changed("b", b));
    let sum = match text.contains("exchanged") {
        true => a.wrapping_sub(b),
        false => a + b,
    };
    let all = (1 << WIDTH) - 1;
    changed("register", changed("sum", sum & all)) & all
}

#[test]
fn mutants_do_what_they_say() {
    let design = adder();
    let controls = Controls::new(&design, &sites(&design));
    let program = Arc::new(Program::new(&controls.design, &[]));
    let mutants = controls.mutants();
    // Four nets of three bits, each changed in three ways, and the operator.
    assert_eq!(mutants.len(), 4 * 3 * 3 + 1);
    for mutant in mutants {
        let text = controls.describe(&mutant);
        let pairs = (0..1 << WIDTH).flat_map(|a| (0..1 << WIDTH).map(move |b| (a, b)));
        let wanted: Vec<u64> = pairs.map(|(a, b)| expected(&text, a, b)).collect();
        assert_eq!(run(&program, &mutant).1, wanted, "{text}");
    }
}

#[test]
fn no_mutant_that_shows_is_called_equivalent() {
    let design = adder();
    let controls = Controls::new(&design, &sites(&design));
    let judge = Judge::new(&controls, &Known::new(&design, &Contract::default()));
    for mutant in controls.mutants() {
        let text = controls.describe(&mutant);
        assert_eq!(judge.judge(&mutant.upsets), Verdict::Differs, "{text}");
    }
}

#[test]
fn power_up_shows_before_the_first_clock_alone_and_is_forgotten() {
    let design = adder();
    let controls = Controls::new(&design, &power_up(&design));
    let program = Arc::new(Program::new(&controls.design, &[]));
    let contract = Contract {
        latency: 1,
        ..Contract::default()
    };
    let known = Known::new(&design, &contract);
    for mutant in controls.mutants() {
        assert_eq!(mutant.change, Change::Initial);
        let (first, results) = run(&program, &mutant);
        assert_eq!(first, 1 << mutant.bit);
        assert_eq!(results[1], 1, "{}", controls.describe(&mutant));
        assert!(known.is_forgotten(mutant.upsets[0].0, mutant.bit));
    }
}

/// A counter keeps what it began with: nothing of it is forgotten.
#[test]
fn a_counter_forgets_nothing() {
    let design = Design::of(|| {
        module("counter", "top", ("enable", Bits::input(1)), |enable| {
            let count = Bits::register(4).named("count");
            count.load_when(enable, count + Bits::new(1, 4));
            ("value", count)
        });
    });
    let contract = Contract {
        latency: 8,
        ..Contract::default()
    };
    let known = Known::new(&design, &contract);
    assert!((0..4).all(|bit| !known.is_forgotten(0, bit)));
}

/// A register holds 1 from the first clock on, and 0 before: what takes it for 1 differs in no result.
#[test]
fn a_difference_that_is_gone_before_the_first_result_is_none() {
    let design = Design::of(|| {
        module("gate", "top", ("a", Bits::input(1)), |a| {
            net! { let one = Bits::new(1, 1).reg(); }
            ("y", (a & one).reg())
        });
    });
    let controls = Controls::new(&design, &sites(&design));
    let verdict = |text: &str, latency: usize| {
        let contract = Contract {
            latency,
            ..Contract::default()
        };
        let judge = Judge::new(&controls, &Known::new(&design, &contract));
        let mutants = controls.mutants();
        let mut mutants = mutants.iter();
        let mutant = mutants.find(|mutant| controls.describe(mutant).starts_with(text));
        judge.judge(&mutant.expect("a mutant").upsets)
    };
    assert_eq!(verdict("one[0] stuck at 1", 2), Verdict::Equivalent);
    assert_eq!(verdict("one[0] stuck at 0", 2), Verdict::Differs);
    // One clock after the power-up the first state still shows.
    assert_eq!(verdict("one[0] stuck at 1", 1), Verdict::Differs);
}

/// What a counter holds never leaves it: it is not judged by its last inputs alone.
#[test]
fn no_mutant_of_a_counter_that_shows_is_called_equivalent() {
    let design = Design::of(|| {
        module("counter", "top", ("enable", Bits::input(1)), |enable| {
            let count = Bits::register(2).named("count");
            count.load_when(enable, count + Bits::new(1, 2));
            ("value", count)
        });
    });
    let contract = Contract {
        latency: 4,
        ..Contract::default()
    };
    let controls = Controls::new(&design, &sites(&design));
    let judge = Judge::new(&controls, &Known::new(&design, &contract));
    for mutant in controls.mutants() {
        let text = controls.describe(&mutant);
        assert_eq!(judge.judge(&mutant.upsets), Verdict::Differs, "{text}");
    }
}

/// Keeps the word of the clock with `start`, and gives it a clock later beside a flag.
fn keeper() -> Design {
    Design::of(|| {
        let inputs = (("start", Bits::input(1)), ("word", Bits::input(2)));
        module("keeper", "top", inputs, |(start, word)| {
            net! { let kept = word.reg_when(start); }
            (("is_first", start.reg().reg()), ("y", kept.reg()))
        });
    })
}

fn verdicts(held: &[&str]) -> Vec<(String, Mutant, Verdict)> {
    let design = keeper();
    let contract = Contract {
        quiet: vec!["start".to_owned()],
        begins: vec![vec![("start".to_owned(), 1)]],
        held: held.iter().map(|name| (*name).to_owned()).collect(),
        latency: 2,
        ..Contract::default()
    };
    let controls = Controls::new(&design, &sites(&design));
    let judge = Judge::new(&controls, &Known::new(&design, &contract));
    let mutants = controls.mutants().into_iter().map(|mutant| {
        let verdict = judge.judge(&mutant.upsets);
        (controls.describe(&mutant), mutant, verdict)
    });
    mutants.collect()
}

/// Zones of five clocks with a word each, which changes while nothing is under way: what comes out from the second
/// clock of the first zone on.
fn zones(upsets: &[Upset]) -> Vec<u64> {
    let design = keeper();
    let controls = Controls::new(&design, &sites(&design));
    let program = Arc::new(Program::new(&controls.design, &[]));
    let mut simulation = Simulation::new(&program);
    for (register, word) in upsets {
        simulation.upset(0, *register, *word);
    }
    let words = [1, 2, 0, 3, 1, 0, 2, 3];
    let clocks = words
        .iter()
        .flat_map(|word| [1, 0, 0, 0, 0].map(|start| [start, *word]));
    let outputs = clocks.map(|inputs| {
        simulation.set_all(inputs);
        simulation.clock();
        simulation.outputs()[..2].to_vec()
    });
    let outputs: Vec<Vec<u64>> = outputs.collect();
    // While the next word is already there and the last result is not yet out, nothing is asked.
    let asked = outputs.iter().enumerate().skip(1);
    let asked = asked.filter(|(clock, _)| clock % 5 != 0);
    asked.flat_map(|(_, output)| output.clone()).collect()
}

#[test]
fn what_is_equivalent_where_words_are_held_shows_in_no_zone() {
    let verdicts = verdicts(&["word"]);
    let good = zones(&[]);
    let mut equivalent = vec![];
    for (text, mutant, verdict) in verdicts {
        if verdict == Verdict::Equivalent {
            assert_eq!(zones(&mutant.upsets), good, "{text}");
            equivalent.push(text);
        } else {
            assert_ne!(zones(&mutant.upsets), good, "{text}");
        }
    }
    let is_load = |text: &String| text.starts_with("kept enable stuck at 1");
    assert!(equivalent.iter().any(is_load), "{equivalent:?}");
}

#[test]
fn no_mutant_is_equivalent_because_of_words_that_may_change() {
    for (text, _, verdict) in verdicts(&[]) {
        assert_eq!(verdict, Verdict::Differs, "{text}");
    }
}
