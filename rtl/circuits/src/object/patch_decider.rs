//! Decision of a patch.

use super::clamped::Clamped;
use super::{Interval, PlaneAt, Roots, Seen, half_space_test};
use crate::rows::numbered;
use imogene_contract::words::{FAR_ROOT, NEAR_ROOT};
use imogene_hdl::{Bundle, Int, Value, module, net};

/// The first face of a bare surface that every plane keeps, all planes at once: each keeps or removes each of the two
/// faces without looking at the other face or at another plane, so that two signals of each plane (the source's E_F and
/// E_B) and two wide ANDs stand in the place of a chain of cuts.
///
/// A face in a plane is kept; a face outside `[ZLOW, ZMAX)` is not there. Latency 3. Section 2.4.3.
pub fn patch_decider(at: &str, roots: Roots, planes: Vec<PlaneAt>) -> Seen {
    let inputs = (roots, ("plane", planes, "plane #, beside the sums"));
    module("patch_decider", at, inputs, |(roots, planes)| {
        net! { let is_there = roots.is_inside & roots.in_box; }
        // The two ends are planes of constant depth: asked beside the planes, not before them.
        let is_left = |name: &str, sum: Int, face: u64| {
            let end = Clamped::of(name, sum, face).is_visible();
            let exists = (is_there & end).delayed_as(&format!("{name}_exists"), 2);
            let planes = numbered(&format!("keeps_{name}"), &planes);
            planes.fold(exists, |left, (at, plane)| {
                left & half_space_test(&at, *plane, sum, sum)
            })
        };
        net! {
            let near_left = is_left("near", roots.near_sum, NEAR_ROOT);
            let far_left = is_left("far", roots.far_sum, FAR_ROOT);
            let near_depth = roots.near_sum.low(roots.depth()).delay(2);
            let far_depth = roots.far_sum.low(roots.depth()).delay(2);
        }
        let faces = Interval::of_surface([near_left, far_left], [near_depth, far_depth]);
        faces.seen().registered()
    })
}
