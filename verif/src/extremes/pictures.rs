//! The picture that the hardware drew beside the exact one.

use imogene_analysis::bounds::{check, depth_bound, undecided_pixels};
use imogene_analysis::exact::render::{DEPTH_FRACTION, ExactPixel, render};
use imogene_golden::machine::frame::Frame;
use imogene_prepare::{PreparedObject, PreparedScene};
use imogene_scene::FramedScene;

/// A scene, drawn twice.
pub struct Pictures {
    scene: FramedScene,
    prepared: PreparedScene,
    /// What the hardware drew.
    pub frame: Frame,
    exact: Vec<Option<ExactPixel>>,
}

impl Pictures {
    pub fn new(scene: FramedScene, prepared: PreparedScene, frame: Frame) -> Pictures {
        let exact = render(&scene, &prepared.format, || ());
        Pictures {
            scene,
            prepared,
            frame,
            exact,
        }
    }

    /// Object and face are the exact ones wherever the words decide, and every depth is within its bound.
    pub fn agree(&self) -> Result<(), String> {
        let undecided = undecided_pixels(&self.scene, &self.prepared);
        for (index, exact) in self.exact.iter().enumerate() {
            let place = (index % self.frame.width, index / self.frame.width);
            let golden = (self.frame.id[index], self.frame.number[index]);
            match exact {
                Some(exact) if golden == (exact.id as i32, exact.number) => {
                    self.depth_holds(index, exact)?;
                }
                None if golden.0 < 0 => {}
                _ if undecided[index] => {}
                _ => {
                    let drawn = format!("drawn object {} face {}", golden.0, golden.1);
                    return Err(format!("pixel {place:?}: {drawn}, exact {exact:?}"));
                }
            }
        }
        Ok(())
    }

    /// The check fails and says of an object that its silhouette has no direction.
    pub fn unbounded(&self) -> Result<String, String> {
        let report = check(&self.scene, &self.prepared);
        let mut objects = report.objects.iter();
        match objects.find(|o| o.quadric().is_some_and(|q| q.bounds.silhouette_singular)) {
            Some(object) if !report.ok => Ok(format!("check fails: object '{}'", object.name)),
            _ => Err("check finds nothing wrong".into()),
        }
    }

    fn depth_holds(&self, index: usize, exact: &ExactPixel) -> Result<(), String> {
        let (x, y) = (index % self.frame.width, index / self.frame.width);
        let bound = match &self.prepared.objects[exact.id as usize] {
            PreparedObject::Parts(parts) => parts.depth_bound.ok_or("no bound is known")?,
            PreparedObject::Unseen(_) => return Err("it was left out".into()),
            PreparedObject::Quadric(object) | PreparedObject::Patch(object) => {
                let f2 = object.words.f2.exact_at(x as i64, y as i64);
                let f2 = i64::try_from(f2);
                let f2 = f2.map_err(|_| format!("f2 at ({x}, {y}) leaves its word"))?;
                depth_bound(object, exact.number, f2)
            }
        };
        let unit = f64::from(1u32 << DEPTH_FRACTION);
        let off = (self.frame.depth[index] as f64 - exact.depth as f64 / unit).abs();
        // The exact depth itself is cut after its fraction bits.
        match off <= bound + 2.0 / unit {
            true => Ok(()),
            false => Err(format!(
                "pixel ({x}, {y}): depth off by {off} words, bound {bound}"
            )),
        }
    }

    pub fn id(&self, x: usize, y: usize) -> Option<i32> {
        let id = self.frame.id[y * self.frame.width + x];
        (id >= 0).then_some(id)
    }

    pub fn pixels_of(&self, id: i32) -> usize {
        self.frame.id.iter().filter(|&&found| found == id).count()
    }

    /// Pixels of one face, of any object.
    pub fn pixels_of_face(&self, number: u8) -> usize {
        let covered = self.frame.id.iter().zip(&self.frame.number);
        let of_face = covered.filter(|&(&id, &found)| id >= 0 && found == number);
        of_face.count()
    }

    /// Pixels of the exact picture with an object.
    pub fn exactly_covered(&self) -> usize {
        self.exact.iter().flatten().count()
    }

    pub fn pixels(&self) -> usize {
        self.frame.id.len()
    }
}
