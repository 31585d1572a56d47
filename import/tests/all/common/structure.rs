//! What was read of a structure file.

use imogene_import::Imported;
use imogene_import::pdb::{self, Format, Options};
use imogene_scene::{Object, Shape, Step};

pub fn cif(text: &str, options: &Options) -> Result<Imported, String> {
    pdb::read(text.as_bytes(), Format::Mmcif, "f.cif", options).map_err(|e| e.to_string())
}

pub fn names(imported: &Imported) -> Vec<&str> {
    let objects = imported.scene.objects.iter();
    objects.map(|object| object.name.as_str()).collect()
}

pub fn places(imported: &Imported) -> Vec<[f64; 3]> {
    let is_sphere = |o: &&Object| matches!(o.shape, Shape::Sphere { .. });
    let spheres = imported.scene.objects.iter().filter(is_sphere);
    let place = |object: &Object| match object.place[..] {
        [Step::Translate(place)] => place,
        ref other => panic!("{other:?}"),
    };
    spheres.map(place).collect()
}

/// The options with a change.
pub fn with(change: impl FnOnce(&mut Options)) -> Options {
    let mut options = Options::default();
    change(&mut options);
    options
}
