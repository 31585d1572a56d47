//! The scene of a compiled part.

use super::task::Part;
use super::vector::{Vector, along, cross, opposite, unit};
use super::{Cell, Compilation, Implicit, Model, Planes};
use imogene_golden::format::Format;
use imogene_prepare::{Framing, Options, refused};
use imogene_scene::{
    Body, Camera, Cut, ImageSize, Light, Material, Object, SceneFile, Shape, Surface, fitting_from,
};

/// The scene; `None` if no object is left.
pub fn scene(part: &Part) -> Option<SceneFile> {
    let Part { model, planes, .. } = part;
    let mut objects = vec![];
    for (index, (solid, compilation)) in model.solids.iter().zip(&part.solids).enumerate() {
        match compilation {
            Compilation::Volume(cell) => {
                let material = model.material(index, solid.faces[0]);
                objects.push(object(&solid.name, material, cell, planes, true));
            }
            Compilation::Faces(faces) => {
                for (face, compiled) in solid.faces.iter().zip(faces) {
                    let material = model.material(index, *face);
                    let face = &model.faces[*face].name;
                    for (index, cell) in compiled.cells.iter().enumerate() {
                        let name = match compiled.cells.len() {
                            1 => format!("{}/{face}", solid.name),
                            _ => format!("{}/{face}#{}", solid.name, index + 1),
                        };
                        objects.push(object(&name, material, cell, planes, false));
                    }
                }
            }
        }
    }
    let used = |material: &&Material| objects.iter().any(|o| o.material == material.name);
    if objects.is_empty() {
        return None;
    }
    let camera = camera(model, VIEWS[0], &objects);
    let light = |from, intensity| Light::directional(turned(model.z_up, from), intensity);
    Some(SceneFile {
        background: [0.09, 0.11, 0.15],
        ambient: [1.0; 3],
        image: ImageSize::default(),
        lights: vec![light([-3.0, 5.0, 7.0], 0.75), light([6.0, 2.0, 1.0], 0.35)],
        materials: model.materials.iter().filter(used).cloned().collect(),
        objects,
        ..SceneFile::new(&model.title, camera)
    })
}

/// Moves the eye of a checked scene to where all objects fit the base format; if that is nowhere, says which do not.
pub fn look_from_elsewhere(scene: &mut SceneFile, model: &Model) -> Vec<String> {
    let first = refusals(scene);
    if first.is_empty() {
        return first;
    }
    let mut others = VIEWS[1..].iter().map(|view| SceneFile {
        camera: camera(model, *view, &scene.objects),
        ..scene.clone()
    });
    let Some(other) = others.find(|other| refusals(other).is_empty()) else {
        return first;
    };
    *scene = other;
    vec![]
}

fn refusals(scene: &SceneFile) -> Vec<String> {
    let ImageSize { width, height } = scene.image;
    let Ok(framed) = scene.frame(width, height) else {
        return vec![];
    };
    let found = refused(&framed, Format::BASE, Options::default()).into_iter();
    let name = |(index, _): (usize, _)| scene.objects[index].name.clone();
    found.map(name).collect()
}

/// A cell of a quadric face is a patch, one of a plane face a solid without thickness, a volume a solid.
fn object(name: &str, material: &str, cell: &Cell, planes: &Planes, volume: bool) -> Object {
    // It keeps the side of the plane's normal, or the other.
    let cut = |(plane, positive): (usize, bool)| {
        let (point, normal) = planes.get(plane);
        let normal = if positive { opposite(normal) } else { normal };
        Cut { point, normal }
    };
    let both = cell.flat.map(|flat| [(flat, true), (flat, false)]);
    let cuts = both.into_iter().flatten().chain(cell.cuts.iter().copied());
    let shape = match cell.quadric {
        Some(Implicit(coefficients)) => Shape::Quadric { coefficients },
        None => Shape::Polyhedron,
    };
    let mode = match cell.flat.is_some() || volume {
        true => Surface::Solid,
        false => Surface::Patch,
    };
    Object {
        mode,
        cuts: cuts.map(cut).collect(),
        ..crate::kit::object(name.to_owned(), shape, material.to_owned())
    }
}

/// Where a part is looked at from: the direction of the eye, in a picture in which y points up, and its distance in
/// sizes of the part. The first from which all objects fit their words is taken, else the first of all. A cone has
/// great words where the eye is near the endless cone.
const VIEWS: [(Vector, f64); 5] = [
    ([0.55, 0.62, 0.85], 2.2),
    ([0.5, 0.95, 0.75], 2.2),
    ([0.65, 0.35, 0.9], 2.2),
    ([0.5, 0.95, 0.75], 5.0),
    ([0.65, 0.35, 0.9], 5.0),
];

/// The objects, as large as the picture lets them be.
fn camera(model: &Model, (from, sizes): (Vector, f64), objects: &[Object]) -> Camera {
    let size = model.size();
    let middle = model.middle();
    let distance = rounded(sizes * size, size);
    let towards = turned(model.z_up, unit(from));
    let right = unit(cross(turned(model.z_up, [0.0, 1.0, 0.0]), towards));
    let axes = [right, cross(towards, right), towards];
    let bodies = objects.iter().map(|o| Body::of(o, middle, 1e4 * size));
    let ends = |axis: &Vector| [*axis, axis.map(|v| -v)];
    let has_end = |body: &Body| axes.iter().flat_map(ends).all(|end| body.reach(end) < size);
    let mut bodies: Vec<Body> = bodies.filter(has_end).collect();
    if bodies.is_empty() {
        bodies.push(Body::ball([0.0; 3], 0.5 * size));
    }
    let ImageSize { width, height } = ImageSize::default();
    let shape = f64::from(width) / f64::from(height);
    let ([x, y], tangent) = fitting_from(&bodies, &axes, distance, shape);
    let target = along(along(middle, x, axes[0]), y, axes[1]).map(|v| rounded(v, size));
    let eye = along(target, distance, towards).map(|v| rounded(v, size));
    let up = turned(model.z_up, [0.0, 1.0, 0.0]);
    let height = rounded(2.0 * tangent * distance, size);
    Camera::perspective([eye, target, up], distance, height)
}

/// A direction of a picture in which y points up, for a part in which z may do.
fn turned(z_up: bool, [x, y, z]: Vector) -> Vector {
    // Without the sign of a zero.
    if z_up { [x, 0.0 - z, y] } else { [x, y, z] }
}

/// To a ten-thousandth of the size, for people who read the file.
fn rounded(value: f64, size: f64) -> f64 {
    let step = 10_f64.powf((4.0 - size.log10().floor()).clamp(-9.0, 15.0));
    (value * step).round() / step + 0.0
}
