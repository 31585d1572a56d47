//! Files of finished points: one each, whole or not there, and taken again only by a run that would make the same.

use super::point::Point;
use crate::kit::picture::{WriteError, write_whole};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// What a result depends on besides its point.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Key {
    /// Digest of the scene.
    pub scene: String,
    /// The scene as the commands name it.
    pub name: String,
    pub size: (u32, u32),
    /// Device of the costs.
    pub target: String,
    pub program: String,
}

#[derive(Serialize, Deserialize)]
struct Kept {
    key: Key,
    point: Point,
}

/// A folder of results.
pub struct Store<'a> {
    pub folder: &'a Path,
    /// What its results must belong to.
    pub key: Key,
}

impl Store<'_> {
    /// The file of a point.
    pub fn path(&self, id: &str) -> PathBuf {
        self.folder.join("points").join(format!("{id}.json"))
    }

    /// A point that is finished and belongs to this run.
    pub fn take(&self, id: &str) -> Option<Point> {
        let bytes = std::fs::read(self.path(id)).ok()?;
        let kept: Kept = serde_json::from_slice(&bytes).ok()?;
        let point = kept.point;
        let files = [&point.picture, &point.map, &point.machine_file].into_iter();
        let is_there = |name: &String| self.folder.join(name).is_file();
        let is_whole = files.flatten().all(is_there);
        (kept.key == self.key && point.id == id && is_whole).then_some(point)
    }

    /// Writes the file of a point.
    pub fn keep(&self, point: &Point) -> Result<(), WriteError> {
        let kept = Kept {
            key: self.key.clone(),
            point: point.clone(),
        };
        write_whole(&self.path(&point.id), |out| {
            serde_json::to_writer_pretty(&mut *out, &kept)?;
            out.write_all(b"\n")
        })
    }
}
