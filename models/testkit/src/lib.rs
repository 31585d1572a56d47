//! Scenes written by hand in the camera frame, and what the tests ask of them.

use imogene_algebra::rational::{integer, to_f64};
use imogene_algebra::vector::{cross, dot, length};
use imogene_golden::format::Format;
use imogene_golden::object::line::for_each_present;
use imogene_golden::object::quadric::{ObjectPixel, QuadricWords};
use imogene_prepare::Framing;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{Options, PreparedQuadric, PreparedScene, prepare_with};
use imogene_scene::{
    DepthRange, FramedObject, FramedQuadric, FramedScene, Material, Plane, Projection, Quadric,
    SceneFile, Surface,
};
use std::path::{Path, PathBuf};

/// The screen of the source machine: its principal point is pixel (360, 270).
pub const WIDTH: u32 = 720;
/// Lines of that screen.
pub const HEIGHT: u32 = 540;

/// The quadric of whole coefficients a to j.
pub fn whole_quadric(coefficients: [i64; 10]) -> Quadric {
    Quadric::from_array(coefficients.map(integer))
}

/// `a (x-x0)^2 + b (y-y0)^2 + c (z-z0)^2 - k`.
pub fn centred([a, b, c]: [i64; 3], [x, y, z]: [i64; 3], k: i64) -> Quadric {
    let constant = a * x * x + b * y * y + c * z * z - k;
    whole_quadric([a, b, c, 0, 0, 0, -a * x, -b * y, -c * z, constant])
}

/// A sphere.
pub fn sphere(centre: [i64; 3], radius: i64) -> Quadric {
    centred([1, 1, 1], centre, radius * radius)
}

/// The half-space `a x + b y + c z + d <= 0`.
pub fn plane(coefficients: [i64; 4]) -> Plane {
    Plane::from_array(coefficients.map(integer))
}

/// An object of the first material.
pub fn object(
    name: &str,
    surface: Surface,
    quadric: Quadric,
    planes: &[[i64; 4]],
) -> FramedQuadric {
    FramedQuadric {
        name: name.into(),
        surface,
        quadric,
        planes: planes.iter().copied().map(plane).collect(),
        material: 0,
        casts_shadow: true,
    }
}

/// A ball of the first material.
pub fn ball(centre: [i64; 3], radius: i64, planes: &[[i64; 4]]) -> FramedQuadric {
    object("ball", Surface::Solid, sphere(centre, radius), planes)
}

/// The view of an eye so many pixels before the screen.
pub fn perspective(distance: i64) -> Projection {
    let distance = integer(distance);
    Projection::Perspective { distance }
}

/// A parallel view that reaches so many pixels before and behind the screen.
pub fn parallel(half_depth: i64) -> Projection {
    let half_depth = integer(half_depth);
    Projection::Orthographic { half_depth }
}

/// A perspective scene of 720 x 540 pixels at 1000 pixels from the viewer.
pub fn scene(objects: Vec<FramedQuadric>) -> FramedScene {
    scene_of(WIDTH, HEIGHT, perspective(1000), objects)
}

/// A scene without lights.
pub fn scene_of(
    width: u32,
    height: u32,
    projection: Projection,
    objects: Vec<FramedQuadric>,
) -> FramedScene {
    FramedScene {
        title: "test".into(),
        width,
        height,
        range: DepthRange::of_pixels(&projection),
        sample_at: [0.0; 2],
        projection,
        objects: objects.into_iter().map(FramedObject::from).collect(),
        solids: vec![],
        materials: vec![Material {
            name: "plain".into(),
            colour: [1.0; 3],
            ambient: 0.3,
            diffuse: 0.7,
            specular: 0.0,
            exponent: 1,
            opacity: 1.0,
        }],
        lights: vec![],
        sources: vec![],
        ambient: [1.0; 3],
        attenuation: None,
        background: [0; 3],
    }
}

/// Prepared as the source does: rounded about the first pixel.
pub fn prepare_at_origin(scene: &FramedScene) -> PreparedScene {
    let options = Options {
        anchor: Some(Anchor::ORIGIN),
        ..Options::default()
    };
    prepare_with(scene, Format::BASE, options).expect("fits the base format")
}

/// Prepared as a machine is loaded.
pub fn prepare(scene: &FramedScene) -> PreparedScene {
    imogene_prepare::prepare(scene, Format::BASE).expect("fits the base format")
}

/// The first object of a framed scene.
pub fn framed(scene: &FramedScene) -> &FramedQuadric {
    scene.objects[0].quadric().expect("a quadric")
}

/// The first object of a prepared scene.
pub fn first(prepared: &PreparedScene) -> &PreparedQuadric {
    prepared.objects[0].quadric().expect("a quadric")
}

/// What the golden processor hands on at a pixel; nothing where the object is absent.
pub fn golden_at(words: &QuadricWords, x: i64, y: i64) -> Option<ObjectPixel> {
    let mut found = None;
    for_each_present(words, &Format::BASE, y, |column, pixel| {
        if column == x {
            found = Some(pixel);
        }
    });
    found
}

/// Number of pixels at which the golden processor sees the object.
pub fn golden_pixels(words: &QuadricWords) -> usize {
    let mut count = 0;
    for y in 0..i64::from(HEIGHT) {
        for_each_present(words, &Format::BASE, y, |_, _| count += 1);
    }
    count
}

/// A small deterministic generator (multiply with carry), for samples that must be the same in every run.
pub struct Random(pub u64);

impl Random {
    /// A number in -1 .. 1.
    pub fn signed(&mut self) -> f64 {
        self.0 = (self.0 & 0xffff_ffff) * 4_294_957_665 + (self.0 >> 32);
        (self.0 & 0xffff_ffff) as f64 / 2f64.powi(31) - 1.0
    }

    /// A direction, all equally likely, in whole millionths.
    pub fn direction(&mut self) -> [i64; 3] {
        let z = self.signed();
        let (sin, cos) = (self.signed() * std::f64::consts::PI).sin_cos();
        let ring = (1.0 - z * z).sqrt();
        [ring * cos, ring * sin, z].map(|v| (v * 1e6).round() as i64)
    }
}

/// The gradient of a quadric at a point of the camera frame, up to a positive factor, in `f64`.
pub fn gradient(quadric: &Quadric, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let coefficients = quadric.coefficients().map(to_f64);
    let greatest = coefficients.iter().fold(0.0, |most, v| v.abs().max(most));
    let [a, b, c, d, e, f, g, h, i, _] = coefficients.map(|v| v / greatest);
    [
        a * x + d * y + e * z + g,
        d * x + b * y + f * z + h,
        e * x + f * y + c * z + i,
    ]
}

/// The angle between two vectors in degrees, accurate for small angles.
pub fn angle_deg(u: [f64; 3], v: [f64; 3]) -> f64 {
    length(cross(u, v)).atan2(dot(u, v)).to_degrees()
}

fn folder_of_scenes(name: &str) -> PathBuf {
    let all = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    all.join(name)
}

/// The file of a scene of the collection, by its path there without the end of its name.
pub fn scene_path(name: &str) -> PathBuf {
    folder_of_scenes(name).with_extension("toml")
}

/// Such a scene.
pub fn scene_file(name: &str) -> SceneFile {
    SceneFile::read(&scene_path(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The scene files of the collection, in order.
pub fn collection() -> Vec<PathBuf> {
    let mut found = vec![];
    scenes_below(&folder_of_scenes(""), &mut found);
    found.sort();
    found
}

/// Those of one folder alone; `""` is the one of all others.
pub fn scenes_in(folder: &str) -> Vec<PathBuf> {
    let folder = folder_of_scenes(folder);
    let mut found = collection();
    found.retain(|path| path.parent() == Some(folder.as_path()));
    found
}

fn scenes_below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder of scenes") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            scenes_below(&path, found);
        } else if path.extension().is_some_and(|end| end == "toml") {
            found.push(path);
        }
    }
}

/// A scene file at a size, in a format; none if the preparation refuses it, as it does some of the extremes.
pub fn file_prepared(
    path: &Path,
    (width, height): (u32, u32),
    format: Format,
) -> Option<(FramedScene, PreparedScene)> {
    let file = SceneFile::read(path).expect("a valid scene");
    let framed = file.frame(width, height).expect("a valid size");
    let prepared = imogene_prepare::prepare(&framed, format).ok()?;
    Some((framed, prepared))
}

/// True in the long run, `scripts/test --full`.
pub fn is_full() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

/// The rows of a table, a line each, with their cells between bars.
pub fn rows(table: &str) -> impl Iterator<Item = Vec<&str>> {
    let lines = table.trim().lines();
    lines.map(|line| line.split('|').map(str::trim).collect())
}
