//! Vector shifted to full words.

use super::leading_one::shifts;
use crate::kernel::*;

/// Shifts a vector by `places` to the left if no component needs the bits.
pub struct VectorStep<const N: usize> {
    /// Component x.
    pub x: Signal<In, Word<N>>,
    /// Component y.
    pub y: Signal<In, Word<N>>,
    /// Component z.
    pub z: Signal<In, Word<N>>,
    /// The bits that a component needs, below the sign.
    pub magnitude: Signal<In, Word<N>>,
    /// Places shifted before.
    pub count: Signal<In, Word<6>>,
    /// Component x, shifted or not.
    pub late_x: Signal<Out, Word<N>>,
    /// Component y, shifted or not.
    pub late_y: Signal<Out, Word<N>>,
    /// Component z, shifted or not.
    pub late_z: Signal<Out, Word<N>>,
    /// The magnitude, shifted or not.
    pub late_magnitude: Signal<Out, Word<N>>,
    /// Places shifted so far.
    pub late_count: Signal<Out, Word<6>>,
    first_bits: Signal<Local, Word<N>>,
    mask: Constant<Word<N>>,
    zero: Constant<Word<N>>,
    places: Constant<Word<6>>,
    _asleep: bool,
}

block! {
    [const N: usize] VectorStep [N]
    inputs { x, y, z, magnitude, count }
    parts { late_x, late_y, late_z, late_magnitude, late_count, first_bits, mask, zero, places }
    data { }
}

impl<const N: usize> VectorStep<N> {
    fn new(places: usize) -> Self {
        fields! {
            [x, y, z, magnitude, count, late_x, late_y, late_z, late_magnitude, late_count, first_bits]
            mask: constant(((1 << places) - 1) << (N - 1 - places)),
            zero: constant(0),
            places: constant(places as u64),
        }
    }
}

impl<const N: usize> Logic for VectorStep<N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("vector_step");
        self.first_bits.next = self.magnitude.val() & self.mask.val();
        if self.first_bits.val() == self.zero.val() {
            self.late_x.next = self.x.val() << self.places.val();
            self.late_y.next = self.y.val() << self.places.val();
            self.late_z.next = self.z.val() << self.places.val();
            self.late_magnitude.next = self.magnitude.val() << self.places.val();
            self.late_count.next = self.count.val() | self.places.val();
        } else {
            self.late_x.next = self.x.val();
            self.late_y.next = self.y.val();
            self.late_z.next = self.z.val();
            self.late_magnitude.next = self.magnitude.val();
            self.late_count.next = self.count.val();
        }
    }
}

/// Bits that a component needs below its sign: those that differ from the sign.
pub struct NeededBits<const N: usize> {
    /// The component.
    pub part: Signal<In, Word<N>>,
    /// The bits.
    pub magnitude: Signal<Out, Word<N>>,
    sign: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const N: usize] NeededBits [N]
    inputs { part }
    parts { magnitude, sign }
    data { }
}

impl<const N: usize> NeededBits<N> {
    fn new() -> Self {
        fields! {
            [part, magnitude]
            sign: constant(N as u64 - 1),
        }
    }
}

impl<const N: usize> Logic for NeededBits<N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("needed_bits");
        if self.part.val().get_bit(self.sign.val().index()) {
            self.magnitude.next = !self.part.val();
        } else {
            self.magnitude.next = self.part.val();
        }
    }
}

/// Shifts a vector to the left until its longest component fills its word, by `N - 2` places at most; the zero vector stays.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `x`, `y`, `z` | in | `N` bits, two's complement |
/// | `shifted_x`, `shifted_y`, `shifted_z` | out | `N` bits, two's complement |
/// | `places` | out | 6 bits, how far it was shifted |
///
/// Latency 2: the long shifts, then the short ones.
pub struct VectorNormaliser<const N: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Component x.
    pub x: Signal<In, Int<N>>,
    /// Component y.
    pub y: Signal<In, Int<N>>,
    /// Component z.
    pub z: Signal<In, Int<N>>,
    /// Component x in a full word.
    pub shifted_x: Signal<Out, Int<N>>,
    /// Component y in a full word.
    pub shifted_y: Signal<Out, Int<N>>,
    /// Component z in a full word.
    pub shifted_z: Signal<Out, Int<N>>,
    /// Places it was shifted.
    pub places: Signal<Out, Word<6>>,
    needed: Vec<NeededBits<N>>,
    magnitude: Signal<Local, Word<N>>,
    long_steps: Vec<VectorStep<N>>,
    short_steps: Vec<VectorStep<N>>,
    halfway_x: Signal<Local, Word<N>>,
    halfway_y: Signal<Local, Word<N>>,
    halfway_z: Signal<Local, Word<N>>,
    halfway_magnitude: Signal<Local, Word<N>>,
    halfway_count: Signal<Local, Word<6>>,
    complete_x: Signal<Local, Word<N>>,
    complete_y: Signal<Local, Word<N>>,
    complete_z: Signal<Local, Word<N>>,
    complete_count: Signal<Local, Word<6>>,
    kept_halfway_x: DFF<Word<N>>,
    kept_halfway_y: DFF<Word<N>>,
    kept_halfway_z: DFF<Word<N>>,
    kept_halfway_magnitude: DFF<Word<N>>,
    kept_halfway_count: DFF<Word<6>>,
    kept_x: DFF<Word<N>>,
    kept_y: DFF<Word<N>>,
    kept_z: DFF<Word<N>>,
    kept_count: DFF<Word<6>>,
    one: Constant<Word<N>>,
    no_places: Constant<Word<6>>,
    _long: usize,
    _short: usize,
    _asleep: bool,
}

block! {
    [const N: usize] VectorNormaliser [N]
    inputs { clock, x, y, z }
    parts { shifted_x, shifted_y, shifted_z, places, needed, magnitude, long_steps, short_steps, halfway_x, halfway_y,
        halfway_z, halfway_magnitude, halfway_count, complete_x, complete_y, complete_z, complete_count, kept_halfway_x,
        kept_halfway_y, kept_halfway_z, kept_halfway_magnitude, kept_halfway_count, kept_x, kept_y, kept_z, kept_count,
        one, no_places }
    data { _long, _short }
}

impl<const N: usize> VectorNormaliser<N> {
    pub(crate) fn new() -> Self {
        let (long, short) = shifts(N - 2);
        fields! {
            [clock, x, y, z, shifted_x, shifted_y, shifted_z, places, magnitude, halfway_x, halfway_y, halfway_z,
                halfway_magnitude, halfway_count, complete_x, complete_y, complete_z, complete_count, kept_halfway_x,
                kept_halfway_y, kept_halfway_z, kept_halfway_magnitude, kept_halfway_count, kept_x, kept_y, kept_z,
                kept_count]
            _long: long.len(),
            _short: short.len(),
            needed: repeat(3, NeededBits::new),
            long_steps: long.into_iter().map(VectorStep::new).collect(),
            short_steps: short.into_iter().map(VectorStep::new).collect(),
            one: constant(1),
            no_places: constant(0),
        }
    }
}

impl<const N: usize> Logic for VectorNormaliser<N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("vector_normaliser");
        clock!(
            self,
            clock,
            kept_halfway_x,
            kept_halfway_y,
            kept_halfway_z,
            kept_halfway_magnitude,
            kept_halfway_count,
            kept_x,
            kept_y,
            kept_z,
            kept_count
        );
        self.needed[0].part.next = unsigned_cast(self.x.val());
        self.needed[1].part.next = unsigned_cast(self.y.val());
        self.needed[2].part.next = unsigned_cast(self.z.val());
        self.magnitude.next = ((self.needed[0].magnitude.val() | self.needed[1].magnitude.val())
            | self.needed[2].magnitude.val())
            | self.one.val();
        self.long_steps[0].x.next = unsigned_cast(self.x.val());
        self.long_steps[0].y.next = unsigned_cast(self.y.val());
        self.long_steps[0].z.next = unsigned_cast(self.z.val());
        self.long_steps[0].magnitude.next = self.magnitude.val();
        self.long_steps[0].count.next = self.no_places.val();
        for i in 1..self._long {
            self.long_steps[i].x.next = self.long_steps[i - 1].late_x.val();
            self.long_steps[i].y.next = self.long_steps[i - 1].late_y.val();
            self.long_steps[i].z.next = self.long_steps[i - 1].late_z.val();
            self.long_steps[i].magnitude.next = self.long_steps[i - 1].late_magnitude.val();
            self.long_steps[i].count.next = self.long_steps[i - 1].late_count.val();
        }
        for i in 0..self._long {
            self.halfway_x.next = self.long_steps[i].late_x.val();
            self.halfway_y.next = self.long_steps[i].late_y.val();
            self.halfway_z.next = self.long_steps[i].late_z.val();
            self.halfway_magnitude.next = self.long_steps[i].late_magnitude.val();
            self.halfway_count.next = self.long_steps[i].late_count.val();
        }
        self.kept_halfway_x.d.next = self.halfway_x.val();
        self.kept_halfway_y.d.next = self.halfway_y.val();
        self.kept_halfway_z.d.next = self.halfway_z.val();
        self.kept_halfway_magnitude.d.next = self.halfway_magnitude.val();
        self.kept_halfway_count.d.next = self.halfway_count.val();
        self.short_steps[0].x.next = self.kept_halfway_x.q.val();
        self.short_steps[0].y.next = self.kept_halfway_y.q.val();
        self.short_steps[0].z.next = self.kept_halfway_z.q.val();
        self.short_steps[0].magnitude.next = self.kept_halfway_magnitude.q.val();
        self.short_steps[0].count.next = self.kept_halfway_count.q.val();
        for i in 1..self._short {
            self.short_steps[i].x.next = self.short_steps[i - 1].late_x.val();
            self.short_steps[i].y.next = self.short_steps[i - 1].late_y.val();
            self.short_steps[i].z.next = self.short_steps[i - 1].late_z.val();
            self.short_steps[i].magnitude.next = self.short_steps[i - 1].late_magnitude.val();
            self.short_steps[i].count.next = self.short_steps[i - 1].late_count.val();
        }
        for i in 0..self._short {
            self.complete_x.next = self.short_steps[i].late_x.val();
            self.complete_y.next = self.short_steps[i].late_y.val();
            self.complete_z.next = self.short_steps[i].late_z.val();
            self.complete_count.next = self.short_steps[i].late_count.val();
        }
        self.kept_x.d.next = self.complete_x.val();
        self.kept_y.d.next = self.complete_y.val();
        self.kept_z.d.next = self.complete_z.val();
        self.kept_count.d.next = self.complete_count.val();
        self.shifted_x.next = signed_cast(self.kept_x.q.val());
        self.shifted_y.next = signed_cast(self.kept_y.q.val());
        self.shifted_z.next = signed_cast(self.kept_z.q.val());
        self.places.next = self.kept_count.q.val();
    }
}

clocked!(VectorNormaliser<const N: usize>);
