//! Scene files as text: TOML, written by hand or by an importer.

use super::error::{SceneError, line_and_column};
use super::file::{FORMAT_VERSION, SceneFile};
use serde::Deserialize;
use std::path::Path;
use toml::de::{DeArray, DeTable, DeValue};

/// Most bytes of a scene file: a million objects take a hundred million.
const MAX_BYTES: u64 = 256 << 20;
/// Bytes of memory for each byte of a scene file, at least: 43 were measured of spheres, 53 of cut ellipsoids.
/// Reading takes the most; the preparation takes less than reading did.
const MEMORY_PER_BYTE: u64 = 40;

impl SceneFile {
    /// Reads and checks a scene file.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let file = path.display().to_string();
        let unreadable = |source| SceneError::Unreadable(file.clone(), source);
        let bytes = imogene_files::read(path, MAX_BYTES).map_err(unreadable)?;
        check_memory(bytes.len() as u64).map_err(unreadable)?;
        let text = std::str::from_utf8(&bytes).map_err(|error| {
            let offset = error.valid_up_to();
            let (line, _) = line_and_column(&String::from_utf8_lossy(&bytes[..offset]), offset);
            SceneError::NotText(file.clone(), line, offset)
        })?;
        Self::parse(text, &file)
    }

    /// Reads and checks the text of a scene; `file` is the name that messages give it.
    pub fn parse(text: &str, file: &str) -> Result<Self, SceneError> {
        let syntax = |error| SceneError::syntax(file, text, &error);
        // Read once for both, because reading takes longer than all else of a scene of ten thousand objects.
        let mut table = DeTable::parse(text).map_err(syntax)?;
        check_version(table.get_ref(), text, file)?;
        let leads = first_camera_leads(table.get_mut());
        let scene = Self::deserialize(toml::Deserializer::from(table)).map_err(syntax)?;
        let first = leads.then_some(&scene.camera);
        let mut cameras = first.into_iter().chain(&scene.cameras);
        if let Some(index) = cameras.position(|camera| camera.node.name.is_none()) {
            return Err(syntax(serde::de::Error::custom(format!(
                "cameras[{index}] has no `name`; each of `[[cameras]]` needs one, `[camera]` alone may go without"
            ))));
        }
        scene.validate_text().map_err(|error| error.in_file(file))?;
        Ok(scene)
    }

    /// The scene as the text of a scene file; [`SceneFile::parse`] reads it back as the same scene.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        self.validate_text()?;
        toml::to_string(self).map_err(SceneError::Unwritable)
    }
}

/// Refuses a text whose parts do not fit into memory, before the system ends the process for it.
fn check_memory(bytes: u64) -> std::io::Result<()> {
    let needed = bytes * MEMORY_PER_BYTE;
    let Some(free) = imogene_files::free_memory().filter(|free| needed > *free) else {
        return Ok(());
    };
    let [needed, free] = [needed, free].map(|bytes| bytes as f64 / f64::from(1 << 30));
    Err(std::io::Error::other(format!(
        "it takes {needed:.1} GiB of memory and more, and {free:.1} GiB are free"
    )))
}

/// Without `[camera]` the first of `[[cameras]]` takes its place.
fn first_camera_leads(table: &mut DeTable) -> bool {
    if table.contains_key("camera") {
        return false;
    }
    let Some(DeValue::Array(cameras)) = table.get_mut("cameras").map(|list| list.get_mut()) else {
        return false;
    };
    let mut each = std::mem::replace(cameras, DeArray::new()).into_iter();
    let first = each.next();
    *cameras = each.collect();
    let leads = first.map(|own| table.insert(toml::Spanned::new(own.span(), "camera".into()), own));
    leads.is_some()
}

/// Refuses another version before its unknown keys are blamed on the author.
fn check_version(table: &DeTable, text: &str, file: &str) -> Result<(), SceneError> {
    let version = table.get("format").map(|value| value.get_ref());
    let whole = version.and_then(|value| value.as_integer());
    if whole.is_some_and(|number| number.as_str() == FORMAT_VERSION.to_string()) {
        return Ok(());
    }
    let table: toml::Table =
        toml::from_str(text).map_err(|error| SceneError::syntax(file, text, &error))?;
    let accepted = format!("this program reads `format = {FORMAT_VERSION}`");
    let refuse =
        |problem: String| Err(SceneError::value("format", problem, accepted).in_file(file));
    match table.get("format") {
        None if table.is_empty() => refuse("the file is empty".into()),
        None => refuse("the version of the format is missing".into()),
        Some(toml::Value::Integer(FORMAT_VERSION)) => Ok(()),
        Some(other) => refuse(format!("version {other} is not known")),
    }
}
