//! What a scene needs and has, in short: the machine, and the objects that a person may want to know of.

use super::guards::{ExactGuards, exact_guards};
use super::needs::{MachineNeeds, machine_needs};
use super::pixels::Shows;
use super::report::{ObjectReport, QuadricReport};
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;
use serde::Serialize;

/// The scene in short; objects by their names.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// The narrowest machine; `None` if there are objects of other processors than quadric and patch.
    pub machine: Option<MachineNeeds>,
    /// Guard bits from which on rounding adds at most a depth word to a quadric's face and leaves no silhouette pixel
    /// open; nothing where none do.
    pub guards: Option<ExactGuards>,
    /// Objects that need the front-view path.
    pub front_view: Vec<String>,
    /// Prisms.
    pub prisms: Vec<String>,
    /// Quadrics that are no curved surface.
    pub degenerate: Vec<String>,
    /// Objects with planes that are half-planes of the screen.
    pub perpendicular_planes: Vec<String>,
    /// Objects with planes that change no pixel.
    pub planes_without_effect: Vec<String>,
    /// Objects that no pixel of the picture shows.
    pub never_shown: Vec<String>,
    /// Objects whose material does not mirror light.
    pub without_highlights: Vec<String>,
}

pub(super) fn summary(
    scene: &FramedScene,
    prepared: &PreparedScene,
    objects: &[ObjectReport],
) -> Summary {
    let all = |is: &dyn Fn(&ObjectReport) -> bool| -> Vec<String> {
        let found = objects.iter().filter(|o| is(o));
        found.map(|o| o.name.clone()).collect()
    };
    let quadrics = |is: fn(&QuadricReport) -> bool| all(&|o| o.quadric().is_some_and(is));
    Summary {
        machine: machine_needs(scene, prepared),
        guards: exact_guards(prepared),
        front_view: quadrics(|o| o.front_view),
        prisms: quadrics(|o| o.prism),
        degenerate: quadrics(|o| o.degenerate),
        perpendicular_planes: quadrics(|o| !o.perpendicular_planes.is_empty()),
        planes_without_effect: quadrics(|o| !o.planes_without_effect.is_empty()),
        never_shown: all(&|o| o.shows != Shows::Visible),
        without_highlights: all(&|o| !o.highlights),
    }
}

/// Pixels of the golden picture that show each object.
pub(super) fn visible_pixels(prepared: &PreparedScene) -> Vec<usize> {
    let frame = prepared.frame(|| ());
    let mut pixels = vec![0; prepared.objects.len()];
    for id in &frame.id {
        if let Ok(id) = usize::try_from(*id) {
            pixels[id] += 1;
        }
    }
    for layer in &frame.layers {
        let both = layer.depth.iter().zip(&frame.depth);
        pixels[layer.object] = both.filter(|(own, surface)| own < surface).count();
    }
    pixels
}
