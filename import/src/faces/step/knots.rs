//! Knots and weights of B-spline curves.

use super::args::Args;
use crate::ImportError;

/// The weights of a rational curve.
pub fn weights(args: &Args, count: usize) -> Result<Vec<f64>, ImportError> {
    let weights = args.numbers(0)?;
    if weights.len() != count {
        return Err(args.error(
            format!("{} weights for {count} control points", weights.len()),
            "a weight for every control point is needed",
        ));
    }
    match weights
        .iter()
        .find(|weight| !(1e-9..=1e9).contains(*weight))
    {
        Some(weight) => Err(args.error(
            format!("a weight of {weight}"),
            "weights from 1e-9 to 1e9 are possible",
        )),
        None => Ok(weights),
    }
}

/// Knots as they are written, each as often as it counts.
pub fn written_knots(
    args: &Args,
    first: usize,
    degree: usize,
    count: usize,
) -> Result<Vec<f64>, ImportError> {
    let times = args.wholes(first)?;
    let values = args.numbers(first + 1)?;
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
    let each = values.into_iter().zip(times);
    let knots: Vec<f64> = each
        .flat_map(|(value, times)| std::iter::repeat_n(value, times))
        .collect();
    if knots[degree] >= knots[count] {
        return Err(args.error(
            "its parameter has no range",
            "knots that differ between the first and the last pieces are needed",
        ));
    }
    Ok(knots)
}

/// Knots that follow from the kind of the curve.
pub fn implied_knots(
    args: &Args,
    name: &str,
    degree: usize,
    count: usize,
) -> Result<Vec<f64>, ImportError> {
    let total = count + degree + 1;
    let clamped = |index: usize, last: usize| index.clamp(degree, last) - degree;
    let knot = |index: usize| match name {
        "UNIFORM_CURVE" => index as f64,
        "QUASI_UNIFORM_CURVE" => clamped(index, count) as f64,
        // The joints of the pieces count as often as the degree.
        _ => index.div_ceil(degree).clamp(1, (count - 1) / degree + 1) as f64,
    };
    if name == "BEZIER_CURVE" && !(count - 1).is_multiple_of(degree) {
        return Err(args.error(
            format!("{count} control points for pieces of degree {degree}"),
            "one control point and as many as the degree for every piece are needed",
        ));
    }
    Ok((0..total).map(knot).collect())
}
