//! A whole picture from the exact reference.

use super::facet::{MeshNormals, RayMesh};
use super::number::SurdReal;
use super::ray::{Hit, RayObject};
use imogene_algebra::vector::length;
use imogene_algebra::whole::scaled;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::{Frame, FrameLayer};
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE};
use imogene_golden::unit::normal::NEAR_END_NORMAL;
use imogene_scene::{FramedObject, FramedScene, FramedSolid, Tree};
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Fraction bits of an exact depth in depth words.
pub const DEPTH_FRACTION: u32 = 20;

/// What is truly seen at a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactPixel {
    /// Depth in depth words with [`DEPTH_FRACTION`] fraction bits, exact to one unit of the last.
    pub depth: i64,
    /// Index of the visible object.
    pub id: u32,
    /// Number of the visible face.
    pub number: u8,
    /// Index of the visible facet of a mesh; 0 for any other object.
    pub part: u32,
    /// It is the back of an object that a solid takes away, whose normal is turned.
    pub is_back: bool,
}

/// What is seen at a pixel; nothing on the background.
pub type Found = Option<ExactPixel>;

pub(super) enum Rays {
    Cut(Box<RayObject>),
    Mesh(RayMesh),
}

impl Rays {
    /// None if it is nowhere to be seen.
    pub(super) fn new(object: &FramedObject, scene: &FramedScene) -> Option<Rays> {
        Some(match object {
            FramedObject::Mesh(mesh) => Rays::Mesh(RayMesh::new(mesh, scene)),
            _ => Rays::Cut(Box::new(RayObject::new(&object.cut_quadric()?, scene))),
        })
    }

    fn first_hit(&self, x: i64, y: i64) -> Option<Hit> {
        match self {
            Rays::Cut(object) => object.first_hit(x, y),
            Rays::Mesh(mesh) => mesh.first_hit(x, y),
        }
    }

    /// Where a line of sight is within a solid.
    fn interval(&self, x: i64, y: i64) -> Option<Interval> {
        let Rays::Cut(object) = self else {
            return None;
        };
        let front = object.first_hit(x, y)?;
        let back = object.back_of(&front, x, y);
        Some([front, back])
    }
}

/// The exact picture, row-major; `None` is background. `line_done` is called once a line, from any thread.
pub fn render(scene: &FramedScene, format: &Format, line_done: impl Fn() + Sync) -> Vec<Found> {
    render_where(scene, format, |_| true, line_done)
}

/// The same for the pixels that are wanted, by their index, alone; the others are `None`.
pub fn render_where(
    scene: &FramedScene,
    format: &Format,
    wanted: impl Fn(usize) -> bool + Sync,
    line_done: impl Fn() + Sync,
) -> Vec<Found> {
    let view = View::new(scene);
    pixels(scene, format, wanted, |x, y| view.visible(x, y), line_done)
}

/// What `visible` finds at the wanted pixels, with its object.
fn pixels(
    scene: &FramedScene,
    format: &Format,
    wanted: impl Fn(usize) -> bool + Sync,
    visible: impl Fn(i64, i64) -> Option<(u32, Hit)> + Sync,
    line_done: impl Fn() + Sync,
) -> Vec<Found> {
    let full = BigInt::from(format.z_max());
    let width = i64::from(scene.width);
    let line = |y: i64| {
        let pixel = |x| {
            if !wanted((y * width + x) as usize) {
                return None;
            }
            let (id, hit) = visible(x, y)?;
            let depth = hit.w.fixed(&full, &full, DEPTH_FRACTION);
            Some(ExactPixel {
                depth: depth.to_i64().expect("in the depth word"),
                id,
                number: hit.number,
                part: hit.part as u32,
                is_back: hit.is_back,
            })
        };
        let pixels: Vec<Found> = (0..width).map(pixel).collect();
        line_done();
        pixels
    };
    let lines = (0..i64::from(scene.height)).into_par_iter();
    lines.flat_map_iter(line).collect()
}

/// All that can be seen along the rays of a screen.
pub struct View<'a> {
    objects: Vec<Option<Rays>>,
    solids: &'a [FramedSolid],
    members: Vec<BTreeSet<usize>>,
    /// Objects in none.
    alone: Vec<usize>,
}

impl View<'_> {
    /// Sets up the rays of a scene's screen.
    pub fn new(scene: &FramedScene) -> View<'_> {
        let of = |solid: &FramedSolid| solid.tree.objects().into_iter().collect();
        let members: Vec<BTreeSet<usize>> = scene.solids.iter().map(of).collect();
        let is_alone = |id: &usize| !members.iter().any(|members| members.contains(id));
        let opaque = (0..scene.objects.len()).filter(|id| !scene.is_transparent(*id));
        View {
            objects: scene.objects.iter().map(|o| Rays::new(o, scene)).collect(),
            solids: &scene.solids,
            alone: opaque.filter(is_alone).collect(),
            members,
        }
    }

    /// The nearest hit, with its object; of equal ones an object goes before a solid, then the earlier one.
    pub fn visible(&self, x: i64, y: i64) -> Option<(u32, Hit)> {
        let hit = |&id: &usize| Some((id, self.objects[id].as_ref()?.first_hit(x, y)?));
        let interval = |&id: &usize| Some((id, self.objects[id].as_ref()?.interval(x, y)?));
        let solids = self.solids.iter().zip(&self.members);
        let solids = solids.filter_map(|(solid, members)| {
            first_point(&solid.tree, &members.iter().filter_map(interval).collect())
        });
        let all = self.alone.iter().filter_map(hit).chain(solids);
        nearest(all).map(|(id, hit)| (id as u32, hit))
    }
}

/// An object where a line of sight enters it and where it leaves it.
type Interval = [Hit; 2];

/// The first point of a solid behind which the line is within, with its object: the nearest face behind which the tree
/// contains the line. Of two faces there a front goes first, then the smaller index.
fn first_point(tree: &Tree, met: &BTreeMap<usize, Interval>) -> Option<(usize, Hit)> {
    let is_within = |w: &SurdReal| {
        let holds = |[front, back]: &Interval| front.w <= *w && *w < back.w;
        tree.contains(&|object| met.get(&object).is_some_and(holds))
    };
    let front = |(&id, [front, _]): (&usize, &Interval)| (id, front.clone());
    let back = |(&id, [_, back]): (&usize, &Interval)| {
        let turned = Hit {
            is_back: true,
            number: match back.number {
                // Seen from behind, the far root is the near one.
                FACE_NEAR => FACE_FAR,
                FACE_FAR => FACE_NEAR,
                number => number,
            },
            ..back.clone()
        };
        (id, turned)
    };
    let faces = met.iter().map(front).chain(met.iter().map(back));
    nearest(faces.filter(|(_, hit)| is_within(&hit.w)))
}

/// Of equally near ones the first.
fn nearest(hits: impl Iterator<Item = (usize, Hit)>) -> Option<(usize, Hit)> {
    hits.reduce(|best, hit| if hit.1.w < best.1.w { hit } else { best })
}

/// The exact picture rounded to a frame, for shading and comparison: depths floored, normals in full 16-bit words.
pub fn to_frame(pixels: &[Found], scene: &FramedScene, format: &Format) -> Frame {
    let width = scene.width as usize;
    let mut frame = Frame::background(width, scene.height as usize, format.z_max());
    let directions = directions(pixels, scene, format);
    for (index, pixel) in pixels.iter().enumerate() {
        let Some(pixel) = pixel else { continue };
        frame.depth[index] = pixel.depth >> DEPTH_FRACTION;
        frame.id[index] = pixel.id as i32;
        frame.number[index] = pixel.number;
        frame.normal[index] = full_length(directions[index]);
    }
    let transparent = (0..scene.objects.len()).filter(|id| scene.is_transparent(*id));
    frame.layers = transparent.map(|id| layer(id, scene, format)).collect();
    frame
}

fn layer(id: usize, scene: &FramedScene, format: &Format) -> FrameLayer {
    let object = Rays::new(&scene.objects[id], scene);
    let hit = |x, y| Some((id as u32, object.as_ref()?.first_hit(x, y)?));
    let pixels = pixels(scene, format, |_| true, hit, || ());
    let directions = directions(&pixels, scene, format);
    let depth = |pixel: &Found| pixel.map_or(format.z_max(), |pixel| pixel.depth >> DEPTH_FRACTION);
    let normal =
        |(pixel, direction): (&Found, [f64; 3])| pixel.map_or([0; 3], |_| full_length(direction));
    FrameLayer {
        object: id,
        weight: scene.weight(id),
        depth: pixels.iter().map(depth).collect(),
        normal: pixels.iter().zip(directions).map(normal).collect(),
    }
}

/// The direction of the true normal at every pixel, of any length; zero where nothing is seen.
pub fn directions(pixels: &[Found], scene: &FramedScene, format: &Format) -> Vec<[f64; 3]> {
    let width = scene.width as usize;
    let full = scene.projection.full_depth();
    let unit = (1i64 << DEPTH_FRACTION) as f64 * format.z_max() as f64;
    let normals: Vec<Option<Normals>> = scene.objects.iter().map(Normals::new).collect();
    let direction = |(index, pixel): (usize, &Found)| {
        let Some(pixel) = pixel else { return [0.0; 3] };
        let depth = pixel.depth as f64 / unit * full;
        let centre = scene.pixel_centre(index % width, index / width);
        let point = scene.projection.antecedent(centre, depth);
        let normals = normals[pixel.id as usize].as_ref();
        let normals = normals.expect("no pixel shows what is unseen");
        let turn = if pixel.is_back { -1.0 } else { 1.0 };
        normals.at(pixel, point).map(|part| turn * part)
    };
    pixels.iter().enumerate().map(direction).collect()
}

/// Where the normals of an object come from, in floating point.
enum Normals<'a> {
    /// Coefficients of the quadric, and normals of the planes.
    Cut([f64; 10], Vec<[f64; 3]>),
    Mesh(MeshNormals<'a>),
}

impl Normals<'_> {
    fn new(object: &FramedObject) -> Option<Normals<'_>> {
        if let FramedObject::Mesh(mesh) = object {
            return Some(Normals::Mesh(MeshNormals::new(mesh)));
        }
        let cut = object.cut_quadric()?;
        let planes = cut.planes.iter().map(|p| scaled([&p.a, &p.b, &p.c]));
        let quadric = scaled(cut.quadric.coefficients());
        Some(Normals::Cut(quadric, planes.collect()))
    }

    fn at(&self, pixel: &ExactPixel, point: [f64; 3]) -> [f64; 3] {
        let (quadric, planes) = match self {
            Normals::Mesh(mesh) => return mesh.at(pixel.part as usize, point),
            Normals::Cut(quadric, planes) => (quadric, planes),
        };
        match pixel.number {
            FACE_NEAR_END => NEAR_END_NORMAL.map(f64::from),
            n if n >= FACE_PLANE => planes[usize::from(n - FACE_PLANE)],
            _ => {
                let [a, b, c, d, e, f, g, h, i, _] = *quadric;
                let [x, y, z] = point;
                let rows = [[a, d, e, g], [d, b, f, h], [e, f, c, i]];
                rows.map(|[u, v, w, one]| u * x + v * y + w * z + one)
            }
        }
    }
}

fn full_length(direction: [f64; 3]) -> [i16; 3] {
    let length = length(direction);
    direction.map(|v| (v / length * 32767.0).round() as i16)
}
