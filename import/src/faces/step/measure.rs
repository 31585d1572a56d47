//! What all points of a file say of its digits and its extent.

use step21::{Exchange, Kind};

/// Coordinates with fewer decimals than this are taken for exact: a round number says nothing of how numbers are
/// rounded.
const FEWEST_DECIMALS: usize = 5;

/// What is known of the coordinates of a file, in its units of length.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measure {
    /// The last digit of its coordinates: 0.000001 if none has more than six decimals; 0 if all have so few that they
    /// may be exact.
    pub last_digit: f64,
    /// The greatest difference of two coordinates along an axis.
    pub extent: f64,
}

impl Measure {
    pub fn of(file: &Exchange) -> Measure {
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let mut most = 0;
        for point in file.all(&["CARTESIAN_POINT"]).filter(|p| !p.entity.complex) {
            for ([low, high], value) in bounds.iter_mut().zip(point.list(1).unwrap_or_default()) {
                if let Kind::Number(value, _) = value.kind {
                    (*low, *high) = (low.min(value), high.max(value));
                }
            }
            let text = &file.bytes[point.entity.at..];
            let end = text.iter().position(|b| *b == b';').unwrap_or(text.len());
            most = most.max(decimals(&text[..end]));
        }
        let extents = bounds.map(|[low, high]| high - low);
        let digits = Some(most).filter(|most| *most >= FEWEST_DECIMALS);
        Measure {
            last_digit: digits.map_or(0.0, |most| 10_f64.powi(-(most as i32))),
            extent: extents.into_iter().fold(0.0, f64::max),
        }
    }
}

/// The most decimals in a text of coordinates; those of numbers with an exponent say nothing.
fn decimals(text: &[u8]) -> usize {
    let after = text.split(|byte| *byte == b'.').skip(1);
    let digits = after.map(|after| {
        let digits = after.iter().take_while(|b| b.is_ascii_digit()).count();
        let exponent = matches!(after.get(digits), Some(b'E' | b'e'));
        if exponent { 0 } else { digits }
    });
    digits.max().unwrap_or(0)
}
