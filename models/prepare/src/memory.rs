//! What a preparation takes of memory, before it is begun.
//!
//! Coefficients are exact, and their digits grow with those of the camera and of each place. The figures here are
//! measured of objects whose places have three digits after the point, seen by a camera that looks along no axis
//! (`models/prepare/tests/memory.rs` holds them against what is taken).

use imogene_scene::{Object, SceneFile, Shape};

/// Bytes of an object that is framed and prepared.
const OBJECT: u64 = 8_600;
/// More for each of its cuts.
const CUT: u64 = 3_000;
/// More for each corner of a mesh, which has words for every facet around it.
const CORNER: u64 = 4_000;
/// Of an object that is left out.
const UNSEEN: u64 = 400;
/// Of one volume of a shadow.
const VOLUME: u64 = 8_000;
/// Of anything else, such as the picture.
const REST: u64 = 16 << 20;

/// Bytes that framing and preparing a scene takes at most, beside the scene itself.
pub fn of_scene(scene: &SceneFile) -> u64 {
    of_objects(scene, scene.objects.iter().map(|object| (object, false)))
}

/// The same of these objects, each with whether it is left out.
pub(super) fn of_objects<'a>(
    scene: &SceneFile,
    objects: impl Iterator<Item = (&'a Object, bool)>,
) -> u64 {
    let sources = scene.lights.iter().filter(|light| light.shadows).count() as u64;
    let of_one = |(object, is_unseen): (&Object, bool)| {
        if is_unseen {
            return UNSEEN;
        }
        let cuts = object.cuts.len() as u64;
        // A face that is not plane is two facets, each with a shadow.
        let (corners, parts) = match &object.shape {
            Shape::Mesh(mesh) => (mesh.vertices.len() as u64, 2 * mesh.faces.len() as u64),
            _ => (0, 1 + cuts),
        };
        let volumes = match object.casts_shadow {
            true => sources * parts,
            false => 0,
        };
        OBJECT + CUT * cuts + CORNER * corners + VOLUME * volumes
    };
    REST + objects.map(of_one).sum::<u64>()
}
