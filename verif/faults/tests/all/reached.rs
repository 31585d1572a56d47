//! Mutants that differ only in states that are never reached, or where nothing counts: each circuit has one that is
//! proven equivalent and one that is not, and what is proven is run on every input of some clocks.

use super::{controls, judge, outputs, started, within};
use imogene_faults::{Contract, Verdict};
use imogene_hdl::{Bits, Design, Simulator, Value, join, module, net};

/// Counts to five and begins again; the values from six on are looked for in vain.
fn counter() -> Design {
    Design::of(|| {
        module("counter", "top", ("enable", Bits::input(1)), |enable| {
            let word = |value| Bits::new(value, 8);
            net! {
                let count = Bits::register(8);
                let is_beyond = count.is(200);
                let ends = count.is(5);
            }
            count.load_when(enable, ends.select(word(0), count + word(1)));
            (("count", count), ("is_beyond", is_beyond))
        });
    })
}

/// Shifts two bits of a word out, the top one first, in the clock of its start and the next; those below are not seen.
fn shifter() -> Design {
    Design::of(|| {
        let inputs = (("start", Bits::input(1)), ("word", Bits::input(8)));
        module("shifter", "top", inputs, |(start, word)| {
            let flag = |value| Bits::new(value, 1);
            net! {
                let busy = Bits::register(1);
                let rest = Bits::register(8);
                let begins = start & !busy;
                let current = begins.select(word, rest);
                let moved = current.left(1);
                let works = begins | busy;
                let shown = Bits::register(1);
            }
            busy.load_when(works, begins.select(flag(1), flag(0)));
            rest.load_when(works, moved);
            shown.load_when(works, current.top());
            (("busy", busy), ("shown", shown))
        });
    })
}

/// Keeps a word from `go` on for the clock in which it is valid.
fn latch() -> Design {
    Design::of(|| {
        let inputs = (("go", Bits::input(1)), ("word", Bits::input(1)));
        module("latch", "top", inputs, |(go, word)| {
            net! {
                let valid = go.reg();
                let kept = word.reg_when(go);
            }
            (("valid", valid), ("kept", kept))
        });
    })
}

/// A flag that never rises, and a word beside it that is seen where it is 1; in more phases than are looked at.
fn hidden() -> Design {
    Design::of(|| {
        let inputs = (("go", Bits::input(1)), ("word", Bits::input(12)));
        module("hidden", "top", inputs, |(go, word)| {
            net! {
                let flag = Bits::register(1);
                let rises = flag & word.top();
                let kept = word.reg();
                let turned = kept ^ Bits::new(5, 12);
                let turned_late = turned.reg();
                let low = word.low(6).reg();
                let high = word.high(6).reg();
            }
            flag.load_when(go, rises);
            (("y", flag.select(turned_late, kept)), ("z", low ^ high))
        });
    })
}

/// A word plus one, where a word of up to sixteen bits takes another way to the same.
fn two_ways() -> Design {
    Design::of(|| {
        module("two_ways", "top", ("word", Bits::input(28)), |word| {
            net! {
                let is_short = word.high(12).is(0);
                let short = word.low(16).extend(28) + Bits::new(1, 28);
                let long = word + Bits::new(1, 28);
                let is_short_late = is_short.reg();
                let short_late = short.reg();
                let long_late = long.reg();
            }
            ("y", is_short_late.select(short_late, long_late))
        });
    })
}

/// Shows a word three clocks later, zero for the greatest one, in whose place another is kept meanwhile. What hides it
/// stands in a long register: it is no phase.
fn replaced() -> Design {
    Design::of(|| {
        module("replaced", "top", ("word", Bits::input(8)), |word| {
            net! {
                let is_last = word.is(255);
                let beside = join([word.low(7), is_last]).delay(2);
                let other = Bits::new(90, 8);
                let kept = is_last.select(other, word).reg();
                let late = kept.reg();
                let shown = beside.bit(0).select(Bits::new(0, 8), late).reg();
            }
            (("beside", beside.high(7)), ("shown", shown))
        });
    })
}

/// Shows words whose top bit is 1 in all registers but at power-up, when nothing is shown yet; counts its clocks beside
/// that, so that something is kept.
fn begun() -> Design {
    Design::of(|| {
        module("begun", "top", ("word", Bits::input(8)), |word| {
            net! {
                let set = (word | Bits::new(128, 8)).reg();
                let late = set.reg();
                let is_begun = Bits::new(1, 1).delay(2);
                let shown = is_begun.select(late, Bits::new(90, 8)).reg();
                let count = Bits::register(4);
            }
            count.load(count + Bits::new(1, 4));
            (("shown", shown), ("count", count))
        });
    })
}

/// Every input of some clocks, in an order that comes through most states.
fn inputs(design: &Design, clocks: u64) -> Vec<Vec<u64>> {
    let widths = design.top.ports_of(imogene_hdl::Direction::In);
    let widths: Vec<u32> = widths.map(|port| design.top.node(port.net).width).collect();
    let mut state = 1u64;
    let clocks = (0..clocks).map(|_| {
        let words = widths.iter().map(|width| {
            let product = state.wrapping_mul(6_364_136_223_846_793_005);
            state = product.wrapping_add(1);
            state >> (64 - width)
        });
        words.collect()
    });
    clocks.collect()
}

/// The states that a circuit comes to on such inputs.
fn seen(design: &Design) -> Vec<Vec<u64>> {
    let mut simulator = Simulator::new(design);
    let ports = design.top.ports_of(imogene_hdl::Direction::In);
    let ports: Vec<_> = ports.map(|port| simulator.port(&port.name)).collect();
    let clocks = inputs(design, 200).into_iter().map(|words| {
        for (port, word) in ports.iter().zip(words) {
            simulator.set(*port, word);
        }
        simulator.clock();
        simulator.registers().collect()
    });
    clocks.collect()
}

/// Judges every mutant; what is equivalent shows nothing. Which are equivalent?
fn equivalent(design: &Design, contract: &Contract, counts: fn(&[u64]) -> usize) -> Vec<String> {
    let controls = controls(design);
    let judge = judge(&controls, design, contract);
    let outputs = |upsets: &[_]| outputs(&controls, upsets, inputs(design, 2_000));
    let good = outputs(&[]);
    let mutants = controls.mutants().into_iter();
    let equivalent = mutants.filter(|mutant| judge.judge(&mutant.upsets) == Verdict::Equivalent);
    let texts = equivalent.map(|mutant| {
        let text = controls.describe(&mutant);
        for (good, bad) in good.iter().zip(&outputs(&mutant.upsets)) {
            let count = counts(good);
            assert_eq!(good[..count], bad[..count], "{text}");
        }
        text
    });
    texts.collect()
}

/// Is there one whose description begins so?
fn has(texts: &[String], start: &str) -> bool {
    texts.iter().any(|text| text.starts_with(start))
}

fn all(output: &[u64]) -> usize {
    output.len()
}

#[test]
fn a_counter_that_ends_never_comes_beyond() {
    let design = counter();
    let with_states = Contract {
        seen: seen(&design),
        ..Contract::default()
    };
    let texts = equivalent(&design, &with_states, all);
    assert!(has(&texts, "is_beyond[0] stuck at 0"), "{texts:?}");
    assert!(!has(&texts, "ends[0] stuck at 0"), "{texts:?}");
    // Nothing is guessed without states.
    let texts = equivalent(&design, &Contract::default(), all);
    assert!(!has(&texts, "is_beyond[0] stuck at 0"), "{texts:?}");
}

#[test]
fn what_is_left_at_rest_counts_nothing() {
    let texts = equivalent(&shifter(), &started(), all);
    // The bit that comes in from below never comes out.
    assert!(has(&texts, "moved[0] stuck at 1"), "{texts:?}");
    assert!(!has(&texts, "moved[7] stuck at 1"), "{texts:?}");
}

#[test]
fn a_word_that_is_not_valid_may_be_any() {
    let design = latch();
    let contract = Contract {
        counts_with: vec![("kept".to_owned(), "valid".to_owned())],
        ..Contract::default()
    };
    let of_valid = |output: &[u64]| if output[0] == 1 { 2 } else { 1 };
    let texts = equivalent(&design, &contract, of_valid);
    assert!(has(&texts, "kept enable stuck at 1"), "{texts:?}");
    assert!(!has(&texts, "kept enable stuck at 0"), "{texts:?}");
    let texts = equivalent(&design, &Contract::default(), all);
    assert!(!has(&texts, "kept enable stuck at 1"), "{texts:?}");
}

#[test]
fn what_a_constant_hides_counts_nothing() {
    let texts = equivalent(&hidden(), &Contract::default(), all);
    assert!(has(&texts, "turned[3] stuck at 1"), "{texts:?}");
    assert!(!has(&texts, "kept[3] stuck at 1"), "{texts:?}");
    // Then the flag is no constant.
    assert!(!has(&texts, "rises[0] stuck at 1"), "{texts:?}");
    assert!(!has(&texts, "rises[0] inverted"), "{texts:?}");
}

#[test]
fn a_difference_that_is_hidden_clocks_later_counts_nothing() {
    let texts = equivalent(&replaced(), &Contract::default(), all);
    assert!(has(&texts, "other[3] inverted"), "{texts:?}");
    assert!(!has(&texts, "kept[3] inverted"), "{texts:?}");
    assert!(!has(&texts, "is_last[0] inverted"), "{texts:?}");
}

#[test]
fn what_differs_before_anything_is_shown_counts_nothing() {
    let texts = equivalent(&begun(), &within(3), all);
    assert!(has(&texts, "set[7] stuck at 1"), "{texts:?}");
    assert!(!has(&texts, "set[6] stuck at 1"), "{texts:?}");
    assert!(!has(&texts, "is_begun[0] stuck at 1"), "{texts:?}");
    // In the first clock it does differ.
    let texts = equivalent(&begun(), &within(0), all);
    assert!(!has(&texts, "set[7] stuck at 1"), "{texts:?}");
}

#[test]
fn short_words_are_told_from_all_others() {
    let design = two_ways();
    let controls = controls(&design);
    let judge = judge(&controls, &design, &within(1));
    let mutants = controls.mutants();
    let short = |start: &str| {
        let mut mutants = mutants.iter();
        let mutant = mutants.find(|mutant| controls.describe(mutant).starts_with(start));
        judge.short(&mutant.expect("a mutant").upsets, 24)
    };
    // Without the short way a short word takes the other one, to the same result.
    assert_eq!(short("is_short[0] stuck at 0"), Some(16));
    assert_eq!(short("is_short[0] stuck at 1"), None);
    assert_eq!(short("long[3] inverted"), None);
}
