//! Golden colours held against those that the tracer allows.

use super::{CLOSE_LEVELS, Comparison, Difference, Judge, Mark, Painted};
use crate::colour::{Colours, Levels, Surface};
use crate::trace::TracedPixel;
use rayon::prelude::*;

/// What is seen of an object at a pixel.
struct Layer {
    /// Its depth in depth words, and how far others must be from it to be told apart.
    depth: f64,
    reach: f64,
    surface: Surface,
}

impl Judge<'_> {
    /// What the tracer sees at a pixel, if the normal is known.
    fn layer(&self, at: (usize, usize), seen: &TracedPixel) -> Option<Layer> {
        let normal = self.pair.golden.normal[at.1 * self.pair.traced.width + at.0];
        let place = (at.0 as i64, at.1 as i64);
        let (bounds, tracer) = (self.bounds, self.tracer);
        let off = bounds.normal(seen.object, seen.number, place, normal)?;
        let reach = self.bound(seen, at) + self.slack(seen);
        let share = reach / bounds.z_max;
        let (t, normal) = tracer.normal(at.0 as u32, at.1 as u32, seen, share)?;
        Some(Layer {
            depth: self.depth(seen),
            reach,
            surface: Surface {
                object: seen.object,
                t,
                normal,
                off,
            },
        })
    }
}

/// The levels that the tracer allows at a pixel; nothing where faces or their order are open.
fn levels(judges: &[Judge], colours: &Colours, at: (usize, usize)) -> Option<Levels> {
    let index = at.1 * judges[0].pair.traced.width + at.0;
    // Nothing is there, or all that is needed is known.
    let seen = |judge: &Judge| match &judge.pair.traced.pixels[index] {
        None => Some(None),
        Some(pixel) => judge.layer(at, pixel).map(Some),
    };
    let seen: Option<Vec<Option<Layer>>> = judges.iter().map(seen).collect();
    let mut seen = seen?;
    let surface = seen.remove(0);
    let mut layers: Vec<Layer> = seen.into_iter().flatten().collect();
    layers.sort_by(|a, b| b.depth.total_cmp(&a.depth));
    let is_told =
        |far: &Layer, near: &Layer| (far.depth - near.depth).abs() > far.reach + near.reach;
    let apart = layers.windows(2).all(|two| is_told(&two[0], &two[1]));
    let before = |layer: &&Layer| surface.as_ref().is_none_or(|s| layer.depth < s.depth);
    let behind = surface.as_ref();
    if !apart || behind.is_some_and(|s| layers.iter().any(|layer| !is_told(s, layer))) {
        return None;
    }
    let before = layers.iter().filter(before).map(|layer| &layer.surface);
    let before: Vec<&Surface> = before.collect();
    let (x, y) = judges[0].tracer.sight.place(at.0 as u32, at.1 as u32);
    colours.seen((x, y), behind.map(|layer| &layer.surface), &before)
}

impl Comparison {
    /// Compares the colours of pixels at which both pictures show the same; marks those that differ.
    pub(super) fn add_colours(&mut self, judges: &[Judge], painted: &Painted, marks: &mut [Mark]) {
        let (width, traced) = (judges[0].pair.traced.width, &judges[0].pair.traced);
        let of = |index: usize| {
            let at = (index % width, index / width);
            let is_alike = marks[index] <= Mark::Band;
            is_alike.then(|| levels(judges, &painted.colours, at))?
        };
        let allowed: Vec<Option<Levels>> = (0..marks.len()).into_par_iter().map(of).collect();
        let golden = painted.golden.as_chunks::<3>().0;
        for (index, (allowed, &golden)) in allowed.into_iter().zip(golden).enumerate() {
            let Some(allowed) = allowed else { continue };
            self.colours += 1;
            let each = || allowed.iter().zip(golden.map(f64::from));
            if each().all(|(allowed, _)| 0.5 * allowed.width() <= CLOSE_LEVELS) {
                let off = each().map(|(allowed, golden)| (golden - allowed.middle()).abs());
                self.colours_known += 1;
                self.colour_error = off.fold(self.colour_error, f64::max);
            }
            if each().all(|(allowed, golden)| allowed.lo <= golden && golden <= allowed.hi) {
                continue;
            }
            self.colours_beyond_bound += 1;
            marks[index] = Mark::Colour;
            let at = (index % width, index / width);
            self.list(Difference {
                colour: Some((golden, allowed.map(|v| [v.lo, v.hi]))),
                ..judges[0].difference(at, traced.pixels[index])
            });
        }
    }
}
