//! What a scene requires of a machine: the narrowest words that are loaded with the same integers, the slots, and the
//! guard bits from which on rounding decides nothing that is seen of its quadrics.
//!
//! Two things are asked of guard bits, at every pixel of every object's screen box, before any coefficient is rounded:
//!
//! * rounding adds at most one depth word to what the floor of the root and the dropped guard bits take from a face:
//!   half a word by f1, half a word by f2 through the root;
//! * no sign of f2 is open. With `|q2 - f2| <= e2` the check calls a sign open unless `f2' - e2 >= 0` or `f2' + 1 + e2
//!   <= 0`, where f2' is the floor of q2; so `|f2| >= 2 e2 + 1` closes it.
//!
//! Both bounds are those known beforehand, which halve with every bit, so that more bits never hurt. Cut planes have no
//! guard bits and no part in this.

use super::accumulators::plane_bits;
use super::depth::depth_terms;
use super::headroom::least_f2;
use imogene_contract::MachineWords;
use imogene_contract::slots;
use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::widths;
use imogene_prepare::{PreparedQuadric, PreparedScene, RoundingBounds, prepare};
use imogene_scene::FramedScene;
use serde::Serialize;

/// The narrowest machine of the scene at its depth word.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MachineNeeds {
    /// Widths as `--widths` takes them: fewest root and plane bits in which the scene prepares to the same integers, so
    /// that its picture is the same.
    pub widths: String,
    /// Slots as `--slots` takes them.
    pub slots: String,
    /// Why the root cannot be a bit shorter.
    pub root_limit: String,
    /// Why the plane word cannot be a bit shorter.
    pub plane_limit: String,
}

/// Searches the narrowest machine; `None` if other processors than quadric and patch draw a part of the scene.
pub fn machine_needs(scene: &FramedScene, prepared: &PreparedScene) -> Option<MachineNeeds> {
    if prepared.objects.iter().any(|o| o.quadric().is_none()) {
        return None;
    }
    let keeps = |widths: &MachineWords| keeps(scene, prepared, widths);
    // What the preparation said that the words need, if the scene prepares to the same integers in that.
    let wide = prepared.format.widths();
    let guess = prepared.needed().narrowed(&wide);
    let mut widths = if keeps(&guess).is_ok() { guess } else { wide };
    // Shortens a word as far as it goes, and says why no further.
    let mut narrow = |shorten: fn(&mut MachineWords)| loop {
        let mut less = widths;
        shorten(&mut less);
        match keeps(&less) {
            Ok(()) => widths = less,
            Err(why) => break why,
        }
    };
    let root_limit = narrow(|less| less.root -= 1);
    let plane_limit = narrow(|less| less.plane -= 1);
    Some(MachineNeeds {
        widths: widths::print(&widths),
        slots: slots::print(&prepared.fitted_slots()),
        root_limit,
        plane_limit,
    })
}

/// Whether a scene prepares to the same integers in other widths; if not, why.
fn keeps(scene: &FramedScene, own: &PreparedScene, widths: &MachineWords) -> Result<(), String> {
    let format = Format::fitted(widths).map_err(|e| e.to_string())?;
    let other = prepare(scene, format).map_err(|e| e.to_string())?;
    let scaled = |name| format!("{name}: its words are scaled to their widths and would be others");
    for (mine, others) in own.objects.iter().zip(&other.objects) {
        if mine.words() != others.words() {
            return Err(scaled(format!("object '{}'", mine.name())));
        }
    }
    // The preparation proves the exact depth of a plane, not what its rounded words reach.
    for (_, object) in other.quadrics() {
        if plane_bits(&object.words).iter().any(|&b| b > format.plane) {
            let name = &object.name;
            return Err(format!("object '{name}': the words of a plane would wrap"));
        }
    }
    for (mine, others) in own.volumes.iter().zip(&other.volumes) {
        if mine.words != others.words {
            return Err(scaled(mine.name.clone()));
        }
    }
    Ok(())
}

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
    let format = &prepared.format;
    let objects = prepared.quadrics().map(|(_, object)| object);
    let on_screen = objects.filter(|o| !o.words.screen_box.is_empty());
    let needs = on_screen.map(|o| guards(o, format));
    let needs: Vec<(u32, u32)> = needs.collect::<Option<_>>()?;
    let g1 = needs.iter().map(|n| n.0).max()?;
    let g2 = needs.iter().map(|n| n.1).max()?;
    let accepted = format.with_guards(g1, g2).is_ok();
    Some(ExactGuards { g1, g2, accepted })
}

fn guards(object: &PreparedQuadric, format: &Format) -> Option<(u32, u32)> {
    let (window, class) = (&object.words.screen_box, object.words.class);
    let least = least_f2(object);
    let linear = object.anchor.linear_bound(window);
    let quadratic = object.anchor.quadratic_bound(window);
    let after = |bound: f64, guards: u32| bound * 0.5f64.powi(guards as i32);
    let g2 = (0..=MOST).find(|&g| is_decided(after(quadratic, g), least, class, format))?;
    let g1 = (0..=MOST).find(|&g| after(linear, g) <= SHARE)?;
    // No depth of a prism is computed from f1.
    Some((if class == Class::Prism { 0 } else { g1 }, g2))
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
