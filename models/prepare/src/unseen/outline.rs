//! What a processor computes of a ball, in depth words, with what rounding can change of it.

use super::ball::Ball;
use super::conic::Conic;
use super::view::{DepthWord, View};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;

/// f1 and f2 of a ball about the pixel place `at`, which need be no pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outline {
    pub(super) at: [f64; 2],
    /// Value at `at`, and for one column and one line more.
    pub(super) f1: [f64; 3],
    /// How far `f1` may be from that of the true ball within the box.
    pub(super) f1_spare: f64,
    /// Of the outer and the inner ball.
    pub(super) outer: Conic,
    pub(super) inner: Conic,
}

/// Greatest errors of the words of an object whose box reaches so many columns and lines from the pixel about which it
/// is rounded, in depth words: of f1, and of f2.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WordErrors {
    f1: f64,
    pub(super) f2: f64,
}

impl WordErrors {
    /// Of the exact expressions.
    pub const NONE: WordErrors = WordErrors { f1: 0.0, f2: 0.0 };

    /// Half a bit for each factor, times what it is multiplied with; the guard bits are not counted on. One more for
    /// what guard bits, the root and its rows that are left out cut off.
    pub fn of(reach: [f64; 2], format: &Format) -> WordErrors {
        let [u, v] = reach;
        // Roots stay half a bit below their word.
        let most = f64::exp2(f64::from(format.root) - 0.5);
        let root = format.root_form.error_at(most, format.dropped_rows);
        WordErrors {
            f1: 0.5 * (u + v + 1.0) + 2.0 + root,
            f2: 0.5 * (u * u + v * v + u * v + u + v + 1.0) + 2.0,
        }
    }

    /// Most that a drawn depth differs from the true one: `|sqrt(f2 + e) - sqrt(f2)| <= sqrt(|e|)`.
    pub(super) fn depth(&self) -> f64 {
        self.f1 + self.f2.sqrt()
    }
}

/// Where a ball is on the screen, beyond doubt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Span {
    /// All of it within the screen, at pixels of this box at most.
    Inside(ScreenBox),
    /// All of it beside the screen.
    Beside,
    /// Anything else.
    Open,
}

/// What is at least computed of a ball: greatest magnitudes.
pub(crate) struct Magnitudes {
    f1_and_root: f64,
    f2: f64,
}

/// Bits of the words that have to hold them, with room for a margin.
impl Magnitudes {
    pub fn fit(&self, sum: u32, quadratic: u32) -> bool {
        let most = |bits: u32| 0.99 * f64::exp2(f64::from(bits - 1)) - 4.0;
        self.f1_and_root < most(sum) && self.f2 < most(quadratic)
    }
}

impl Outline {
    /// Of a ball that lies wholly before the eye or behind it, and not too near to be a plain case; nothing for any
    /// other.
    pub fn of(ball: &Ball, view: &View) -> Option<Outline> {
        let pixels = view.camera.pixels;
        let (middle, z_max) = (view.middle(), view.z_max);
        let [x, y, z] = ball.centre;
        match view.depth {
            DepthWord::Orthographic { middle: zero, half } => {
                let scale = z_max / half;
                let unit = scale / pixels;
                let conic = |radius: f64| Conic {
                    c: (scale * radius).powi(2),
                    d: 0.0,
                    e: 0.0,
                    a: -unit * unit,
                    b: -unit * unit,
                    m: 0.0,
                };
                Some(Outline {
                    at: [middle[0] + x * pixels, middle[1] + y * pixels],
                    f1: [scale * (z - zero), 0.0, 0.0],
                    f1_spare: scale * ball.spare + 1.0,
                    outer: conic(ball.radius + ball.spare),
                    inner: conic(ball.radius - ball.spare),
                })
            }
            DepthWord::Perspective { near } => {
                // Then |c|^2 - r^2 is at least three quarters of |c|^2, whatever else is between r -+ spare.
                if z.abs() < 2.01 * ball.radius {
                    return None;
                }
                let length = x * x + y * y + z * z;
                let strength = |radius: f64| 2.0 * near * z_max / (length - radius * radius);
                let conic = |radius: f64| {
                    let (s, r) = (strength(radius).powi(2), radius * radius);
                    Conic {
                        c: s * r * (1.0 + (x * x + y * y) / (z * z)),
                        d: s * 2.0 * r * x / z / pixels,
                        e: s * 2.0 * r * y / z / pixels,
                        a: s * (r - z * z - y * y) / (pixels * pixels),
                        b: s * (r - z * z - x * x) / (pixels * pixels),
                        m: s * 2.0 * x * y / (pixels * pixels),
                    }
                };
                let s = strength(ball.radius);
                let [u, v] = view.farthest();
                let slant = 1.0 + (u + v) / pixels + (x.abs() + y.abs()) / z;
                Some(Outline {
                    at: [middle[0] + x / z * pixels, middle[1] + y / z * pixels],
                    f1: [
                        z_max - s * ((x * x + y * y) / z + z),
                        -s * x / pixels,
                        -s * y / pixels,
                    ],
                    // |s' p.c' - s p.c| <= s |p| spare + |s' - s| |p| |c|, and |s' - s| / s <= 8 spare / |c|.
                    f1_spare: 9.0 * s * slant * ball.spare + 1.0,
                    outer: conic(ball.radius + ball.spare),
                    inner: conic(ball.radius - ball.spare),
                })
            }
        }
    }

    /// Where the ball is seen.
    pub fn span(&self, view: &View) -> Span {
        // A millionth of a pixel covers the rounding of the ends.
        let Some([[x0, x1], [y0, y1]]) = self.ends(0.0) else {
            return Span::Open;
        };
        let (right, bottom) = (f64::from(view.width) - 1.0, f64::from(view.height) - 1.0);
        let along = |low: f64, high: f64, last: f64| {
            if low > 0.0 && high < last {
                Some(true)
            } else {
                (high < 0.0 || low > last).then_some(false)
            }
        };
        match (along(x0, x1, right), along(y0, y1, bottom)) {
            (Some(true), Some(true)) => Span::Inside(ScreenBox {
                x0: x0.ceil() as i64,
                x1: x1.floor() as i64,
                y0: y0.ceil() as i64,
                y1: y1.floor() as i64,
            }),
            (Some(_), Some(_)) => Span::Beside,
            _ => Span::Open,
        }
    }

    /// Least and greatest column and line at which f2 of the outer ball is not below `-spare`, a millionth of a pixel
    /// wider.
    fn ends(&self, spare: f64) -> Option<[[f64; 2]; 2]> {
        let Conic { c, d, e, a, b, m } = self.outer;
        let c = c + spare;
        // The greatest value of f2 along the other axis is of second degree in this one.
        let ends = |d: f64, e: f64, a: f64, b: f64| {
            let square = a - m * m / (4.0 * b);
            let linear = d - e * m / (2.0 * b);
            let constant = c - e * e / (4.0 * b);
            let root = (linear * linear - 4.0 * square * constant).sqrt();
            let ends = [
                (-linear + root) / (2.0 * square),
                (-linear - root) / (2.0 * square),
            ];
            (b < 0.0 && square < 0.0).then_some(ends)
        };
        let wider = |[low, high]: [f64; 2], at: f64| {
            let margin = 1e-6 + 1e-9 * (high - low);
            [at + low - margin, at + high + margin]
        };
        let (x, y) = (ends(d, e, a, b)?, ends(e, d, b, a)?);
        let all = [wider(x, self.at[0]), wider(y, self.at[1])];
        all.iter().flatten().all(|v| v.is_finite()).then_some(all)
    }

    /// The pixels of a box at which anything of the ball may be drawn.
    pub fn touched(&self, view: &View, errors: &WordErrors) -> Option<ScreenBox> {
        let [[x0, x1], [y0, y1]] = self.ends(errors.f2)?;
        let screen = view.screen();
        let clamped = |v: f64, last: i64| v.clamp(-1.0, last as f64 + 1.0) as i64;
        Some(ScreenBox {
            x0: clamped(x0.ceil(), screen.x1).max(0),
            x1: clamped(x1.floor(), screen.x1).min(screen.x1),
            y0: clamped(y0.ceil(), screen.y1).max(0),
            y1: clamped(y1.floor(), screen.y1).min(screen.y1),
        })
    }

    /// Greatest distance of the box from the middle, in columns and lines.
    fn reach(&self, window: &ScreenBox) -> [f64; 2] {
        let far =
            |low: i64, high: i64, at: f64| (at - low as f64).abs().max((high as f64 - at).abs());
        let ScreenBox { x0, x1, y0, y1 } = *window;
        [far(x0, x1, self.at[0]), far(y0, y1, self.at[1])]
    }

    /// Greatest magnitudes on a box.
    pub fn magnitudes(&self, window: &ScreenBox, errors: &WordErrors) -> Magnitudes {
        let [u, v] = self.reach(window);
        let Conic { c, d, e, a, b, m } = self.outer;
        let linear = d.abs() * u + e.abs() * v;
        let f2 = (c + linear).max(a.abs() * u * u + b.abs() * v * v + m.abs() * u * v + linear);
        let f1 = self.f1[0].abs() + self.f1[1].abs() * u + self.f1[2].abs() * v;
        Magnitudes {
            f1_and_root: f1 + self.f1_spare + errors.f1 + (c + linear + errors.f2).sqrt(),
            f2: f2 + errors.f2,
        }
    }

    /// True if the ball lies between the ends of the depth, and not within two pixels of depth of one.
    pub fn is_within_ends(&self, view: &View, window: &ScreenBox) -> bool {
        let end = view.z_max - 2.0 * view.words_per_pixel();
        self.is_between([-end, end], window, &WordErrors::NONE)
    }

    /// True if all that is computed of the ball lies between these depth words.
    pub fn is_between(
        &self,
        [low, high]: [f64; 2],
        window: &ScreenBox,
        errors: &WordErrors,
    ) -> bool {
        let [u, v] = self.reach(window);
        let spread = self.f1[1].abs() * u
            + self.f1[2].abs() * v
            + self.outer.greatest().sqrt()
            + self.f1_spare
            + errors.depth();
        low < self.f1[0] - spread && self.f1[0] + spread < high
    }
}
