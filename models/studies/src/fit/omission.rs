//! What a machine is not made for: the objects that are seen least, with their shadows, and the cut planes that are
//! missed least.
//!
//! The truth still shows them, so each pixel that lacks one is an error that the budget has to allow. Objects of solids
//! and transparent ones stay as they are, and so do the objects that are seen most.

use super::FitError;
use super::budget::Budget;
use super::estimate;
use super::frames::{Frame, Frames};
use super::search::is_possible;
use super::spare::{View, spare_planes};
use imogene_contract::MachineWords;
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::slots::{own_kind, required};
use imogene_plan::description::MachineKind;
use imogene_prepare::{Framing, PreparedScene};
use imogene_scene::SceneFile;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

/// How much is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeaveOut {
    /// What fewer pixels of every frame show.
    Below(u64),
    /// What makes the smallest machine within the budget.
    Auto,
}

const AUTO: &str = "auto";

impl FromStr for LeaveOut {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == AUTO {
            return Ok(Self::Auto);
        }
        let number = text.parse().map(Self::Below);
        number.map_err(|_| format!("expected a number of pixels such as 60, or {AUTO}"))
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

    /// What is at stake at no fewer pixels of a frame of `pixels` stays.
    fn over(self, budget: &Budget, pixels: usize) -> u64 {
        let counts = [budget.silhouette, budget.faces].into_iter().flatten();
        match self {
            Self::Below(pixels) => pixels,
            Self::Auto => counts.map(|count| count.of(pixels) as u64).sum::<u64>() + 1,
        }
    }
}

impl fmt::Display for LeaveOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Below(pixels) => pixels.fmt(f),
            Self::Auto => AUTO.fmt(f),
        }
    }
}

/// What is left out.
#[derive(Clone, Debug, Default)]
pub struct LeftOut {
    /// Names of the objects.
    pub names: Vec<String>,
    /// Planes of the objects that stay.
    pub planes: Vec<LeftPlane>,
    /// The frames without them; nothing where none is left out.
    pub scenes: Vec<SceneFile>,
}

/// A cut plane that is left out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LeftPlane {
    /// Name of its object.
    pub object: String,
    /// Index among the cuts of the object.
    pub cut: usize,
}

/// Parts that are too much for the budget, behind which others are looked at.
const PASSED_OVER: usize = 3;

/// An object, or one of its cut planes.
pub type Part = (usize, Option<usize>);
/// Pixels of the frame that shows most of it, or of what is missed with it.
type AtStake = (u64, Part);

/// Frames of which something can be left out.
pub struct Omission<'a> {
    frames: &'a Frames,
    files: &'a [(String, SceneFile)],
    kind: Option<MachineKind>,
    /// What may go: first where the fewest pixels of any frame are at stake for a logic cell.
    may_go: Vec<Part>,
}

impl<'a> Omission<'a> {
    /// Of these files, for a machine of the kind that is asked for. Fails when a frame cannot be prepared.
    pub fn new(
        frames: &'a Frames,
        files: &'a [(String, SceneFile)],
        kind: Option<MachineKind>,
        (leave_out, budget): (LeaveOut, &Budget),
    ) -> Result<Omission<'a>, FitError> {
        let over = leave_out.over(budget, frames.all[0].truth.pixels.len());
        let count = frames.all[0].scene.objects.len();
        let mut seen = vec![0; count];
        let mut may_go = vec![true; count];
        let mut pictures = vec![];
        let mut cells = vec![];
        for frame in &frames.all {
            for (most, own) in seen.iter_mut().zip(frame.truth.seen(count)) {
                *most = own.max(*most);
            }
            let prepared = frame.prepare_wide()?;
            let slots = prepared.slots_alone();
            for (object, may_go) in may_go.iter_mut().enumerate() {
                *may_go &= slots.iter().any(|slot| slot.object == object);
            }
            cells = cells_of(&prepared, count);
            pictures.push(prepared.frame(|| ()));
        }
        let most_seen = seen.iter().copied().max().unwrap_or(0);
        let planes = (0..count).into_par_iter().filter(|object| may_go[*object]);
        let planes = planes.flat_map_iter(|object| {
            let view = |k: usize| View::of(object, &frames.all[k], &files[k].1, &pictures[k]);
            let views: Option<Vec<View>> = (0..pictures.len()).map(view).collect();
            let spare = views.map_or(vec![], |views| spare_planes(&views, over));
            let spare = spare.into_iter();
            spare.map(move |(pixels, plane)| (pixels, (object, Some(plane))))
        });
        let planes: Vec<AtStake> = planes.collect();
        let objects = seen.into_iter().enumerate();
        let goes = objects.filter(|&(object, seen)| may_go[object] && seen < most_seen.min(over));
        let objects = goes.map(|(object, seen)| (seen, (object, None)));
        let mut may_go: Vec<AtStake> = objects.chain(planes).collect();
        let of_a_cell = |&(pixels, (object, plane)): &AtStake| {
            let [whole, each] = cells[object];
            pixels as f64 / plane.map_or(whole, |_| each)
        };
        // Planes of an object stay in the order in which it loses them.
        may_go.sort_by(|a, b| of_a_cell(a).total_cmp(&of_a_cell(b)));
        Ok(Omission {
            frames,
            files,
            kind,
            may_go: may_go.into_iter().map(|(_, part)| part).collect(),
        })
    }

    /// All that may go.
    pub fn all(&self) -> &[Part] {
        &self.may_go
    }

    /// What can be left out within a budget: in quarters of the most, from nothing on, and in quarters of the most
    /// objects alone, since an object can hide what another one's plane takes away.
    /// Fails when a frame cannot be drawn.
    pub fn within(&self, budget: &Budget) -> Result<Vec<Vec<Part>>, FitError> {
        let objects = self.may_go.iter().filter(|(_, plane)| plane.is_none());
        let objects: Vec<Part> = objects.copied().collect();
        let mut found = vec![vec![]];
        for parts in [&self.may_go, &objects] {
            let parts = self.most_within(budget, parts)?;
            for quarter in 1..=4 {
                let some = parts[..parts.len() * quarter / 4].to_vec();
                if !found.contains(&some) {
                    found.push(some);
                }
            }
        }
        Ok(found)
    }

    /// The first of these parts that can be left out within a budget; a few that are too much are passed over.
    fn most_within(&self, budget: &Budget, parts: &[Part]) -> Result<Vec<Part>, FitError> {
        let mut parts = parts.to_vec();
        let mut most = 0;
        for _ in 0..=PASSED_OVER {
            let mut over = parts.len() + 1;
            while most + 1 < over {
                let middle = (most + over) / 2;
                match is_possible(&self.without(&parts[..middle])?.0, budget)? {
                    true => most = middle,
                    false => over = middle,
                }
            }
            if most == parts.len() {
                break;
            }
            parts.remove(most);
        }
        parts.truncate(most);
        Ok(parts)
    }

    /// The frames without these parts. Fails when a frame cannot be framed without them.
    pub fn without(&self, parts: &[Part]) -> Result<(Frames, LeftOut), FitError> {
        let frames = self.frames;
        let mut goes = vec![false; frames.all[0].scene.objects.len()];
        let mut planes: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for &(object, plane) in parts {
            match plane {
                None => goes[object] = true,
                Some(plane) => planes.entry(object).or_default().push(plane),
            }
        }
        planes.retain(|object, _| !goes[*object]);
        let name = |object: usize| frames.all[0].scene.objects[object].name().to_owned();
        let out = (0..goes.len()).filter(|object| goes[*object]);
        let names: Vec<String> = out.map(name).collect();
        // Of each object among those that stay.
        let mut next = 0..;
        let index = |goes: &bool| if *goes { None } else { next.next() };
        let indices: Vec<Option<u32>> = goes.iter().map(index).collect();
        let (mut all, mut scenes) = (vec![], vec![]);
        for (frame, (file_name, file)) in frames.all.iter().zip(self.files) {
            let mut file = file.clone();
            let mut truth = frame.truth.clone();
            file.objects.retain(|object| !names.contains(&object.name));
            for (&object, out) in &planes {
                truth.renumber_planes(object as u32, out);
                let name = name(object);
                let cut = file.objects.iter_mut().find(|cut| cut.name == name);
                let mut index = 0..;
                let mut is_out = || index.next().is_some_and(|index| out.contains(&index));
                let cut = cut.expect("an object that stays");
                cut.cuts.retain(|_| !is_out());
            }
            truth.renumber(&indices);
            let scene = file.frame(frame.scene.width, frame.scene.height);
            let scene = scene.map_err(|source| FitError::of(file_name, source))?;
            all.push(Frame::new(file_name, scene, truth));
            scenes.push(file);
        }
        let is_whole = parts.is_empty();
        if is_whole {
            scenes.clear();
        }
        let frames = Frames {
            all,
            is_whole,
            ..*frames
        };
        let planes = planes.into_iter().flat_map(|(object, mut cuts)| {
            cuts.sort_unstable();
            let object = name(object);
            cuts.into_iter().map(move |cut| LeftPlane {
                object: object.clone(),
                cut,
            })
        });
        let left_out = LeftOut {
            names,
            planes: planes.collect(),
            scenes,
        };
        Ok((frames.settled(self.kind)?, left_out))
    }
}

/// Estimated logic cells of each object's processors, and of one of its planes, in words of the base format.
fn cells_of(prepared: &PreparedScene, objects: usize) -> Vec<[f64; 2]> {
    let words = MachineWords::of(Format::BASE.depth);
    // What has no processor saves next to nothing.
    let mut cells = vec![[1.0; 2]; objects];
    for slot in prepared.slots_alone() {
        let Some(own) = required(&own_kind(slot.words)) else {
            continue;
        };
        let with = |planes: u32| estimate::of_slot(&words, &FittedSlot { planes, ..own });
        let [whole, each] = &mut cells[slot.object];
        *whole += with(own.planes);
        *each += with(own.planes) - with(own.planes.saturating_sub(1));
    }
    cells
}
