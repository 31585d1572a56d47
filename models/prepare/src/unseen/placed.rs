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
}
