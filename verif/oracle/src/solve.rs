//! What a pixel shows of one object, exactly: whole numbers, and roots of quadratic polynomials of whole numbers.

use crate::body::{Body, CutBody, Whole};
use crate::root::{Quadratic, Real};
use crate::verdict::{Ends, Solved};
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END};
use imogene_scene::Surface;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

impl Body {
    /// The first point at a pixel, in half pixels from the middle of the picture.
    pub fn solve(&self, x: i64, y: i64, ends: &Ends) -> Option<Solved> {
        match self {
            Body::Cut(body) => body.solve(x, y, ends),
            Body::Facet(facet) => facet.solve(x, y, ends),
        }
    }
}

/// One line of sight in the frame of an object.
pub(crate) struct Line<'a> {
    from: Whole,
    along: Whole,
    /// The quadric along it.
    pub(crate) q: Quadratic,
    ends: &'a Ends,
}

impl Line<'_> {
    /// A plane along it: constant and slope.
    pub(crate) fn along(&self, plane: &Whole) -> [BigInt; 2] {
        [dot(plane, &self.from), dot(plane, &self.along)]
    }
}

impl CutBody {
    fn solve(&self, x: i64, y: i64, ends: &Ends) -> Option<Solved> {
        let line = self.sight_line(x, y, ends);
        let found = match self.surface {
            Surface::Solid => self.solve_solid(&line),
            Surface::Patch => self.solve_patch(&line),
        };
        found.map(|(t, number)| Solved { t, number, part: 0 })
    }

    pub(crate) fn sight_line<'a>(&self, x: i64, y: i64, ends: &'a Ends) -> Line<'a> {
        let at = |[a, b, c]: &[Whole; 3]| -> Whole {
            std::array::from_fn(|k| &a[k] * x + &b[k] * y + &c[k])
        };
        let (from, along) = (at(&self.exact.from), at(&self.exact.along));
        let form = |u: &Whole, v: &Whole| -> BigInt {
            let rows = self.exact.form.iter().flatten().zip(u);
            let rows = rows.filter(|(_, a)| !a.is_zero());
            rows.map(|(row, a)| a * dot(row, v)).sum()
        };
        Line {
            q: Quadratic {
                a: form(&along, &along),
                b: form(&from, &along),
                c: form(&from, &from),
            },
            from,
            along,
            ends,
        }
    }

    /// The part of the line that near end and planes leave: start, its face, and end; `None` if that is nothing.
    fn kept(&self, line: &Line) -> Option<(BigRational, u8, Option<BigRational>)> {
        let (mut start, mut number, mut end) = (line.ends.first.clone(), FACE_NEAR_END, None);
        for (plane, &own) in self.exact.planes.iter().zip(&self.numbers) {
            let [at, slope] = line.along(plane);
            if slope.is_zero() {
                if at.is_positive() {
                    return None;
                }
                continue;
            }
            let bound = BigRational::new(-at, slope.clone());
            if slope.is_positive() {
                if end.as_ref().is_none_or(|end| bound < *end) {
                    end = Some(bound);
                }
            } else if bound > start {
                (start, number) = (bound, own);
            }
        }
        let last = line.ends.last.as_ref();
        let ends_before = end.as_ref().is_some_and(|end| *end < start);
        let nothing = ends_before || last.is_some_and(|last| start >= *last);
        (!nothing).then_some((start, number, end))
    }

    fn solve_solid(&self, line: &Line) -> Option<(Real, u8)> {
        let (start, number, end) = self.kept(line)?;
        let q = &line.q;
        if q.sign_at(&start) != Ordering::Greater {
            return Some((Real::Fraction(start), number));
        }
        // Outside at the start; it is entered where the quadric falls through zero.
        let entered = if q.a.is_zero() {
            q.b.is_negative()
                .then(|| Real::Fraction(BigRational::new(-&q.c, &q.b * 2)))?
        } else {
            let later = q.a.is_negative() || q.slope_at(&start) == Ordering::Less;
            if q.discriminant().is_negative() || !later {
                return None;
            }
            Real::root(q, q.a.is_negative())
        };
        let within = end.is_none_or(|end| entered.cmp_fraction(&end) != Ordering::Greater);
        let drawn = line.ends.end_after(&entered);
        let far = q.a.is_negative() && (!self.perspective || q.c.is_negative());
        (within && drawn).then_some((entered, if far { FACE_FAR } else { FACE_NEAR }))
    }

    fn solve_patch(&self, line: &Line) -> Option<(Real, u8)> {
        let q = &line.q;
        if q.a.is_zero() && q.b.is_zero() {
            // A line within the surface is seen from its beginning.
            let inside = q.c.is_zero().then(|| self.kept(line))??;
            return Some((Real::Fraction(inside.0), FACE_NEAR));
        }
        let mut roots = self.roots(q).into_iter();
        roots.find(|(t, _)| self.surely_keeps(line, t))
    }

    /// Where a line of sight meets the quadric, in ascending order, and the face; nothing if the line lies within it.
    pub(crate) fn roots(&self, q: &Quadratic) -> Vec<(Real, u8)> {
        if q.a.is_zero() {
            let only = || Real::Fraction(BigRational::new(-&q.c, &q.b * 2));
            let only = (!q.b.is_zero()).then(|| (only(), FACE_NEAR));
            return only.into_iter().collect();
        }
        if q.discriminant().is_negative() {
            return vec![];
        }
        let [low, high] = [false, true].map(|greater| Real::root(q, greater));
        // What is behind the eye comes after infinity.
        let zero = BigRational::zero();
        let is_second = !self.perspective || low.cmp_fraction(&zero) == Ordering::Greater;
        let number = if is_second { FACE_FAR } else { FACE_NEAR };
        vec![(low, FACE_NEAR), (high, number)]
    }

    fn surely_keeps(&self, line: &Line, t: &Real) -> bool {
        line.ends.hold(t)
            && self.exact.planes.iter().all(|plane| {
                let [at, slope] = line.along(plane);
                if slope.is_zero() {
                    return !at.is_positive();
                }
                let removed = slope.cmp(&BigInt::zero());
                t.cmp_fraction(&BigRational::new(-at, slope)) != removed
            })
    }
}

fn dot(u: &Whole, v: &Whole) -> BigInt {
    u.iter().zip(v).map(|(a, b)| a * b).sum()
}
