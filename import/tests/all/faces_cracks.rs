//! Pictures of closed parts have no cracks: the screen-space detector of the source (thesis section IV.2.2), whose
//! false alarms (a hole of which one pixel looks out behind an edge) a ray through the faces themselves takes back. One
//! crack is injected to see that it is found.

use crate::common::list::{EACH_FACE, file};
use crate::common::winding::Oracle;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_import::faces::vector::{Vector, along, cross, dot, minus, times, unit};
use imogene_import::faces::{Part, Surface, compile, read};
use imogene_prepare::{Framing, prepare};
use imogene_scene::{Camera, Lens, Object, SceneFile};

const SIZE: [usize; 2] = [360, 270];

/// A part, its scene, its frame, and for every object the face it is of.
struct Drawn {
    part: Part,
    scene: SceneFile,
    frame: Frame,
    faces: Vec<String>,
}

fn drawn(name: &str, format: &Format) -> Drawn {
    let bytes = file(&format!("parts/{name}.faces.toml"));
    let part = compile(&bytes, name, &EACH_FACE).unwrap();
    let scene = read(&bytes, name, &EACH_FACE).unwrap().scene;
    // `solid/face` or `solid/face#1`
    let face = |object: &Object| object.name.split(['/', '#']).nth(1).unwrap().to_owned();
    let faces = scene.objects.iter().map(face).collect();
    let [width, height] = SIZE;
    let framed = scene.frame(width as u32, height as u32).unwrap();
    let prepared = prepare(&framed, *format).unwrap();
    let frame = beam::render(&prepared.slots(), format, width, height, || ());
    Drawn {
        part,
        scene,
        frame,
        faces,
    }
}

impl Drawn {
    /// The face that a pixel shows.
    fn owner(&self, index: usize) -> Option<&str> {
        let id = usize::try_from(self.frame.id[index]).ok()?;
        Some(&self.faces[id])
    }

    /// The face that the ray through a pixel meets first, by the winding of its loops.
    fn truth(&self, x: usize, y: usize) -> Option<&str> {
        let Camera {
            eye,
            target,
            up,
            view_height,
            lens: Lens::Perspective {
                viewer_distance, ..
            },
            ..
        } = self.scene.camera
        else {
            panic!("the import writes perspective")
        };
        let forward = unit(minus(target, eye));
        let right = unit(cross(forward, up));
        let down = cross(forward, right);
        let step = view_height / SIZE[1] as f64;
        let from_middle = |at: usize, size: usize| step * (at as f64 - 0.5 * size as f64);
        let ahead = times(viewer_distance, forward);
        let aside = along(ahead, from_middle(x, SIZE[0]), right);
        let ray = along(aside, from_middle(y, SIZE[1]), down);
        let mut nearest: Option<(f64, &str)> = None;
        for face in &self.part.model.faces {
            let oracle = Oracle::new(&self.part.model, face);
            for t in hits(&face.surface, eye, ray) {
                if nearest.is_none_or(|(least, _)| t < least) && oracle.has(along(eye, t, ray)) {
                    nearest = Some((t, &face.name));
                }
            }
        }
        nearest.map(|(_, name)| name)
    }
}

/// Where a ray meets a surface, in front of the eye.
fn hits(surface: &Surface, eye: Vector, ray: Vector) -> Vec<f64> {
    let all = match surface.plane() {
        Some((origin, normal)) => vec![dot(minus(origin, eye), normal) / dot(ray, normal)],
        None => {
            let [a, b, c] = surface.implicit().unwrap().on_line(eye, ray);
            let root = (b * b - 4.0 * a * c).sqrt();
            vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
        }
    };
    let in_front = |t: &f64| t.is_finite() && *t > 0.0;
    all.into_iter().filter(in_front).collect()
}

/// Pixels that the detector flags and that truly show something else.
fn cracks(drawn: &Drawn, d_min: i64) -> Vec<(usize, usize)> {
    let mut found = flagged(drawn, d_min);
    found.retain(|(x, y)| drawn.owner(y * drawn.frame.width + x) != drawn.truth(*x, *y));
    found
}

/// Pixels between two opposite neighbours that are both nearer by more than `d_min` words and neither of the pixel's
/// own face.
fn flagged(drawn: &Drawn, d_min: i64) -> Vec<(usize, usize)> {
    let frame = &drawn.frame;
    let owner = |k: usize| drawn.owner(k);
    let mut found = vec![];
    for y in 1..frame.height - 1 {
        for x in 1..frame.width - 1 {
            let at = y * frame.width + x;
            let is_before = |k: usize| {
                let other = owner(k).is_some() && owner(k) != owner(at);
                other && frame.depth[k] + d_min < frame.depth[at]
            };
            let mut steps = [1, frame.width - 1, frame.width, frame.width + 1].into_iter();
            if steps.any(|step| is_before(at - step) && is_before(at + step)) {
                found.push((x, y));
            }
        }
    }
    found
}

#[test]
fn closed_parts_are_seen_without_cracks() {
    let format = Format::BASE;
    for name in "flange bracket curved-plate volumes cross-drilled".split(' ') {
        let mut drawn = drawn(name, &format);
        let frame = &drawn.frame;
        let both = frame.depth.iter().zip(&frame.id);
        let seen = both.filter(|(_, id)| **id >= 0);
        let [least, most] = [seen.clone().min(), seen.max()].map(|pair| pair.unwrap().0);
        // A hundredth of the depth of what is seen: every wall of the parts is thicker.
        let d_min = (most - least) / 100;
        assert_eq!(cracks(&drawn, d_min), [], "{name}");
        // One pixel out of the middle of what is covered.
        let covered = |k: usize| frame.id.get(k).is_some_and(|id| *id >= 0);
        let whole = |k: &usize| {
            (0..3).all(|line| (0..3).all(|column| covered(k + column + line * frame.width)))
        };
        let middle = (0..frame.id.len()).find(whole).unwrap() + 1 + frame.width;
        let place = (middle % frame.width, middle / frame.width);
        drawn.frame.id[middle] = -1;
        drawn.frame.depth[middle] = format.z_max();
        assert_eq!(cracks(&drawn, d_min), [place], "{name}");
    }
}
