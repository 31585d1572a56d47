//! Scenes of the tests.

use imogene_scene::SceneFile;
use std::path::{Path, PathBuf};

/// Ten units from the origin, the screen plane through it, ten pixels to the unit.
pub const PERSPECTIVE: &str = "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nviewer_distance = 10\nview_height = 4.8\n";
pub const PARALLEL: &str = "kind = \"orthographic\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nview_height = 4.8\nhalf_depth = 4\n";

/// A scene of 64 x 48 pixels with these objects; each has its name and material already.
pub fn scene(camera: &str, objects: &[&str]) -> SceneFile {
    let mut text = format!(
        "format = 1\ntitle = \"test\"\nimage = {{ width = 64, height = 48 }}\n[camera]\n{camera}\n\
         [[materials]]\nname = \"clay\"\ncolour = [0.8, 0.4, 0.3]\n"
    );
    for (index, object) in objects.iter().enumerate() {
        text += &format!("[[objects]]\nname = \"object {index}\"\nmaterial = \"clay\"\n{object}\n");
    }
    SceneFile::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The folder of the scene files of the repository.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

/// One of them, by its path without the ending.
pub fn read(name: &str) -> SceneFile {
    SceneFile::read(&folder().join(format!("{name}.toml"))).expect("valid")
}

/// All of them with the names of their files.
pub fn all() -> impl Iterator<Item = (String, SceneFile)> {
    files().into_iter().map(|file| {
        let name = file.file_stem().expect("a file").to_string_lossy();
        let scene = SceneFile::read(&file).expect("valid");
        (name.into_owned(), scene)
    })
}

fn files() -> Vec<PathBuf> {
    let mut folders = vec![folder()];
    let mut files = vec![];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("the scenes folder") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "toml") {
                files.push(path);
            }
        }
    }
    files.sort();
    assert!(files.len() > 60, "{}", files.len());
    files
}
