//! Prepared objects that the counts are taken from: real words, moved about in whole pixels.

use super::EvaluateError;
use super::hardware::MACHINE_PLANES;
use crate::detail;
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::words::Words;
use imogene_prepare::{Framing, PreparedObject, PreparedQuadric, PreparedScene, prepare};
use imogene_scene::SceneFile;

/// Side of the source's greater zones.
pub const ZONE_SIDE: u32 = 128;
/// Side of the box of an object in the source's examples.
pub const OBJECT_SIDE: u32 = 80;

/// A zone machine of so many object processors, with four planes and the source's greater zones.
pub fn zone_machine(object_processors: usize) -> ZoneMachine {
    ZoneMachine {
        slots: vec![FittedSlot::quadric(MACHINE_PLANES as u32); object_processors],
        volume_processors: 0,
        volume_planes: 0,
        ..detail::machine(ZONE_SIDE)
    }
}

fn prepared(text: &str, name: &str, size: (u32, u32)) -> Result<PreparedScene, EvaluateError> {
    let framed = SceneFile::parse(text, name)?.frame(size.0, size.1)?;
    Ok(prepare(&framed, Format::BASE)?)
}

/// An object that can be put anywhere.
#[derive(Clone, Debug)]
pub struct Moving {
    scene: PreparedScene,
    /// The object where it was prepared.
    pub object: PreparedQuadric,
}

impl Moving {
    /// A scene with a copy of the object at each of these places of its box.
    pub fn at(&self, places: &[[i64; 2]], [width, height]: [u32; 2]) -> PreparedScene {
        let copy = |&[x, y]: &[i64; 2]| {
            let mut object = self.object.clone();
            object.words = object.words.for_zone(-x, -y, width.into(), height.into());
            PreparedObject::Quadric(Box::new(object))
        };
        PreparedScene {
            width,
            height,
            objects: places.iter().map(copy).collect(),
            ..self.scene.clone()
        }
    }
}

/// A ball of 80 pixels, and of it the solid of three planes and the patch of four.
pub fn balls() -> Result<[Moving; 3], EvaluateError> {
    let balls = include_str!("balls.toml");
    let scene = prepared(balls, "balls.toml", (OBJECT_SIDE, OBJECT_SIDE))?;
    let empty = PreparedScene {
        objects: vec![],
        volumes: vec![],
        ..scene.clone()
    };
    Ok([0, 1, 2].map(|index: usize| {
        let object = scene.objects[index].quadric();
        let object = object.expect("a quadric or a patch").clone();
        let scene = empty.clone();
        Moving { scene, object }
    }))
}

/// Words of the other processors: a facet, a sphere and a cylinder.
pub fn others() -> Result<Vec<ProcessorWords>, EvaluateError> {
    let mesh = include_str!("../../../../scenes/processors/mesh.toml");
    let round = include_str!("../../../../scenes/processors/paraboloids.toml");
    let mesh = prepared(mesh, "mesh.toml", (160, 120))?.slots();
    let round = prepared(round, "paraboloids.toml", (160, 120))?.slots();
    let all = mesh.into_iter().chain(round);
    Ok(all.map(|slot| slot.words).collect())
}
