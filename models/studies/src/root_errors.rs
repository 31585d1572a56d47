//! Measured error and cost of every member of the family, for the table of `docs/root-network.md`.

use imogene_analysis::metrics::Spread;
use imogene_golden::format::Format;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_golden::unit::root::{Method, root, root_length};
use rayon::prelude::*;
use serde::Serialize;

/// Places per octave of the radicand at which the error is measured, evenly spaced from the octave's first radicand on.
/// The spacing is odd, so that the lower bits, on which the floors depend, take all values.
const PLACES: u128 = 1 << 13;

/// One row of the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RootRow {
    /// The member.
    pub method: Method,
    /// Its name for a reader.
    pub label: String,
    /// Root and remainder are those of the definition on every radicand.
    pub exact: bool,
    /// Error against the true square root.
    pub error: RootError,
    /// Steps between neighbouring radicands.
    pub steps: Steps,
    /// Depth of the test sphere; the base format only, whose words the sphere is given in.
    pub sphere: Option<DepthError>,
    /// What it is built of.
    pub cost: Cost,
}

/// Error against the true square root over the upper half of the radicand's octaves, each octave of the same weight.
/// The floor of the exact root is below 1 in the last place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct RootError {
    /// Greatest, in the last place of the root.
    pub max_lsb: f64,
    /// Mean of the absolute values, in the last place.
    pub mean_lsb: f64,
    /// Root mean square, in the last place.
    pub rms_lsb: f64,
    /// Greatest, in percent of the root.
    pub max_percent: f64,
    /// Mean of the absolute values, in percent of the root.
    pub mean_percent: f64,
}

/// Steps of the root between radicands X - 1 and X: measured places, and where a scaled argument begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Steps {
    /// No step down was found.
    pub monotone: bool,
    /// Greatest step in either direction; the exact root's is 1.
    pub largest: u64,
}

/// Error of the front depth of the test sphere against the depth in real numbers, in pixels of depth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct DepthError {
    /// Covered pixels.
    pub pixels: u64,
    /// Greatest, in depth words.
    pub max_counts: f64,
    /// Greatest.
    pub max_px: f64,
    /// Mean.
    pub mean_px: f64,
}

/// What a member is built of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Cells of adders, subtractors and controlled subtractors: one for each live bit of each sum, besides multipliers
    /// and shifters.
    pub adder_cells: u32,
    /// 16 x 16 multipliers.
    pub multipliers: u32,
    /// Shifters by a variable count.
    pub shifters: u32,
    /// Clocks from radicand to root, at one row per register stage.
    pub latency: u32,
    /// Clocks from one result to the next.
    pub interval: u32,
}

/// The members in the order of the table.
pub fn family(format: &Format) -> Vec<Method> {
    let mut family = vec![Method::Restoring, Method::NonRestoring, Method::Iterative];
    family.extend([0, 1, 2].map(|corrections| Method::Linear { corrections }));
    family.extend([0, 1, 2].map(|corrections| Method::Quadratic { corrections }));
    let kept = [6, 8, 10, 12, 14, 16, 20, 24];
    let kept = kept.into_iter().filter(|kept| *kept < format.root);
    family.extend(kept.clone().map(|kept| Method::Rows { kept }));
    family.extend(kept.map(|kept| Method::Leading { kept }));
    family
}

/// The measured table of the family at the widths of a format.
pub fn table(format: &Format) -> Vec<RootRow> {
    let row = |method: Method| RootRow {
        method,
        label: method.to_string(),
        exact: method.is_exact(),
        error: error(method, format.root),
        steps: steps(method, format.root),
        sphere: (*format == Format::BASE).then(|| sphere(method)),
        cost: cost(method, format.root),
    };
    family(format).into_par_iter().map(row).collect()
}

/// Radicands of the upper half of the octaves, from `root_bits` to `2 root_bits` significant bits.
fn places(root_bits: u32) -> impl Iterator<Item = u128> {
    (root_bits - 1..2 * root_bits).flat_map(|octave| {
        let first = 1u128 << octave;
        let step = ((first - 1) / PLACES).max(1);
        (0..PLACES.min(first)).map(move |place| first + place * step)
    })
}

/// The measured error of a member with roots of so many bits.
pub fn error(method: Method, root_bits: u32) -> RootError {
    let off = |radicand: u128| {
        let truth = (radicand as f64).sqrt();
        let off = (root(method, radicand, root_bits).root as f64 - truth).abs();
        (off, 100.0 * off / truth)
    };
    let (lsb, percent) = places(root_bits).map(off).unzip();
    let (lsb, percent) = (Spread::of(lsb), Spread::of(percent));
    RootError {
        max_lsb: lsb.max,
        mean_lsb: lsb.mean,
        rms_lsb: lsb.rms,
        max_percent: percent.max,
        mean_percent: percent.mean,
    }
}

fn steps(method: Method, root_bits: u32) -> Steps {
    let value = |radicand| root(method, radicand, root_bits).root;
    let mut found = Steps {
        monotone: true,
        largest: 0,
    };
    for place in places(root_bits) {
        let scaled = place >> root_length(place) << root_length(place);
        for radicand in [place, scaled] {
            let (before, after) = (value(radicand - 1), value(radicand));
            found.monotone &= before <= after;
            found.largest = found.largest.max(before.abs_diff(after));
        }
    }
    found
}

/// The f1, in depth words, of the test sphere of the source's restatement, 4.3: centre (20, -10, 300), radius 100,
/// viewer distance 1000, 720 x 540 pixels.
pub const F1: Linear = Linear::new(-100, 50, 1_921_817);
/// Its f2, in squares of depth words.
pub const F2: Quadratic = Quadratic::new([
    -41_863_718,
    -41_871_193,
    -9_967,
    31_440_272_584,
    21_966_180_078,
    -8_533_734_878_403,
]);
const COLUMNS: i64 = 720;
const LINES: i64 = 540;
/// Depth words per pixel of depth, `Kp = (2^23 - 1) / 1000`.
pub const WORDS_PER_PIXEL: f64 = 8_388.607;

/// Front depth in real numbers, in depth words: the near root of the transformed equation of the sphere.
fn true_depth(column: i64, line: i64) -> f64 {
    let (x, y) = ((column - COLUMNS / 2) as f64, (line - LINES / 2) as f64);
    let square = 3361.0 / 2000.0;
    let half = x / 50.0 - y / 100.0 - 761.0 / 2.0;
    let rest = x * x + y * y - 40.0 * x + 20.0 * y + 80_500.0;
    let middle = -half / square;
    let radicand = middle * middle - rest / square;
    WORDS_PER_PIXEL * (middle - radicand.max(0.0).sqrt())
}

/// The depth error of a member on the test sphere, at the base format.
pub fn sphere(method: Method) -> DepthError {
    let mut found = DepthError::default();
    for line in 0..LINES {
        for column in 0..COLUMNS {
            let radicand = F2.wrapped_at(column, line, Format::BASE.quadratic);
            if radicand < 0 {
                continue;
            }
            let f1 = F1.wrapped_at(column, line, Format::BASE.sum);
            let root = root(method, radicand as u128, Format::BASE.root).root;
            let off = ((f1 - i128::from(root)) as f64 - true_depth(column, line)).abs();
            found.pixels += 1;
            found.max_counts = found.max_counts.max(off);
            found.mean_px += off / WORDS_PER_PIXEL;
        }
    }
    found.mean_px /= found.pixels as f64;
    found.max_px = found.max_counts / WORDS_PER_PIXEL;
    found
}

/// Cells of the first rows: row k subtracts k + 2 bits, the first 2.
fn row_cells(rows: u32) -> u32 {
    (rows * (rows + 5) / 2).saturating_sub(1)
}

/// Products of 15-bit digits, each pair once, of a square; a top digit of one or two bits is gates.
fn square_products(bits: u32) -> u32 {
    let digits = bits.div_ceil(15);
    let digits = digits - u32::from(bits % 15 <= 2);
    digits * (digits + 1) / 2
}

/// What a member with roots of so many bits is built of.
pub fn cost(method: Method, root_bits: u32) -> Cost {
    // The excess, and what it takes from the root.
    let cells_of = |corrections: u32| corrections * (2 * root_bits + root_bits + 1);
    let products_of = |corrections: u32| corrections * square_products(root_bits + 1);
    let (adder_cells, multipliers, shifters) = match method {
        Method::Restoring => (row_cells(root_bits), 0, 0),
        // The remainder's last addition besides the rows.
        Method::NonRestoring => (row_cells(root_bits) + root_bits + 1, 0, 0),
        Method::Iterative => (root_bits + 2, 0, 0),
        Method::Rows { kept } => (row_cells(kept), 0, 0),
        // The first digit takes no row.
        Method::Leading { kept } => (row_cells(kept) - row_cells(1), 0, 2),
        Method::Linear { corrections } => {
            let cells = root_bits + cells_of(corrections);
            (cells, products_of(corrections), 1 + corrections)
        }
        Method::Quadratic { corrections } => {
            // 15 A, 15 times the rest of X, two sums of 15 R; the fifteenth: two parts of ones, the sum of parts and
            // their joining.
            let estimate = 4 * (root_bits + 4) + 8 * 24;
            let products = square_products(root_bits) + products_of(corrections);
            (estimate + cells_of(corrections), products, 3 + corrections)
        }
    };
    Cost {
        adder_cells,
        multipliers,
        shifters,
        latency: method.latency(root_bits, 1),
        interval: match method {
            Method::Iterative => root_bits,
            _ => 1,
        },
    }
}
