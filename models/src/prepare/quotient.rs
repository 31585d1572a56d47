//! A quadric whose depth is a quotient: the eye lies on it, or looks along an asymptotic direction (thesis section 2.1.1: c' = 0).
//!
//! The equation on the screen is then `2 B z + T = 0` with B of first and T of second degree. Numerator and denominator share a scale that is free, so each fills half
//! of its word. A quadric that passes the eye so closely that its z^2 term changes no depth by more than half a depth word is drawn in the same way.

use super::Context;
use super::error::PrepareError;
use super::forms::{LinearForm, QuadraticForm};
use super::ledger::{Ledger, most};
use super::object::{Projected, normals, too_large, unseen_note};
use super::parts::PreparedParts;
use super::perspective::ScreenQuadric;
use super::planes::prepare_plane;
use super::rounding::{linear_error, quadratic_error, round_linear, round_quadratic};
use super::seams::Place;
use crate::format::Format;
use crate::object::quadric::ScreenBox;
use crate::object::quotient::{QuotientWords, denominator_width, numerator_width};
use crate::object::slot::ProcessorWords;
use crate::rational::{floor, fraction, from_f64_exact, integer, power_of_two, to_f64, to_f64_up};
use crate::scene::{FramedQuadric, Surface};
use crate::unit::interval::{FACE_FAR, FACE_NEAR};
use crate::unit::normal::NormalWords;
use crate::unit::pe1::Linear;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// Most that the neglected z^2 term of a quadric that the eye nearly lies on may change a depth, in depth words.
fn greatest_neglect() -> BigRational {
    fraction(1, 2)
}

/// Fitted machines, and those of one type of processor, have none for a quotient.
fn is_possible(context: &Context) -> bool {
    context.format.is_of_catalogue() && !context.options.roots_only
}

/// The words of an object whose depth is exactly a quotient; nothing for any other.
pub(super) fn prepare_on_eye(
    object: &FramedQuadric,
    projected: &Projected,
    place: &Place,
    context: &Context,
) -> Result<Option<PreparedParts>, PrepareError> {
    let Projected {
        quadric, planes, ..
    } = projected;
    let is_quotient = quadric.eye_value().is_zero() && !quadric.is_free_of_depth();
    if !is_quotient || !is_possible(context) {
        return Ok(None);
    }
    // A plane keeps the eye iff its depth factor is not negative.
    let eye_kept = planes.iter().all(|p| !p.c.is_negative());
    if context.perspective && object.surface == Surface::Solid && eye_kept {
        return Err(PrepareError::ViewerOnSolid {
            object: object.name.clone(),
        });
    }
    prepare(object, projected, place, FACE_NEAR, context).map(Some)
}

/// The words of a surface that the eye lies on but for a distance that changes no depth by more than [`greatest_neglect`]; nothing for any other.
pub(super) fn prepare_near_eye(
    object: &FramedQuadric,
    projected: &Projected,
    place: &Place,
    context: &Context,
) -> Result<Option<PreparedParts>, PrepareError> {
    let Projected {
        quadric, window, ..
    } = projected;
    let possible = object.surface == Surface::Patch
        && is_possible(context)
        && !quadric.polar().is_zero_everywhere();
    if !possible || window.is_empty() {
        return Ok(None);
    }
    // With c z^2 + 2 B z + T = 0 and |z| <= full: the depth differs from -T / (2 B) by c z^2 / (2 B), and the other root lies beyond every depth.
    let polar = context.to_pixels_linear(&quadric.polar());
    let Some(least) = least_magnitude(&polar, window) else {
        return Ok(None);
    };
    let full = &context.full_depth;
    let neglect =
        quadric.eye_value().abs() * full * full * &context.depth_scale / (integer(2) * &least);
    if neglect > greatest_neglect() {
        return Ok(None);
    }
    // The other root is about -2 B / c, of one sign on the box.
    let at_corner = polar.at(&integer(window.x0), &integer(window.y0));
    let other_is_nearer = at_corner.is_positive() == quadric.eye_value().is_positive();
    let face = if other_is_nearer { FACE_FAR } else { FACE_NEAR };
    let mut parts = prepare(object, projected, place, face, context)?;
    let neglect = to_f64_up(&neglect);
    parts.depth_bound = parts.depth_bound.map(|bound| bound + neglect);
    parts.notes.push(format!(
        "the viewer lies so nearly on this quadric that its z^2 term is left out, which changes no depth by more than {:.1e} depth words",
        neglect
    ));
    Ok(Some(parts))
}

/// Least magnitude of an expression on the box; nothing if it is zero somewhere.
fn least_magnitude(form: &LinearForm, window: &ScreenBox) -> Option<BigRational> {
    let corners = [
        (window.x0, window.y0),
        (window.x0, window.y1),
        (window.x1, window.y0),
        (window.x1, window.y1),
    ];
    let values = corners.map(|(x, y)| form.at(&integer(x), &integer(y)));
    let one_sign = values.iter().all(|v| v.is_positive()) || values.iter().all(|v| v.is_negative());
    one_sign.then(|| values.iter().map(|v| v.abs()).min().expect("four corners"))
}

fn prepare(
    object: &FramedQuadric,
    projected: &Projected,
    place: &Place,
    face: u8,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let Projected {
        quadric,
        planes,
        region,
        window,
    } = projected;
    if window.is_empty() {
        let note = unseen_note(object, false, context)?;
        return Ok(PreparedParts::unseen(&object.name, note));
    }
    let mut ledger = Ledger::new(&object.name, *window, context);
    let at = (window, &place.quadric);
    let depth = Depth::new(quadric, at, &mut ledger, context)?;
    let (mut normal, normal_from) = normal(projected, context);
    if face == FACE_FAR {
        normal.k = normal.k.map(|k| -k);
    }
    let mut words = QuotientWords {
        screen_box: *window,
        solid: object.surface == Surface::Solid,
        face,
        numerator: depth.numerator,
        denominator: depth.denominator,
        normal,
        normal_from,
        planes: vec![],
    };
    let mut notes = vec![];
    for (index, (original, projected)) in object.planes.iter().zip(planes).enumerate() {
        let place = (region, window, &place.planes[index]);
        let plane = prepare_plane(&object.name, index, original, projected, place, context)?;
        let magnitude = power_of_two(plane.needed - 1) - integer(1);
        ledger.prove(&format!("cut {index}"), &magnitude, context.format.plane)?;
        notes.extend(plane.note(index));
        words.planes.push(plane.words);
    }
    let (bound, unbounded) = depth.bound(&words, &context.format);
    notes.insert(0, note(bound, unbounded));
    Ok(PreparedParts {
        name: object.name.clone(),
        screen_box: *window,
        words: vec![ProcessorWords::Quotient(words)],
        needed: most(ledger.needed),
        notes,
        depth_bound: Some(bound),
    })
}

/// Numerator and denominator, and how far rounding carries them on the box.
struct Depth {
    numerator: crate::unit::pe2::Quadratic,
    denominator: Linear,
    off_numerator: f64,
    off_denominator: f64,
}

impl Depth {
    fn new(
        quadric: &ScreenQuadric,
        (window, shared): (&ScreenBox, &ScreenBox),
        ledger: &mut Ledger,
        context: &Context,
    ) -> Result<Depth, PrepareError> {
        let (wide, narrow) = (
            numerator_width(&context.format),
            denominator_width(&context.format),
        );
        let t = context.to_pixels_quadratic(&quadric.depth_free_part());
        let t = t.scaled(&-&context.depth_scale);
        let b = context
            .to_pixels_linear(&quadric.polar())
            .scaled(&integer(2));
        // Half of each word, so that rounding has room.
        let fill = |width: u32, most: BigRational| {
            (!most.is_zero()).then(|| power_of_two(width - 2) / most)
        };
        let scales = [
            fill(wide, t.max_abs_on(shared)),
            fill(narrow, b.max_abs_on(shared)),
        ];
        let anchor = context.anchor_of(shared);
        let scale = scales.into_iter().flatten().min().unwrap_or(integer(1));
        let (t, b) = (t.scaled(&scale), b.scaled(&scale));
        let refuse = |word: &str, value: &BigRational, width| {
            too_large(ledger.object(), word, &value.abs(), width, window)
        };
        let numerator =
            round_quadratic(&t, anchor).map_err(|u| refuse("numerator", &u.value, wide))?;
        let denominator =
            round_linear(&b, anchor).map_err(|u| refuse("denominator", &u.value, narrow))?;
        let greatest = QuadraticForm::of_words(&numerator).max_abs_on(window);
        ledger.prove("numerator", &greatest, wide)?;
        let greatest = LinearForm::of_words(&denominator).max_abs_on(window);
        ledger.prove("denominator", &greatest, narrow)?;
        Ok(Depth {
            off_numerator: to_f64_up(&quadratic_error(&numerator, &t, 0, window)),
            off_denominator: to_f64_up(&linear_error(&denominator, &b, 0, window)),
            numerator: numerator.wrapped(wide),
            denominator: denominator.wrapped(narrow),
        })
    }

    /// Greatest distance of a drawn depth of the surface from the true one, in depth words, and the pixels at which there is no bound because rounding can
    /// change the sign of the denominator.
    ///
    /// With the true `N / M`, the words `n`, `m` and `z = floor(n / m)`: the distance of `N / M` from `n / m` is at most
    /// `(off_n + |n / m| off_m) / (|m| - off_m)`, and the floor takes up to one.
    pub(super) fn bound(&self, words: &QuotientWords, format: &Format) -> (f64, usize) {
        let (mut bound, mut unbounded) = (0f64, 0);
        let drawn = ProcessorWords::Quotient(words.clone());
        for y in words.screen_box.y0..=words.screen_box.y1 {
            drawn.for_each_present(format, y, |x, pixel| {
                let m = words
                    .denominator
                    .wrapped_at(x, y, denominator_width(format));
                let least = m.unsigned_abs() as f64 - self.off_denominator;
                if least <= 0.0 {
                    unbounded += 1;
                    return;
                }
                let z = pixel.zf.unsigned_abs() as f64 + 1.0;
                let off = (self.off_numerator + z * self.off_denominator) / least;
                bound = bound.max(1.0 + off * (1.0 + 1e-12));
            });
        }
        (bound, unbounded)
    }
}

/// What is known of the depths that are drawn.
fn note(bound: f64, unbounded: usize) -> String {
    let lying = match unbounded {
        0 => String::new(),
        n => format!("; at {n} more pixels the line of sight lies in the surface but for rounding"),
    };
    format!(
        "the viewer lies on this quadric (or looks along an asymptotic direction of it): its depth is a quotient, \
         within {bound:.3} depth words of the true one where it is drawn{lying}"
    )
}

/// The normal's words, and the depth from which they count.
fn normal(projected: &Projected, context: &Context) -> (NormalWords, i64) {
    let full = to_f64(&context.full_depth);
    let Projected {
        quadric,
        region,
        window,
        ..
    } = projected;
    let range = region.depth_range(context.width, context.height, full);
    let (near, far) = range.unwrap_or((-full, full));
    let word = |depth: f64| {
        let word = floor(&(from_f64_exact(depth) * &context.depth_scale)).to_i64();
        let word = word.unwrap_or(context.format.z_low());
        word.clamp(context.format.z_low(), context.format.z_max())
    };
    // The range is as wide as the search leaves it; rounding carries a depth a few words further, of which the normal takes no notice.
    let (from, to) = (word(near), word(far) + 1);
    let reach = BigInt::from(to - from);
    let start = integer(from) / &context.depth_scale;
    let parts = quadric.normal().map(|(linear, k)| {
        let constant = LinearForm::new(integer(0), integer(0), &k * &start);
        (context.to_pixels_linear(&linear).plus(&constant), -k)
    });
    let (words, _) = normals(&parts, &reach, window, context);
    (words, from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_form_without_zero_has_its_least_magnitude_in_a_corner() {
        let window = ScreenBox {
            x0: 0,
            x1: 9,
            y0: 0,
            y1: 4,
        };
        let form = |a, b, c| LinearForm::new(integer(a), integer(b), integer(c));
        assert_eq!(least_magnitude(&form(-1, 2, 10), &window), Some(integer(1)));
        assert_eq!(least_magnitude(&form(-1, 0, -3), &window), Some(integer(3)));
        assert_eq!(least_magnitude(&form(-1, 0, 3), &window), None);
    }
}
