//! Random circuits: compiled, and in the levelised simulator, with every named net compared on every clock.

use imogene_compiled::{Program, Simulation};
use imogene_hdl::{Bits, Design, Direction, Int, Simulator, Value};
use imogene_hdl::{join, memory, module, read_only_memory};
use proptest::prelude::*;
use std::sync::Arc;

/// One value more: what it is, and of which of those before.
#[derive(Clone, Debug)]
struct Step {
    kind: u8,
    from: [usize; 3],
    number: u32,
}

/// Kinds of steps: small equal parts, a part that may hold others, large equal parts.
const ROWS: u8 = 28;
const PART: u8 = 35;
const PAIRS: u8 = 36;

/// Steps of the top module and of those in it; a module holds instances of those behind it alone.
type Recipe = Vec<Vec<Step>>;

#[derive(Clone, Copy)]
enum Any {
    Word(Bits),
    Number(Int),
}

impl Any {
    fn word(self) -> Bits {
        match self {
            Any::Word(word) => word,
            Any::Number(number) => number.bits(),
        }
    }

    fn word_of(self, width: u32) -> Bits {
        let word = self.word();
        if word.width() < width {
            word.extend(width)
        } else {
            word.low(width)
        }
    }

    fn number_of(self, width: u32) -> Int {
        match self {
            Any::Number(number) if number.width() < width => number.extend(width),
            other => other.word_of(width).int(),
        }
    }

    fn flag(self) -> Bits {
        self.word().bit(0)
    }
}

/// Inputs of every module but the top one.
const WIDTHS: [u32; 2] = [7, 33];

/// Equal parts one behind the other, each with a constant of its own; some take from none before.
fn rows(index: usize, number: u32, first: Bits, flag: Bits) -> Bits {
    let width = first.width();
    let last = (0..number % 11).fold((first, flag), |(word, flag), k| {
        let is_first = number >> k & 0x1000 != 0;
        let taken = if is_first { first } else { word };
        let own = Bits::new(u64::from(number) >> k & 1, 1);
        let inputs = (("word", taken), ("flag", flag), ("own", own));
        let at = format!("row_{index}_{k}");
        module(&format!("row_{width}"), &at, inputs, |(word, flag, own)| {
            let sum = word + own.extend(width);
            let next = flag.select(sum, !word).reg();
            (("behind", next), ("over", sum.less(word).reg()))
        })
    });
    last.0 ^ last.1.extend(width)
}

/// Widths in one vector of eight lanes, and in two.
const OF_PAIRS: [u32; 5] = [1, 7, 32, 33, 64];

fn fit(word: Bits, width: u32) -> Bits {
    Any::Word(word).word_of(width)
}

/// More than sixty nets, which give registers.
fn stage(words: &[Bits], own: Bits) -> Vec<Bits> {
    let held = OF_PAIRS.iter().enumerate().map(|(index, &width)| {
        let sum = fit(words[index], width) + fit(words[(index + 1) % 5], width);
        let chosen = words[0].select(sum, sum ^ fit(own, width));
        let last = (0..6).fold(chosen, |word, _| (word + fit(words[4], width)).reg());
        let held = Bits::register(width).initially(1);
        held.load(last);
        held
    });
    held.collect()
}

/// Equal parts, each behind one of other equal parts, in their order or in another.
fn pairs(index: usize, number: u32, word: Bits, flag: Bits) -> Bits {
    let part = |name: &str, k: usize, words: Vec<Bits>| {
        let inputs = (("word", words), ("own", Bits::new(k as u64, 4)));
        let at = format!("{name}_{index}_{k}");
        module(name, &at, inputs, |(words, own)| {
            ("held", stage(&words, own))
        })
    };
    let words = OF_PAIRS.map(|width| fit(word, width));
    let words = [&[flag], &words[1..]].concat();
    let count = 1 + number as usize % 14;
    let firsts: Vec<Vec<Bits>> = (0..count)
        .map(|k| part("front", k, words.clone()))
        .collect();
    let order = 1 + number as usize / 16 % 3;
    let ends = (0..count).map(|k| {
        let last = part("back", k, firsts[k * order % count].clone());
        last[0].select(
            fit(last[1] ^ last[2].low(7), 64),
            fit(last[3], 64) ^ last[4],
        )
    });
    ends.reduce(|a, b| a ^ b).expect("a pair")
}

/// A word that is late by many clocks, some of its ways seen and some of them held, or several words that are late
/// together.
fn delayed(x: Bits, y: Bits, number: u32) -> Bits {
    if number.is_multiple_of(3) {
        let words = [x, y, x + y, x ^ y, x - y].map(|word| word.reg());
        let late = (0..number / 3 % 4).fold(words, |words, _| words.map(|word| word.reg()));
        return late.into_iter().fold(y, |sum, word| sum + word);
    }
    let delay = (0..number / 3 % 20).fold((x.reg(), y), |(word, sum), k| {
        let [is_seen, is_held] = [1, 5].map(|some| number >> k & some == some);
        let next = match is_held {
            true => word.reg_when(y.bit(k % y.width())),
            false => word.reg(),
        };
        (next, if is_seen { sum + word } else { sum })
    });
    delay.0 ^ delay.1
}

/// Constants that are chosen by the bits of a word from one on, the last of them in front or behind.
fn chosen(by: Bits, width: u32, number: u32) -> Bits {
    let count = (1 + number % 5).min(by.width());
    let low = number / 8 % (by.width() - count + 1);
    let most = u64::MAX >> (64 - width);
    let word = |place: u32| {
        u64::from(number | 1)
            .wrapping_mul(0x9e37_79b9_7f4a_7c15)
            .rotate_left(place * 11)
            & most
    };
    let mut words: Vec<Bits> = (0..1 << count)
        .map(|place| Bits::new(word(place), width))
        .collect();
    for level in 0..count {
        let bit = if number & 0x100 == 0 {
            level
        } else {
            count - 1 - level
        };
        let pairs = words.chunks(2);
        words = pairs
            .map(|pair| by.bit(low + bit).select(pair[1], pair[0]))
            .collect();
    }
    words[0]
}

fn build(recipe: &[Vec<Step>], inputs: Vec<Any>) -> (&'static str, Vec<Bits>) {
    let mut values = inputs;
    for (index, step) in recipe[0].iter().enumerate() {
        let [a, b, c] = step.from.map(|place| values[place % values.len()]);
        let width = a.word().width();
        let number = step.number;
        let (x, y, z) = (a.word_of(width), b.word_of(width), c.flag());
        let (p, q) = (a.number_of(width), b.number_of(width));
        let most = width.min(32);
        let value = match step.kind {
            0 => Any::Word(x + y),
            1 => Any::Word(x - y),
            2 => Any::Word(x & y),
            3 => Any::Word(x | y),
            4 => Any::Word(x ^ y),
            5 => Any::Word(!x),
            6 => Any::Word(x.left_by(b.word())),
            7 => Any::Word(x.right_by(b.word())),
            8 => Any::Number(p.right_by(b.word())),
            9 => Any::Word(x.equals(y)),
            10 => Any::Word(x.less(y)),
            11 => Any::Word(p.less(q)),
            12 => Any::Word(z.select(x, y)),
            13 => Any::Number(z.select(p, q)),
            14 => {
                let high = width - 1 - number % width % 8;
                Any::Word(x.slice(high, number / 256 % (high + 1)))
            }
            15 if width + b.word().width() <= 64 => Any::Word(join([x, b.word()])),
            16 => Any::Number(p.extend(64.min(width + number % 30))),
            17 => Any::Word(x.extend(64.min(width + number % 30))),
            18 => Any::Word(a.word_of(most) * b.word_of(most)),
            19 => Any::Number(a.number_of(most) * b.number_of(most)),
            20 => Any::Word(delayed(x, y, number)),
            21 => Any::Number(p.reg_when(z)),
            22 => {
                let sum = Bits::register(width);
                sum.load_when(z, sum + x);
                Any::Word(sum)
            }
            23 => {
                let sum = Int::register(width);
                sum.load(sum - q);
                Any::Number(sum)
            }
            24 => {
                let words = 2 + number as usize % 5;
                let (at, from) = (b.word_of(3), c.word_of(3));
                let name = format!("kept_{index}");
                let most = u64::MAX >> (64 - x.width());
                let word = |place: usize| u64::from(number).rotate_right(7 * place as u32) & most;
                Any::Word(match number % 3 {
                    0 => {
                        let contents = (0..words).map(word).collect();
                        read_only_memory(&name, x.width(), contents, from)
                    }
                    _ => memory(&name, words, (z, at, x), from),
                })
            }
            25 => Any::Number(p),
            26 => Any::Word(Bits::new(u64::from(number) % (1 << width.min(20)), width)),
            PAIRS => Any::Word(pairs(index, number, a.word_of(64), z)),
            29 => Any::Word(chosen(b.word(), width, number)),
            ROWS | 30 => Any::Word(rows(index, number, x, z)),
            27 | 31..=34 => {
                // A chain of registers that take words together, every third of them now and then.
                let (chain, sum) = (1..number % 24).fold((x, x), |(last, sum), k| {
                    let enable = if k % 3 == 0 { z & b.flag() } else { z };
                    let next = (last + y).reg_when(enable);
                    (next, sum ^ next)
                });
                Any::Word(chain ^ sum)
            }
            PART if recipe.len() > 1 => {
                let part = 1 + number as usize % (recipe.len() - 1);
                let [one, other] = WIDTHS;
                // Many of a kind that has no others in it.
                let count = if part + 1 == recipe.len() {
                    number / 16 % 14
                } else {
                    0
                };
                let outputs = (0..=count).map(|k| {
                    let (x, y) = if number >> k & 1 == 1 { (a, b) } else { (b, c) };
                    let ports = (("one", x.word_of(one)), ("other", y.number_of(other)));
                    let at = format!("part_{index}_{k}");
                    let outputs = module(&format!("module_{part}"), &at, ports, |(one, other)| {
                        build(&recipe[part..], vec![Any::Word(one), Any::Number(other)])
                    });
                    outputs[number as usize % outputs.len()]
                });
                let outputs: Vec<Bits> = outputs.collect();
                Any::Word(outputs.into_iter().reduce(|a, b| a ^ b).expect("a part"))
            }
            _ => a,
        };
        let name = format!("value_{index}");
        values.push(match value {
            Any::Word(word) => Any::Word(word.named(&name)),
            Any::Number(number) => Any::Number(number.named(&name)),
        });
    }
    let last = values.iter().rev().take(3).map(|value| value.word());
    ("output", last.collect())
}

/// Inputs of the top module: more than four, which lanes take together, and not eight.
const INPUTS: usize = 6;

fn design(recipe: &Recipe) -> Design {
    Design::of(|| {
        let words = (
            ("x", Bits::input(1)),
            ("y", Bits::input(18)),
            ("z", Bits::input(32)),
        );
        let numbers = (
            ("a", Int::input(33)),
            ("b", Int::input(64)),
            ("c", Int::input(9)),
        );
        module("top", "top", (words, numbers), |((x, y, z), (a, b, c))| {
            let words = [x, y, z].map(Any::Word);
            build(recipe, [&words[..], &[a, b, c].map(Any::Number)].concat())
        });
    })
}

fn steps(most: usize) -> impl Strategy<Value = Vec<Step>> {
    let step = (0u8..37, any::<[usize; 3]>(), any::<u32>());
    let step = step.prop_map(|(kind, from, number)| Step { kind, from, number });
    prop::collection::vec(step, 1..most)
}

/// A recipe with a part that stands once, in which there are rows and equal parts.
fn with_a_part_apart(
    (mut top, mut part, inner, numbers): (Vec<Step>, Vec<Step>, Vec<Step>, [u32; 3]),
) -> Recipe {
    let step = |kind, number| Step {
        kind,
        from: [1, 3, 0].map(|place| place + number as usize % 7),
        number,
    };
    top.push(step(PART, numbers[0] & !1));
    part.push(step(PAIRS, numbers[1]));
    part.push(step(ROWS, numbers[2]));
    vec![top, part, inner]
}

/// The paths of all nets with names, and of all ports of instances.
fn paths(design: &Design) -> Vec<String> {
    fn walk(module: &imogene_hdl::Module, path: &str, found: &mut Vec<String>) {
        let ports = module.ports.iter();
        found.extend(ports.map(|port| format!("{path}{}", port.name)));
        let names = module.nets().filter_map(|(_, node)| node.name.as_ref());
        found.extend(names.map(|name| format!("{path}{name}")));
        for instance in &module.instances {
            let path = format!("{path}{}.", instance.name);
            walk(&instance.module, &path, found);
        }
    }
    let mut found = vec![];
    walk(&design.top, "", &mut found);
    found
}

/// What runs a circuit beside the simulator, in how many lanes, and the ports that are compared.
struct Run {
    what: &'static str,
    program: Arc<Program>,
    simulation: Simulation,
    /// The same, with inputs that are handed over with each clock.
    stepped: Simulation,
}

impl Run {
    fn new(what: &'static str, program: Program) -> Run {
        let program = Arc::new(program);
        Run {
            what,
            simulation: Simulation::new(&program),
            stepped: Simulation::new(&program),
            program,
        }
    }
}

proptest! {
    #[test]
    fn every_net_is_that_of_the_simulator(
        recipe in (steps(40), steps(80), steps(20)).prop_map(|(top, part, inner)| vec![top, part, inner]),
        stimulus in prop::collection::vec(any::<[[u64; INPUTS]; 8]>(), 1..12),
    ) {
        let design = design(&recipe);
        let paths = paths(&design);
        let mut lanes: Vec<Simulator> = (0..8).map(|_| Simulator::new(&design)).collect();
        let mut runs = [
            Run::new("steps of one lane", Program::new(&design, &paths).interpreted()),
            Run::new("steps of eight lanes", Program::in_lanes(&design, &paths).interpreted()),
            Run::new("one lane", Program::new(&design, &paths)),
            Run::new("eight lanes", Program::in_lanes(&design, &paths)),
        ];
        let points = paths.iter().enumerate();
        let points = points.filter_map(|(index, path)| Some((lanes[0].point(path)?, index)));
        let points: Vec<_> = points.collect();
        let inputs: Vec<_> = design.top.ports_of(Direction::In).collect();
        for words in stimulus {
            let rows = words.map(|words| words.map(|word| word as i64));
            let rows = rows.each_ref().map(|row| &row[..]);
            for (simulator, words) in lanes.iter_mut().zip(words) {
                for (port, word) in inputs.iter().zip(words) {
                    simulator.set(simulator.port(&port.name), word);
                }
            }
            for run in &mut runs {
                for (lane, words) in words.iter().enumerate().take(run.program.lanes()) {
                    run.simulation.set_lane(lane, *words);
                }
                let (count, found) = (run.program.lanes(), run.simulation.points());
                for (there, index) in &points {
                    for (lane, simulator) in lanes.iter_mut().enumerate().take(count) {
                        let (word, path) = (found[index * count + lane], &paths[*index]);
                        prop_assert_eq!(word, simulator.get(*there), "{}, lane {}: {}", run.what, lane, path);
                    }
                }
                run.simulation.clock();
                let stepped = run.stepped.step(&rows[..run.program.lanes()]);
                prop_assert_eq!(stepped, run.simulation.outputs(), "{}", run.what);
            }
            lanes.iter_mut().for_each(Simulator::clock);
        }
    }

    /// Inputs stay for so many clocks that parts rest; then some of them are others.
    #[test]
    fn what_rests_goes_on_with_an_input(
        recipe in (steps(40), steps(80), steps(20), any::<[u32; 3]>()).prop_map(with_a_part_apart),
        stimulus in prop::collection::vec((any::<[(bool, u64); INPUTS]>(), 1u32..120), 2..8),
    ) {
        let design = design(&recipe);
        let paths = paths(&design);
        let mut simulator = Simulator::new(&design);
        let program = Program::new(&design, &paths);
        let mut simulation = Simulation::new(&Arc::new(program));
        let points = paths.iter().map(|path| simulator.point(path));
        let points: Vec<_> = points.collect();
        let inputs: Vec<_> = design.top.ports_of(Direction::In).collect();
        let mut words = [0; INPUTS];
        for (others, clocks) in stimulus {
            for ((word, (is_new, other)), port) in words.iter_mut().zip(others).zip(&inputs) {
                *word = if is_new { other } else { *word };
                simulator.set(simulator.port(&port.name), *word);
            }
            simulation.set_all(words);
            for _ in 0..clocks {
                for ((path, point), word) in paths.iter().zip(&points).zip(simulation.points()) {
                    let wanted = point.map(|point| simulator.get(point));
                    prop_assert_eq!(wanted.unwrap_or(*word), *word, "{}", path);
                }
                simulation.clock();
                simulator.clock();
            }
        }
    }

    /// What differs between the runs is what registers hold: of each run another one holds something else at first.
    #[test]
    fn runs_on_one_stimulus_are_those_of_one_lane(
        recipe in (steps(40), steps(80), steps(20)).prop_map(|(top, part, inner)| vec![top, part, inner]),
        stimulus in prop::collection::vec(any::<[u64; INPUTS]>(), 1..12),
        upset in any::<u64>(),
    ) {
        let design = design(&recipe);
        let paths = paths(&design);
        let count = registers(&design.top);
        let alone = Arc::new(Program::new(&design, &paths));
        for program in [
            Program::on_one_stimulus(&design, &paths),
            Program::on_one_stimulus(&design, &paths).interpreted(),
        ] {
            let mut together = Simulation::new(&Arc::new(program));
            let lanes = together.lanes();
            let mut single: Vec<Simulation> = (0..lanes).map(|_| Simulation::new(&alone)).collect();
            for (lane, single) in single.iter_mut().enumerate().filter(|_| count > 0) {
                let (register, word) = (lane * 7 % count, upset.rotate_left(9 * lane as u32));
                together.upset(lane, register, word);
                single.upset(0, register, word);
            }
            for words in &stimulus {
                together.set_all(*words);
                for (lane, single) in single.iter_mut().enumerate() {
                    single.set_all(*words);
                    let points = together.points()[lane..].iter().step_by(lanes);
                    prop_assert!(points.eq(single.points()), "lane {}", lane);
                    single.clock();
                }
                together.clock();
            }
        }
    }
}

fn registers(module: &imogene_hdl::Module) -> usize {
    let parts = module.instances.iter();
    parts.map(|part| registers(&part.module)).sum::<usize>() + module.registers.len()
}
