//! And gates with inverters, equal ones once.

use rustc_hash::FxHashMap;
use std::ops::Not;
use std::sync::Arc;

/// The output of a gate, or its inverse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Bit(u32);

/// Always 0.
pub(crate) const NO: Bit = Bit(0);
/// Always 1.
pub(crate) const YES: Bit = Bit(1);

impl Bit {
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

#[derive(Clone, Default)]
struct Table {
    /// Operands, those of a gate before it; two times 0 is an input.
    gates: Vec<[Bit; 2]>,
    known: FxHashMap<[Bit; 2], Bit>,
}

#[derive(Clone)]
pub(crate) struct Gates {
    /// Those that copies share.
    shared: Arc<Table>,
    own: Table,
}

impl Gates {
    pub(crate) fn new() -> Gates {
        let shared = Arc::default();
        let mut own = Table::default();
        own.gates.push([NO; 2]);
        Gates { shared, own }
    }

    /// The same gates, of which a copy costs nothing.
    pub(crate) fn frozen(self) -> Gates {
        let mut all = Arc::unwrap_or_clone(self.shared);
        all.gates.extend(self.own.gates);
        let mut fewer = self.own.known;
        if fewer.len() > all.known.len() {
            std::mem::swap(&mut fewer, &mut all.known);
        }
        all.known.extend(fewer);
        Gates {
            shared: Arc::new(all),
            own: Table::default(),
        }
    }

    fn add(&mut self, operands: [Bit; 2]) -> Bit {
        self.own.gates.push(operands);
        Bit((self.len() as u32 - 1) << 1)
    }

    pub(crate) fn input(&mut self) -> Bit {
        self.add([NO; 2])
    }

    /// What a gate reads; `None` if it is an input or the constant.
    pub(crate) fn operands(&self, gate: usize) -> Option<[Bit; 2]> {
        let operands = self.at(gate);
        (operands != [NO; 2]).then_some(operands)
    }

    fn at(&self, gate: usize) -> [Bit; 2] {
        match gate.checked_sub(self.shared.gates.len()) {
            Some(own) => self.own.gates[own],
            None => self.shared.gates[gate],
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.shared.gates.len() + self.own.gates.len()
    }

    /// Does one of these bits depend on each gate?
    pub(crate) fn behind(&self, bits: impl Iterator<Item = Bit>) -> Vec<bool> {
        let mut is_behind = vec![false; self.len()];
        bits.for_each(|bit| is_behind[bit.gate()] = true);
        for gate in (0..self.len()).rev() {
            if is_behind[gate] {
                for bit in self.at(gate) {
                    is_behind[bit.gate()] = true;
                }
            }
        }
        is_behind
    }

    /// Does each gate depend on one of these?
    pub(crate) fn depending(&self, sources: &[usize]) -> Vec<bool> {
        let mut depends = vec![false; self.len()];
        sources.iter().for_each(|gate| depends[*gate] = true);
        for gate in 0..self.len() {
            if let Some(operands) = self.operands(gate) {
                depends[gate] = operands.iter().any(|bit| depends[bit.gate()]);
            }
        }
        depends
    }

    /// Does each gate depend on one of these bits?
    pub(crate) fn depending_on(&self, bits: &[Bit]) -> Vec<bool> {
        let gates: Vec<usize> = bits.iter().map(|bit| bit.gate()).collect();
        self.depending(&gates)
    }

    pub(crate) fn and(&mut self, a: Bit, b: Bit) -> Bit {
        let [a, b] = if a < b { [a, b] } else { [b, a] };
        match (a, b) {
            (NO, _) => NO,
            (YES, _) => b,
            _ if a == b => a,
            _ if a == !b => NO,
            _ => {
                let known = self.shared.known.get(&[a, b]);
                if let Some(known) = known.or_else(|| self.own.known.get(&[a, b])) {
                    return *known;
                }
                let gate = self.add([a, b]);
                self.own.known.insert([a, b], gate);
                gate
            }
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
