//! Number shifted to its leading one.

use crate::kernel::*;

/// Shifts a number by `places` to the left if as many of its first bits are zero.
pub struct LeadingStep<const F: usize> {
    /// The number.
    pub number: Signal<In, Word<F>>,
    /// Places shifted before.
    pub count: Signal<In, Word<6>>,
    /// The number, shifted or not.
    pub shifted: Signal<Out, Word<F>>,
    /// Places shifted so far.
    pub late_count: Signal<Out, Word<6>>,
    first_bits: Signal<Local, Word<F>>,
    mask: Constant<Word<F>>,
    zero: Constant<Word<F>>,
    places: Constant<Word<6>>,
    _asleep: bool,
}

block! {
    [const F: usize] LeadingStep [F]
    inputs { number, count }
    parts { shifted, late_count, first_bits, mask, zero, places }
    data { }
}

impl<const F: usize> LeadingStep<F> {
    fn new(places: usize) -> Self {
        fields! {
            [number, count, shifted, late_count, first_bits]
            mask: constant(((1 << places) - 1) << (F - places)),
            zero: constant(0),
            places: constant(places as u64),
        }
    }
}

impl<const F: usize> Logic for LeadingStep<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("leading_step");
        self.first_bits.next = self.number.val() & self.mask.val();
        if self.first_bits.val() == self.zero.val() {
            self.shifted.next = self.number.val() << self.places.val();
            self.late_count.next = self.count.val() | self.places.val();
        } else {
            self.shifted.next = self.number.val();
            self.late_count.next = self.count.val();
        }
    }
}

/// Shifts a number to the left until its first bit is one; 0 has no places.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `number` | in | `F` bits |
/// | `shifted` | out | `F` bits, the first of them one |
/// | `places` | out | 6 bits, how far it was shifted |
///
/// Latency 2: the long shifts, then the short ones.
pub struct LeadingOne<const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number.
    pub number: Signal<In, Word<F>>,
    /// The number with a leading one.
    pub shifted: Signal<Out, Word<F>>,
    /// Places it was shifted.
    pub places: Signal<Out, Word<6>>,
    long_steps: Vec<LeadingStep<F>>,
    short_steps: Vec<LeadingStep<F>>,
    halfway: Signal<Local, Word<F>>,
    halfway_count: Signal<Local, Word<6>>,
    complete: Signal<Local, Word<F>>,
    complete_count: Signal<Local, Word<6>>,
    kept_halfway: DFF<Word<F>>,
    kept_halfway_count: DFF<Word<6>>,
    kept: DFF<Word<F>>,
    kept_count: DFF<Word<6>>,
    no_places: Constant<Word<6>>,
    _long: usize,
    _short: usize,
    _asleep: bool,
}

block! {
    [const F: usize] LeadingOne [F]
    inputs { clock, number }
    parts { shifted, places, long_steps, short_steps, halfway, halfway_count, complete, complete_count, kept_halfway,
        kept_halfway_count, kept, kept_count, no_places }
    data { _long, _short }
}

/// The shifts that together make every shift up to `most`, the longer ones and the shorter ones.
pub(super) fn shifts(most: usize) -> (Vec<usize>, Vec<usize>) {
    let count = (most + 1).next_power_of_two().trailing_zeros();
    let shifts: Vec<usize> = (0..count).rev().map(|bit| 1 << bit).collect();
    let (long, short) = shifts.split_at(shifts.len().div_ceil(2));
    (long.to_vec(), short.to_vec())
}

impl<const F: usize> LeadingOne<F> {
    pub(super) fn new() -> Self {
        let (long, short) = shifts(F - 1);
        fields! {
            [clock, number, shifted, places, halfway, halfway_count, complete, complete_count,
                kept_halfway, kept_halfway_count, kept, kept_count]
            _long: long.len(),
            _short: short.len(),
            long_steps: long.into_iter().map(LeadingStep::new).collect(),
            short_steps: short.into_iter().map(LeadingStep::new).collect(),
            no_places: constant(0),
        }
    }
}

impl<const F: usize> Logic for LeadingOne<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("leading_one");
        clock!(
            self,
            clock,
            kept_halfway,
            kept_halfway_count,
            kept,
            kept_count
        );
        self.long_steps[0].number.next = self.number.val();
        self.long_steps[0].count.next = self.no_places.val();
        for i in 1..self._long {
            self.long_steps[i].number.next = self.long_steps[i - 1].shifted.val();
            self.long_steps[i].count.next = self.long_steps[i - 1].late_count.val();
        }
        for i in 0..self._long {
            self.halfway.next = self.long_steps[i].shifted.val();
            self.halfway_count.next = self.long_steps[i].late_count.val();
        }
        self.kept_halfway.d.next = self.halfway.val();
        self.kept_halfway_count.d.next = self.halfway_count.val();
        self.short_steps[0].number.next = self.kept_halfway.q.val();
        self.short_steps[0].count.next = self.kept_halfway_count.q.val();
        for i in 1..self._short {
            self.short_steps[i].number.next = self.short_steps[i - 1].shifted.val();
            self.short_steps[i].count.next = self.short_steps[i - 1].late_count.val();
        }
        for i in 0..self._short {
            self.complete.next = self.short_steps[i].shifted.val();
            self.complete_count.next = self.short_steps[i].late_count.val();
        }
        self.kept.d.next = self.complete.val();
        self.kept_count.d.next = self.complete_count.val();
        self.shifted.next = self.kept.q.val();
        self.places.next = self.kept_count.q.val();
    }
}

clocked!(LeadingOne<const F: usize>);
