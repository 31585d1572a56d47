//! The preparation of one scene after another, of an animation: what is the same as before is not prepared again.
//!
//! The words of an object depend on the object in the camera frame, on what all objects share (picture size, format
//! and projection), and on the boxes of objects with which it has planes or a quadric in common. Those of a shadow
//! depend on its object, on where the source stands, and on the room that everything seen takes together. Only where
//! all of this is equal are words taken over, so that they are those of a preparation from scratch.

use super::cell::Cell;
use super::context::{Context, Options};
use super::error::PrepareError;
use super::known::{KeptObject, KeptShadow, Known};
use super::located::Located;
use super::prepared::PreparedObject;
use super::run::{Run, prepared_scene};
use super::scene::PreparedScene;
use super::seams::Place;
use super::volume::Volumes;
use imogene_golden::format::Format;
use imogene_scene::{FramedObject, FramedScene};
use serde::Serialize;
use std::collections::HashMap;

/// What one preparation leaves for the next.
#[derive(Default)]
pub struct Kept {
    context: Option<Context>,
    receivers: Option<Cell>,
    objects: HashMap<String, KeptObject>,
}

/// How much of a scene was prepared, and how much taken over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Reuse {
    /// Objects whose words were computed.
    pub objects_prepared: usize,
    /// Objects whose words are those of the scene before.
    pub objects_reused: usize,
    /// Shadow volumes whose words were computed, and the cones of spots.
    pub volumes_prepared: usize,
    /// Shadow volumes whose words are those of the scene before.
    pub volumes_reused: usize,
}

impl Kept {
    pub(crate) fn framed(&self, name: &str) -> Option<&FramedObject> {
        self.objects.get(name).map(|kept| &kept.framed)
    }

    fn known(&self, scene: &FramedScene, context: &Context) -> Known<'_> {
        if self.context.as_ref() != Some(context) {
            return Known::nothing(scene);
        }
        let known = |object: &FramedObject| {
            let kept = self.objects.get(object.name())?;
            (kept.framed == *object).then_some(kept)
        };
        Known {
            objects: scene.objects.iter().map(known).collect(),
            receivers: self.receivers,
        }
    }

    fn keep(
        &mut self,
        scene: &FramedScene,
        places: Vec<Option<Box<Place>>>,
        fresh: Vec<Option<PreparedObject>>,
        volumes: &Volumes,
        context: &Context,
    ) {
        let mut before = std::mem::take(&mut self.objects);
        let each = scene.objects.iter().zip(fresh).zip(places);
        for (index, ((object, fresh), place)) in each.enumerate() {
            let (framed, prepared) = match fresh {
                Some(prepared) => (object.clone(), prepared),
                None => {
                    let kept = before.remove(object.name());
                    let kept = kept.expect("what is not fresh was kept");
                    (kept.framed, kept.prepared)
                }
            };
            let kept = KeptObject {
                framed,
                place,
                prepared,
                seen: volumes.seen.get(index).copied(),
                shadows: vec![],
            };
            self.objects.insert(object.name().to_owned(), kept);
        }
        for shadow in &volumes.shadows {
            let name = scene.objects[shadow.object].name();
            let object = self.objects.get_mut(name).expect("kept above");
            object.shadows.push(KeptShadow {
                source: shadow.source,
                point: scene.sources[shadow.source].point.clone(),
                volumes: shadow.volumes.clone(),
            });
        }
        self.context = Some(context.clone());
        self.receivers = volumes.receivers;
    }
}

/// Prepares a scene whose objects have unique names with what is kept of the one before, and keeps it for the next;
/// the words are those of [`prepare_with`](super::prepare_with). `done` is called about once for each of
/// [`steps`](super::steps), from any thread.
/// Fails as a preparation from scratch does; then what was kept stays.
pub fn prepare_again(
    scene: &FramedScene,
    format: Format,
    options: Options,
    kept: &mut Kept,
    done: &(impl Fn() + Sync),
) -> Result<(PreparedScene, Reuse), PrepareError> {
    let context = Context::of(scene, format, options);
    let mut known = kept.known(scene, &context);
    let located = Located::new(scene, &context, &known);
    known.forget_moved(&located.places);
    let mut run = Run {
        scene,
        located: &located,
        known: &known,
        context: &context,
        done,
        missing: vec![],
    };
    let mut objects = run.objects()?;
    let fresh = objects.iter().zip(&known.objects);
    let fresh = fresh.map(|(object, known)| known.is_none().then(|| object.clone()));
    let fresh: Vec<Option<PreparedObject>> = fresh.collect();
    let volumes = run.volumes(&mut objects)?;
    let missing = run.missing;
    let reuse = Reuse::of(&fresh, &volumes);
    if missing.is_empty() {
        kept.keep(scene, located.places, fresh, &volumes, &context);
    } else {
        // What is left out must be named again.
        *kept = Kept::default();
    }
    let prepared = prepared_scene(scene, context, objects, volumes, missing)?;
    Ok((prepared, reuse))
}

impl Reuse {
    fn of(fresh: &[Option<PreparedObject>], volumes: &Volumes) -> Reuse {
        let objects_prepared = fresh.iter().flatten().count();
        let count = |reused: bool| -> usize {
            let shadows = volumes.shadows.iter().filter(|s| s.reused == reused);
            shadows.map(|shadow| shadow.volumes.len()).sum()
        };
        Reuse {
            objects_prepared,
            objects_reused: fresh.len() - objects_prepared,
            volumes_prepared: volumes.spots.len() + count(false),
            volumes_reused: count(true),
        }
    }
}
