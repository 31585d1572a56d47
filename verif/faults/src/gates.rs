//! And gates with inverters, equal ones once.

use std::collections::HashMap;
use std::ops::Not;

/// The output of a gate, or its inverse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Bit(u32);

/// Always 0.
pub(crate) const NO: Bit = Bit(0);
/// Always 1.
pub(crate) const YES: Bit = Bit(1);

impl Bit {
    /// The number of its gate.
    pub(crate) fn gate(self) -> usize {
        (self.0 >> 1) as usize
    }

    pub(crate) fn is_inverted(self) -> bool {
        self.0 & 1 == 1
    }

    pub(crate) fn of(value: bool) -> Bit {
        Bit(u32::from(value))
    }
}

impl Not for Bit {
    type Output = Bit;

    fn not(self) -> Bit {
        Bit(self.0 ^ 1)
    }
}

/// All gates.
#[derive(Clone)]
pub(crate) struct Gates {
    /// Operands, those of a gate before it; two times 0 is an input.
    gates: Vec<[Bit; 2]>,
    known: HashMap<[Bit; 2], Bit>,
}

impl Gates {
    pub(crate) fn new() -> Gates {
        Gates {
            gates: vec![[NO; 2]],
            known: HashMap::new(),
        }
    }

    fn add(&mut self, operands: [Bit; 2]) -> Bit {
        self.gates.push(operands);
        Bit((self.gates.len() as u32 - 1) << 1)
    }

    pub(crate) fn input(&mut self) -> Bit {
        self.add([NO; 2])
    }

    /// What a gate reads; nothing if it is an input or the constant.
    pub(crate) fn operands(&self, gate: usize) -> Option<[Bit; 2]> {
        let operands = self.gates[gate];
        (operands != [NO; 2]).then_some(operands)
    }

    pub(crate) fn len(&self) -> usize {
        self.gates.len()
    }

    /// Does one of these bits depend on each gate?
    pub(crate) fn behind(&self, bits: impl Iterator<Item = Bit>) -> Vec<bool> {
        let mut is_behind = vec![false; self.gates.len()];
        bits.for_each(|bit| is_behind[bit.gate()] = true);
        for gate in (0..self.gates.len()).rev() {
            if is_behind[gate] {
                for bit in self.gates[gate] {
                    is_behind[bit.gate()] = true;
                }
            }
        }
        is_behind
    }

    pub(crate) fn and(&mut self, a: Bit, b: Bit) -> Bit {
        let [a, b] = if a < b { [a, b] } else { [b, a] };
        match (a, b) {
            (NO, _) => NO,
            (YES, _) => b,
            _ if a == b => a,
            _ if a == !b => NO,
            _ => match self.known.get(&[a, b]) {
                Some(known) => *known,
                None => {
                    let gate = self.add([a, b]);
                    self.known.insert([a, b], gate);
                    gate
                }
            },
        }
    }

    pub(crate) fn or(&mut self, a: Bit, b: Bit) -> Bit {
        !self.and(!a, !b)
    }

    pub(crate) fn xor(&mut self, a: Bit, b: Bit) -> Bit {
        let (only_a, only_b) = (self.and(a, !b), self.and(!a, b));
        self.or(only_a, only_b)
    }

    pub(crate) fn select(&mut self, which: Bit, a: Bit, b: Bit) -> Bit {
        if a == b {
            return a;
        }
        let (a, b) = (self.and(which, a), self.and(!which, b));
        self.or(a, b)
    }

    /// Sum and carry.
    pub(crate) fn full_add(&mut self, a: Bit, b: Bit, carry: Bit) -> (Bit, Bit) {
        let differ = self.xor(a, b);
        let sum = self.xor(differ, carry);
        let (both, passed) = (self.and(a, b), self.and(differ, carry));
        (sum, self.or(both, passed))
    }
}
