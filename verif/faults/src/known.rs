//! What is known of the state of a circuit, and of what it does with the state at power-up.

use crate::flow::{State, keeps_nothing};
use crate::frame::{Begin, Word, bit_of, constant, less, sum};
use crate::gates::{Bit, Gates, NO, YES};
use crate::held::Held;
use crate::solve::{CONFLICTS, can_be};
use imogene_hdl::{Design, Direction, Levels};

/// What a circuit may rely on.
#[derive(Clone, Debug, Default)]
pub struct Contract {
    /// Bits of inputs that are 0.
    pub zeros: Vec<(String, u32)>,
    /// Inputs that are 1 in the clock with which its work begins.
    pub begins: Vec<String>,
    /// Inputs that do not change between two such clocks.
    pub held: Vec<String>,
    /// Pairs of points inside, both what a register holds: a remainder and its root, behind a row of a root. What
    /// cannot be proven of them is dropped.
    pub remainders: Vec<[String; 2]>,
    /// Do the rows restore their remainders?
    pub restores: bool,
    /// Clocks from an input to its result.
    pub latency: usize,
}

/// What holds in every state that is reached from power-up. Registers are counted without controls.
pub struct Known {
    pub(crate) zeros: Vec<(usize, u32)>,
    /// The value of each bit of each register that never changes.
    constants: Vec<Vec<Option<bool>>>,
    remainders: Vec<[usize; 2]>,
    restores: bool,
    /// Do the remainders hold from power-up on?
    pub(crate) always_holds: bool,
    /// Clocks from an input to its result.
    pub(crate) latency: usize,
    /// Is each bit of each register forgotten once work began?
    forgotten: Vec<Vec<bool>>,
    /// What holds while the circuit works.
    pub(crate) held: Held,
}

impl Known {
    /// Of a design without controls.
    pub fn new(design: &Design, contract: &Contract) -> Known {
        let levels = Levels::of(design);
        let ports: Vec<&str> = design
            .top
            .ports_of(Direction::In)
            .map(|port| &port.name[..])
            .collect();
        let place = |name: &String| ports.iter().position(|port| port == name);
        let register = |path: &String| {
            let mut points = levels.points.iter();
            let (_, point) = points.find(|(name, _)| name == path)?;
            let mut flops = levels.flops.iter();
            flops.position(|flop| flop.output == point.place)
        };
        let pairs = contract.remainders.iter();
        let pairs = pairs.filter_map(|[a, b]| Some([register(a)?, register(b)?]));
        let zeros = contract.zeros.iter();
        let mut known = Known {
            zeros: zeros
                .filter_map(|(name, bit)| Some((place(name)?, *bit)))
                .collect(),
            remainders: pairs.collect(),
            restores: contract.restores,
            always_holds: true,
            latency: contract.latency,
            constants: initial(&levels),
            forgotten: vec![],
            held: Held::default(),
        };
        known.drop_changing(&levels);
        known.drop_unproven(&levels);
        let begins: Vec<usize> = contract.begins.iter().filter_map(place).collect();
        known.forgotten = forgotten(&levels, &begins, contract.latency);
        let inputs: Vec<usize> = contract.held.iter().filter_map(place).collect();
        if !inputs.is_empty() && levels.stores.is_empty() && known.forgets_all() {
            known.held = Held::of(&levels, begins, inputs, contract.latency);
        }
        known
    }

    /// How many remainders are proven to be what they must.
    pub fn proven_remainders(&self) -> usize {
        self.remainders.len()
    }

    /// Is what a bit of a register holds at power-up without meaning: does nothing depend on it once work began and
    /// the latency passed?
    pub fn is_forgotten(&self, register: usize, bit: u32) -> bool {
        self.forgotten[register][bit as usize]
    }

    /// Is nothing left of any state once work began and the latency passed?
    fn forgets_all(&self) -> bool {
        let bits = self.forgotten.iter().flatten();
        let constants = self.constants.iter().flatten();
        bits.zip(constants)
            .all(|(is, constant)| *is || constant.is_some())
    }

    /// Bits that are 1 in every state that is reached; `registers` are those without controls.
    pub(crate) fn bits(
        &self,
        levels: &Levels,
        begin: &Begin,
        registers: &[usize],
        gates: &mut Gates,
    ) -> Vec<Bit> {
        let mut bits: Vec<Bit> = zero_inputs(&self.zeros, levels, begin).collect();
        for (register, constants) in registers.iter().zip(&self.constants) {
            let word = begin.at(levels.flops[*register].output);
            let pairs = word.iter().zip(constants);
            let constant = pairs.filter_map(|(bit, constant)| Some((bit, (*constant)?)));
            bits.extend(constant.map(|(bit, is)| if is { *bit } else { !*bit }));
        }
        for pair in &self.remainders {
            let words = pair.map(|index| begin.at(levels.flops[registers[index]].output));
            bits.push(self.is_remainder(gates, *pair, words));
        }
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

    /// Drops the constants that one clock may change, until there is none.
    fn drop_changing(&mut self, levels: &Levels) {
        loop {
            let mut gates = Gates::new();
            let mut begin = Begin::any(levels, &mut gates);
            for (index, bit) in &self.zeros {
                begin.at_mut(levels.inputs()[*index].place)[*bit as usize] = NO;
            }
            for (flop, constants) in levels.flops.iter().zip(&self.constants) {
                let bits = begin.at_mut(flop.output).iter_mut();
                for (bit, constant) in bits.zip(constants) {
                    *bit = constant.map_or(*bit, Bit::of);
                }
            }
            let end = begin.clock(levels, &mut gates).end;
            let mut is_done = true;
            for (constants, next) in self.constants.iter_mut().zip(&end.registers) {
                for (constant, next) in constants.iter_mut().zip(next) {
                    if constant.is_some_and(|value| *next != Bit::of(value)) {
                        *constant = None;
                        is_done = false;
                    }
                }
            }
            if is_done {
                return;
            }
        }
    }

    /// Do the remainders hold at power-up?
    fn holds_at_power_up(&self, levels: &Levels) -> bool {
        let initial = Begin::initial(levels);
        let mut gates = Gates::new();
        self.remainders.iter().all(|pair| {
            let words = pair.map(|index| initial.at(levels.flops[index].output));
            self.is_remainder(&mut gates, *pair, words) == YES
        })
    }

    /// Drops the pairs that do not hold after a clock before which all hold, until there is none.
    ///
    /// Those that are left need not hold at power-up: where they do not, they hold in some state, and a circuit that
    /// keeps nothing comes to the same results from there.
    fn drop_unproven(&mut self, levels: &Levels) {
        let registers: Vec<usize> = (0..levels.flops.len()).collect();
        loop {
            let mut gates = Gates::new();
            let begin = Begin::any(levels, &mut gates);
            let assumed = self.bits(levels, &begin, &registers, &mut gates);
            let end = begin.clock(levels, &mut gates).end;
            let pairs = self.remainders.iter().copied().filter(|pair| {
                let words = pair.map(|index| &end.registers[index]);
                let holds = self.is_remainder(&mut gates, *pair, words);
                can_be(&gates, !holds, &assumed, CONFLICTS) == Some(false)
            });
            let kept: Vec<[usize; 2]> = pairs.collect();
            if kept.len() < self.remainders.len() {
                self.remainders = kept;
                continue;
            }
            self.always_holds = self.holds_at_power_up(levels);
            if !self.always_holds {
                let state = State::of(levels, &begin);
                let hold_in_some_state = can_be(&gates, YES, &assumed, CONFLICTS) == Some(true);
                if !hold_in_some_state || !keeps_nothing(&gates, &end, &state, self.latency) {
                    self.remainders.clear();
                }
            }
            return;
        }
    }
}

/// What every register holds at power-up.
fn initial(levels: &Levels) -> Vec<Vec<Option<bool>>> {
    let flops = levels.flops.iter().map(|flop| {
        let word = levels.words[flop.output as usize];
        (0..flop.width)
            .map(|bit| Some(word >> bit & 1 == 1))
            .collect()
    });
    flops.collect()
}

/// Bits that are 1 where these bits of inputs are 0.
pub(crate) fn zero_inputs(
    zeros: &[(usize, u32)],
    levels: &Levels,
    begin: &Begin,
) -> impl Iterator<Item = Bit> {
    let zeros = zeros.iter();
    zeros.map(|(index, bit)| !bit_of(begin.at(levels.inputs()[*index].place), *bit))
}

fn at_most_twice(gates: &mut Gates, a: &Word, b: &Word) -> Bit {
    let twice: Word = [NO].into_iter().chain(b.iter().copied()).collect();
    let width = a.len().max(twice.len()) as u32;
    !less(gates, &twice, a, width)
}

/// Bits of registers that are forgotten: two circuits that differ in them alone differ in no others before a clock
/// with these inputs at 1, and in none once the latency passed after it.
fn forgotten(levels: &Levels, begins: &[usize], latency: usize) -> Vec<Vec<bool>> {
    let mut gates = Gates::new();
    let mut begin = Begin::any(levels, &mut gates);
    let registers = levels.flops.iter();
    let registers = registers.map(|flop| begin.at(flop.output).clone());
    let registers: Vec<Word> = registers.collect();
    let before = begin.clock(levels, &mut gates).end;
    for index in begins {
        *begin.at_mut(levels.inputs()[*index].place) = constant(1);
    }
    let mut end = begin.clock(levels, &mut gates).end;
    let mut kept: Word = end.memories.concat();
    for _ in 1..latency.max(1) {
        begin = begin.after(&end, levels, &mut gates);
        end = begin.clock(levels, &mut gates).end;
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
        matters
            .iter_mut()
            .zip(reached)
            .for_each(|(all, one)| *all |= one);
        if count(&matters) == old {
            break;
        }
    }
    let registers = registers.iter();
    registers
        .map(|word| word.iter().map(|bit| !matters[bit.gate()]).collect())
        .collect()
}
