//! Pictures of closed parts have no cracks: the screen-space detector of the source (thesis section IV.2.2), whose
//! false alarms (a hole of which one pixel looks out behind an edge) a ray through the faces themselves takes back. One
//! crack is injected to see that it is found.

use crate::common::winding::Oracle;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_import::faces::vector::{Vector, along, cross, dot, minus, plus, times, unit};
use imogene_import::faces::{FaceOptions, read};
use imogene_import::faces::{Part, Surface, compile};
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_scene::{Camera, Lens, SceneFile};

const SIZE: [usize; 2] = [360, 270];

/// A part, its scene, its frame, and for every object the face it is of.
struct Drawn {
    part: Part,
    scene: SceneFile,
    frame: Frame,
    faces: Vec<String>,
}

fn drawn(name: &str, format: &Format) -> Drawn {
    let path = format!("{}/../parts/{name}.faces.toml", env!("CARGO_MANIFEST_DIR"));
    let bytes = std::fs::read(path).unwrap();
    let options = FaceOptions {
        max_deviation: None,
        no_volumes: true,
    };
    let part = compile(&bytes, name, &options).unwrap();
    let scene = read(&bytes, name, &options).unwrap().scene;
    // `solid/face` or `solid/face#1`
    let faces = scene
        .objects
        .iter()
        .map(|object| {
            let face = object.name.split('/').nth(1).unwrap();
            face.split('#').next().unwrap().to_owned()
        })
        .collect();
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
        let [i, j] = [
            x as f64 - 0.5 * SIZE[0] as f64,
            y as f64 - 0.5 * SIZE[1] as f64,
        ];
        let ray = plus(
            times(viewer_distance, forward),
            plus(times(i * step, right), times(j * step, down)),
        );
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
    all.into_iter()
        .filter(|t| t.is_finite() && *t > 0.0)
        .collect()
}

/// Pixels that the detector flags and that truly show something else.
fn cracks(drawn: &Drawn, d_min: i64) -> Vec<(usize, usize)> {
    let found = flagged(drawn, d_min);
    let wrong =
        |&(x, y): &(usize, usize)| drawn.owner(y * drawn.frame.width + x) != drawn.truth(x, y);
    found.into_iter().filter(wrong).collect()
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
            let steps = [1, frame.width - 1, frame.width, frame.width + 1];
            let crack = steps.into_iter().any(|step| {
                [at - step, at + step].into_iter().all(|k| {
                    owner(k).is_some()
                        && owner(k) != owner(at)
                        && frame.depth[k] + d_min < frame.depth[at]
                })
            });
            if crack {
                found.push((x, y));
            }
        }
    }
    found
}

#[test]
fn closed_parts_are_seen_without_cracks() {
    let format = Format::BASE;
    for name in [
        "flange",
        "bracket",
        "curved-plate",
        "volumes",
        "cross-drilled",
    ] {
        let mut drawn = drawn(name, &format);
        let frame = &drawn.frame;
        let seen = frame
            .depth
            .iter()
            .zip(&frame.id)
            .filter(|(_, id)| **id >= 0);
        let [near, far] = seen.fold([i64::MAX, i64::MIN], |[near, far], (depth, _)| {
            [near.min(*depth), far.max(*depth)]
        });
        // A hundredth of the depth of what is seen: every wall of the parts is thicker.
        let d_min = (far - near) / 100;
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
