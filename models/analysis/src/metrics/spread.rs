//! What is kept of many magnitudes.

use serde::{Deserialize, Serialize};

/// Greatest, 99.9 % quantile, mean and root mean square; all zero of no values. The keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// How many values.
    pub count: usize,
    /// The greatest.
    pub max: f64,
    /// The least value that 99.9 % of all do not exceed.
    pub quantile_999: f64,
    /// Mean.
    pub mean: f64,
    /// Root of the mean square.
    pub rms: f64,
}

/// One class of a histogram; the keys are stable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Class {
    /// The values are below this, a power of two, and not below the last class's.
    pub below: f64,
    /// How many.
    pub count: usize,
}

impl Spread {
    /// Of magnitudes in any order.
    pub fn of(mut values: Vec<f64>) -> Spread {
        if values.is_empty() {
            return Spread::default();
        }
        let count = values.len();
        let sum: f64 = values.iter().sum();
        let squares: f64 = values.iter().map(|v| v * v).sum();
        // In whole numbers: ceil(0.999 n), counted from 1.
        let rank = (count * 999).div_ceil(1000);
        let (_, quantile, above) = values.select_nth_unstable_by(rank - 1, f64::total_cmp);
        Spread {
            count,
            max: above.iter().copied().fold(*quantile, f64::max),
            quantile_999: *quantile,
            mean: sum / count as f64,
            rms: (squares / count as f64).sqrt(),
        }
    }

    /// The same values in another unit.
    pub fn divided(self, by: f64) -> Spread {
        Spread {
            count: self.count,
            max: self.max / by,
            quantile_999: self.quantile_999 / by,
            mean: self.mean / by,
            rms: self.rms / by,
        }
    }
}

/// Power of two below which all small values are one class.
const FINEST: i32 = -3;

/// Magnitudes by powers of two, from those below 1/8 up to the class of the greatest.
pub fn histogram(values: &[f64]) -> Vec<Class> {
    let mut classes: Vec<Class> = vec![];
    let greatest = values.iter().copied().fold(0.0, f64::max);
    let (mut from, mut below) = (0.0, f64::from(FINEST).exp2());
    loop {
        let count = values.iter().filter(|v| (from..below).contains(*v)).count();
        classes.push(Class { below, count });
        if greatest < below {
            return classes;
        }
        (from, below) = (below, below * 2.0);
    }
}
