//! Terms of a face, split until each is one object.

use super::arrangement::{Division, MAX_SEPARATORS, Sample};
use super::compile::Task;
use super::cover::{Conflict, Term, cover};
use super::curve::PlaneOf;
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

/// Whether a term is one object.
type Fits<'a> = &'a dyn Fn(&Parting, &Term) -> bool;
/// Planes that take apart terms that are not, a point and a normal each; none if all are.
type Refine<'a> = &'a dyn Fn(&Parting, &[Term], &[Sample]) -> Vec<PlaneOf>;

/// Terms of a parting, split until each is one object.
///
/// First with the fewest sides for every term, which drops a plane that only halves a convex piece; where that does
/// not end on a plane, once more with the halves.
pub fn terms(
    task: Task,
    parting: &mut Parting,
    planes: &mut Planes,
    fits: Fits,
    refine: Refine,
) -> Result<Vec<Term>, String> {
    if parting.separators.len() > MOST_SEARCHED {
        return Err("its border has too many pieces for the search".into());
    }
    let start = parting.clone();
    match attempt(task, parting, planes, fits, refine, false) {
        Err(Trouble::Unresolved(_)) if task.face().surface.is_plane() => {
            *parting = start;
            attempt(task, parting, planes, fits, refine, true)
        }
        other => other,
    }
    .map_err(|trouble| match trouble {
        Trouble::Wrong(reason) => reason.into(),
        Trouble::Unresolved(trouble) => format!(
            "it is not resolved within {MAX_ROUNDS} rounds of splitting and {MAX_SEPARATORS} planes: {trouble}"
        ),
    })
}

/// Why there are no terms.
enum Trouble {
    /// Its loops make no face.
    Wrong(&'static str),
    /// The rounds or planes were not enough.
    Unresolved(&'static str),
}

fn attempt(
    task: Task,
    parting: &mut Parting,
    planes: &mut Planes,
    fits: Fits,
    refine: Refine,
    halves: bool,
) -> Result<Vec<Term>, Trouble> {
    let surface = &task.face().surface;
    let mut trouble = "";
    for _ in 0..MAX_ROUNDS {
        let division = Division {
            surface,
            separators: &parting.separators,
            boundaries: &parting.boundaries,
            size: task.model.size(),
        };
        let samples = division.samples().map_err(Trouble::Wrong)?;
        if samples.len() > MOST_SAMPLES {
            break;
        }
        if !samples.iter().any(|sample| sample.inside) {
            return Err(Trouble::Wrong("its loops enclose nothing"));
        }
        let fits = |term: &Term| fits(parting, term);
        let new = match cover(&samples, &parting.ranks, halves.then_some(&fits)) {
            Err(conflicts) => {
                trouble = "pieces of it lie on the same side of all its planes as others that are not of it";
                conflicts.iter().map(|c| between(c, surface)).collect()
            }
            Ok(terms) => {
                let new = refine(parting, &terms, &samples);
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
