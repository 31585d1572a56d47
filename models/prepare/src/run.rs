//! The preparation of a scene.

use super::context::{Context, Options};
use super::error::{Missing, PrepareError};
use super::known::Known;
use super::layers::layers;
use super::located::Located;
use super::object;
use super::prepared::PreparedObject;
use super::scene::PreparedScene;
use super::solids::PreparedSolids;
use super::volume::{self, Volumes};
use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::Class;
use imogene_scene::{CutOff, End, FramedObject, FramedScene};
use rayon::prelude::*;

/// The note on an object of which something lies before the range of the depth word.
const NEAR_END_CUTS: &str = "reaches nearer than the near end of the depth: what is nearer is cut off, and a solid is \
                             seen open there";
/// The same behind it.
const FAR_END_CUTS: &str =
    "reaches farther than the far end of the depth: what is farther is cut off";

/// Prepares a scene for a format.
pub fn prepare(scene: &FramedScene, format: Format) -> Result<PreparedScene, PrepareError> {
    prepare_with(scene, format, Options::default())
}

/// Prepares a scene for machines that have quadric and patch processors alone, so that an object that the eye lies on
/// is refused.
pub fn prepare_for_roots(
    scene: &FramedScene,
    format: Format,
) -> Result<PreparedScene, PrepareError> {
    prepare_with(scene, format, Options::ROOTS)
}

/// Prepares a scene with options.
pub fn prepare_with(
    scene: &FramedScene,
    format: Format,
    options: Options,
) -> Result<PreparedScene, PrepareError> {
    prepare_reporting(scene, format, options, &|| ())
}

/// Where the objects of a scene are on its screen: exact, and the same in any words, so that preparations of one scene
/// for many formats share it.
pub struct LocatedScene(Located);

impl LocatedScene {
    /// Finds the boxes of all objects.
    pub fn new(scene: &FramedScene) -> LocatedScene {
        // The format has no say in it.
        let context = Context::of(scene, Format::BASE, Options::default());
        LocatedScene(Located::new(scene, &context, &Known::nothing(scene)))
    }

    /// [`prepare_with`] of the scene that was located.
    pub fn prepare(
        &self,
        scene: &FramedScene,
        format: Format,
        options: Options,
    ) -> Result<PreparedScene, PrepareError> {
        let context = Context::of(scene, format, options);
        prepare_located(scene, &self.0, context, &|| ())
    }
}

/// The objects that cannot be prepared for a format, by index, each with its reason; shadows are not looked at.
pub fn refused(
    scene: &FramedScene,
    format: Format,
    options: Options,
) -> Vec<(usize, PrepareError)> {
    let context = Context::of(scene, format, options);
    let located = Located::new(scene, &context, &Known::nothing(scene));
    let problem = |(index, object)| Some((index, located.prepare(index, object, &context).err()?));
    let objects = scene.objects.par_iter().enumerate();
    objects.filter_map(problem).collect()
}

/// Steps of a preparation, for a bar of its progress.
pub fn steps(scene: &FramedScene) -> u64 {
    (scene.objects.len() + volume::pairs(scene).len()) as u64
}

/// Prepares a scene; `done` is called about once for each of [`steps`], from any thread.
pub fn prepare_reporting(
    scene: &FramedScene,
    format: Format,
    options: Options,
    done: &(impl Fn() + Sync),
) -> Result<PreparedScene, PrepareError> {
    let context = Context::of(scene, format, options);
    let located = Located::new(scene, &context, &Known::nothing(scene));
    prepare_located(scene, &located, context, done)
}

fn prepare_located(
    scene: &FramedScene,
    located: &Located,
    context: Context,
    done: &(impl Fn() + Sync),
) -> Result<PreparedScene, PrepareError> {
    let mut run = Run {
        scene,
        located,
        known: &Known::nothing(scene),
        context: &context,
        done,
        missing: vec![],
    };
    let mut objects = run.objects()?;
    let volumes = run.volumes(&mut objects)?;
    let missing = run.missing;
    prepared_scene(scene, context, objects, volumes, missing)
}

/// The preparation of one scene.
pub(super) struct Run<'a> {
    pub scene: &'a FramedScene,
    pub located: &'a Located,
    pub known: &'a Known<'a>,
    pub context: &'a Context,
    /// Called about once for each of [`steps`], from any thread.
    pub done: &'a (dyn Fn() + Sync),
    /// What was left out.
    pub missing: Vec<Missing>,
}

impl Run<'_> {
    pub fn objects(&mut self) -> Result<Vec<PreparedObject>, PrepareError> {
        // Collected before the first error is taken, so that the same object is named in every run.
        let scene = self.scene;
        let objects = scene.objects.par_iter().enumerate();
        let objects = objects.map(|(index, object)| {
            let prepared = match self.known.objects[index] {
                Some(kept) => Ok(kept.prepared.clone()),
                None => self.located.prepare(index, object, self.context),
            };
            (self.done)();
            prepared.map_err(Box::new)
        });
        let objects: Vec<Result<PreparedObject, Box<PrepareError>>> = objects.collect();
        let mut left_out = |object: &FramedObject, reason: Box<PrepareError>| {
            self.leave_out(false, *reason)?;
            let note = "left out: it cannot be drawn";
            let absent = object::absent(object.name(), Class::default(), note);
            Ok(PreparedObject::Quadric(Box::new(absent)))
        };
        let named = objects.into_iter().zip(&scene.objects);
        let named = named.map(|(prepared, object)| prepared.or_else(|why| left_out(object, why)));
        named.collect()
    }

    /// Records what is left out, or refuses the scene.
    pub fn leave_out(&mut self, is_volume: bool, reason: PrepareError) -> Result<(), PrepareError> {
        if !self.context.options.without_refused {
            return Err(reason);
        }
        self.missing.push(Missing { is_volume, reason });
        Ok(())
    }
}

pub(super) fn prepared_scene(
    scene: &FramedScene,
    context: Context,
    mut objects: Vec<PreparedObject>,
    volumes: Volumes,
    missing: Vec<Missing>,
) -> Result<PreparedScene, PrepareError> {
    for CutOff { object, end } in &scene.range.cut {
        let cut = objects.iter_mut().find(|o| o.name() == object);
        if let Some(cut) = cut.filter(|o| !o.screen_box().is_empty()) {
            cut.add_note(match end {
                End::Near => NEAR_END_CUTS,
                End::Far => FAR_END_CUTS,
            });
        }
    }
    let ids = 0..objects.len();
    let transparent = ids.filter(|id| scene.is_transparent(*id)).collect();
    Ok(PreparedScene {
        missing,
        solids: PreparedSolids::of(scene, &objects, &context)?,
        layers: layers(scene, &transparent, &objects, &context)?,
        transparent,
        format: context.format,
        width: context.width,
        height: context.height,
        depth_scale: context.depth_scale,
        objects,
        volumes: volumes.into_list(),
    })
}
