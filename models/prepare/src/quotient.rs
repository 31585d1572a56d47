//! A quadric whose depth is a quotient: the eye lies on it, or looks along an asymptotic direction (thesis
//! section 2.1.1: c' = 0).
//!
//! The equation on the screen is then `2 B z + T = 0` with B of first and T of second degree. Numerator and
//! denominator share a scale that is free, so each fills half of its word. A quadric that passes the eye so closely
//! that one of its depths leaves the words of roots is drawn in the same way, with a root in its denominator.

use super::context::{Context, Quotients};
use super::error::PrepareError;
use super::forms::{LinearForm, QuadraticForm};
use super::ledger::Ledger;
use super::object::normals;
use super::prepared::PreparedParts;
use super::projected::{Projected, Subject};
use super::rounding::{linear_error, quadratic_error, round_linear, round_quadratic};
use imogene_algebra::rational::{
    floor, from_f64_exact, integer, power_of_two, round_half_up, to_f64_up,
};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::quotient::{QuotientRoot, QuotientWidths, QuotientWords, widths};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_golden::unit::normal::NormalWords;
use imogene_scene::Surface;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// Is there a processor for a quotient? Its widths follow from the depth word.
fn is_possible(context: &Context, processors: &[Quotients]) -> bool {
    context.format.follows_depth_word() && processors.contains(&context.options.quotients)
}

/// Is the depth of an object exactly a quotient that a processor draws?
pub(super) fn is_on_eye(subject: Subject) -> bool {
    let quadric = &subject.projected.quadric;
    let is_quotient = quadric.eye_value().is_zero() && !quadric.is_free_of_depth();
    is_quotient && is_possible(subject.context, &[Quotients::All, Quotients::OfOneDepth])
}

/// Would a processor draw an object one of whose depths leaves the words of roots: one that the eye nearly lies on?
pub(super) fn is_near_eye(subject: Subject) -> bool {
    let projected = subject.projected;
    let has_eye_value = !projected.quadric.eye_value().is_zero();
    let is_quadric = !subject.object.quadric.is_everywhere() && has_eye_value;
    is_quadric && is_possible(subject.context, &[Quotients::All]) && !projected.window.is_empty()
}

/// The words of an object whose depth is a quotient, or nearly so.
pub(super) fn prepare(subject: Subject) -> Result<PreparedParts, PrepareError> {
    let (object, context) = (subject.object, subject.context);
    let window = &subject.projected.window;
    if window.is_empty() {
        return Ok(PreparedParts::unseen(&object.name, subject.unseen_note()));
    }
    let mut ledger = Ledger::new(&object.name, *window, context);
    let (mut words, off) = depth_words(subject, &mut ledger)?;
    let (mut notes, mut of_cuts) = (vec![], 0f64);
    for (index, plane) in subject.planes().enumerate() {
        let plane = plane?;
        let magnitude = power_of_two(plane.needed - 1) - integer(1);
        ledger.prove(&format!("cut {index}"), &magnitude, context.format.plane)?;
        notes.extend(plane.note(index));
        if plane.words.kind != PlaneKind::Perpendicular {
            of_cuts = of_cuts.max(plane.bound);
        }
        words.planes.push(plane.words);
    }
    let (bound, unbounded) = off.bound(&words, &context.format);
    notes.insert(0, note(&words, bound, of_cuts, unbounded));
    Ok(PreparedParts {
        notes,
        depth_bound: Some(bound.max(of_cuts)),
        ..ledger.finish(ProcessorWords::Quotient(words))
    })
}

/// How far rounding carries the words of the depth on the box.
struct Off {
    numerator: f64,
    denominator: f64,
    discriminant: f64,
}

/// The words of an object without its planes, scaled for the box of all that share its quadric.
fn depth_words(
    subject: Subject,
    ledger: &mut Ledger,
) -> Result<(QuotientWords, Off), PrepareError> {
    let (projected, context) = (subject.projected, subject.context);
    let (quadric, window) = (&projected.quadric, &projected.window);
    let shared = &subject.place.quadric;
    let leading = quadric.eye_value() * integer(2);
    let widths = widths(&context.format, !leading.is_zero());
    let t = context.to_pixels_quadratic(&quadric.depth_free_part());
    let t = t.scaled(&-&context.depth_scale);
    let b = context
        .to_pixels_linear(&quadric.polar())
        .scaled(&integer(2));
    // 4 (B^2 - C T) is f2 times the square of 2 C.
    let discriminant = (!leading.is_zero()).then(|| {
        let f2 = context.to_pixels_quadratic(&quadric.f2());
        f2.scaled(&(&leading * &leading))
    });
    let scale = scale(&t, &b, discriminant.as_ref(), shared, &widths);
    let (t, b) = (t.scaled(&scale), b.scaled(&scale));
    let anchor = context.anchor_of(shared);
    let mut quadratic = |word: &str, exact: &QuadraticForm, width: u32| {
        let rounded = round_quadratic(exact, anchor)
            .map_err(|value| ledger.refusal(word, &value.abs(), width))?;
        let greatest = QuadraticForm::of_words(&rounded).max_abs_on(window);
        ledger.prove(word, &greatest, width)?;
        let off = to_f64_up(&quadratic_error(&rounded, exact, 0, window));
        Ok((rounded.wrapped(width), off))
    };
    let (numerator, off_numerator) = quadratic("numerator", &t, widths.numerator)?;
    let discriminant = discriminant.map(|exact| exact.scaled(&(&scale * &scale)));
    let root = discriminant.map(|d| quadratic("discriminant", &d, widths.discriminant));
    let root = root.transpose()?;
    let denominator = round_linear(&b, anchor)
        .map_err(|value| ledger.refusal("denominator", &value.abs(), widths.denominator))?;
    let greatest = LinearForm::of_words(&denominator).max_abs_on(window);
    ledger.prove("denominator", &greatest, widths.denominator)?;
    let off = Off {
        numerator: off_numerator,
        denominator: to_f64_up(&linear_error(&denominator, &b, 0, window)),
        discriminant: root.as_ref().map_or(0.0, |(_, off)| *off),
    };
    let root = root.map(|(discriminant, _)| {
        let (leading, fraction) = leading_word(&(leading * scale / &context.depth_scale));
        QuotientRoot {
            discriminant,
            leading,
            fraction,
        }
    });
    let (normal, normal_from) = normal(projected, context);
    let words = QuotientWords {
        screen_box: *window,
        solid: subject.object.surface == Surface::Solid,
        numerator,
        denominator: denominator.wrapped(widths.denominator),
        root,
        normal,
        normal_from,
        planes: vec![],
    };
    Ok((words, off))
}

impl Off {
    /// Greatest distance of a drawn depth of the surface from the true one, in depth words, and the pixels at which
    /// there is no bound because rounding can change the sign of the denominator.
    fn bound(&self, words: &QuotientWords, format: &Format) -> (f64, usize) {
        let (mut bound, mut unbounded) = (0f64, 0);
        let drawn = ProcessorWords::Quotient(words.clone());
        for y in words.screen_box.y0..=words.screen_box.y1 {
            drawn.for_each_present(format, y, |x, pixel| {
                if pixel.number != FACE_NEAR && pixel.number != FACE_FAR {
                    return;
                }
                match self.bound_at(words, (x, y), pixel.zf, format) {
                    Some(at) => bound = bound.max(at * (1.0 + 1e-12)),
                    None => unbounded += 1,
                }
            });
        }
        (bound, unbounded)
    }

    /// The same of a depth that is drawn at a pixel.
    ///
    /// With the true `N / M`, the words `n`, `m` and `z = floor(n / m)`: the distance of `N / M` from `n / m` is at
    /// most `(off_n + |n / m| off_m) / (|m| - off_m)`, and the floor takes up to one. If m holds a root, off_m is
    /// what is off the discriminant through the root, and its floor, besides; the other depth is m over a constant
    /// that is rounded by half.
    fn bound_at(
        &self,
        words: &QuotientWords,
        (x, y): (i64, i64),
        depth: i64,
        format: &Format,
    ) -> Option<f64> {
        let widths = words.widths(format);
        let z = depth.unsigned_abs() as f64 + 1.0;
        let ratio = |off_n: f64, m: f64, off_m: f64| {
            let least = m - off_m;
            (least > 0.0).then(|| 1.0 + (off_n + z * off_m) / least)
        };
        let Some(root) = &words.root else {
            let m = words.denominator.wrapped_at(x, y, widths.denominator);
            let m = m.unsigned_abs() as f64;
            return ratio(self.numerator, m, self.denominator);
        };
        let depths = words.depths_at(x, y, format)?;
        let d = root.discriminant.wrapped_at(x, y, widths.discriminant) as f64;
        let low = (d - self.discriminant).max(0.0).sqrt();
        let high = (d + 1.0 + self.discriminant).sqrt();
        let off_root = (high - d.sqrt()).max(d.sqrt() - low) + 1.0;
        let off = self.denominator + off_root;
        let m = depths.denominator.unsigned_abs() as f64;
        if depth == depths.inner {
            return ratio(2.0 * self.numerator, m, off);
        }
        let off = off * f64::exp2(f64::from(root.fraction));
        ratio(off, root.leading.unsigned_abs() as f64, 0.5)
    }
}

/// The scale at which every expression fills at most half of its word on a box, so that rounding has room.
fn scale(
    t: &QuadraticForm,
    b: &LinearForm,
    discriminant: Option<&QuadraticForm>,
    window: &ScreenBox,
    widths: &QuotientWidths,
) -> BigRational {
    let fill =
        |width: u32, most: BigRational| (!most.is_zero()).then(|| power_of_two(width - 2) / most);
    let square = discriminant.and_then(|d| fill(widths.discriminant - 2, d.max_abs_on(window)));
    // A power of two below the square root.
    let root = square.map(|square| {
        let bits = |n: &BigInt| n.bits() as i64;
        let log2 = bits(square.numer()) - bits(square.denom()) - 1;
        let half = log2.div_euclid(2);
        let power = power_of_two(half.unsigned_abs() as u32);
        if half < 0 { power.recip() } else { power }
    });
    let scales = [
        fill(widths.numerator, t.max_abs_on(window)),
        fill(widths.denominator, b.max_abs_on(window)),
        root,
    ];
    scales.into_iter().flatten().min().unwrap_or(integer(1))
}

/// A constant of about 44 bits with its binary places, as many as its magnitude asks for and at most 50; its sign
/// stays.
fn leading_word(value: &BigRational) -> (i64, u32) {
    const BITS: i64 = 44;
    const MOST: i64 = 50;
    let size = value.numer().bits() as i64 - value.denom().bits() as i64;
    let fraction = (BITS - size).clamp(0, MOST) as u32;
    let rounded = round_half_up(&(value * power_of_two(fraction)));
    let least = if value.is_negative() { -1 } else { 1 };
    let word = rounded.to_i64().filter(|word| *word != 0).unwrap_or(least);
    (word, fraction)
}

fn note(words: &QuotientWords, bound: f64, of_cuts: f64, unbounded: usize) -> String {
    let cuts = match of_cuts {
        0.0 => String::new(),
        words => format!("; cut faces are within {words:.3}"),
    };
    let lying = match unbounded {
        0 => String::new(),
        n => format!("; at {n} more pixels the line of sight lies in the surface but for rounding"),
    };
    let why = match words.root {
        None => "the viewer lies on this quadric (or looks along an asymptotic direction of it)",
        Some(_) => {
            "the viewer lies so nearly on this quadric that one of its two depths leaves every word"
        }
    };
    format!(
        "{why}: its depth is a quotient, within {bound:.3} depth words of the true one where it is drawn{cuts}{lying}"
    )
}

/// The normal's words, and the depth from which they count.
fn normal(projected: &Projected, context: &Context) -> (NormalWords, i64) {
    let (quadric, window) = (&projected.quadric, &projected.window);
    let (near, far) = projected.depths(context);
    let word = |depth: f64| {
        let word = floor(&(from_f64_exact(depth) * &context.depth_scale)).to_i64();
        let word = word.unwrap_or(context.format.z_low());
        word.clamp(context.format.z_low(), context.format.z_max())
    };
    // The range is as wide as the search leaves it; rounding carries a depth a few words further, of which the normal
    // takes no notice.
    let (from, to) = (word(near), word(far) + 1);
    let reach = BigInt::from(to - from);
    let start = integer(from) / &context.depth_scale;
    let parts = quadric.normal().map(|(linear, k)| {
        let constant = LinearForm::of_array([integer(0), integer(0), &k * &start]);
        (context.to_pixels_linear(&linear).plus(&constant), -k)
    });
    let (words, _) = normals(&parts, &reach, window, context);
    (words, from)
}
