//! One object: classification, expressions, scales, rounding and proofs, in the order of the source's preparation
//! module (Fig B.4).

use super::context::Context;
use super::depth::{Asked, Exact};
use super::error::{PrepareError, too_large};
use super::forms::{LinearForm, QuadraticForm, greater, inverse, sum, times};
use super::prepared::{ExactForms, NeededWidths, PreparedQuadric, RoundingBounds};
use super::projected::{Projected, Subject};
use super::range::remedy;
use super::rounding::{Anchor, linear_error, round_linear};
use imogene_algebra::rational::{integer, power_of_two, round_half_up, to_f64_up};
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_scene::Surface;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

pub(super) fn prepare_quadric(subject: Subject) -> Result<PreparedQuadric, PrepareError> {
    let (object, projected, context) = (subject.object, subject.projected, subject.context);
    let (quadric, window) = (&projected.quadric, &projected.window);
    let shared = &subject.place.quadric;
    let class = classify(subject)?;
    let edge_on = class == Class::Prism && object.surface == Surface::Patch;
    if window.is_empty() || edge_on {
        let note = match edge_on {
            true => "a patch seen exactly edge-on: nothing to draw",
            false => subject.unseen_note(),
        };
        return Ok(absent(&object.name, class, note));
    }
    let asked = Asked {
        quadric,
        class,
        at: (window, shared),
        shift: 0,
        context,
        exact: Exact::default(),
    };
    let words = projected
        .depth
        .words(&object.name, &asked)
        .map_err(|mut refusal| {
            if let PrepareError::TooLarge(_, excess) = &mut refusal {
                excess.remedy = remedy(quadric, &projected.region, context);
            }
            refusal
        })?;
    let note = match class {
        Class::Prism => Some("does not depend on the depth (seen end-on)"),
        Class::Front => Some("the viewer is inside the unbounded quadric (front view)"),
        Class::Side | Class::Patch => None,
    };
    let mut prepared = PreparedQuadric {
        name: object.name.clone(),
        words: QuadricWords {
            class,
            screen_box: *window,
            f1: words.f1,
            f2: words.f2,
            ..QuadricWords::default()
        },
        exact: asked.into_exact(),
        anchor: context.anchor_of(shared),
        bounds: words.bounds,
        needed: words.needed,
        notes: note.map(str::to_owned).into_iter().collect(),
    };
    if class != Class::Prism {
        (prepared.words.normal, prepared.bounds.normal) =
            normal_words(projected, &words.root_max, context);
    }
    for (index, plane) in subject.planes().enumerate() {
        let plane = plane?;
        // A half-plane of the screen has a scale of its own, but in a short word its rounding can still carry it out.
        if plane.needed > context.format.plane {
            let magnitude = power_of_two(plane.needed - 1) - integer(1);
            let (name, word) = (&object.name, format!("cut {index}"));
            let available = context.format.plane;
            return Err(too_large(name, &word, &magnitude, available, window));
        }
        prepared.notes.extend(plane.note(index));
        let exact = projected.planes[index].exact(&plane, context);
        prepared.exact.planes.push(exact);
        prepared.words.planes.push(plane.words);
        prepared.bounds.planes.push(plane.bound);
        prepared.needed.plane = prepared.needed.plane.max(plane.needed);
    }
    Ok(prepared)
}

fn classify(subject: Subject) -> Result<Class, PrepareError> {
    let (object, quadric) = (subject.object, &subject.projected.quadric);
    let name = || object.name.clone();
    let eye = quadric.eye_value();
    if eye.is_zero() {
        return if quadric.is_free_of_depth() {
            Ok(Class::Prism)
        } else if subject.context.perspective {
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
        words: QuadricWords {
            class,
            screen_box: ScreenBox::EMPTY,
            ..QuadricWords::default()
        },
        exact: ExactForms {
            f1: LinearForm::zero(),
            f2: QuadraticForm::zero(),
            planes: vec![],
        },
        anchor: Anchor::ORIGIN,
        bounds: RoundingBounds::default(),
        needed: NeededWidths::default(),
        notes: vec![note.to_string()],
    }
}

fn normal_words(projected: &Projected, root_max: &BigInt, context: &Context) -> (NormalWords, f64) {
    let (quadric, window) = (&projected.quadric, &projected.window);
    let (format, anchor) = (&context.format, context.anchor_of(window));
    let key = (format.depth, format.normal, anchor, root_max.clone());
    projected.normals.get(key, || {
        let f1 = context.to_pixels_linear(&quadric.f1());
        let parts = quadric
            .normal()
            .map(|(linear, k)| (context.to_pixels_linear(&linear).plus(&f1.scaled(&k)), k));
        normals(&parts, root_max, window, context)
    })
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
    let (anchor, word) = (context.anchor_of(window), &context.depth_scale);
    let mut words = NormalWords::default();
    let in_pixels =
        |value: BigInt| BigRational::new_raw(value * word.denom(), word.numer().clone());
    let root = in_pixels(root_max.clone());
    let reached = parts.each_ref().map(|(g, k)| {
        let root = times(&k.abs(), &root);
        sum(&g.max_abs_on(window), &root)
    });
    let most_reached = greatest_of(reached);
    if most_reached.is_zero() {
        return (words, 0.0);
    }
    let shift = (root_max.bits() as u32).saturating_sub(context.format.normal - 1);
    let fraction = shift + context.format.product_fraction();
    let factor_unit = in_pixels(BigInt::one() << fraction);
    let k_max = greatest_of(parts.each_ref().map(|(_, k)| k.abs()));
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
        // Halves away from zero.
        let size = round_half_up(&times(&k.abs(), &factor_scale));
        let size = size.to_i16().expect("scaled to its word");
        if k.is_negative() { -size } else { size }
    });
    let error = |k: usize| linear_error(&words.g[k], &linear[k], 0, window);
    (words, to_f64_up(&greatest_of([0, 1, 2].map(error))))
}

fn greatest_of([a, b, c]: [BigRational; 3]) -> BigRational {
    greater(greater(a, b), c)
}
