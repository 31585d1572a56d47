//! A function by parabolas over equal segments.

use super::delay::WordDelay;
use crate::kernel::*;

/// Bits of the place in a segment.
const PLACE: u32 = 14;

/// Gives `c0 + ((c1 + ((c2 x) >> 14)) x >> 14)`, the coefficients chosen by the segment; shifts round down.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `segment` | in | `A` bits |
/// | `place` | in | 14 bits, `x` |
/// | `value` | out | 24 bits, two's complement |
///
/// The coefficients are constants, chosen by a tree of multiplexers. Latency 5: coefficients, product, sum, product, sum.
pub struct SegmentCurve<const A: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The segment.
    pub segment: Signal<In, Word<A>>,
    /// The place in the segment.
    pub place: Signal<In, Word<14>>,
    /// The value.
    pub value: Signal<Out, Int<24>>,
    node: Vec<Signal<Local, Word<60>>>,
    entry: Vec<Constant<Word<60>>>,
    inner: Vec<Constant<Word<8>>>,
    lower: Vec<Constant<Word<8>>>,
    upper: Vec<Constant<Word<8>>>,
    level: Vec<Constant<Word<8>>>,
    chosen: DFF<Word<60>>,
    place_1: DFF<Word<14>>,
    bend: Signal<Local, Int<18>>,
    wide_place_1: Signal<Local, Word<18>>,
    factor_1: Signal<Local, Int<18>>,
    kept_bend: DFF<Doubled<18>>,
    bend_part: Signal<Local, Int<18>>,
    slope: Signal<Local, Int<18>>,
    slope_2: DFF<Int<18>>,
    kept_slope: DFF<Int<18>>,
    place_2: DFF<Word<14>>,
    place_3: DFF<Word<14>>,
    wide_place_3: Signal<Local, Word<18>>,
    factor_3: Signal<Local, Int<18>>,
    kept_rise: DFF<Doubled<18>>,
    rise_part: Signal<Local, Int<18>>,
    wide_rise: Signal<Local, Int<24>>,
    base: Signal<Local, Int<24>>,
    base_delay: WordDelay<Int<24>>,
    kept_value: DFF<Int<24>>,
    base_at: Constant<Word<8>>,
    slope_at: Constant<Word<8>>,
    places: Constant<Word<8>>,
    _nodes: usize,
    _entries: usize,
    _asleep: bool,
}

block! {
    [const A: usize] SegmentCurve [A]
    inputs { clock, segment, place }
    parts { value, node, entry, inner, lower, upper, level, chosen, place_1, bend, wide_place_1, factor_1, kept_bend,
        bend_part, slope, slope_2, kept_slope, place_2, place_3, wide_place_3, factor_3, kept_rise, rise_part, wide_rise,
        base, base_delay, kept_value, base_at, slope_at, places }
    data { _nodes, _entries }
}

/// Coefficients of the parabola that meets a function at the Chebyshev nodes of each segment; `c0` is half a unit higher for the floors that follow.
fn coefficients(
    function: impl Fn(f64) -> f64,
    segments: u32,
    length: f64,
    fraction: u32,
) -> Vec<[i64; 3]> {
    let unit = f64::from(fraction).exp2();
    let node = 0.75f64.sqrt() / 2.0;
    let parabola = |i: u32| {
        let at = |t: f64| function((f64::from(i) + t) * length);
        let (low, middle, high) = (at(0.5 - node), at(0.5), at(0.5 + node));
        let bend = (low - 2.0 * middle + high) * (8.0 / 3.0);
        let slope = (high - low) / (2.0 * node);
        [
            ((middle - slope / 2.0 + bend / 4.0) * unit + 0.5).round() as i64,
            ((slope - bend) * unit).round() as i64,
            (bend * unit).round() as i64,
        ]
    };
    (0..segments).map(parabola).collect()
}

impl<const A: usize> SegmentCurve<A> {
    /// The curve of a function over `2^A` segments of a length, with `fraction` bits after the point.
    pub(crate) fn new(function: impl Fn(f64) -> f64, length: f64, fraction: u32) -> Self {
        let segments = 1u64 << A;
        let nodes = segments - 1;
        let packed = |[c0, c1, c2]: [i64; 3]| {
            let bits = |value: i64, width: u32| value as u64 & ((1 << width) - 1);
            constant(bits(c0, 24) << 36 | bits(c1, 18) << 18 | bits(c2, 18))
        };
        // The first nodes are the entries; each later one chooses between the next two by the bit of its level.
        let level = |i: u64| A as u64 - 1 - u64::from((nodes - i).ilog2());
        fields! {
            [clock, segment, place, value, chosen, place_1, bend, wide_place_1, factor_1, kept_bend, bend_part, slope,
                slope_2, kept_slope, place_2, place_3, wide_place_3, factor_3, kept_rise, rise_part, wide_rise, base,
                kept_value]
            node: repeat((nodes + segments) as usize, Signal::default),
            entry: coefficients(function, segments as u32, length, fraction)
                .into_iter()
                .map(packed)
                .collect(),
            inner: (segments..segments + nodes).map(constant).collect(),
            lower: (0..nodes).map(|i| constant(2 * i)).collect(),
            upper: (0..nodes).map(|i| constant(2 * i + 1)).collect(),
            level: (0..nodes).map(|i| constant(level(i))).collect(),
            base_delay: WordDelay::new(3),
            base_at: constant(36),
            slope_at: constant(18),
            places: constant(u64::from(PLACE)),
            _nodes: nodes as usize,
            _entries: segments as usize,
        }
    }
}

impl<const A: usize> Logic for SegmentCurve<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("segment_curve");
        clock!(
            self, clock, chosen, place_1, kept_bend, slope_2, kept_slope, place_2, place_3,
            kept_rise, base_delay, kept_value
        );
        for i in 0..self._entries {
            self.node[i].next = self.entry[i].val();
        }
        for i in 0..self._nodes {
            if self.segment.val().get_bit(self.level[i].val().index()) {
                self.node[self.inner[i].val().index()].next =
                    self.node[self.upper[i].val().index()].val();
            } else {
                self.node[self.inner[i].val().index()].next =
                    self.node[self.lower[i].val().index()].val();
            }
            self.chosen.d.next = self.node[self.inner[i].val().index()].val();
        }
        self.place_1.d.next = self.place.val();
        self.bend.next = signed_cast(self.chosen.q.val().get_bits::<18>(0));
        self.wide_place_1.next = bit_cast::<18, 14>(self.place_1.q.val());
        self.factor_1.next = signed_cast(self.wide_place_1.val());
        self.kept_bend.d.next = self.bend.val() * self.factor_1.val();
        self.slope.next = signed_cast(
            self.chosen
                .q
                .val()
                .get_bits::<18>(self.slope_at.val().index()),
        );
        self.slope_2.d.next = self.slope.val();
        self.place_2.d.next = self.place_1.q.val();
        self.bend_part.next = self
            .kept_bend
            .q
            .val()
            .get_bits::<18>(self.places.val().index());
        self.kept_slope.d.next = self.slope_2.q.val() + self.bend_part.val();
        self.place_3.d.next = self.place_2.q.val();
        self.wide_place_3.next = bit_cast::<18, 14>(self.place_3.q.val());
        self.factor_3.next = signed_cast(self.wide_place_3.val());
        self.kept_rise.d.next = self.kept_slope.q.val() * self.factor_3.val();
        self.rise_part.next = self
            .kept_rise
            .q
            .val()
            .get_bits::<18>(self.places.val().index());
        self.wide_rise.next = signed_bit_cast::<24, 18>(self.rise_part.val());
        self.base.next = signed_cast(
            self.chosen
                .q
                .val()
                .get_bits::<24>(self.base_at.val().index()),
        );
        self.base_delay.word.next = self.base.val();
        self.kept_value.d.next = self.base_delay.late.val() + self.wide_rise.val();
        self.value.next = self.kept_value.q.val();
    }
}

clocked!(SegmentCurve<const A: usize>);
