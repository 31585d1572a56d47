//! Terms of a face, split until each is one object.

use super::arrangement::{Division, MAX_SEPARATORS, Sample};
use super::cover::{Conflict, Term, cover};
use super::curve::PlaneOf;
use super::model::Model;
use super::parting::{Parting, within};
use super::planes::Planes;
use super::surface::Surface;
use super::vector::{minus, plus, times, unit};

/// Most rounds of splitting a face before it is given up: the depth limit of trim structures (thesis section III.4.2).
pub const MAX_ROUNDS: usize = 13;

/// Most pieces of a border from which a search for few terms is worth its time.
const MOST_SEARCHED: usize = 128;

/// Most pieces of a surface that are searched.
const MOST_SAMPLES: usize = 100_000;

/// Planes that take terms apart, a point and a normal each.
pub type Refine<'a> = &'a dyn Fn(&Parting, &[Term], &[Sample]) -> Vec<PlaneOf>;

/// What one object can be, and planes for what it cannot be.
pub struct Rules<'a> {
    /// Whether a term is one object.
    pub fits: &'a dyn Fn(&Parting, &Term) -> bool,
    /// Planes that take apart terms that are not; none if all are.
    pub refine: Refine<'a>,
}

/// Terms of a parting, split until each is one object.
///
/// First with the fewest sides for every term, which drops a plane that only halves a convex piece; where that does
/// not end on a plane, once more with the halves.
pub fn terms(
    model: &Model,
    surface: &Surface,
    parting: &mut Parting,
    planes: &mut Planes,
    rules: &Rules,
) -> Result<Vec<Term>, String> {
    if parting.separators.len() > MOST_SEARCHED {
        return Err("its border has too many pieces for the search".into());
    }
    let start = parting.clone();
    match attempt(model, surface, parting, planes, rules, false) {
        Err(Trouble::Unresolved(_)) if surface.is_plane() => {
            *parting = start;
            attempt(model, surface, parting, planes, rules, true)
        }
        other => other,
    }
    .map_err(|trouble| match trouble {
        Trouble::Wrong(reason) => reason,
        Trouble::Unresolved(trouble) => format!(
            "it is not resolved within {MAX_ROUNDS} rounds of splitting and {MAX_SEPARATORS} planes: {trouble}"
        ),
    })
}

/// Why there are no terms.
enum Trouble {
    /// Its loops make no face.
    Wrong(String),
    /// The rounds or planes were not enough.
    Unresolved(&'static str),
}

fn attempt(
    model: &Model,
    surface: &Surface,
    parting: &mut Parting,
    planes: &mut Planes,
    rules: &Rules,
    halves: bool,
) -> Result<Vec<Term>, Trouble> {
    let mut trouble = "";
    for _ in 0..MAX_ROUNDS {
        let division = Division {
            surface,
            separators: &parting.separators,
            boundaries: &parting.boundaries,
            size: model.size(),
        };
        let samples = division
            .samples()
            .map_err(|reason| Trouble::Wrong(reason.into()))?;
        if samples.len() > MOST_SAMPLES {
            break;
        }
        if !samples.iter().any(|sample| sample.inside) {
            return Err(Trouble::Wrong("its loops enclose nothing".into()));
        }
        let fits = |term: &Term| (rules.fits)(parting, term);
        let new = match cover(&samples, &parting.ranks, halves.then_some(&fits)) {
            Err(conflicts) => {
                trouble = "pieces of it lie on the same side of all its planes as others that are not of it";
                conflicts.iter().map(|c| between(c, surface)).collect()
            }
            Ok(terms) => {
                let new = (rules.refine)(parting, &terms, &samples);
                if new.is_empty() {
                    return Ok(terms);
                }
                trouble = "a convex piece of it has more sides than an object has cut planes";
                new
            }
        };
        if !parting.split(planes, &new) {
            break;
        }
    }
    Err(Trouble::Unresolved(trouble))
}

/// A plane between two pieces that no separator tells apart.
fn between(conflict: &Conflict, surface: &Surface) -> PlaneOf {
    let (p, q) = (conflict.inside.point, conflict.outside.point);
    (times(0.5, plus(p, q)), unit(within(minus(q, p), surface)))
}
