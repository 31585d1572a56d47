//! The frames that a machine has to draw, each with its truth, and what a machine of given words makes of them.

use super::budget::{Budget, Item, worst};
use super::{Cause, FitError};
use crate::kit::words::{drawn, narrowest};
use imogene_analysis::metrics::{Drawing, Metrics, Truth, measure};
use imogene_contract::MachineWords;
use imogene_files::text::counted;
use imogene_golden::format::Format;
use imogene_plan::description::MachineKind;
use imogene_plan::display::DisplayError;
use imogene_plan::needs;
use imogene_prepare::Framing;
use imogene_prepare::error::PrepareError;
use imogene_prepare::lit_sphere::SphereForm;
use imogene_prepare::{LocatedScene, Options, PreparedScene};
use imogene_scene::{FramedScene, SceneFile};

/// Processors of a beam machine at most, if nobody says which machine: more are shared zone by zone.
pub(super) const MOST_OF_BEAM: usize = 16;
/// Guard bits of f1 and f2 at most: as many as keep the depth of every facet, and more than help any scene known.
pub(super) const MOST_GUARDS: (u32, u32) = (10, 16);

/// One frame.
pub struct Frame {
    /// The file.
    pub name: String,
    /// The scene at its size.
    pub scene: FramedScene,
    /// What is truly seen.
    pub truth: Truth,
    located: LocatedScene,
}

impl Frame {
    pub(super) fn new(name: &str, scene: FramedScene, truth: Truth) -> Frame {
        Frame {
            name: name.to_owned(),
            truth,
            located: LocatedScene::new(&scene),
            scene,
        }
    }

    fn prepare(&self, format: Format) -> Result<PreparedScene, PrepareError> {
        self.located.prepare(&self.scene, format, Options::HARDWARE)
    }

    /// In the [`wide`] format.
    pub(super) fn prepare_wide(&self) -> Result<PreparedScene, FitError> {
        self.prepare(wide()).map_err(|source| self.refused(source))
    }

    fn draw(&self, prepared: &PreparedScene) -> Result<Drawing, FitError> {
        let drawing = drawn(&self.scene, prepared, None);
        drawing.map_err(|source| self.refused(DisplayError::from(source)))
    }

    /// The map of a picture's errors: red, green, blue of every pixel. Fails without words for the shading processor.
    pub fn errors(&self, prepared: &PreparedScene) -> Result<Vec<u8>, FitError> {
        Ok(measure(&self.truth, &self.draw(prepared)?).1)
    }

    pub(super) fn refused(&self, source: impl Into<Cause>) -> FitError {
        FitError::of(&self.name, source)
    }
}

/// The base format with guard bits for every facet.
pub(super) fn wide() -> Format {
    let wide = Format::BASE.with_guards(MOST_GUARDS.0, 0);
    wide.expect("guard bits of f1 within their range")
}

/// All frames of an animation, or the one of a picture.
pub struct Frames {
    /// The frames.
    pub all: Vec<Frame>,
    /// Every object is of the quadric or the patch processor: their errors have bounds, and their words are free, while
    /// those of others follow from the depth word.
    pub has_bounds: bool,
    /// Nothing is left out of the scene: the bounds are those of all that is seen.
    pub is_whole: bool,
    pub(super) kind: MachineKind,
    pub(super) is_for_zones: bool,
    /// Its tables of lit-sphere shading, in the place of a shading processor.
    pub lit_sphere: Option<SphereForm>,
    /// Pixels of a line that it draws at once; several are streamed, by a beam machine.
    pub pixels_per_clock: u32,
}

/// The frames in words, against their truth.
#[derive(Clone)]
pub struct Drawn {
    /// Every width.
    pub widths: MachineWords,
    /// The frames in these widths.
    pub prepared: Vec<PreparedScene>,
    /// How far each picture is from the truth.
    pub metrics: Vec<Metrics>,
    /// The limits of the budget, each with the worst of all frames.
    pub items: Vec<Item>,
}

impl Drawn {
    /// True if every limit is kept.
    pub fn fits(&self) -> bool {
        self.items.iter().all(Item::holds)
    }
}

impl Frames {
    /// Solves the frames; `line_done` is called once a line, from any thread.
    /// They are for a machine of the kind that is asked for, or else for a beam machine if few processors do.
    /// Fails if a scene cannot be framed, no such machine shows it, or the frames are not of one animation.
    pub fn new(
        files: &[(String, SceneFile)],
        size: Option<(u32, u32)>,
        kind: Option<MachineKind>,
        line_done: impl Fn() + Sync,
    ) -> Result<Frames, FitError> {
        let scenes = files.iter().map(|(name, file)| {
            let (width, height) = size.unwrap_or((file.image.width, file.image.height));
            file.frame(width, height)
                .map_err(|source| FitError::of(name, source))
        });
        let scenes: Vec<FramedScene> = scenes.collect::<Result<_, _>>()?;
        let expected = scenes.first().map_or(0, |scene| scene.objects.len());
        for ((name, _), scene) in files.iter().zip(&scenes) {
            let problem = match scene.objects.len() {
                0 => "there is no object, and no machine to fit".to_owned(),
                count if count == expected => continue,
                count => format!(
                    "{}, but the first frame has {expected}; the frames of an animation have the same objects in the same order",
                    counted(count, "object")
                ),
            };
            return Err(FitError::of(name, problem));
        }
        let frames = files.iter().zip(scenes).map(|((name, _), scene)| {
            let truth = Truth::new(&scene, &line_done);
            Frame::new(name, scene, truth)
        });
        let frames = Frames {
            all: frames.collect(),
            has_bounds: true,
            is_whole: true,
            kind: MachineKind::Beam,
            is_for_zones: true,
            lit_sphere: None,
            pixels_per_clock: 1,
        };
        frames.settled(kind)
    }

    /// Finds which machines show all frames, and which of them is meant.
    pub(super) fn settled(mut self, kind: Option<MachineKind>) -> Result<Frames, FitError> {
        let (mut has_bounds, mut is_for_zones, mut processors) = (true, true, 0);
        for frame in &self.all {
            // What this format refuses no other words take: f2 and the planes grow with the depth word.
            let prepared = frame.prepare_wide()?;
            let [zone, beam] = [MachineKind::Zone, MachineKind::Beam].map(|kind| {
                let shown = needs::check_any(kind, &frame.scene, &prepared);
                shown.map_err(|source| frame.refused(source))
            });
            match kind {
                Some(MachineKind::Zone) => zone?,
                // What processors of quadrics do not draw is for a beam machine, however many there are.
                _ => beam.map(|()| is_for_zones &= zone.is_ok())?,
            }
            processors = processors.max(prepared.slots().len() + prepared.volumes.len());
            has_bounds &= prepared.objects.iter().all(|object| object.has_bounds());
        }
        let is_large = is_for_zones && processors > MOST_OF_BEAM;
        self.kind = kind.unwrap_or(match is_large {
            true => MachineKind::Zone,
            false => MachineKind::Beam,
        });
        (self.has_bounds, self.is_for_zones) = (has_bounds, is_for_zones);
        Ok(self)
    }

    /// The same frames for a zone machine; false, and nothing is changed, if it does not show all of them.
    pub fn share_processors(&mut self) -> bool {
        if self.is_for_zones {
            self.kind = MachineKind::Zone;
        }
        self.is_for_zones
    }

    /// Draws all frames in the narrowest widths, up to these, that take them; `None` if these are too few for a frame.
    /// Fails if a frame cannot be drawn by any machine.
    pub fn draw(&self, wide: &MachineWords, budget: &Budget) -> Result<Option<Drawn>, FitError> {
        let in_widths = |widths: &MachineWords| self.in_widths(widths);
        // Without bounds all widths but the guard bits follow from the depth word.
        let following = MachineWords {
            guard_linear: wide.guard_linear,
            guard_quadratic: wide.guard_quadratic,
            ..MachineWords::of(wide.depth)
        };
        let found = match self.has_bounds {
            true => narrowest(wide, in_widths)?,
            false => in_widths(&following)?.map(|prepared| (following, prepared)),
        };
        let Some((widths, prepared)) = found else {
            return Ok(None);
        };
        let mut metrics = Vec::new();
        let mut items = Vec::new();
        for (frame, prepared) in self.all.iter().zip(&prepared) {
            let (found, _) = measure(&frame.truth, &frame.draw(prepared)?);
            items.push(budget.judge(&found, frame.truth.pixels.len()));
            metrics.push(found);
        }
        Ok(Some(Drawn {
            widths,
            prepared,
            metrics,
            items: worst(&items),
        }))
    }

    /// The frames in a format; `None` if there is no such format, or a word of it is too short.
    fn in_widths(&self, widths: &MachineWords) -> Result<Option<Vec<PreparedScene>>, FitError> {
        let Ok(format) = Format::fitted(widths) else {
            return Ok(None);
        };
        let mut all = Vec::new();
        for frame in &self.all {
            match frame.prepare(format) {
                Ok(prepared) => {
                    let drawn = needs::check_any(self.kind, &frame.scene, &prepared);
                    drawn.map_err(|source| frame.refused(source))?;
                    all.push(prepared);
                }
                Err(PrepareError::TooLarge { .. } | PrepareError::SteepPlane { .. }) => {
                    return Ok(None);
                }
                Err(source) => return Err(frame.refused(source)),
            }
        }
        Ok(Some(all))
    }
}
