//! What exactness costs: guard bits from which on rounding decides nothing that is seen of the quadrics of a scene.
//!
//! Two things are asked of them, at every pixel of every object's screen box, before any coefficient is rounded:
//!
//! * rounding adds at most one depth word to what the floor of the root and the dropped guard bits take from a face:
//!   half a word by f1, half a word by f2 through the root;
//! * no sign of f2 is open. With `|q2 - f2| <= e2` the check calls a sign open unless `f2' - e2 >= 0` or `f2' + 1 + e2
//!   <= 0`, where f2' is the floor of q2; so `|f2| >= 2 e2 + 1` closes it.
//!
//! Both bounds are those known beforehand, which halve with every bit, so that more bits never hurt. Cut planes have no
//! guard bits and no part in this.

use super::depth::depth_terms;
use super::headroom::least_f2;
use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::{PreparedQuadric, PreparedScene, RoundingBounds};
use serde::Serialize;

/// Most that f1, and f2 through the root, may add to a depth.
const SHARE: f64 = 0.5;
/// Guard bits beyond which no search goes; formats have 16 at most.
const MOST: u32 = 64;

/// Guard bits that leave nothing to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ExactGuards {
    /// Of f1.
    pub g1: u32,
    /// Of f2.
    pub g2: u32,
    /// Whether the format can have so many; if not, a longer depth word is the answer.
    pub accepted: bool,
}

/// The least guard bits; `None` if there is no quadric on the screen, or one whose f2 is within a unit of zero at some
/// pixel, which no guard bits of this depth word tell apart.
pub fn exact_guards(prepared: &PreparedScene) -> Option<ExactGuards> {
    let objects = prepared.quadrics().map(|(_, object)| object);
    let each = objects.filter(|o| !o.words.screen_box.is_empty());
    let format = &prepared.format;
    let needs: Option<Vec<(u32, u32)>> = each.map(|o| needs(o, format)).collect();
    let needs = needs.filter(|needs| !needs.is_empty())?;
    let g1 = needs.iter().map(|n| n.0).max()?;
    let g2 = needs.iter().map(|n| n.1).max()?;
    let accepted = format.with_guards(g1, g2).is_ok();
    Some(ExactGuards { g1, g2, accepted })
}

fn needs(object: &PreparedQuadric, format: &Format) -> Option<(u32, u32)> {
    let window = &object.words.screen_box;
    let anchor = object.anchor;
    let least = least_f2(object);
    let after = |bound: f64, guards: u32| bound * 0.5f64.powi(guards as i32);
    let linear = anchor.linear_bound(window);
    let quadratic = anchor.quadratic_bound(window);
    let g2 = |g: &u32| is_decided(after(quadratic, *g), least, object.words.class, format);
    let g2 = (0..=MOST).find(g2)?;
    let g1 = (0..=MOST).find(|&g| after(linear, g) <= SHARE)?;
    Some(match object.words.class {
        // No depth of it is computed from f1.
        Class::Prism => (0, g2),
        _ => (g1, g2),
    })
}

/// Whether an error e2 of f2 leaves every sign closed and adds no more than its share to a depth, if no `|f2|` is less
/// than `least`.
fn is_decided(error: f64, least: f64, class: Class, format: &Format) -> bool {
    if least < 2.0 * error + 1.0 {
        return false;
    }
    let bounds = RoundingBounds {
        f2: error,
        // As with any number of guard bits.
        dropped_f2: 1.0,
        ..RoundingBounds::of_format(format)
    };
    let computed = (least - error - 1.0).floor();
    class == Class::Prism || depth_terms(&bounds, computed as i64).quadratic <= SHARE
}
