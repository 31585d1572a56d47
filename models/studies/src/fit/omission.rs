//! Objects that a machine is not made for: those that are seen least, and their shadows.
//!
//! The truth still shows them, so each pixel that lacks one is an error that the budget has to allow. Objects of solids
//! and transparent ones stay, and so do those that are seen most.

use super::FitError;
use super::budget::Budget;
use super::frames::{Frame, Frames};
use super::search::is_possible;
use imogene_plan::description::MachineKind;
use imogene_prepare::Framing;
use imogene_scene::SceneFile;
use std::fmt;
use std::str::FromStr;

/// How much is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeaveOut {
    /// What is seen at fewer pixels of every frame.
    Below(u64),
    /// What makes the smallest machine within the budget.
    Auto,
}

const AUTO: &str = "auto";

impl FromStr for LeaveOut {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = || text.parse().map(Self::Below).ok();
        let found = (text == AUTO).then_some(Self::Auto).or_else(number);
        found.ok_or_else(|| format!("expected a number of pixels such as 60, or {AUTO}"))
    }
}

impl LeaveOut {
    /// Refuses a budget that does not say how many pixels may lack something.
    pub fn check(self, budget: &Budget) -> Result<(), FitError> {
        let is_said = budget.silhouette.is_some() && budget.faces.is_some();
        match self {
            Self::Auto if !is_said => Err(FitError::NoCounts),
            _ => Ok(()),
        }
    }
}

impl fmt::Display for LeaveOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Below(pixels) => write!(f, "{pixels}"),
            Self::Auto => write!(f, "{AUTO}"),
        }
    }
}

/// What is left out.
#[derive(Clone, Debug, Default)]
pub struct LeftOut {
    /// Names of the objects.
    pub names: Vec<String>,
    /// The frames without them; nothing where none is left out.
    pub scenes: Vec<SceneFile>,
}

/// Frames of which objects can be left out.
pub struct Omission<'a> {
    frames: &'a Frames,
    files: &'a [(String, SceneFile)],
    kind: Option<MachineKind>,
    /// Pixels of the frame that shows most of it, and index, of each object that may go; the least first.
    may_go: Vec<(u64, usize)>,
}

impl<'a> Omission<'a> {
    /// Of these files, for a machine of the kind that is asked for.
    ///
    /// # Errors
    ///
    /// When a frame cannot be prepared.
    pub fn new(
        frames: &'a Frames,
        files: &'a [(String, SceneFile)],
        kind: Option<MachineKind>,
    ) -> Result<Omission<'a>, FitError> {
        let count = frames.all[0].scene.objects.len();
        let mut seen = vec![0; count];
        let mut may_go = vec![true; count];
        for frame in &frames.all {
            for (most, own) in seen.iter_mut().zip(frame.truth.seen(count)) {
                *most = own.max(*most);
            }
            let prepared = frame.prepare_wide()?;
            let mut is_alone = vec![false; count];
            for slot in prepared.slots_alone() {
                is_alone[slot.object] = true;
            }
            for (may_go, is_alone) in may_go.iter_mut().zip(is_alone) {
                *may_go &= is_alone;
            }
        }
        let most_seen = seen.iter().copied().max().unwrap_or(0);
        let objects = seen.into_iter().enumerate();
        let goes = objects.filter(|&(object, seen)| may_go[object] && seen < most_seen);
        let mut may_go: Vec<(u64, usize)> = goes.map(|(object, seen)| (seen, object)).collect();
        may_go.sort_unstable();
        Ok(Omission {
            frames,
            files,
            kind,
            may_go,
        })
    }

    /// Objects that are seen at fewer pixels of every frame.
    pub fn below(&self, pixels: u64) -> usize {
        self.may_go.partition_point(|(seen, _)| *seen < pixels)
    }

    /// Numbers of objects that can be left out within a budget, in quarters of the most, from none on.
    ///
    /// # Errors
    ///
    /// When a frame cannot be drawn.
    pub fn within(&self, budget: &Budget) -> Result<Vec<usize>, FitError> {
        let (mut most, mut over) = (0, self.may_go.len() + 1);
        while most + 1 < over {
            let middle = (most + over) / 2;
            match is_possible(&self.without(middle)?.0, budget)? {
                true => most = middle,
                false => over = middle,
            }
        }
        let mut quarters: Vec<usize> = (0..=4).map(|part| most * part / 4).collect();
        quarters.dedup();
        Ok(quarters)
    }

    /// The frames without so many of the objects that are seen least.
    ///
    /// # Errors
    ///
    /// When a frame cannot be framed without them.
    pub fn without(&self, objects: usize) -> Result<(Frames, LeftOut), FitError> {
        let frames = self.frames;
        let mut goes = vec![false; frames.all[0].scene.objects.len()];
        for &(_, object) in &self.may_go[..objects] {
            goes[object] = true;
        }
        let named = frames.all[0].scene.objects.iter().zip(&goes);
        let names = named.filter(|(_, goes)| **goes);
        let names: Vec<String> = names.map(|(object, _)| object.name().to_owned()).collect();
        let (mut all, mut scenes) = (vec![], vec![]);
        for (frame, (name, file)) in frames.all.iter().zip(self.files) {
            let mut file = file.clone();
            file.objects.retain(|object| !names.contains(&object.name));
            let scene = file.frame(frame.scene.width, frame.scene.height);
            let scene = scene.map_err(|source| FitError::of(name, source))?;
            let mut truth = frame.truth.clone();
            truth.renumber(&indices(&goes));
            all.push(Frame::new(name, scene, truth));
            scenes.push(file);
        }
        if names.is_empty() {
            scenes.clear();
        }
        let is_whole = names.is_empty();
        let frames = Frames {
            all,
            is_whole,
            ..*frames
        };
        Ok((frames.settled(self.kind)?, LeftOut { names, scenes }))
    }
}

/// The index that each object has among those that stay.
fn indices(goes: &[bool]) -> Vec<Option<u32>> {
    let mut next = 0;
    let index = |&goes: &bool| {
        let index = (!goes).then_some(next);
        next += u32::from(!goes);
        index
    };
    goes.iter().map(index).collect()
}
