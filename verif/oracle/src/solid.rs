//! Solids at a pixel, exactly, by points: the line of sight is divided wherever it crosses a quadric or a plane of one
//! of their objects, and a point of each piece is in the solid or is not, as the scene file says.
//!
//! Neither depths of fronts and backs nor products take part.

use crate::body::CutBody;
use crate::interval::Interval;
use crate::root::Real;
use crate::solve::Line;
use crate::verdict::{Ends, Solved};
use imogene_algebra::rational::integer;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END};
use imogene_scene::{Object, Operand, Operation};
use num_rational::BigRational;
use num_traits::Zero;
use std::cmp::Ordering;

/// A solid, and the indices of its objects by their names.
#[derive(Debug)]
pub struct SolidBody {
    operation: Operation,
    members: Vec<(String, u32)>,
}

/// A face of an object on a line of sight.
struct Crossing {
    t: Real,
    /// It lies here.
    about: Interval,
    object: u32,
    number: u8,
}

impl Crossing {
    fn new(t: Real, object: u32, number: u8) -> Crossing {
        let [low, high] = <[BigRational; 2]>::from(t.between(64)).map(|end| Interval::about(&end));
        Crossing {
            t,
            about: Interval::new(low.lo, high.hi),
            object,
            number,
        }
    }

    /// Exactly where intervals cannot tell.
    fn compare(&self, other: &Crossing) -> Ordering {
        if self.about.below(other.about) {
            return Ordering::Less;
        }
        if other.about.below(self.about) {
            return Ordering::Greater;
        }
        self.t.compare(&other.t)
    }
}

/// An object of a solid on a line of sight.
pub(crate) type Member<'a> = (u32, &'a CutBody);

impl SolidBody {
    /// Of a solid among the objects of a flat scene.
    pub fn new(operation: &Operation, objects: &[Object]) -> SolidBody {
        let index = |name: &str| objects.iter().position(|object| object.name == name);
        let named = |name: &str| Some((name.to_owned(), index(name)? as u32));
        SolidBody {
            members: operation.names().into_iter().filter_map(named).collect(),
            operation: operation.clone(),
        }
    }

    /// True if an object is one of its own.
    pub fn has(&self, object: u32) -> bool {
        self.members.iter().any(|(_, own)| *own == object)
    }

    /// The first point at a pixel, of the objects that may be met there.
    pub(crate) fn solve(
        &self,
        met: &[Member],
        (x, y): (i64, i64),
        ends: &Ends,
    ) -> Option<(u32, Solved)> {
        let own = met.iter().filter(|(object, _)| self.has(*object));
        let lines = own.map(|&(object, body)| (object, body, body.sight_line(x, y, ends)));
        let lines: Vec<(u32, &CutBody, Line)> = lines.collect();
        let all = lines.iter().flat_map(|(object, body, line)| {
            let own = body.crossings(line).into_iter();
            own.map(|(t, number)| Crossing::new(t, *object, number))
        });
        let mut crossings: Vec<Crossing> = all.filter(|crossing| ends.hold(&crossing.t)).collect();
        crossings.sort_by(Crossing::compare);
        // A line may be within an object from the beginning.
        let first = || Real::Fraction(ends.first.clone());
        let cap = |(object, ..): &(u32, _, _)| Crossing::new(first(), *object, FACE_NEAR_END);
        crossings.splice(0..0, lines.iter().map(cap));
        let is_in = |object: u32, at: &BigRational| {
            let mut own = lines.iter().filter(|(own, ..)| *own == object);
            own.any(|(_, body, line)| body.has(line, at))
        };
        let mut before = None;
        for (index, crossing) in crossings.iter().enumerate() {
            let next = crossings.get(index + 1);
            let Some(at) = behind(crossing, next, ends) else {
                continue;
            };
            let is_behind = |object: u32| is_in(object, &at);
            if !self.contains(&self.operation, &is_behind) {
                before = Some(at);
                continue;
            }
            // Of the faces at this point, that of an object whose inside begins or ends there: a front first, then the
            // earlier object.
            let was_in = |object| before.as_ref().is_some_and(|at| is_in(object, at));
            let faces = crossings[..=index].iter().filter(|face| {
                let is_cap = face.number == FACE_NEAR_END && is_behind(face.object);
                let changes = is_cap || was_in(face.object) != is_behind(face.object);
                changes && face.compare(crossing) == Ordering::Equal
            });
            let face = faces.min_by_key(|face| (!is_behind(face.object), face.object))?;
            // A back is seen from behind, where the far root of a quadric is the near one.
            let number = match (is_behind(face.object), face.number) {
                (false, FACE_NEAR) => FACE_FAR,
                (false, FACE_FAR) => FACE_NEAR,
                (_, number) => number,
            };
            let t = face.t.clone();
            return Some((face.object, Solved { t, number, part: 0 }));
        }
        None
    }

    /// What the scene file says of a point.
    fn contains(&self, operation: &Operation, is_in: &dyn Fn(u32) -> bool) -> bool {
        let holds = |operand: &Operand| match operand {
            Operand::Object(name) => {
                let mut members = self.members.iter();
                members.any(|(own, object)| own == name && is_in(*object))
            }
            Operand::Operation(operation) => self.contains(operation, is_in),
        };
        let mut operands = operation.operands().iter();
        match operation {
            Operation::Union(_) => operands.any(holds),
            Operation::Intersection(_) => operands.all(holds),
            Operation::Difference(_) => operands.next().is_some_and(holds) && !operands.any(holds),
        }
    }
}

/// A fraction behind a crossing and before the next one, or the end; `None` if both are one point.
fn behind(from: &Crossing, next: Option<&Crossing>, ends: &Ends) -> Option<BigRational> {
    if let Some(next) = next {
        let middle = 0.5 * (from.about.hi + next.about.lo);
        if from.about.hi < middle && middle < next.about.lo {
            return BigRational::from_float(middle);
        }
    }
    if next.is_some_and(|next| next.compare(from) == Ordering::Equal) {
        return None;
    }
    let mut bits = 64;
    loop {
        let (_, low) = from.t.between(bits);
        let high = match (next, &ends.last) {
            (Some(next), _) => next.t.between(bits).0,
            (None, Some(last)) => last.clone(),
            (None, None) => &low + integer(1),
        };
        if low < high {
            return Some((low + high) / integer(2));
        }
        bits *= 2;
    }
}

impl CutBody {
    /// Where a line of sight crosses the quadric and the planes, each with the number of the face.
    fn crossings(&self, line: &Line) -> Vec<(Real, u8)> {
        let planes = self.exact.planes.iter().zip(&self.numbers);
        let planes = planes.filter_map(|(plane, &number)| {
            let [at, slope] = line.along(plane);
            (!slope.is_zero()).then(|| (Real::Fraction(BigRational::new(-at, slope)), number))
        });
        // Of two roots that are one the far face is seen.
        let roots = self.roots(&line.q).into_iter().rev();
        planes.chain(roots).collect()
    }

    /// True if a point of a line of sight is inside.
    fn has(&self, line: &Line, at: &BigRational) -> bool {
        let kept = self.exact.planes.iter().all(|plane| {
            let [constant, slope] = line.along(plane);
            BigRational::from_integer(constant) + BigRational::from_integer(slope) * at
                <= BigRational::zero()
        });
        kept && line.q.sign_at(at) != Ordering::Greater
    }
}
