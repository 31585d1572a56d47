//! A ball on the screen, and whether its picture is a plain case.

use super::ball::Ball;
use super::outline::{Outline, Span, WordErrors};
use super::view::View;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;

pub(super) struct Placed {
    pub outline: Outline,
    pub span: Span,
    /// Where it may be drawn.
    pub window: ScreenBox,
    pub errors: WordErrors,
}

impl Placed {
    /// `None` if the ball could be refused, or reach beyond an end of the depth.
    pub fn of(ball: &Ball, view: &View, format: &Format) -> Option<Placed> {
        let outline = Outline::of(ball, view)?;
        let screen = view.screen();
        let span = match outline.span(view) {
            _ if view.is_behind(ball) => Span::Beside,
            span => span,
        };
        // The box of an object beside the screen is empty only if no end of the depth is passed.
        let is_unseen = view.is_behind(ball) || outline.is_within_ends(view, &screen);
        let (window, errors) = match span {
            Span::Beside if is_unseen => (screen, WordErrors::NONE),
            Span::Inside(window) if outline.is_within_ends(view, &window) => {
                let reach = [window.x1 - window.x0, window.y1 - window.y0];
                (
                    window,
                    WordErrors::of(reach.map(|n| 0.5 * n as f64 + 1.0), format),
                )
            }
            _ => {
                // Its box may be larger than it has to be.
                let errors = WordErrors::of([view.width, view.height].map(f64::from), format);
                (outline.touched(view, &errors)?, errors)
            }
        };
        let placed = Placed {
            outline,
            span,
            window,
            errors,
        };
        (span == Span::Beside && is_unseen || placed.is_safe(view, format)).then_some(placed)
    }

    /// It is not refused, and no end of the depth cuts it.
    fn is_safe(&self, view: &View, format: &Format) -> bool {
        let window = match self.span {
            Span::Inside(_) => self.window,
            _ => view.screen(),
        };
        let magnitudes = self.outline.magnitudes(&window, &self.errors);
        let ends = [format.z_low() as f64, format.z_max() as f64];
        magnitudes.fit(format.sum, format.quadratic)
            && self.outline.is_between(ends, &self.window, &self.errors)
    }
    /// Nothing that is drawn of the ball on its box is nearer.
    pub fn nearest(&self) -> f64 {
        let ScreenBox { x0, x1, y0, y1 } = self.window;
        let Outline { at, f1, outer, .. } = &self.outline;
        let along = |axis: usize, ends: [i64; 2]| {
            let [one, other] = ends.map(|n| f1[1 + axis] * (n as f64 - at[axis]));
            one.min(other)
        };
        let least = along(0, [x0, x1]) + along(1, [y0, y1]);
        f1[0] + least - outer.greatest().sqrt() - self.outline.f1_spare - self.errors.depth()
    }

    /// Calls `each` with the columns of a line, within the box, at which the ball is surely drawn, and with a depth
    /// that is not nearer than the one that is drawn there.
    pub fn covered(&self, y: i64, mut each: impl FnMut(i64, f64)) {
        let Outline { at, f1, inner, .. } = &self.outline;
        let v = y as f64 - at[1];
        let line = inner.on_line(v);
        // One more for the rounding of this sum.
        let least = self.errors.f2 + 1.0;
        let constant = f1[0] + f1[2] * v + (self.outline.f1_spare + self.errors.depth() + 1.0);
        for x in line.columns(-least, at[0], &self.window) {
            let u = x as f64 - at[0];
            let f2 = line.at(u);
            if f2 >= least {
                each(x, constant + f1[1] * u - f2.sqrt());
            }
        }
    }

    /// The same for the columns at which the ball may be drawn, with a depth that is not farther; ends early where
    /// `each` says so.
    pub fn may_cover(&self, y: i64, mut each: impl FnMut(i64, f64) -> bool) -> bool {
        let Outline { at, f1, outer, .. } = &self.outline;
        let v = y as f64 - at[1];
        let line = outer.on_line(v);
        let constant = f1[0] + f1[2] * v - (self.outline.f1_spare + self.errors.depth() + 1.0);
        let mut columns = line.columns(self.errors.f2 + 1.0, at[0], &self.window);
        columns.all(|x| {
            let u = x as f64 - at[0];
            each(x, constant + f1[1] * u - line.at(u).max(0.0).sqrt())
        })
    }
}
