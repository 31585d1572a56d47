//! Leaving out of a plan what changes no pixel: objects, planes and volumes that the screen box alone sends to a zone
//! (source: 1.3.2, 5.5).

use super::plan::{Part, Zone, ZonePlan, ZoneProduct};
use crate::culling::part::{Matter, in_box, is_drawn, matter};
use crate::culling::volume::{Seen, matter_of_volume, volume_with_planes};
use crate::culling::{Planes, all_planes};
use imogene_golden::machine::zone::sample::Sample;
use imogene_golden::object::member::for_each_seen;
use imogene_golden::object::quadric::{ObjectPixel, QuadricWords, ScreenBox};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::{VolumeKind, VolumeWords};
use imogene_golden::object::volume_line::for_each_inside;
use imogene_golden::object::words::Words;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// How the host decides what goes to a zone. The picture is the same whatever it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Refinement {
    /// By screen boxes.
    #[default]
    Box,
    /// By bounds of what the words say on the zone and on blocks of it.
    Bounds,
    /// By drawing the zone: the least that can be sent, at the price of a picture in software.
    Pixels,
}

impl ZonePlan {
    /// The same frame from less: every zone without the objects, planes and volumes that change none of its pixels.
    pub fn refined(mut self, refinement: Refinement) -> ZonePlan {
        if refinement == Refinement::Box {
            return self;
        }
        let zones = std::mem::take(&mut self.zones);
        let samples: Vec<Sample> = Sample::all(self.machine.samples).collect();
        let plans: Vec<ZonePlan> = samples.iter().map(|&s| self.at_sample(s)).collect();
        let one = |zone: Zone| {
            let place = zone.sample.line * zone.sample.of + zone.sample.column;
            let plan = &plans[place as usize];
            ZoneRefiner { plan, zone }.refine(refinement)
        };
        self.zones = zones.into_par_iter().map(one).collect();
        self
    }

    /// The plan without zones, with the words of one sample of the pixels.
    fn at_sample(&self, sample: Sample) -> ZonePlan {
        let mut plan = self.clone();
        for part in &mut plan.parts {
            part.words = part.words.on(&sample.pixels());
        }
        for volume in &mut plan.volumes {
            *volume = volume.on(&sample.pixels());
        }
        plan
    }
}

struct ZoneRefiner<'a> {
    plan: &'a ZonePlan,
    zone: Zone,
}

impl<'a> ZoneRefiner<'a> {
    fn refine(mut self, refinement: Refinement) -> Zone {
        self.refine_parts(refinement);
        self.refine_products(refinement);
        if self.zone.is_empty() {
            self.zone.volumes.clear();
        }
        if self.zone.volumes.is_empty() {
            return self.zone;
        }
        // The backs of what is taken away have no bounds, and what is drawn as no quadric.
        let parts = self.zone.parts.iter();
        let quadrics: Option<Vec<_>> = parts.map(|&index| self.part(index).quadric()).collect();
        if let Some(quadrics) = quadrics.filter(|_| self.zone.products.is_empty()) {
            self.bound_volumes(&quadrics);
        }
        if refinement == Refinement::Pixels {
            self.try_volumes();
        }
        self.zone
    }

    fn part(&self, index: u32) -> &'a Part {
        &self.plan.parts[index as usize]
    }

    fn words(&self, index: u32) -> &'a ProcessorWords {
        &self.part(index).words
    }

    fn member(&self, index: u32) -> &'a QuadricWords {
        self.part(index).quadric().expect("solids are of quadrics")
    }

    fn volume(&self, index: u32) -> &'a VolumeWords {
        &self.plan.volumes[index as usize]
    }

    fn refine_parts(&mut self, refinement: Refinement) {
        let mut left = vec![];
        for index in std::mem::take(&mut self.zone.parts) {
            let Some(planes) = self.planes_on(&self.zone.window, index, refinement) else {
                continue;
            };
            left.push(index);
            if planes != self.part(index).all_planes() {
                self.zone.part_planes.insert(index, planes);
            }
        }
        self.zone.parts = left;
    }

    /// The planes of a part that matter on a window; `None` if it is at no pixel there.
    fn planes_on(&self, window: &ScreenBox, index: u32, refinement: Refinement) -> Option<Planes> {
        let part = self.part(index);
        let window = part.words.screen_box().shared(window);
        let matter = match part.quadric() {
            Some(words) => matter(words, &window, &self.plan.format),
            None if window.is_empty() => Matter::Nothing,
            None => Matter::With(part.all_planes()),
        };
        let Matter::With(planes) = matter else {
            return None;
        };
        let is_there = refinement != Refinement::Pixels
            || is_drawn(&in_box(&part.words, window), &self.plan.format);
        is_there.then_some(planes)
    }

    /// Leaves out products that are nowhere, and what the others take away nowhere. The back of an object counts, so
    /// that all planes of the others stay.
    fn refine_products(&mut self, refinement: Refinement) {
        let mut left = vec![];
        for mut product in std::mem::take(&mut self.zone.products) {
            let boxes = product.intersected.iter();
            let boxes = boxes.map(|&index| *self.words(index).screen_box());
            let window = boxes.fold(self.zone.window, |all, one| all.shared(&one));
            let is_there = |&index: &u32| self.planes_on(&window, index, refinement).is_some();
            if !product.intersected.iter().all(is_there) {
                continue;
            }
            product.subtracted.retain(is_there);
            if refinement != Refinement::Pixels || self.is_seen(&product, &window) {
                left.push(product);
            }
        }
        self.zone.products = left;
    }

    /// Is the product at any pixel of the window?
    fn is_seen(&self, product: &ZoneProduct, window: &ScreenBox) -> bool {
        let objects = product.parts().map(|index| QuadricWords {
            screen_box: self.member(index).screen_box.shared(window),
            ..self.member(index).clone()
        });
        let (objects, intersected) = (objects.collect::<Vec<_>>(), product.intersected.len());
        (window.y0..=window.y1).any(|y| {
            let mut seen = false;
            for_each_seen(&objects, intersected, &self.plan.format, y, |_, _, _| {
                seen = true;
            });
            seen
        })
    }

    /// `quadrics` are the words of its parts.
    fn bound_volumes(&mut self, quadrics: &[&QuadricWords]) {
        let seen = self.zone.parts.iter().zip(quadrics).map(|(&index, words)| {
            let planes = self.zone.planes_of_part(index) & self.part(index).all_planes();
            Seen::new(words, planes, words.screen_box.shared(&self.zone.window))
        });
        let seen: Vec<Seen> = seen.collect();
        let matter = |index: u32| matter_of_volume(self.volume(index), &seen, &self.plan.format);
        let volumes = self.zone.volumes.iter();
        let matters: Vec<(u32, Matter)> = volumes.map(|&v| (v, matter(v))).collect();
        self.keep(&matters);
    }

    /// Keeps the volumes that matter. A source whose light reaches nothing here has no shadows to draw.
    fn keep(&mut self, matters: &[(u32, Matter)]) {
        let is_light = |index| self.volume(index).kind == VolumeKind::Light;
        let dark: BTreeSet<u8> = matters
            .iter()
            .filter(|(index, matter)| is_light(*index) && *matter == Matter::Nothing)
            .map(|(index, _)| self.volume(*index).source)
            .collect();
        let mut left = vec![];
        let mut masks: Vec<(u32, Planes)> = vec![];
        for &(index, matter) in matters {
            let words = self.volume(index);
            match (words.kind, matter) {
                (VolumeKind::Shadow, Matter::Nothing) => continue,
                (VolumeKind::Shadow, _) if dark.contains(&words.source) => continue,
                (VolumeKind::Light, Matter::Nothing) => {}
                (_, Matter::With(planes)) => {
                    if planes != all_planes(words.planes.len()) {
                        masks.push((index, planes));
                    }
                }
            }
            left.push(index);
        }
        self.zone.volumes = left;
        self.zone.volume_planes.extend(masks);
    }

    /// Draws the zone and leaves out the volumes that take no source from a visible point that another one has not
    /// taken already: lights first, then shadows by the number of points inside, the most first.
    fn try_volumes(&mut self) {
        let depths = self.depths();
        let z_max = self.plan.format.z_max();
        let is_surface: Vec<bool> = depths.iter().map(|&z| z != z_max).collect();
        let volumes = std::mem::take(&mut self.zone.volumes);
        let points = |index| (index, self.darkened(index, &depths, &is_surface));
        let mut darkened: Vec<(u32, Vec<bool>)> = volumes.into_iter().map(points).collect();
        darkened.sort_by_key(|(index, points)| {
            let count = points.iter().filter(|&&dark| dark).count();
            let is_shadow = self.volume(*index).kind == VolumeKind::Shadow;
            (is_shadow, Reverse(count), *index)
        });
        let mut dark: BTreeMap<u8, Vec<bool>> = BTreeMap::new();
        let mut left = vec![];
        for (index, points) in darkened {
            let known = dark.entry(self.volume(index).source);
            let known = known.or_insert_with(|| vec![false; points.len()]);
            let mut adds = false;
            for (known, point) in known.iter_mut().zip(points) {
                adds |= point && !*known;
                *known |= point;
            }
            if adds {
                left.push(index);
            }
        }
        left.sort_unstable();
        self.zone.volumes = left;
    }

    /// The visible points that a volume takes its source from.
    fn darkened(&self, index: u32, depths: &[i64], is_surface: &[bool]) -> Vec<bool> {
        let inside = self.inside(index, depths);
        let dark = self.volume(index).kind == VolumeKind::Shadow;
        let points = inside.into_iter().zip(is_surface);
        let points = points.map(|(inside, &surface)| surface && inside == dark);
        points.collect()
    }

    /// Visible depths of the zone, line by line.
    fn depths(&self) -> Vec<i64> {
        let (zone, format) = (&self.zone, &self.plan.format);
        let [width, height] = zone.window.size();
        let mut depths = vec![format.z_max(); (width * height) as usize];
        let mut show = |x: i64, y: i64, pixel: ObjectPixel| {
            let depth = &mut depths[(y * width + x) as usize];
            *depth = pixel.zf.min(*depth);
        };
        for &index in &zone.parts {
            let words = zone.in_zone(self.words(index));
            for y in 0..height {
                words.for_each_present(format, y, |x, pixel| show(x, y, pixel));
            }
        }
        for product in &zone.products {
            let objects = product.parts();
            let objects = objects.map(|index| zone.in_zone(self.member(index)));
            let (objects, intersected) = (objects.collect::<Vec<_>>(), product.intersected.len());
            for y in 0..height {
                for_each_seen(&objects, intersected, format, y, |x, _, pixel| {
                    show(x, y, pixel);
                });
            }
        }
        depths
    }

    /// The visible points of the zone inside a volume.
    fn inside(&self, index: u32, depths: &[i64]) -> Vec<bool> {
        let zone = &self.zone;
        let words = volume_with_planes(self.volume(index), zone.planes_of_volume(index));
        let words = zone.in_zone(&words);
        let [width, _] = zone.window.size().map(|side| side as usize);
        let mut inside = vec![false; depths.len()];
        let lines = inside.chunks_mut(width).zip(depths.chunks(width));
        for (y, (inside, line)) in lines.enumerate() {
            for_each_inside(&words, &self.plan.format, y as i64, line, |x| {
                inside[x] = true;
            });
        }
        inside
    }
}

impl Zone {
    /// The planes of a part that are sent to the zone: all ones if nothing was left out.
    pub fn planes_of_part(&self, index: u32) -> Planes {
        self.part_planes.get(&index).copied().unwrap_or(Planes::MAX)
    }

    /// The same of a volume.
    pub fn planes_of_volume(&self, index: u32) -> Planes {
        let planes = self.volume_planes.get(&index);
        planes.copied().unwrap_or(Planes::MAX)
    }
}
