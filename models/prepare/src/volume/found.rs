//! What is found of volumes the first time that a scene is prepared, and is the same in any words.

use super::shadow::{ShadowPart, SourceInside, mesh_shadow_parts, shadow_parts};
use crate::cell::Cell;
use crate::context::Context;
use crate::depth::Depth;
use crate::memo::Memo;
use crate::perspective::{ScreenQuadric, on_screen};
use crate::planes::PlacedPlane;
use crate::prepared::Beginning;
use crate::screen_box::{Region, Search};
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{FramedObject, FramedScene, Plane, Quadric, Surface};
use std::sync::Arc;

/// A volume where objects can be seen.
pub struct VolumePlace {
    /// It has planes alone.
    pub is_everywhere: bool,
    /// Its quadric and its planes on the screen; it begins at the first.
    pub screen: ScreenQuadric,
    pub planes: Vec<PlacedPlane>,
    pub depth: Depth,
    pub window: ScreenBox,
    /// Least and greatest depth of the receivers.
    pub depths: (f64, f64),
}

impl VolumePlace {
    pub fn new(quadric: &Quadric, planes: &[Plane], receivers: &Cell, context: &Context) -> Self {
        let (screen, projected) = on_screen(quadric, planes, &context.inverse_distance);
        let region = Region::new(&screen.q, &projected, Surface::Solid);
        let (width, height) = (context.width, context.height);
        let (middle, reach) = (receivers.centre[2], receivers.half[2]);
        VolumePlace {
            is_everywhere: quadric.is_everywhere(),
            window: region.box_within(*receivers, width, height, Search::COARSE),
            screen,
            planes: projected.into_iter().map(PlacedPlane::of).collect(),
            depth: Depth::default(),
            depths: (middle - reach, middle + reach),
        }
    }
}

/// The parts of a shadow, each with where it begins.
pub type ShadowPlaces = Result<Arc<[(Beginning, VolumePlace)]>, SourceInside>;

/// Found once.
#[derive(Default)]
pub struct Found {
    /// Near and far depth of an object.
    pub depths: Memo<usize, Option<(f64, f64)>>,
    /// Shadows by source, caster, and the bits of the cell of the receivers.
    shadows: Memo<(usize, usize, [[u64; 3]; 2]), ShadowPlaces>,
}

impl Found {
    /// The shadow of an object from a source.
    pub fn shadow(
        &self,
        scene: &FramedScene,
        (source, object): (usize, usize),
        receivers: &Cell,
        context: &Context,
    ) -> ShadowPlaces {
        let bits = [receivers.centre, receivers.half].map(|at| at.map(f64::to_bits));
        self.shadows.get((source, object, bits), || {
            let place = |part: &ShadowPart| {
                let place = VolumePlace::new(&part.quadric, &part.planes, receivers, context);
                (part.beginning, place)
            };
            let point = &scene.sources[source].point;
            let parts = match &scene.objects[object] {
                FramedObject::Mesh(mesh) => mesh_shadow_parts(mesh, point),
                object => shadow_parts(object.caster().expect("it casts a shadow"), point)?,
            };
            Ok(parts.iter().map(place).collect())
        })
    }
}
