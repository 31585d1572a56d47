//! Functions by parabolas over equal segments.

/// A function of one argument: `c0 + (c1 + c2 x) x` in each of `2^n` segments, `x` the place in the segment.
#[derive(Clone, Debug)]
pub struct Curve {
    place: u32,
    coefficients: Vec<[i64; 3]>,
}

impl Curve {
    /// The curve of `function` over `0 .. 2^n * length` in `2^n` segments, with `place` bits of place and `fraction`
    /// bits after the point.
    ///
    /// A parabola meets the function at the three Chebyshev nodes of its segment; `c0` is half a unit higher for the
    /// floors that follow.
    pub fn new(
        function: impl Fn(f64) -> f64,
        n: u32,
        length: f64,
        place: u32,
        fraction: u32,
    ) -> Curve {
        let unit = f64::from(fraction).exp2();
        let node = 0.75f64.sqrt() / 2.0;
        let segment = |i: u32| {
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
        Curve {
            place,
            coefficients: (0..1 << n).map(segment).collect(),
        }
    }

    /// The value at an argument: the number of the segment, and below it the bits of the place.
    pub fn value(&self, argument: u64) -> i64 {
        let [c0, c1, c2] = self.coefficients[(argument >> self.place) as usize];
        let x = (argument & ((1 << self.place) - 1)) as i64;
        let slope = c1 + ((c2 * x) >> self.place);
        c0 + ((slope * x) >> self.place)
    }
}
