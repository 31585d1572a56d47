//! What the reader says of a STEP file besides its model.

use imogene_files::text::counted;
use serde::Serialize;
use std::collections::BTreeMap;

/// What the reader says of a file besides its model; the keys are stable.
#[derive(Debug, Default, Serialize)]
pub struct Summary {
    /// What the header calls the schema.
    pub schema: Vec<String>,
    pub entities: usize,
    /// Faces of the file that are part of a shell, each counted once.
    pub faces: usize,
    /// The same, as often as their solids are placed: all faces of the model.
    pub placed_faces: usize,
    /// Faces of shells that no product places, as those of validation properties.
    pub unplaced_faces: usize,
    /// What is no shell and was left out: entities by their name.
    pub left_out: BTreeMap<String, usize>,
    /// Parts and placements that are missing, and why.
    pub missing: Vec<String>,
    /// Files beside this one whose parts are placed in it.
    pub files: Vec<String>,
}

impl Summary {
    /// Lines for a person.
    pub fn notes(&self) -> Vec<String> {
        let left_out = self.left_out.iter();
        let left_out =
            left_out.map(|(name, count)| format!("{count} {name} left out: faces alone are drawn"));
        let mut notes: Vec<String> = left_out.collect();
        notes.extend(self.missing.iter().cloned());
        if self.unplaced_faces > 0 {
            notes.push(format!(
                "{} of properties left out: no product places them",
                counted(self.unplaced_faces, "face")
            ));
        }
        notes
    }

    /// Takes over what another file says.
    pub fn add(&mut self, other: Summary) {
        self.entities += other.entities;
        self.faces += other.faces;
        self.placed_faces += other.placed_faces;
        self.unplaced_faces += other.unplaced_faces;
        for (name, count) in other.left_out {
            *self.left_out.entry(name).or_default() += count;
        }
        self.missing.extend(other.missing);
        self.files.extend(other.files);
    }
}
