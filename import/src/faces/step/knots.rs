//! Knots and weights of B-spline curves and surfaces.

use step21::{Args, Result};

/// Weights of control points, checked.
pub fn weights(args: &Args, weights: Vec<f64>, count: usize) -> Result<Vec<f64>> {
    if weights.len() != count {
        let problem = format!("{} weights for {count} control points", weights.len());
        return Err(args.error(problem, "a weight for every control point is needed"));
    }
    if let Some(weight) = weights.iter().find(|w| !(1e-9..=1e9).contains(*w)) {
        let problem = format!("a weight of {weight}");
        return Err(args.error(problem, "weights from 1e-9 to 1e9 are possible"));
    }
    Ok(weights)
}

/// Knots as they are written, each as often as it counts; at these two places are the multiplicities and the knots.
pub fn written_knots(
    args: &Args,
    places: [usize; 2],
    degree: usize,
    count: usize,
) -> Result<Vec<f64>> {
    let times = args.wholes(places[0])?;
    let values = args.numbers(places[1])?;
    let total: usize = times.iter().sum();
    let rising = values.windows(2).all(|pair| pair[0] < pair[1]);
    let bounded = values.iter().all(|value| value.abs() <= 1e15);
    let possible = times.iter().all(|times| (1..=degree + 1).contains(times));
    if times.len() != values.len()
        || total != count + degree + 1
        || !(rising && bounded && possible)
    {
        return Err(args.error(
            format!(
                "{} knots, {total} with their multiplicities, for {count} control points of degree {degree}",
                values.len()
            ),
            "as many rising knots as multiplicities are needed, none above the degree and one, and together a knot for every control point and the degree and one more",
        ));
    }
    let repeated = |(value, times)| std::iter::repeat_n(value, times);
    let knots: Vec<f64> = values.into_iter().zip(times).flat_map(repeated).collect();
    if knots[degree] >= knots[count] {
        let accepted = "knots that differ between the first and the last pieces are needed";
        return Err(args.error("its parameter has no range", accepted));
    }
    Ok(knots)
}

/// Knots that follow from the kind of the curve or surface.
pub fn implied_knots(args: &Args, name: &str, degree: usize, count: usize) -> Result<Vec<f64>> {
    let total = count + degree + 1;
    let clamped = |index: usize, last: usize| index.clamp(degree, last) - degree;
    let is = |kind: &str| name.starts_with(kind);
    let knot = |index: usize| match name {
        _ if is("UNIFORM") => index as f64,
        _ if is("QUASI_UNIFORM") => clamped(index, count) as f64,
        // The joints of the pieces count as often as the degree.
        _ => index.div_ceil(degree).clamp(1, (count - 1) / degree + 1) as f64,
    };
    if is("BEZIER") && !(count - 1).is_multiple_of(degree) {
        let problem = format!("{count} control points for pieces of degree {degree}");
        let accepted = "one control point and as many as the degree for every piece are needed";
        return Err(args.error(problem, accepted));
    }
    Ok((0..total).map(knot).collect())
}
