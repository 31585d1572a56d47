//! One object: classification, expressions, scales, rounding and proofs, in the order of the source's preparation
//! module (Fig B.4).

use super::context::Context;
use super::error::{PrepareError, too_large};
use super::forms::{LinearForm, QuadraticForm, inverse, sum, times};
use super::perspective::ScreenQuadric;
use super::prepared::{ExactForms, NeededWidths, PreparedQuadric, RoundingBounds};
use super::projected::Projected;
use super::range::remedy;
use super::rounding::{
    Anchor, linear_error, quadratic_error, round_contour, round_linear, round_quadratic,
    signed_bits,
};
use super::seams::Place;
use imogene_algebra::rational::{integer, power_of_two, to_f64_up};
use imogene_algebra::whole::greatest;
use imogene_golden::format::{Format, word_max};
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_scene::{FramedQuadric, Surface};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

pub(super) fn prepare_quadric(
    object: &FramedQuadric,
    projected: &Projected,
    place: &Place,
    context: &Context,
) -> Result<PreparedQuadric, PrepareError> {
    let Projected {
        quadric,
        region,
        window,
        ..
    } = projected;
    let class = classify(object, quadric, context)?;
    let edge_on = class == Class::Prism && object.surface == Surface::Patch;
    if window.is_empty() || edge_on {
        let note = match edge_on {
            true => "a patch seen exactly edge-on: nothing to draw",
            false => projected.unseen_note(object, context),
        };
        return Ok(absent(&object.name, class, note));
    }
    let at = (window, &place.quadric);
    let words = depth_words(&object.name, quadric, class, at, context);
    let (mut prepared, root_max) = words.map_err(|mut refusal| {
        if let PrepareError::TooLarge { excess, .. } = &mut refusal {
            excess.remedy = remedy(quadric, region, context);
        }
        refusal
    })?;
    if class != Class::Prism {
        normal_words(&mut prepared, quadric, &root_max, context);
    }
    for (index, plane) in projected.prepare_planes(object, place, context).enumerate() {
        let plane = plane?;
        // A half-plane of the screen has a scale of its own, but in a short word its rounding can still carry it out.
        if plane.needed > context.format.plane {
            let magnitude = power_of_two(plane.needed - 1) - integer(1);
            let (name, word) = (&object.name, format!("cut {index}"));
            let available = context.format.plane;
            return Err(too_large(name, &word, &magnitude, available, window));
        }
        prepared.notes.extend(plane.note(index));
        prepared.words.planes.push(plane.words);
        prepared.exact.planes.push(plane.exact);
        prepared.bounds.planes.push(plane.bound);
        prepared.needed.plane = prepared.needed.plane.max(plane.needed);
    }
    Ok(prepared)
}

fn classify(
    object: &FramedQuadric,
    quadric: &ScreenQuadric,
    context: &Context,
) -> Result<Class, PrepareError> {
    let name = || object.name.clone();
    let eye = quadric.eye_value();
    if eye.is_zero() {
        return if quadric.is_free_of_depth() {
            Ok(Class::Prism)
        } else if context.perspective {
            Err(PrepareError::ViewerOnSurface(name()))
        } else {
            Err(PrepareError::AsymptoticView(name()))
        };
    }
    Ok(match object.surface {
        Surface::Patch => Class::Patch,
        Surface::Solid if eye.is_positive() => Class::Side,
        Surface::Solid => Class::Front,
    })
}

/// An object that is nowhere on the screen.
pub(super) fn absent(name: &str, class: Class, note: &str) -> PreparedQuadric {
    PreparedQuadric {
        name: name.to_owned(),
        words: empty_words(class, ScreenBox::EMPTY),
        exact: ExactForms::zero(),
        anchor: Anchor::ORIGIN,
        bounds: RoundingBounds::default(),
        needed: NeededWidths::default(),
        notes: vec![note.to_string()],
    }
}

pub(super) fn empty_words(class: Class, screen_box: ScreenBox) -> QuadricWords {
    QuadricWords {
        class,
        screen_box,
        f1: Default::default(),
        f2: Default::default(),
        normal: NormalWords::default(),
        planes: vec![],
    }
}

/// The words of the quadric itself, without planes and normals, and its greatest root; proven on a box, rounded and
/// scaled for one around it.
pub(super) fn depth_words(
    name: &str,
    quadric: &ScreenQuadric,
    class: Class,
    (window, shared): (&ScreenBox, &ScreenBox),
    context: &Context,
) -> Result<(PreparedQuadric, BigInt), PrepareError> {
    let scale = &context.depth_scale;
    let refusal = |word: &str, magnitude: &BigRational, available: u32| {
        too_large(name, word, magnitude, available, window)
    };
    let mut prepared = PreparedQuadric {
        name: name.to_string(),
        words: empty_words(class, *window),
        exact: ExactForms::zero(),
        anchor: context.anchor_of(shared),
        bounds: RoundingBounds::of_format(&context.format),
        needed: NeededWidths::default(),
        notes: vec![],
    };
    if class == Class::Prism {
        let contour = context.to_pixels_quadratic(&quadric.depth_free_part());
        let contour = contour.scaled(&integer(-1));
        prepared.exact.f2 = contour_scaled(contour, shared, context.format.quadratic);
    } else {
        prepared.exact.f1 = context.to_pixels_linear(&quadric.f1()).scaled(scale);
        let f2 = context.to_pixels_quadratic(&quadric.f2());
        prepared.exact.f2 = f2.scaled(&(scale * scale));
    }
    let note = match class {
        Class::Prism => Some("does not depend on the depth (seen end-on)"),
        Class::Front => Some("the viewer is inside the unbounded quadric (front view)"),
        Class::Side | Class::Patch => None,
    };
    prepared.notes.extend(note.map(String::from));
    round(&mut prepared, &refusal, &context.format)?;
    let root_max = prove_widths(&mut prepared, &refusal, context)?;
    Ok((prepared, root_max))
}

/// Rounds f1 and f2 to words with the format's guard bits, and bounds what the rounding changes on the box.
fn round(
    prepared: &mut PreparedQuadric,
    refusal: &dyn Fn(&str, &BigRational, u32) -> PrepareError,
    format: &Format,
) -> Result<(), PrepareError> {
    let unrepresentable = |word, guards: u32, bits| {
        move |value: BigRational| refusal(word, &(value.abs() / power_of_two(guards)), bits)
    };
    let (g1, g2) = (format.guard_linear, format.guard_quadratic);
    let (exact, window, anchor) = (&prepared.exact, &prepared.words.screen_box, prepared.anchor);
    let f1 = round_linear(&exact.f1.scaled(&power_of_two(g1)), anchor)
        .map_err(unrepresentable("f1", g1, format.sum))?;
    let scaled = exact.f2.scaled(&power_of_two(g2));
    let f2 = match prepared.words.class {
        Class::Prism => round_contour(&scaled, anchor),
        _ => round_quadratic(&scaled, anchor),
    };
    let f2 = f2.map_err(unrepresentable("f2", g2, format.quadratic))?;
    prepared.bounds.f1 = to_f64_up(&linear_error(&f1, &exact.f1, g1, window));
    prepared.bounds.f2 = to_f64_up(&quadratic_error(&f2, &exact.f2, g2, window));
    (prepared.words.f1, prepared.words.f2) = (f1, f2);
    Ok(())
}

/// Proves on the rounded integers that f2, and f1 -+ r, stay within their words on the box; returns the greatest root
/// that the network finds.
///
/// The values are those with guard bits. Dropping them downwards adds less than one to a magnitude, which rounding the
/// magnitude up to an integer covers; and if that integer fits `S` or `F` bits, the value with its guard bits fits the
/// processor.
fn prove_widths(
    prepared: &mut PreparedQuadric,
    refusal: &dyn Fn(&str, &BigRational, u32) -> PrepareError,
    context: &Context,
) -> Result<BigInt, PrepareError> {
    let window = prepared.words.screen_box;
    let unit = |guards: u32| power_of_two(guards).recip();
    let f2 =
        QuadraticForm::of_words(&prepared.words.f2).scaled(&unit(context.format.guard_quadratic));
    let (least, greatest) = f2.range_on(&window);
    let magnitude = least.abs().max(greatest.abs());
    prepared.needed.quadratic = signed_bits(&magnitude);
    if prepared.needed.quadratic > context.format.quadratic {
        return Err(refusal("f2", &magnitude, context.format.quadratic));
    }
    let root_max: BigInt = greatest.max(BigRational::zero()).ceil().to_integer().sqrt() + 1;
    let bounds = &mut prepared.bounds;
    bounds.greatest_root = to_f64_up(&BigRational::from_integer(root_max.clone()));
    let above = match context.format.root_form.is_exact() {
        // It is rounded down.
        true => 0,
        false => bounds.root_error(bounds.greatest_root).ceil() as i64,
    };
    let root_max = root_max + above;
    let f1 = LinearForm::of_words(&prepared.words.f1).scaled(&unit(context.format.guard_linear));
    let root = BigRational::from_integer(root_max.clone());
    let sum = sum(&f1.max_abs_on(&window), &root);
    prepared.needed.sum = signed_bits(&sum);
    if prepared.needed.sum > context.format.sum {
        return Err(refusal("f1 + sqrt(f2)", &sum, context.format.sum));
    }
    Ok(root_max)
}

fn normal_words(
    prepared: &mut PreparedQuadric,
    quadric: &ScreenQuadric,
    root_max: &BigInt,
    context: &Context,
) {
    let f1 = context.to_pixels_linear(&quadric.f1());
    let parts = quadric
        .normal()
        .map(|(linear, k)| (context.to_pixels_linear(&linear).plus(&f1.scaled(&k)), k));
    let window = prepared.words.screen_box;
    (prepared.words.normal, prepared.bounds.normal) = normals(&parts, root_max, &window, context);
}

/// The words of a normal whose components are `g(x, y) -+ K r`, r a root (or another length along the line of sight)
/// of up to `root_max` depth words, and the greatest error of a linear part.
///
/// Scales (source: 2.4.4, "Kn"): the greatest component fills 22 of the 24 bits, and the factors K fit 16 bits;
/// likewise in shorter words.
pub(super) fn normals(
    parts: &[(LinearForm, BigRational); 3],
    root_max: &BigInt,
    window: &ScreenBox,
    context: &Context,
) -> (NormalWords, f64) {
    let anchor = context.anchor_of(window);
    let mut words = NormalWords::default();
    let root = BigRational::from_integer(root_max.clone()) / &context.depth_scale;
    let reached =
        |(g, k): &(LinearForm, BigRational)| sum(&g.max_abs_on(window), &times(&k.abs(), &root));
    let most_reached = greatest(parts.each_ref().map(reached).each_ref());
    if most_reached.is_zero() {
        return (words, 0.0);
    }
    let shift = (root_max.bits() as u32).saturating_sub(context.format.normal - 1);
    let fraction = shift + context.format.product_fraction();
    let factor_unit = BigRational::from_integer(BigInt::one() << fraction) / &context.depth_scale;
    let k_max = greatest(parts.each_ref().map(|(_, k)| k));
    let most = (1 << (context.format.normal_linear - 2)) - 1;
    let mut scale = times(&integer(most), &inverse(&most_reached));
    let k_limit = integer(context.format.greatest_normal().into());
    let k_most = times(&k_max, &factor_unit);
    if times(&scale, &k_most) > k_limit {
        scale = times(&k_limit, &inverse(&k_most));
    }
    let factor_scale = times(&scale, &factor_unit);
    words.shift = shift as u8;
    let linear = parts.each_ref().map(|(g, _)| g.scaled(&scale));
    words.g = linear
        .each_ref()
        .map(|g| round_linear(g, anchor).expect("scaled to its word"));
    words.k = parts.each_ref().map(|(_, k)| {
        times(k, &factor_scale)
            .round()
            .to_integer()
            .to_i16()
            .expect("scaled to its word")
    });
    let error = |k: usize| linear_error(&words.g[k], &linear[k], 0, window);
    let off = greatest([0, 1, 2].map(error).each_ref());
    (words, to_f64_up(&off))
}

/// A contour has a free scale: the greatest magnitude fills half the word.
fn contour_scaled(form: QuadraticForm, window: &ScreenBox, width: u32) -> QuadraticForm {
    let magnitude = form.max_abs_on(window);
    if magnitude.is_zero() {
        return form;
    }
    let scale = BigRational::from_integer(BigInt::from(word_max(width))) / (magnitude * integer(2));
    form.scaled(&scale)
}
