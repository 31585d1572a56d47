//! What is known of the state of a circuit, and of what it does with the state at power-up.

use crate::facts::{Fact, facts};
use crate::flow::{State, keeps_nothing};
use crate::frame::{Begin, Reached, Word, bit_of, constant, differ, less, sum, zero_inputs};
use crate::gates::{Bit, Gates, NO, YES};
use crate::held::Held;
use crate::idle::{Constants, Idle};
use crate::phases::Phases;
use crate::solve::{Answer, CONFLICTS, ask};
use imogene_hdl::{Design, Direction, Levels, PortRecord};
use std::sync::Arc;

/// What a circuit may rely on.
#[derive(Clone, Debug, Default)]
pub struct Contract {
    /// Bits of inputs that are 0.
    pub zeros: Vec<(String, u32)>,
    /// Bits of inputs that are 0 in a clock in which another one has a word.
    pub zeros_beside: Vec<((String, u64), (String, u32))>,
    /// Inputs that are 0 before its work begins.
    pub quiet: Vec<String>,
    /// Inputs that have these words in the clocks with which it begins, one after the other.
    pub begins: Vec<Vec<(String, u64)>>,
    /// Inputs that do not change between two such clocks.
    pub held: Vec<String>,
    /// Pairs of points inside, both what a register holds: a remainder and its root, behind a row of a root. What
    /// cannot be proven of them is dropped.
    pub remainders: Vec<[String; 2]>,
    /// Do the rows restore their remainders?
    pub restores: bool,
    /// Clocks from an input to its result.
    pub latency: usize,
    /// Some states that it comes to: what its registers hold, in the order of the simulator. What holds in all of them
    /// is tried to be proven.
    pub seen: Vec<Vec<u64>>,
    /// Outputs that count only in clocks in which another one, a flag, is 1.
    pub counts_with: Vec<(String, String)>,
}

/// What holds in every state that is reached from power-up. Registers are counted without controls.
#[derive(Clone)]
pub struct Known {
    pub(crate) zeros: Vec<(usize, u32)>,
    zeros_beside: Vec<((usize, u64), (usize, u32))>,
    /// What never changes.
    pub(crate) constants: Constants,
    /// Conflicts after which the solver gives a mutant up.
    pub(crate) effort: u64,
    remainders: Vec<[usize; 2]>,
    restores: bool,
    facts: Vec<Fact>,
    /// Do the remainders hold from power-up on?
    pub(crate) always_holds: bool,
    /// Clocks from an input to its result.
    pub(crate) latency: usize,
    /// Of each output, the one without which it counts nothing.
    pub(crate) counts_with: Vec<Option<usize>>,
    /// Is each bit of each register forgotten once work began?
    forgotten: Vec<Vec<bool>>,
    /// Is what each register holds at power-up seen nowhere?
    unseen: Vec<bool>,
    /// What holds while the circuit works.
    pub(crate) held: Held,
    /// What holds before.
    pub(crate) idle: Idle,
    pub(crate) phases: Option<Phases>,
}

impl Known {
    /// Of a design without controls.
    pub fn new(design: &Design, contract: &Contract) -> Known {
        let levels = Arc::new(Levels::of(design));
        let place = |name: &String| {
            let mut ports = design.top.ports_of(Direction::In);
            ports.position(|port| port.name == *name)
        };
        let register = |path: &String| {
            let mut points = levels.points.iter();
            let (_, point) = points.find(|(name, _)| name == path)?;
            let mut flops = levels.flops.iter();
            flops.position(|flop| flop.output == point.place)
        };
        let pairs = contract.remainders.iter();
        let pairs = pairs.filter_map(|[a, b]| Some([register(a)?, register(b)?]));
        let zeros = contract.zeros.iter();
        let zeros = zeros.filter_map(|(name, bit)| Some((place(name)?, *bit)));
        let zeros: Vec<(usize, u32)> = zeros.collect();
        let zeros_beside = contract.zeros_beside.iter();
        let zeros_beside = zeros_beside.filter_map(|((beside, word), (name, bit))| {
            Some(((place(beside)?, *word), (place(name)?, *bit)))
        });
        let quiet: Vec<usize> = contract.quiet.iter().filter_map(place).collect();
        let begins = contract.begins.iter().map(|clock| {
            let words = clock.iter();
            let words = words.filter_map(|(name, word)| Some((place(name)?, *word)));
            words.collect::<Vec<_>>()
        });
        let begins: Vec<Vec<(usize, u64)>> = begins.collect();
        let mut known = Known {
            effort: CONFLICTS,
            remainders: pairs.collect(),
            restores: contract.restores,
            facts: vec![],
            always_holds: true,
            latency: contract.latency,
            counts_with: counts_with(design, contract),
            constants: Idle::of(&levels, &zeros, &[]).constants,
            idle: Idle {
                begins,
                ..Idle::of(&levels, &zeros, &quiet)
            },
            phases: None,
            zeros,
            zeros_beside: zeros_beside.collect(),
            forgotten: vec![],
            unseen: vec![],
            held: Held::default(),
        };
        known.drop_unproven(&levels);
        if known.always_holds {
            if !contract.seen.is_empty() {
                known.facts = facts(known.any_clock(&levels), &contract.seen);
            }
            known.phases = Phases::of(known.any_clock(&levels), known.counts_with.clone());
        }
        known.forgotten = known.forgotten(&levels);
        known.unseen = known.unseen(&levels);
        let inputs: Vec<usize> = contract.held.iter().filter_map(place).collect();
        if !inputs.is_empty() && levels.stores.is_empty() && known.forgets_all() {
            let begins = known.idle.quiet.clone();
            known.held = Held::of(&levels, begins, inputs, contract.latency);
        }
        known
    }

    /// The same, where the solver gives a mutant up after so many conflicts.
    pub fn with_effort(self, effort: u64) -> Known {
        Known { effort, ..self }
    }

    /// How many remainders are proven to be what they must.
    pub fn proven_remainders(&self) -> usize {
        self.remainders.len()
    }

    /// Is what a bit of a register holds at power-up without meaning: does nothing depend on it once work began and
    /// the latency passed, or does nothing that counts ever show it?
    pub fn is_forgotten(&self, register: usize, bit: u32) -> bool {
        self.unseen[register] || self.forgotten[register][bit as usize]
    }

    /// Is nothing left of any state once work began and the latency passed?
    fn forgets_all(&self) -> bool {
        let bits = self.forgotten.iter().flatten();
        let constants = self.constants.iter().flatten();
        bits.zip(constants)
            .all(|(is, constant)| *is || constant.is_some())
    }

    /// A clock of the design, with any inputs from any state that is reached.
    fn any_clock(&self, levels: &Arc<Levels>) -> Reached {
        let mut gates = Gates::new();
        let begin = Begin::any(levels, &mut gates);
        self.clock(gates, begin, (0..levels.flops.len()).collect())
    }

    /// The clock with this beginning, of a design with controls beside these registers.
    pub(crate) fn clock(&self, mut gates: Gates, begin: Begin, registers: Vec<usize>) -> Reached {
        let assumed = self.bits(&begin, &registers, &mut gates);
        Reached {
            clock: begin.clock(&mut gates),
            gates,
            begin,
            assumed,
            registers,
        }
    }

    /// Bits that are 1 in every state that is reached; `registers` are those without controls.
    fn bits(&self, begin: &Begin, registers: &[usize], gates: &mut Gates) -> Vec<Bit> {
        let mut bits: Vec<Bit> = zero_inputs(&self.zeros, begin).collect();
        for ((beside, word), zero) in &self.zeros_beside {
            let is_other = differ(gates, begin.input(*beside), &constant(*word));
            let zero = [*zero];
            let is_zero = zero_inputs(&zero, begin);
            bits.extend(is_zero.map(|is| gates.or(is_other, is)));
        }
        for (register, constants) in registers.iter().zip(&self.constants) {
            let pairs = begin.register(*register).iter().zip(constants);
            let constant = pairs.filter_map(|(bit, constant)| Some((bit, (*constant)?)));
            bits.extend(constant.map(|(bit, is)| if is { *bit } else { !*bit }));
        }
        for pair in &self.remainders {
            let words = pair.map(|index| begin.register(registers[index]));
            bits.push(self.is_remainder(gates, *pair, words));
        }
        let word = |register: usize| begin.register(registers[register]);
        bits.extend(self.facts.iter().map(|fact| fact.holds(gates, word)));
        bits
    }

    /// Can a remainder and a root stand behind a row? A remainder is at most twice the root. That of a row that does
    /// not restore is less by `2 root + 1` where the last digit is 0, in two's complement of the bits that it has.
    fn is_remainder(&self, gates: &mut Gates, registers: [usize; 2], words: [&Word; 2]) -> Bit {
        let [remainder, root] = words;
        if self.restores {
            return at_most_twice(gates, remainder, root);
        }
        let constants = &self.constants[registers[0]];
        let width = constants.iter().rposition(Option::is_none);
        let width = width.map_or(0, |place| place as u32 + 1);
        let odd: Word = [YES].into_iter().chain(root.iter().copied()).collect();
        let added = sum(gates, remainder, &odd, NO, width);
        let is_odd = bit_of(root, 0);
        let restored = (0..width).map(|index| {
            let [as_is, added] = [remainder, &added].map(|word| bit_of(word, index));
            gates.select(is_odd, as_is, added)
        });
        let restored: Word = restored.collect();
        at_most_twice(gates, &restored, root)
    }

    /// Bits of registers that are forgotten, by their structure in any state, or by what holds before the work.
    fn forgotten(&self, levels: &Arc<Levels>) -> Vec<Vec<bool>> {
        let first = self.idle.begins.first().map_or(&[][..], |clock| clock);
        let mut forgotten = forgotten(levels, first, self.latency);
        let open = (0..forgotten.len()).filter(|register| forgotten[*register].contains(&false));
        let open = open.collect();
        for register in self.idle.forgotten(levels, open, self.latency) {
            forgotten[register].fill(true);
        }
        forgotten
    }

    /// Of registers that are not forgotten, whether what they hold at power-up is seen nowhere.
    fn unseen(&self, levels: &Arc<Levels>) -> Vec<bool> {
        let of = self.any_clock(levels);
        let registers = self.forgotten.iter().enumerate();
        let is_unseen = |(register, bits): (usize, &Vec<bool>)| {
            self.always_holds && bits.contains(&false) && self.is_unseen(&of, register)
        };
        registers.map(is_unseen).collect()
    }

    /// Do the remainders hold at power-up?
    fn holds_at_power_up(&self, levels: &Arc<Levels>) -> bool {
        let initial = Begin::initial(levels);
        let mut gates = Gates::new();
        self.remainders.iter().all(|pair| {
            let words = pair.map(|index| initial.register(index));
            self.is_remainder(&mut gates, *pair, words) == YES
        })
    }

    /// Drops the pairs that do not hold after a clock before which all hold, until there is none.
    ///
    /// Those that are left need not hold at power-up: where they do not, they hold in some state, and a circuit that
    /// keeps nothing comes to the same results from there.
    fn drop_unproven(&mut self, levels: &Arc<Levels>) {
        loop {
            let mut of = self.any_clock(levels);
            let end = &of.clock.end;
            let pairs = self.remainders.iter().copied().filter(|pair| {
                let words = pair.map(|index| &end.registers[index]);
                let holds = self.is_remainder(&mut of.gates, *pair, words);
                let breaks = ask(&of.gates, !holds, &of.assumed, CONFLICTS, &[]);
                matches!(breaks, Answer::Never)
            });
            let kept: Vec<[usize; 2]> = pairs.collect();
            if kept.len() < self.remainders.len() {
                self.remainders = kept;
                continue;
            }
            self.always_holds = self.holds_at_power_up(levels);
            if !self.always_holds {
                let state = State::of(&of.begin);
                let some_state = ask(&of.gates, YES, &of.assumed, CONFLICTS, &[]);
                let hold_in_some_state = matches!(some_state, Answer::When(_));
                if !hold_in_some_state || !keeps_nothing(&of.gates, end, &state, self.latency) {
                    self.remainders.clear();
                }
            }
            return;
        }
    }
}

/// Of each output, the one without which it counts nothing.
fn counts_with(design: &Design, contract: &Contract) -> Vec<Option<usize>> {
    let outputs = || design.top.ports_of(Direction::Out);
    let flag = |port: &PortRecord| {
        let mut pairs = contract.counts_with.iter();
        let (_, flag) = pairs.find(|(output, _)| *output == port.name)?;
        outputs().position(|port| port.name == *flag)
    };
    outputs().map(flag).collect()
}

fn at_most_twice(gates: &mut Gates, a: &Word, b: &Word) -> Bit {
    let twice: Word = [NO].into_iter().chain(b.iter().copied()).collect();
    let width = a.len().max(twice.len()) as u32;
    !less(gates, &twice, a, width)
}

/// Bits of registers that are forgotten: two circuits that differ in them alone differ in no others before a clock
/// with these inputs at 1, and in none once the latency passed after it.
fn forgotten(levels: &Arc<Levels>, begins: &[(usize, u64)], latency: usize) -> Vec<Vec<bool>> {
    let mut gates = Gates::new();
    let mut begin = Begin::any(levels, &mut gates);
    let registers = levels.flops.iter();
    let registers = registers.map(|flop| begin.at(flop.output).clone());
    let registers: Vec<Word> = registers.collect();
    let before = begin.clock(&mut gates).end;
    for (input, word) in begins {
        *begin.input_mut(*input) = constant(*word);
    }
    let mut end = begin.clock(&mut gates).end;
    let mut kept: Word = end.memories.concat();
    for _ in 1..latency.max(1) {
        begin = begin.after(&end, &mut gates);
        end = begin.clock(&mut gates).end;
        kept.extend(end.memories.iter().flatten());
    }
    kept.extend(end.registers.iter().flatten());
    let mut matters = gates.behind(kept.into_iter());
    loop {
        // What reaches a bit that matters matters.
        let pairs = registers.iter().zip(&before.registers);
        let pairs = pairs.flat_map(|(now, next)| now.iter().zip(next));
        let next = pairs.filter(|(now, _)| matters[now.gate()]);
        let next = next.map(|(_, next)| *next);
        let reached = gates.behind(next.chain(before.memories.iter().flatten().copied()));
        let count = |bits: &[bool]| bits.iter().filter(|is| **is).count();
        let old = count(&matters);
        let pairs = matters.iter_mut().zip(reached);
        pairs.for_each(|(all, one)| *all |= one);
        if count(&matters) == old {
            break;
        }
    }
    let registers = registers.iter();
    registers
        .map(|word| word.iter().map(|bit| !matters[bit.gate()]).collect())
        .collect()
}
