//! One random case: exact expressions, the words they are rounded to, and the bounds that are stated for these words.
//!
//! Any first-degree f1 and second-degree f2 are the two parts of the depth of a quadric, `z^2 - 2 f1 z + f1^2 - f2 =
//! 0`; so the expressions are drawn themselves, at the scales and in the positions where errors are greatest.

use super::exact::{ExactLinear, ExactQuadratic, draw_linear, draw_quadratic, reach_of, rounded};
use super::random::Random;
use imogene_algebra::rational::to_f64_up;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_prepare::RoundingBounds;
use imogene_prepare::forms::{LinearForm, QuadraticForm};
use imogene_prepare::rounding::{Anchor, linear_error, quadratic_error};

const MOST_PIXELS: u64 = 1 << 10;

/// Exact normal: `N_k = g_k -+ K_k s / 2^(shift + 6)`.
pub struct ExactNormal {
    /// Linear parts, in last bits.
    pub g: [ExactLinear; 3],
    /// Numerators of the factors.
    pub k: [i128; 3],
    /// Their denominator.
    pub denominator: i128,
}

/// One case. Exact expressions are in units of the last guard bit, in coordinates centred on the anchor.
pub struct Case {
    /// The widths of the words.
    pub format: Format,
    /// Pixel about which is rounded.
    pub anchor: Anchor,
    /// The box in coordinates centred on the anchor.
    pub reach: ScreenBox,
    /// Middle of both depths.
    pub f1: ExactLinear,
    /// Square of half their difference.
    pub f2: ExactQuadratic,
    /// The normal.
    pub normal: ExactNormal,
    /// What the machine is loaded with.
    pub words: QuadricWords,
    /// What is stated about these words.
    pub bounds: RoundingBounds,
    /// A pixel, centred on the anchor, on which the computed silhouette lies exactly.
    pub on_silhouette: Option<(i64, i64)>,
}

impl Case {
    /// A random case in a format.
    pub fn draw(format: &Format, random: &mut Random) -> Case {
        let (window, anchor, reach) = draw_box(most_pixels(format), random);
        let f1 = draw_linear(format, &reach, random);
        let (f2, on_silhouette) = draw_quadratic(format, &reach, random);
        let root_bits = root_bits(&f2, &reach, format);
        let (normal, shift) = draw_normal(format, root_bits, &reach, random);
        let placed = |exact: &ExactLinear| exact.words().from_zone(-anchor.x, -anchor.y);
        let words = QuadricWords {
            class: Class::Side,
            screen_box: window,
            f1: placed(&f1),
            f2: f2.words().from_zone(-anchor.x, -anchor.y),
            normal: NormalWords {
                g: normal.g.each_ref().map(placed),
                k: normal.k.map(|k| rounded(k, normal.denominator) as i16),
                shift,
            },
            planes: vec![],
        };
        // As the preparation states them, in last bits without guard bits.
        let unit = |guards: u32| 0.5f64.powi(guards as i32);
        let linear = |exact: &ExactLinear| {
            let form = LinearForm::of_array(exact.form());
            to_f64_up(&linear_error(&exact.words(), &form, 0, &reach))
        };
        let form = QuadraticForm::of_array(f2.form());
        let quadratic = to_f64_up(&quadratic_error(&f2.words(), &form, 0, &reach));
        let bounds = RoundingBounds {
            f1: linear(&f1) * unit(format.guard_linear),
            f2: quadratic * unit(format.guard_quadratic),
            normal: normal.g.iter().map(linear).fold(0.0, f64::max),
            ..RoundingBounds::of_format(format)
        };
        Case {
            format: *format,
            anchor,
            reach,
            f1,
            f2,
            normal,
            words,
            bounds,
            on_silhouette,
        }
    }

    /// The pixel of the screen at a place centred on the anchor.
    pub fn pixel(&self, (u, v): (i64, i64)) -> (i64, i64) {
        (u + self.anchor.x, v + self.anchor.y)
    }
}

/// Most pixels of a box along each side in a format: roundings stay a small part of the words, or the preparation would
/// refuse most objects. Words of the catalogue are long enough for all boxes.
fn most_pixels(format: &Format) -> u64 {
    let fits = |most: &u64| {
        let side = (most / 2) as i64;
        let reach = ScreenBox::of([-side, side], [-side, side]);
        let word = |bits: u32| f64::exp2(f64::from(bits));
        Anchor::ORIGIN.linear_bound(&reach) <= 0.05 * word(format.depth + format.guard_linear)
            && Anchor::ORIGIN.quadratic_bound(&reach) <= 0.1 * word(format.pe2_width() - 1)
    };
    let sides = (0..=MOST_PIXELS.ilog2()).map(|power| MOST_PIXELS >> power);
    sides.into_iter().find(fits).unwrap_or(1)
}

fn draw_box(most: u64, random: &mut Random) -> (ScreenBox, Anchor, ScreenBox) {
    // All magnitudes of boxes alike.
    let mut side = || {
        let limit = (most >> (random.bits() % 10)).max(1);
        random.below(limit) as i64
    };
    let (width, height) = (side(), side());
    let (x0, y0) = (random.between(0, 2047), random.between(0, 2047));
    let (columns, lines) = ([x0, x0 + width], [y0, y0 + height]);
    let window = ScreenBox::of(columns, lines);
    let anchor = Anchor::middle_of(&window);
    let reach = ScreenBox::of(columns.map(|x| x - anchor.x), lines.map(|y| y - anchor.y));
    (window, anchor, reach)
}

/// Bits of the greatest root of the rounded f2: where the exact one is tiny, rounding makes most of it.
fn root_bits(f2: &ExactQuadratic, reach: &ScreenBox, format: &Format) -> u32 {
    let rounded = ExactQuadratic {
        factors: f2.rounded(),
        denominator: 1,
    };
    let most = reach_of(&rounded, reach) + 1;
    let root = ((most >> format.guard_quadratic) as f64).sqrt() + 2.0;
    64 - (root as u64).leading_zeros()
}

/// A normal within its words (24 bits in the base format), with factors as great as that allows.
fn draw_normal(
    format: &Format,
    root_bits: u32,
    reach: &ScreenBox,
    random: &mut Random,
) -> (ExactNormal, u8) {
    // A factor of the normal, and the root it is multiplied with, have one bit less than a component.
    let shift = root_bits.saturating_sub(format.normal - 1);
    let shifted_bits = root_bits - shift;
    // In the base format the product with the root is at most 2^21, the linear part at most 2^22.
    let product_bits = format.normal_linear - 3;
    let room = product_bits + format.product_fraction() - shifted_bits;
    let factor_limit = f64::from(format.greatest_normal()).min(f64::exp2(f64::from(room)));
    let denominator = 1 + i128::from(random.below(1 << 20));
    let size = random.magnitude(1.0, 8);
    let spread = (reach.x1 - reach.x0 + reach.y1 - reach.y0 + 1) as f64;
    let mut part = |limit: f64| (random.signed() * limit * denominator as f64) as i128;
    let limit = size * f64::from(1 << product_bits);
    let g = [(); 3].map(|()| ExactLinear {
        factors: [part(limit / spread), part(limit / spread), part(limit)],
        denominator,
    });
    let k = [(); 3].map(|()| part(size * factor_limit));
    let normal = ExactNormal { g, k, denominator };
    (normal, shift as u8)
}
