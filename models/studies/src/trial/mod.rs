//! The trial of the bounds: random cases in every format, every error compared exactly with the bound that is stated
//! for it.
//!
//! A case is an exact f1 and f2 (any pair is a quadric) and an exact normal on a random box, at scales and in positions
//! where errors are greatest: contours through pixels, tangents, thin discs, factors whose rounding is the worst
//! possible. It is rounded, and bounded, as the preparation does; the golden words are evaluated at corners, about the
//! contour and at random pixels. An error and its bound are first computed in `f64`; unless the error is clearly
//! smaller they are compared in big integers, squares against squares.

pub mod case;
pub mod exact;
pub mod place;
pub mod random;
pub mod tally;

pub use tally::{Fared, Term, Violation};

use crate::kit::words::widest;
use case::Case;
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::widths;
use random::Random;
use serde::Serialize;
use tally::Tally;

const PIECE: u64 = 500;

/// Widths that are tried. Fourteen formats of the catalogue, by depth word and guard bits: the 28-bit word has room for
/// 8 guard bits of f2, the 32-bit word for none. Then eight of fitted machines: normals of 10 to 15 bits, root networks
/// without their last rows, and both, down to the shortest words.
pub const FORMATS: [MachineWords; 22] = [
    catalogue(16, 0, 0),
    catalogue(16, 2, 4),
    catalogue(16, 4, 8),
    catalogue(20, 0, 0),
    catalogue(20, 2, 4),
    catalogue(20, 4, 8),
    catalogue(24, 0, 0),
    catalogue(24, 2, 4),
    catalogue(24, 4, 8),
    catalogue(28, 0, 0),
    catalogue(28, 2, 4),
    catalogue(28, 4, 8),
    catalogue(32, 0, 0),
    catalogue(32, 4, 0),
    fitted(24, 24, 10, (0, 0), 0),
    fitted(24, 24, 13, (2, 4), 0),
    fitted(24, 24, 16, (0, 0), 1),
    fitted(24, 21, 15, (0, 0), 4),
    fitted(20, 18, 12, (2, 4), 2),
    fitted(16, 16, 14, (4, 8), 8),
    fitted(13, 11, 11, (1, 3), 3),
    fitted(8, 8, 10, (0, 0), 2),
];

const fn catalogue(depth: u32, guard_linear: u32, guard_quadratic: u32) -> MachineWords {
    fitted(depth, depth, 16, (guard_linear, guard_quadratic), 0)
}

const fn fitted(
    depth: u32,
    root: u32,
    normal: u32,
    guards: (u32, u32),
    dropped_rows: u32,
) -> MachineWords {
    // No plane is tried: its bound is that of its coefficients, like the bound of f1.
    MachineWords {
        root,
        ..widest(depth, normal, guards, dropped_rows)
    }
}

/// How one term's bound fared.
#[derive(Clone, Debug, Serialize)]
pub struct TermReport {
    /// Which.
    pub term: Term,
    /// The figures.
    #[serde(flatten)]
    pub fared: Fared,
}

/// What the trial of one format found.
#[derive(Clone, Debug, Serialize)]
pub struct TrialReport {
    /// Depth word.
    pub depth: u32,
    /// Guard bits of f1.
    pub guard_linear: u32,
    /// Guard bits of f2.
    pub guard_quadratic: u32,
    /// Root bits.
    pub root: u32,
    /// Bits of a normal component.
    pub normal: u32,
    /// Last digits of the root that are not computed.
    pub dropped_rows: u32,
    /// All widths, as text.
    pub widths: String,
    /// Cases tried.
    pub cases: u64,
    /// What was counted.
    #[serde(flatten)]
    pub tally: Tally,
    /// How each bound fared.
    pub terms: Vec<TermReport>,
}

impl TrialReport {
    /// The format in short: depth word and guard bits, and of a fitted machine what is not as in the catalogue.
    pub fn label(&self) -> String {
        let (g1, g2) = (self.guard_linear, self.guard_quadratic);
        let mut label = format!("{}, {g1}:{g2}", self.depth);
        for (name, value, usual) in [
            ("root", self.root, self.depth),
            ("normal", self.normal, Format::BASE.normal),
            ("dropped", self.dropped_rows, 0),
        ] {
            if value != usual {
                label += &format!(", {name} {value}");
            }
        }
        label
    }
}

/// Tries `cases` random cases; `piece_done` is called after each piece with the number of cases in it, from any thread.
/// With `always_exactly` every comparison is made in exact integers, which is slow.
pub fn run(
    format: &Format,
    cases: u64,
    seed: u64,
    always_exactly: bool,
    piece_done: impl Fn(u64) + Sync,
) -> TrialReport {
    let tallies = random::in_pieces(cases, PIECE, piece_done, |range| {
        let mut tally = Tally {
            always_exactly,
            ..Tally::default()
        };
        range.for_each(|case| try_case(format, seed, case, &mut tally));
        tally
    });
    let tally = tallies.into_iter().fold(Tally::default(), Tally::merged);
    let fared = |(term, _)| TermReport {
        term,
        fared: tally.fared(term),
    };
    let terms = Term::ALL.map(fared).to_vec();
    TrialReport {
        depth: format.depth,
        guard_linear: format.guard_linear,
        guard_quadratic: format.guard_quadratic,
        root: format.root,
        normal: format.normal,
        dropped_rows: format.dropped_rows,
        widths: widths::print(&format.widths()),
        cases,
        tally,
        terms,
    }
}

fn try_case(format: &Format, seed: u64, number: u64, tally: &mut Tally) {
    let mut random = Random::of_case(seed, number);
    let case = Case::draw(format, &mut random);
    tally.case = number;
    place::try_beforehand(&case, tally);
    place::try_outline(&case, tally);
    let places = places(&case, &mut random);
    for &place in &places {
        place::try_pixel(&case, place, tally);
    }
    for &place in &places[places.len() - 3..] {
        place::try_normals(&case, place, tally);
    }
}

/// Corners, middle, pixels about the contour, random pixels: the last three are these.
pub fn places(case: &Case, random: &mut Random) -> Vec<(i64, i64)> {
    let reach = &case.reach;
    let mut places = vec![
        (reach.x0, reach.y0),
        (reach.x1, reach.y0),
        (reach.x0, reach.y1),
        (reach.x1, reach.y1),
        (0, 0),
    ];
    places.extend(case.on_silhouette);
    let mut line = || random.between(reach.y0, reach.y1);
    for v in [line(), line(), reach.y0] {
        let [a, _, c, d, ..] = case.f2.factors.map(|n| n as f64);
        let line = v as f64;
        let (b, rest) = (c * line + d, case.f2.at(0, v) as f64);
        let inside = (b * b - 4.0 * a * rest).sqrt();
        // Where there is no root these are not numbers, and become column 0.
        for part in [-inside, inside, 0.0] {
            let root = (-b + part) / (2.0 * a);
            let column = root.floor() as i64;
            let held = [column, column.saturating_add(1)].map(|u| u.clamp(reach.x0, reach.x1));
            places.extend(held.map(|u| (u, v)));
        }
    }
    places.extend([(); 3].map(|()| random.place(reach)));
    places
}
