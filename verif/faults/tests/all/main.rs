//! Mutants of small circuits against what they must do, written by hand, and against what a proof says of them.

mod reached;

use imogene_compiled::{Program, Simulation};
use imogene_faults::{Change, Contract, Controls, Judge, Known, Mutant, Upset, Verdict};
use imogene_faults::{power_up, sites};
use imogene_hdl::{Bits, Design, Levels, Value, memory, module, net};
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

/// A counter of so many bits that may stand still.
fn counter(bits: u32) -> Design {
    Design::of(|| {
        module("counter", "top", ("enable", Bits::input(1)), |enable| {
            let count = Bits::register(bits).named("count");
            count.load_when(enable, count + Bits::new(1, bits));
            ("value", count)
        });
    })
}

/// A circuit whose outputs tell its inputs of so many clocks alone.
fn within(latency: usize) -> Contract {
    Contract {
        latency,
        ..Contract::default()
    }
}

/// All mutants but those of the power-up.
fn controls(design: &Design) -> Controls {
    Controls::new(design, &sites(design))
}

fn judge(controls: &Controls, design: &Design, contract: &Contract) -> Judge {
    Judge::new(controls, &Known::new(design, contract))
}

/// The circuit with these upsets.
fn simulation(controls: &Controls, upsets: &[Upset]) -> Simulation {
    let mut simulation = Simulation::new(&Arc::new(Program::new(&controls.design, &[])));
    for (register, word) in upsets {
        simulation.upset(0, *register, *word);
    }
    simulation
}

/// What comes out, clock by clock.
fn outputs<I: IntoIterator<Item = u64>>(
    controls: &Controls,
    upsets: &[Upset],
    inputs: impl IntoIterator<Item = I>,
) -> Vec<Vec<u64>> {
    let mut simulation = simulation(controls, upsets);
    let clocks = inputs.into_iter().map(|words| {
        simulation.set_all(words);
        simulation.clock();
        simulation.outputs().to_vec()
    });
    clocks.collect()
}

/// All pairs of inputs of the adder.
fn pairs() -> impl Iterator<Item = [u64; 2]> {
    (0..1 << WIDTH).flat_map(|a| (0..1 << WIDTH).map(move |b| [a, b]))
}

/// What comes out one clock after each pair of inputs.
fn sums(controls: &Controls, mutant: &Mutant) -> Vec<u64> {
    let outputs = outputs(controls, &mutant.upsets, pairs()).into_iter();
    outputs.map(|words| words[0]).collect()
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
    let controls = controls(&adder());
    let mutants = controls.mutants();
    // Four nets of three bits, each changed in three ways, and the operator.
    assert_eq!(mutants.len(), 4 * 3 * 3 + 1);
    for mutant in mutants {
        let text = controls.describe(&mutant);
        let wanted: Vec<u64> = pairs().map(|[a, b]| expected(&text, a, b)).collect();
        assert_eq!(sums(&controls, &mutant), wanted, "{text}");
    }
}

/// What a counter holds never leaves it: it is not judged by its last inputs alone.
#[test]
fn no_mutant_that_shows_is_called_equivalent() {
    for (design, contract) in [(adder(), Contract::default()), (counter(2), within(4))] {
        let controls = controls(&design);
        let judge = judge(&controls, &design, &contract);
        for mutant in controls.mutants() {
            let text = format!("{}: {}", design.top.name, controls.describe(&mutant));
            assert_eq!(judge.judge(&mutant.upsets), Verdict::Differs, "{text}");
        }
    }
}

#[test]
fn power_up_shows_before_the_first_clock_alone_and_is_forgotten() {
    let design = adder();
    let controls = Controls::new(&design, &power_up(&design));
    let known = Known::new(&design, &within(1));
    for mutant in controls.mutants() {
        assert_eq!(mutant.change, Change::Initial);
        let first = simulation(&controls, &mutant.upsets).outputs()[0];
        assert_eq!(first, 1 << mutant.bit);
        let results = sums(&controls, &mutant);
        assert_eq!(results[1], 1, "{}", controls.describe(&mutant));
        assert!(known.is_forgotten(mutant.upsets[0].0, mutant.bit));
    }
}

/// A counter keeps what it began with: nothing of it is forgotten.
#[test]
fn a_counter_forgets_nothing() {
    let known = Known::new(&counter(4), &within(8));
    assert!((0..4).all(|bit| !known.is_forgotten(0, bit)));
}

/// Which registers hold at power-up what nothing shows: those of a word that is kept, of its flag, and of a word on its
/// way into a memory. The flag comes with the word, or with an input of its own.
fn unseen(flag_of_its_own: bool, counts_with: &[(&str, &str)]) -> Vec<bool> {
    let design = Design::of(|| {
        let inputs = (("load", Bits::input(1)), ("a", Bits::input(WIDTH)));
        let inputs = (inputs, ("other", Bits::input(1)), ("at", Bits::input(2)));
        module("keeper", "top", inputs, |((load, a), other, at)| {
            let (kept, flag) = (Bits::register(WIDTH), Bits::register(1));
            kept.load_when(load, a);
            let comes = if flag_of_its_own { other } else { load };
            flag.load_when(comes, Bits::new(1, 1));
            let write = (load.reg(), at, a.reg());
            let stored = memory("store", 4, write, at);
            (("valid", flag), ("y", kept), ("stored", stored))
        });
    });
    let names = |(output, flag): &(&str, &str)| (output.to_string(), flag.to_string());
    let contract = Contract {
        counts_with: counts_with.iter().map(names).collect(),
        ..within(2)
    };
    let known = Known::new(&design, &contract);
    let registers = Levels::of(&design).flops.len();
    (0..registers)
        .map(|register| known.is_forgotten(register, 0))
        .collect()
}

/// What is written before anything came is no word: the memory keeps nothing of it. A word that is kept is shown unless
/// it counts beside its flag alone, and the flag comes no earlier.
#[test]
fn power_up_that_nothing_shows_is_found() {
    let beside = [("y", "valid")];
    // kept, flag, and behind them whether and what is written.
    assert_eq!(unseen(false, &beside), [true, false, false, true]);
    assert_eq!(unseen(false, &[]), [false, false, false, true]);
    assert_eq!(unseen(true, &beside), [false, false, false, true]);
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
    let controls = controls(&design);
    let verdict = |text: &str, latency: usize| {
        let judge = judge(&controls, &design, &within(latency));
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

/// A circuit that is started, and done two clocks later.
fn started() -> Contract {
    Contract {
        quiet: vec!["start".to_owned()],
        begins: vec![vec![("start".to_owned(), 1)]],
        ..within(2)
    }
}

/// Is the place that a memory reads at power-up forgotten so many clocks after it was given? It may be written, too.
fn forgets_a_place(latency: usize, is_written: bool) -> bool {
    let design = Design::of(|| {
        let inputs = (("start", Bits::input(1)), ("at", Bits::input(2)));
        let inputs = (inputs, ("write", Bits::input(1)), ("word", Bits::input(2)));
        module("table", "top", inputs, |((start, at), write, word)| {
            net! { let place = at.reg_when(start); }
            let written = if is_written { place } else { word };
            let read = memory("words", 4, (write, at, written), place);
            ("y", read.reg())
        });
    });
    let contract = Contract {
        latency,
        ..started()
    };
    Known::new(&design, &contract).is_forgotten(0, 0)
}

/// What is read at another place reaches the output a clock later, and another one later it has left.
#[test]
fn a_place_of_a_memory_is_forgotten_when_what_it_reads_has_left() {
    assert!(forgets_a_place(3, false));
    assert!(!forgets_a_place(2, false));
    assert!(!forgets_a_place(3, true));
}

fn verdicts(held: &[&str]) -> Vec<(String, Mutant, Verdict)> {
    let design = keeper();
    let contract = Contract {
        held: held.iter().map(|name| (*name).to_owned()).collect(),
        ..started()
    };
    let controls = controls(&design);
    let judge = judge(&controls, &design, &contract);
    let mutants = controls.mutants().into_iter().map(|mutant| {
        let verdict = judge.judge(&mutant.upsets);
        (controls.describe(&mutant), mutant, verdict)
    });
    mutants.collect()
}

/// Zones of five clocks with a word each, which changes while nothing is under way: what comes out from the second
/// clock of the first zone on.
fn zones(upsets: &[Upset]) -> Vec<u64> {
    let words = [1, 2, 0, 3, 1, 0, 2, 3].into_iter();
    let clocks = words.flat_map(|word| [1, 0, 0, 0, 0].map(|start| [start, word]));
    let outputs = outputs(&controls(&keeper()), upsets, clocks);
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
