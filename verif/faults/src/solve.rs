//! Questions to the solver.

use crate::gates::{Bit, Gates, NO};
use batsat::{Callbacks, ClauseKind, Lit, Solver, SolverInterface, SolverOpts, lbool};
use rustc_hash::FxHashMap;

/// Conflicts after which the solver gives up, if nothing else is asked for.
pub const CONFLICTS: u64 = 10_000;

/// Stops the solver: each conflict teaches it a clause.
struct Effort {
    left: u64,
}

impl Callbacks for Effort {
    fn on_new_clause(&mut self, _: &[Lit], kind: ClauseKind) {
        let taken = u64::from(kind == ClauseKind::Learnt);
        self.left = self.left.saturating_sub(taken);
    }

    fn stop(&self) -> bool {
        self.left == 0
    }
}

/// Gates as clauses, each when it is first wanted.
struct Clauses<'a> {
    gates: &'a Gates,
    solver: Solver<Effort>,
    /// The literal of each gate that was wanted: a few of millions.
    known: FxHashMap<usize, Lit>,
}

pub(crate) enum Answer {
    Never,
    /// In some case, in which the bits that were asked for have these values.
    When(Vec<bool>),
    Unknown,
}

/// What is known of a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It behaves like the circuit on every input, from the first result on.
    Equivalent,
    /// In some state, which may be one that is never reached, outputs or next state differ.
    Differs,
    /// The solver gave up.
    Undecided,
}

/// 1 where the bits of some pair are not equal.
pub(crate) fn any_differs(pairs: Vec<(Bit, Bit)>, gates: &mut Gates) -> Bit {
    let differ = pairs.into_iter().filter(|(good, bad)| good != bad);
    let differ: Vec<Bit> = differ.map(|(good, bad)| gates.xor(good, bad)).collect();
    differ.into_iter().fold(NO, |any, bit| gates.or(any, bit))
}

/// Are the bits of all pairs equal?
pub(crate) fn equality(
    pairs: Vec<(Bit, Bit)>,
    assumed: &[Bit],
    gates: &mut Gates,
    conflicts: u64,
) -> Verdict {
    let any = any_differs(pairs, gates);
    match ask(gates, any, assumed, conflicts, &[]) {
        Answer::Never => Verdict::Equivalent,
        Answer::When(_) => Verdict::Differs,
        Answer::Unknown => Verdict::Undecided,
    }
}

/// Can a bit be 1 where others are 1, and what are some other bits in a case in which it can? Unknown after so many
/// conflicts.
pub(crate) fn ask(
    gates: &Gates,
    wanted: Bit,
    assumed: &[Bit],
    conflicts: u64,
    asked: &[Bit],
) -> Answer {
    if wanted == NO {
        return Answer::Never;
    }
    let mut clauses = Clauses::of(gates, assumed, conflicts);
    clauses.assume(wanted);
    let asked = asked.iter().map(|bit| clauses.literal(*bit));
    let asked: Vec<Lit> = asked.collect();
    let found = clauses.solver.solve_limited(&[]);
    if found == lbool::FALSE {
        Answer::Never
    } else if found == lbool::TRUE {
        let value = |literal: Lit| clauses.solver.value_lit(literal) == lbool::TRUE;
        Answer::When(asked.into_iter().map(value).collect())
    } else {
        Answer::Unknown
    }
}

/// Can each of these bits be 1 in some case in which others are 1? `None` if one that is never to be 1 can be, or if
/// the solver gives up, which it does after so many conflicts without a new case.
pub(crate) fn possible(
    gates: &Gates,
    conflicts: u64,
    never: Bit,
    wanted: &[Bit],
    assumed: &[Bit],
) -> Option<Vec<bool>> {
    let mut clauses = Clauses::of(gates, assumed, conflicts);
    if never != NO {
        let literal = clauses.literal(never);
        if clauses.solver.solve_limited(&[literal]) != lbool::FALSE {
            return None;
        }
        clauses.assume(!never);
    }
    let wanted = wanted.iter().map(|bit| clauses.literal(*bit));
    let wanted: Vec<Lit> = wanted.collect();
    let mut found = vec![false; wanted.len()];
    loop {
        // One of those that no case showed so far.
        let open = wanted.iter().zip(&found).filter(|(_, found)| !**found);
        let mut open: Vec<Lit> = open.map(|(literal, _)| *literal).collect();
        clauses.solver.add_clause_reuse(&mut open);
        clauses.solver.cb_mut().left = conflicts;
        let answer = clauses.solver.solve_limited(&[]);
        if answer == lbool::FALSE {
            return Some(found);
        } else if answer != lbool::TRUE {
            return None;
        }
        for (literal, found) in wanted.iter().zip(&mut found) {
            *found |= clauses.solver.value_lit(*literal) == lbool::TRUE;
        }
    }
}

impl Clauses<'_> {
    /// Of a case in which these bits are 1.
    fn of<'a>(gates: &'a Gates, assumed: &[Bit], conflicts: u64) -> Clauses<'a> {
        let mut clauses = Clauses {
            gates,
            solver: Solver::new(SolverOpts::default(), Effort { left: conflicts }),
            known: FxHashMap::default(),
        };
        assumed.iter().for_each(|bit| clauses.assume(*bit));
        clauses
    }

    fn assume(&mut self, bit: Bit) {
        let literal = self.literal(bit);
        self.solver.add_clause_reuse(&mut vec![literal]);
    }

    fn literal(&mut self, bit: Bit) -> Lit {
        self.write(bit.gate());
        self.written(bit)
    }

    fn written(&self, bit: Bit) -> Lit {
        let literal = self.known[&bit.gate()];
        if bit.is_inverted() { !literal } else { literal }
    }

    /// Writes a gate behind its operands.
    fn write(&mut self, wanted: usize) {
        let (mut open, mut clause) = (vec![wanted], vec![]);
        while let Some(&gate) = open.last() {
            if self.known.contains_key(&gate) {
                open.pop();
                continue;
            }
            let Some(operands) = self.gates.operands(gate) else {
                let free = self.variable(gate);
                if gate == NO.gate() {
                    self.solver.add_clause_reuse(&mut vec![!free]);
                }
                continue;
            };
            let before = open.len();
            let operand_gates = operands.map(Bit::gate).into_iter();
            open.extend(operand_gates.filter(|gate| !self.known.contains_key(gate)));
            if open.len() > before {
                continue;
            }
            let [a, b] = operands.map(|bit| self.written(bit));
            let y = self.variable(gate);
            for own in [&[!y, a][..], &[!y, b], &[y, !a, !b]] {
                clause.clear();
                clause.extend_from_slice(own);
                self.solver.add_clause_reuse(&mut clause);
            }
        }
    }

    fn variable(&mut self, gate: usize) -> Lit {
        let literal = Lit::new(self.solver.new_var_default(), true);
        self.known.insert(gate, literal);
        literal
    }
}
