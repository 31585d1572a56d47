//! Cut planes: depth or half-plane form, and the proof that it fits (source: 2.4.2, 2.4.4; the threshold of B.4
//! replaced by a proof).

use super::context::Context;
use super::error::Steep;
use super::forms::{LinearForm, greater, inverse, times};
use super::memo::Few;
use super::rounding::{Anchor, linear_error, round_half_plane, round_linear, signed_bits};
use imogene_algebra::rational::{floor, from_f64_exact, integer, round_half_up, to_f64, to_f64_up};
use imogene_algebra::whole::greatest;
use imogene_golden::format::word_max;
use imogene_golden::object::quadric::{PlaneWords, ScreenBox};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::pe1::Linear;
use imogene_scene::Plane;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use std::sync::Arc;

/// A plane at one place of the screen, and what its words were found to be.
pub(super) struct PlacedPlane {
    projected: Plane,
    /// By the depth word.
    in_depth: Few<(u32, Anchor), InDepth>,
    /// By the plane word.
    across: Few<(u32, Anchor), Result<PreparedPlane, (i64, i64)>>,
}

/// The box that a plane is proven on, and the one around all objects that have it, for which it is rounded and scaled;
/// both are those of the place.
type At<'a> = (&'a ScreenBox, &'a ScreenBox);

/// The depth of a plane.
#[derive(Clone)]
struct InDepth {
    /// Nothing where a coefficient is too large for any word.
    word: Option<Linear>,
    needed: u32,
    bound: f64,
}

/// A plane in words; its normal is for others to say.
#[derive(Clone)]
pub(super) struct PreparedPlane {
    pub words: PlaneWords,
    /// The half-plane form, exactly.
    across: Option<Arc<LinearForm>>,
    pub bound: f64,
    pub needed: u32,
    pub steep: bool,
}

impl PreparedPlane {
    /// What a person should know of plane number `index`.
    pub fn note(&self, index: usize) -> Option<String> {
        self.steep.then(|| {
            format!("cut {index} is so steep that its half-plane form is used, proven equal on every pixel of the box")
        })
    }
}

impl PlacedPlane {
    /// Of a plane after perspective.
    pub fn of(projected: Plane) -> PlacedPlane {
        PlacedPlane {
            projected,
            in_depth: Few::default(),
            across: Few::default(),
        }
    }

    /// The half-plane value; kept where it is not negative.
    fn value(&self, context: &Context) -> LinearForm {
        let Plane { a, b, d, .. } = &self.projected;
        context.to_pixels_linear(&LinearForm::of_array([-a, -b, -d]))
    }

    /// The exact depth in depth words.
    fn depth(&self, context: &Context) -> LinearForm {
        let scale = times(&context.depth_scale, &inverse(&self.projected.c));
        self.value(context).scaled(&scale)
    }

    /// What was rounded.
    pub fn exact(&self, prepared: &PreparedPlane, context: &Context) -> LinearForm {
        let across = prepared.across.as_deref().cloned();
        across.unwrap_or_else(|| self.depth(context))
    }

    /// Prepares the plane, which has to decide between two depths (pixels), which are asked for only if it is steep.
    pub fn words(
        &self,
        (window, shared): At,
        depths: impl FnOnce() -> (f64, f64),
        context: &Context,
    ) -> Result<PreparedPlane, Steep> {
        let (format, anchor) = (&context.format, context.anchor_of(shared));
        let gamma = &self.projected.c;
        let steep = (!gamma.is_zero()).then(|| {
            let in_depth = || InDepth::of(&self.depth(context), anchor, window);
            self.in_depth.get((format.depth, anchor), in_depth)
        });
        if let Some(in_depth) = &steep
            && in_depth.needed <= format.plane
            && let Some(depth) = in_depth.word
        {
            let kind = match gamma.is_negative() {
                true => PlaneKind::Front,
                false => PlaneKind::Back,
            };
            return Ok(PreparedPlane {
                words: PlaneWords::new(kind, depth, [0; 3]),
                across: None,
                bound: in_depth.bound,
                needed: in_depth.needed,
                steep: false,
            });
        }
        let across = self.across.get((format.plane, anchor), || {
            let value = self.value(context);
            let form = match steep {
                None => value,
                Some(_) => perpendicular_if_proven(&value, gamma, depths(), window, context)?,
            };
            Ok(PreparedPlane {
                steep: steep.is_some(),
                ..perpendicular(form, (window, shared), context)
            })
        });
        across.map_err(|(x, y)| Steep {
            needed: steep.map_or(0, |in_depth| in_depth.needed),
            available: format.plane,
            x,
            y,
        })
    }
}

impl InDepth {
    fn of(depth: &LinearForm, anchor: Anchor, window: &ScreenBox) -> InDepth {
        let word = round_linear(depth, anchor).ok();
        let off = |word| to_f64_up(&linear_error(word, depth, 0, window));
        InDepth {
            needed: bits_needed(depth, word.as_ref(), window),
            bound: word.as_ref().map_or(f64::INFINITY, off),
            word,
        }
    }
}

/// The plane's normal before perspective, its greatest component scaled to the greatest of its word.
pub(super) fn constant_normal(plane: &Plane, most: i16) -> [i16; 3] {
    let components = [&plane.a, &plane.b, &plane.c];
    let greatest = greatest(components);
    if greatest.is_zero() {
        return [0; 3];
    }
    let scale = times(&integer(most.into()), &inverse(&greatest));
    components.map(|c| {
        round_half_up(&times(c, &scale))
            .to_i16()
            .expect("within its word")
    })
}

/// Bits of an expression on the box: of the exact one, and of the rounded one, which in a short word and far from the
/// anchor can be greater.
fn bits_needed(exact: &LinearForm, word: Option<&Linear>, window: &ScreenBox) -> u32 {
    let rounded = word.map(|word| LinearForm::of_words(word).max_abs_on(window));
    let most = exact.max_abs_on(window);
    signed_bits(&match rounded {
        Some(rounded) => greater(rounded, most),
        None => most,
    })
}

/// The half-plane form. Its scale is free, so the exact integers are used whenever they fit the plane word.
fn perpendicular(value: LinearForm, (window, shared): At, context: &Context) -> PreparedPlane {
    let limit = BigRational::from_integer(BigInt::from(word_max(context.format.plane)));
    let whole = value.primitive();
    let exact = if whole.max_abs_on(shared) <= limit {
        whole
    } else {
        let scale = limit / (integer(2) * value.max_abs_on(shared));
        value.scaled(&scale)
    };
    let anchor = context.anchor_of(shared);
    let (exact, depth) = match round_half_plane(&exact, anchor) {
        Ok(depth) => (exact, depth),
        // Far too steep for a word where there is but one column or line.
        Err(_) => {
            let exact = on_its_only_line(&exact, shared);
            let depth = round_half_plane(&exact, anchor).expect("scaled to the plane word");
            (exact, depth)
        }
    };
    PreparedPlane {
        words: PlaneWords::new(PlaneKind::Perpendicular, depth, [0; 3]),
        needed: bits_needed(&exact, Some(&depth), window),
        bound: to_f64_up(&linear_error(&depth, &exact, 0, window)),
        across: Some(Arc::new(exact)),
        steep: false,
    }
}

/// The same values on a box of one column or line, without the slope across it.
fn on_its_only_line(form: &LinearForm, window: &ScreenBox) -> LinearForm {
    let [mut a, mut b, mut c] = form.factors();
    let mut drop_slope = |slope: &mut BigRational, from: i64, to: i64| {
        if from == to {
            c += std::mem::take(slope) * integer(from);
        }
    };
    drop_slope(&mut a, window.x0, window.x1);
    drop_slope(&mut b, window.y0, window.y1);
    LinearForm::of_array([a, b, c])
}

/// A plane whose depth does not fit the plane word is so steep that it crosses the object's depths between two pixels
/// almost everywhere. If no pixel of the box lies in that strip, the half-plane form at the object's middle depth
/// decides every pixel as the plane does; otherwise the first such pixel is returned.
fn perpendicular_if_proven(
    value: &LinearForm,
    gamma: &BigRational,
    (near, far): (f64, f64),
    window: &ScreenBox,
    context: &Context,
) -> Result<LinearForm, (i64, i64)> {
    let full = to_f64(&context.full_depth);
    let middle = from_f64_exact(0.5 * (near + far));
    let reach = from_f64_exact(0.5 * (far - near) + 1e-6 * full);
    let zero = BigRational::zero;
    let form = value.minus(&LinearForm::of_array([zero(), zero(), gamma * middle]));
    let strip = gamma.abs() * reach;
    for y in window.y0..=window.y1 {
        let line = integer(y);
        for x in nearest_to_zero(&form, &line, window) {
            if form.at(&integer(x), &line).abs() <= strip {
                return Err((x, y));
            }
        }
    }
    Ok(form)
}

/// The pixels of a line between which the expression passes zero, or where it is smallest.
fn nearest_to_zero(form: &LinearForm, line: &BigRational, window: &ScreenBox) -> [i64; 2] {
    let [a, b, c] = form.factors();
    if a.is_zero() {
        return [window.x0, window.x1];
    }
    let crossing = -(b * line + c) / a;
    let below = match floor(&crossing).to_i64() {
        Some(below) => below,
        None if crossing.is_negative() => i64::MIN / 2,
        None => i64::MAX / 2,
    };
    [below, below + 1].map(|x| x.clamp(window.x0, window.x1))
}
