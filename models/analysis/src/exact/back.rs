//! Where objects end along a line of sight, behind the point at which they are first seen.

use super::number::SurdReal;
use super::ray::{Hit, RayObject, is_visible, ordered_roots};
use super::render::{DEPTH_FRACTION, Found};
use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_scene::{FramedObject, FramedScene, Surface};
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// The true back of a visible object of the quadric or the patch processor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactBack {
    /// Depth in depth words with [`DEPTH_FRACTION`] fraction bits.
    pub depth: i64,
    /// False where the back is the same point as the front: one face of a patch alone.
    pub is_apart: bool,
}

impl RayObject {
    /// The end of the solid part that begins at the first visible point, or the last kept face of a patch.
    pub fn back_of(&self, hit: &Hit, x: i64, y: i64) -> Hit {
        let polynomial = self.polynomial(x, y);
        let roots = ordered_roots(&polynomial);
        match self.surface {
            Surface::Patch => {
                let kept = |w: &SurdReal| is_visible(w) && self.planes_keep(w, x, y);
                let last = roots.and_then(|roots| roots.into_iter().rev().find(kept));
                last.map_or_else(|| hit.clone(), |w| Hit::new(w, FACE_FAR))
            }
            Surface::Solid => {
                let kept = self.kept_interval(x, y);
                let [_, ((n, d), number)] = kept.expect("a solid that is seen has an interval");
                let end = SurdReal::ratio(n, d);
                // Where the line of sight leaves the unbounded quadric that it is in at the first visible point.
                let [a, b, c] = &polynomial;
                let left = match roots {
                    Some([_, second]) if a.is_positive() => Some((second, FACE_FAR)),
                    // Outside between the roots: behind the second one it is inside for ever.
                    Some([first, _]) => {
                        (hit.number != FACE_FAR && hit.w <= first).then_some((first, FACE_NEAR))
                    }
                    None if a.is_zero() && b.is_positive() => {
                        Some((SurdReal::ratio(-c, b.clone()), FACE_NEAR))
                    }
                    None => None,
                };
                match left {
                    Some((leaving, face)) if leaving < end => Hit::new(leaving, face),
                    _ => Hit::new(end, number),
                }
            }
        }
    }
}

/// The true back at every pixel that shows an object of the quadric or the patch processor that is in no solid.
pub fn backs(pixels: &[Found], scene: &FramedScene, format: &Format) -> Vec<Option<ExactBack>> {
    let members: Vec<usize> = scene.solids.iter().flat_map(|s| s.tree.objects()).collect();
    let seen: BTreeSet<u32> = pixels.iter().flatten().map(|pixel| pixel.id).collect();
    let rays = |(id, object): (usize, &FramedObject)| {
        let is_alone = seen.contains(&(id as u32)) && !members.contains(&id);
        let alone = object.quadric().filter(|_| is_alone);
        Some(RayObject::new(alone?, scene))
    };
    let rays: Vec<Option<RayObject>> = scene.objects.iter().enumerate().map(rays).collect();
    let full = BigInt::from(format.z_max());
    let back = |(index, pixel): (usize, &Found)| {
        let pixel = pixel.as_ref()?;
        let object = rays[pixel.id as usize].as_ref()?;
        let width = scene.width as usize;
        let (x, y) = ((index % width) as i64, (index / width) as i64);
        let hit = object.first_hit(x, y)?;
        let w = object.back_of(&hit, x, y).w;
        let depth = w.fixed(&full, &full, DEPTH_FRACTION).to_i64();
        Some(ExactBack {
            depth: depth.expect("visible depths lie in the depth word"),
            is_apart: w != hit.w,
        })
    };
    pixels.par_iter().enumerate().map(back).collect()
}
