//! The frames that a machine has to draw, each with its truth, and what a machine of given words makes of them.

use super::FitError;
use super::budget::{Budget, Item, worst};
use crate::kit::words::narrowest;
use imogene_analysis::metrics::{Drawing, Metrics, Truth, measure};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::machine::fitted::{FittedMachine, FittedSlot};
use imogene_prepare::Framing;
use imogene_prepare::error::PrepareError;
use imogene_prepare::{PreparedScene, prepare_for_roots};
use imogene_scene::{FramedScene, SceneFile};

/// One frame.
pub struct Frame {
    /// The file.
    pub name: String,
    /// The scene at its size.
    pub scene: FramedScene,
    /// What is truly seen.
    pub truth: Truth,
}

impl Frame {
    /// The golden picture of the frame, and the map of its errors: red, green and blue of every pixel.
    pub fn picture(&self, prepared: &PreparedScene) -> (Vec<u8>, Vec<u8>) {
        let drawing = Drawing::of(prepared, &self.scene);
        let (_, map) = measure(&self.truth, &drawing);
        (drawing.rgb, map)
    }
}

/// All frames of an animation, or the one of a picture.
pub struct Frames(Vec<Frame>);

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

    /// The machine: slots that take every frame.
    pub fn machine(&self, rows_per_stage: u32) -> FittedMachine {
        let mut slots: Vec<FittedSlot> = Vec::new();
        for prepared in &self.prepared {
            let frame = prepared.fitted_machine(rows_per_stage).slots;
            if slots.is_empty() {
                slots = frame;
                continue;
            }
            for (slot, other) in slots.iter_mut().zip(frame) {
                *slot = slot.or(&other);
            }
        }
        FittedMachine {
            widths: self.widths,
            rows_per_stage,
            slots,
        }
    }
}

impl Frames {
    /// Solves the frames; `line_done` is called once a line, from any thread.
    /// Fails if a scene cannot be framed, is for other processors, or the frames are not of one animation.
    pub fn new(
        files: &[(String, SceneFile)],
        size: Option<(u32, u32)>,
        line_done: impl Fn() + Sync,
    ) -> Result<Frames, FitError> {
        let scenes = files.iter().map(|(name, file)| {
            let (width, height) = size.unwrap_or((file.image.width, file.image.height));
            let framed = file.frame(width, height);
            framed.map_err(|source| FitError::Scene {
                scene: name.clone(),
                source: Box::new(source),
            })
        });
        let scenes: Vec<FramedScene> = scenes.collect::<Result<_, _>>()?;
        for ((name, _), scene) in files.iter().zip(&scenes) {
            check(name, scene, scenes[0].objects.len())?;
            // What the base format refuses no other words take: f2 and the planes grow with the depth word.
            let refused = prepare_for_roots(scene, Format::BASE).err();
            if let Some(source) = refused {
                return Err(FitError::Prepare {
                    scene: name.clone(),
                    source: Box::new(source),
                });
            }
        }
        let frames = files.iter().zip(scenes).map(|((name, _), scene)| Frame {
            name: name.clone(),
            truth: Truth::new(&scene, &line_done),
            scene,
        });
        Ok(Frames(frames.collect()))
    }

    /// The frames.
    pub fn all(&self) -> &[Frame] {
        &self.0
    }

    /// Draws all frames in the narrowest widths, up to these, that take them; `None` if these are too few for a frame.
    /// Fails if a frame cannot be drawn by any machine.
    pub fn draw(&self, wide: &MachineWords, budget: &Budget) -> Result<Option<Drawn>, FitError> {
        let in_widths = |widths: &MachineWords| self.in_widths(widths);
        let Some((widths, prepared)) = narrowest(wide, in_widths, PreparedScene::needed)? else {
            return Ok(None);
        };
        let mut metrics = Vec::new();
        let mut items = Vec::new();
        for (frame, prepared) in self.0.iter().zip(&prepared) {
            let drawing = Drawing::of(prepared, &frame.scene);
            let (found, _) = measure(&frame.truth, &drawing);
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
        for frame in &self.0 {
            match prepare_for_roots(&frame.scene, format) {
                Ok(prepared) => all.push(prepared),
                Err(PrepareError::TooLarge { .. } | PrepareError::SteepPlane { .. }) => {
                    return Ok(None);
                }
                Err(source) => {
                    return Err(FitError::Prepare {
                        scene: frame.name.clone(),
                        source: Box::new(source),
                    });
                }
            }
        }
        Ok(Some(all))
    }
}

fn check(name: &str, scene: &FramedScene, expected: usize) -> Result<(), FitError> {
    let name = || name.to_owned();
    let count = scene.objects.len();
    if count == 0 {
        return Err(FitError::Empty { scene: name() });
    }
    if count != expected {
        return Err(FitError::Objects {
            scene: name(),
            count,
            expected,
        });
    }
    match scene.objects.iter().find(|o| o.processor() != "quadric") {
        Some(other) => Err(FitError::Processor {
            scene: name(),
            object: other.name().to_owned(),
            processor: other.processor(),
        }),
        None => Ok(()),
    }
}
