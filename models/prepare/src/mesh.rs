//! Meshes: each corner rounded once to a sixteenth of a pixel, one facet processor for each face.

use super::context::Context;
use super::error::PrepareError;
use super::forms::LinearForm;
use super::ledger::{Ledger, most};
use super::prepared::{NeededWord, PreparedParts};
use imogene_algebra::rational::{fraction, integer, power_of_two, round_half_up};
use imogene_golden::object::facet::{Corner, FacetError, FacetWords, SUBPIXEL};
use imogene_golden::object::paraboloid::plane_guard;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::normal::LINEAR_WIDTH;
use imogene_golden::unit::pe1::Linear;
use imogene_scene::{FramedFacet, FramedMesh};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

/// Pixels from the first one, to any side, within which a corner must lie.
const REACH: i64 = 1 << 22;

pub(super) fn prepare_mesh(
    mesh: &FramedMesh,
    context: &Context,
) -> Result<PreparedParts, PrepareError> {
    let places: Vec<Placed> = mesh.vertices.iter().map(|v| place(v, context)).collect();
    let mut parts = PreparedParts {
        notes: vec![],
        ..PreparedParts::unseen(&mesh.name, "")
    };
    let (mut edge_on, mut needed): (Vec<usize>, Vec<NeededWord>) = (vec![], vec![]);
    for facet in &mesh.facets {
        let corners = corners(mesh, facet, &places)?;
        let found = triangles_or_whole(&corners, facet, mesh, context, &mut needed)?;
        edge_on.extend(found.is_none().then_some(facet.face));
        for one in found.into_iter().flatten() {
            parts.screen_box = parts.screen_box.around(&one.screen_box);
            parts.words.push(ProcessorWords::Facet(one));
        }
    }
    parts.needed = most(needed);
    edge_on.dedup();
    if !edge_on.is_empty() {
        let list: Vec<String> = edge_on.iter().map(usize::to_string).collect();
        parts.notes.push(format!(
            "seen edge-on or smaller than a sixteenth of a pixel, drawing nothing: faces {}",
            list.join(", ")
        ));
    }
    let is_unseen = parts.words.is_empty();
    let note = is_unseen.then(|| "no face is on the screen: nothing to draw".into());
    parts.notes.extend(note);
    Ok(parts)
}

/// A vertex on the screen, its normal left open, or why it cannot be a corner.
type Placed = Result<Corner, &'static str>;

fn place(vertex: &[BigRational; 3], context: &Context) -> Placed {
    let [x, y, z] = vertex;
    // (D + z) / D; 1 in an orthographic view.
    let divisor = integer(1) + z * &context.inverse_distance;
    if !divisor.is_positive() {
        return Err("is not in front of the viewer");
    }
    let depth = z / &divisor;
    if context.perspective && depth < -&context.full_depth {
        return Err("is nearer to the viewer than the near end of the depth");
    }
    let (x0, y0) = context.first_pixel();
    let steps = integer(1 << SUBPIXEL);
    let along = |value: &BigRational, first: BigRational| {
        round_half_up(&((value / &divisor - first) * &steps))
            .to_i64()
            .filter(|v| v.abs() <= REACH << SUBPIXEL)
            .ok_or("is too far beside the screen")
    };
    let z = depth * &context.depth_scale;
    if z.abs() >= power_of_two(context.format.sum - 1) {
        return Err("is too far outside the depth range");
    }
    Ok(Corner {
        x: along(x, x0)?,
        y: along(y, y0)?,
        z,
        normal: [0; 3],
    })
}

fn corners(
    mesh: &FramedMesh,
    facet: &FramedFacet,
    places: &[Placed],
) -> Result<Vec<Corner>, PrepareError> {
    let corner = |&vertex: &usize| match &places[vertex] {
        Ok(place) => Ok(Corner {
            normal: mesh.normals.as_ref().map_or(facet.normal, |n| n[vertex]),
            ..place.clone()
        }),
        Err(problem) => Err(PrepareError::Corner {
            object: mesh.name.clone(),
            face: facet.face,
            vertex,
            problem,
        }),
    };
    facet.corners.iter().map(corner).collect()
}

/// The words of a facet: one processor, or two for a quadrangle whose rounded corners have no common plane or normals.
/// `None` if the facet is a line on the screen; a facet beside the screen has no words.
fn triangles_or_whole(
    corners: &[Corner],
    facet: &FramedFacet,
    mesh: &FramedMesh,
    context: &Context,
    needed: &mut Vec<NeededWord>,
) -> Result<Option<Vec<FacetWords>>, PrepareError> {
    let mut words_of = |corners: &[Corner]| words(corners, facet, mesh, context, needed);
    if let Some(found) = words_of(corners)? {
        return Ok(Some(found.into_iter().collect()));
    }
    let [a, b, c, d] = corners else {
        return Ok(None);
    };
    let halves = [[a, b, c], [a, c, d]].map(|half| half.map(Corner::clone));
    let [one, other] = [words_of(&halves[0])?, words_of(&halves[1])?];
    if one.is_none() && other.is_none() {
        return Ok(None);
    }
    Ok(Some(one.into_iter().chain(other).flatten().collect()))
}

/// The words of one processor; an inner nothing beside the screen, an outer one if these corners are no facet.
fn words(
    corners: &[Corner],
    facet: &FramedFacet,
    mesh: &FramedMesh,
    context: &Context,
    needed: &mut Vec<NeededWord>,
) -> Result<Option<Option<FacetWords>>, PrepareError> {
    let format = &context.format;
    let window = facet_box(corners, context);
    let words = match FacetWords::new(corners, window, format) {
        Ok(words) => words,
        Err(FacetError::NotConvex | FacetError::NotLinear(_)) => return Ok(None),
        Err(other) => unreachable!("corners are counted and normals have a length: {other}"),
    };
    if window.is_empty() {
        return Ok(Some(None));
    }
    let label = |what: &str| format!("{what} of face {}", facet.face);
    let mut ledger = Ledger::new(&mesh.name, window, context);
    for edge in &words.edges {
        let greatest = LinearForm::of_words(edge).max_abs_on(&window);
        ledger.prove(&label("a side"), &greatest, format.plane)?;
    }
    // Depth and normal count inside alone, where they lie between their values in the corners.
    let greatest = |words: &Linear| {
        let form = LinearForm::of_words(words);
        let at = |c: &Corner| form.at(&fraction(c.x, 1 << SUBPIXEL), &fraction(c.y, 1 << SUBPIXEL));
        let values = corners.iter().map(|c| at(c).abs());
        values.max().expect("there are corners")
    };
    // The depth keeps S bits above its guard bits.
    debug_assert_eq!(format.plane - plane_guard(format), format.sum);
    ledger.prove(&label("the depth"), &greatest(&words.depth), format.plane)?;
    for normal in &words.normal {
        ledger.prove(&label("the normal"), &greatest(normal), LINEAR_WIDTH)?;
    }
    needed.extend(ledger.needed.into_iter().map(|one| NeededWord {
        word: one.word.split(" of face").next().unwrap_or_default().into(),
        ..one
    }));
    // As the registers hold them: all sums are modulo the width.
    let edges = words.edges.iter();
    Ok(Some(Some(FacetWords {
        edges: edges.map(|e| e.wrapped(format.plane)).collect(),
        depth: words.depth.wrapped(format.plane),
        normal: words.normal.map(|n| n.wrapped(LINEAR_WIDTH)),
        ..words
    })))
}

fn facet_box(corners: &[Corner], context: &Context) -> ScreenBox {
    let bound = |of: fn(&Corner) -> i64| {
        let all = corners.iter().map(of);
        let (least, greatest) = (all.clone().min(), all.max());
        [least, greatest].map(|v| fraction(v.expect("there are corners"), 1 << SUBPIXEL))
    };
    let ([x0, x1], [y0, y1]) = (bound(|c| c.x), bound(|c| c.y));
    context.pixels_between([x0, x1, y0, y1])
}
