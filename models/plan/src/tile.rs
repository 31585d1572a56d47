//! The words of a tile: a chip that shows the one solid of a scene.

use imogene_algebra::vector::{dot, length};
use imogene_contract::MachineWords;
use imogene_contract::tile::{
    FACTOR, LIGHT, LIGHT_FRACTION, MOST_LEVEL, MOST_TILE_PLANES, TileLight, TilePlane, TileWords,
};
use imogene_contract::video::VideoMode;
use imogene_golden::format::{FittedError, Format};
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::range::bits;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{Class, FACE_NEAR};
use imogene_golden::unit::pe1::Linear;
use imogene_prepare::{PreparedObject, PreparedScene};
use imogene_scene::FramedScene;
use thiserror::Error;

/// Why a tile cannot show a scene.
#[derive(Debug, Error)]
pub enum TileError {
    /// Something else than one solid.
    #[error(
        "a tile draws one opaque solid between two roots, cut by at most {MOST_TILE_PLANES} planes; the scene has {0}"
    )]
    Scene(String),
    /// An object as large as the screen: columns and lines of both.
    #[error(
        "the object takes {}x{} pixels of a screen of {}x{} and has no room to move; a greater view_height makes it smaller", .0[0], .0[1], .1[0], .1[1]
    )]
    Room([u64; 2], [u64; 2]),
    /// Words that there are not.
    #[error(transparent)]
    Words(#[from] FittedError),
}

/// The light of a surface that sends back all that it can.
const BRIGHT: f64 = 60.0;
/// Factor of a colour at which the brightest light has the greatest level.
const MOST_FACTOR: u64 = (MOST_LEVEL << FACTOR) / (1 << LIGHT);
/// The part of the depth of the object that the first plane goes through on its way across the screen.
const SWEPT: f64 = 0.5;
/// Places that the product of the root is shifted, less than this.
const MOST_SHIFT: u32 = 12;
/// Wide enough for every value of an expression on a screen.
const WIDE: u32 = 100;

/// The words of a scene that is prepared for the whole screen of a mode. In the first frame the object is where the
/// scene has it; the window is the box of what is seen of it in any frame.
///
/// The light is that of the brightest source, in white and from one direction. On the quadric it goes with the
/// component of the gradient along this direction, whose greatest length on the object stands for 1: it is not brought
/// to this length at each pixel. The factor of the root gets three bits; the colours make up for what that changes.
/// Fails when the scene is not of one solid that a tile can draw.
pub fn tile_words(
    scene: &FramedScene,
    prepared: &PreparedScene,
    mode: VideoMode,
) -> Result<TileWords, TileError> {
    let quadric = only_solid(prepared)?;
    let screen = [mode.line.active, mode.frame.active];
    let format = widest(&prepared.format)?;
    let object = Drawn::of(quadric, &quadric.screen_box, 0, &format);
    let (drift, reached) = drift(quadric, &object, screen[0]);
    let whole = ScreenBox::of_screen(prepared.width, prepared.height);
    let drawn = reached.map(|by| Drawn::of(quadric, &whole, by, &format));
    let seen = drawn[0].seen.around(&drawn[1].seen);
    let start = [seen.x0 as u64, seen.y0 as u64];
    let window = seen.size().map(|side| side as u64);
    if (0..2).any(|axis| window[axis] >= screen[axis]) {
        return Err(TileError::Room(window, screen));
    }
    let words = |words: &Linear| {
        let moved = words.from_zone(seen.x0, seen.y0);
        [moved.a, moved.b, moved.c].map(|word| word as i64)
    };
    let f2 = quadric.f2.from_zone(seen.x0, seen.y0);
    let shading = Shading::of(scene, quadric, object.longest, &prepared.format);
    let planes = quadric.planes.iter().map(|plane| TilePlane {
        kind: plane.kind as u64,
        depth: words(&plane.depth),
        light: shading.on_plane(plane.normal),
    });
    Ok(TileWords {
        mode,
        widths: widths(quadric, &seen, reached, prepared)?,
        window,
        start,
        f1: words(&quadric.f1),
        f2: [f2.a, f2.b, f2.c, f2.d, f2.e, f2.f].map(|word| word as i64),
        planes: planes.collect(),
        drift,
        light: shading.on_quadric(&quadric.normal.g.each_ref().map(|g| {
            let moved = g.from_zone(seen.x0, seen.y0);
            [moved.a, moved.b, moved.c].map(|word| word as f64)
        })),
        colour: shading.colour,
        background: scene
            .background
            .map(|level| (f64::from(level) / 255.0 * MOST_LEVEL as f64).round() as u64),
    })
}

/// The one object of a scene; fails when it is not one solid that a tile can draw.
pub fn only_solid(prepared: &PreparedScene) -> Result<&QuadricWords, TileError> {
    let refused = |what: &str| TileError::Scene(what.to_owned());
    let [object] = &prepared.objects[..] else {
        let count = prepared.objects.len();
        return Err(refused(&format!("{count} objects")));
    };
    if !prepared.transparent.is_empty() {
        return Err(refused("a transparent object"));
    }
    let PreparedObject::Quadric(object) = object else {
        return Err(refused("an object of another processor"));
    };
    let words = &object.words;
    match (words.class, words.planes.len()) {
        (Class::Side, 0..=MOST_TILE_PLANES) if !words.screen_box.is_empty() => Ok(words),
        (Class::Side, 0..=MOST_TILE_PLANES) => Err(refused("an object that is not in the picture")),
        (Class::Side, planes) => Err(refused(&format!("{planes} planes"))),
        (Class::Patch, _) => Err(refused("a bare surface")),
        (Class::Front, _) => Err(refused("a quadric around the eye")),
        (Class::Prism, _) => Err(refused("a cylinder along the line of sight")),
    }
}

/// The same words with a root and a plane that hold all there is.
fn widest(format: &Format) -> Result<Format, FittedError> {
    let depth = format.depth;
    Format::fitted(&MachineWords {
        root: depth,
        plane: depth + 12,
        ..format.widths()
    })
}

/// What is drawn of an object while its first plane is moved.
struct Drawn {
    /// Where it is seen.
    seen: ScreenBox,
    /// Its least and its greatest depth.
    depth: [i64; 2],
    /// Length of the longest gradient on the quadric.
    longest: f64,
}

impl Drawn {
    fn of(quadric: &QuadricWords, within: &ScreenBox, by: i64, format: &Format) -> Drawn {
        let mut words = quadric.clone();
        words.screen_box = *within;
        if let Some(first) = words.planes.first_mut() {
            first.depth.c += i128::from(by);
        }
        let (mut seen, mut depth, mut longest) = (ScreenBox::EMPTY, [i64::MAX, i64::MIN], 0.0);
        for (x, y) in within.each() {
            if !has_root(&words, x, y, format) {
                continue;
            }
            let pixel = words.probe_at(x, y, format).output;
            if pixel.zf == format.z_max() {
                continue;
            }
            seen = seen.around(&ScreenBox::of([x; 2], [y; 2]));
            depth = [depth[0].min(pixel.zf), depth[1].max(pixel.zb)];
            if pixel.number == FACE_NEAR {
                longest = f64::max(longest, length(pixel.normal.map(f64::from)));
            }
        }
        Drawn {
            seen,
            depth,
            longest,
        }
    }
}

/// Whether the quadric is there at a pixel, with a root that has a word.
fn has_root(words: &QuadricWords, x: i64, y: i64, format: &Format) -> bool {
    let f2 = words.f2.wrapped_at(x, y, WIDE);
    (0..1 << (format.pe2_width() - 1)).contains(&f2)
}

/// What the first plane moves by in a frame, and how far it is moved at both edges of the screen, at most. A plane
/// along the line of sight stays.
fn drift(quadric: &QuadricWords, object: &Drawn, screen: u64) -> (i64, [i64; 2]) {
    let moves = |kind| matches!(kind, PlaneKind::Front | PlaneKind::Back);
    let first = quadric.planes.first();
    if !first.is_some_and(|plane| moves(plane.kind)) {
        return (0, [0; 2]);
    }
    let left = object.seen.x0;
    let right = screen as i64 - 1 - object.seen.x1;
    let depth = (object.depth[1] - object.depth[0]) as f64;
    let drift = (SWEPT * depth / (left + right).max(1) as f64).round() as i64;
    (drift, [-drift * left, drift * right])
}

/// The least words that hold f2 in the window, and the planes where the quadric is.
fn widths(
    quadric: &QuadricWords,
    window: &ScreenBox,
    reached: [i64; 2],
    prepared: &PreparedScene,
) -> Result<MachineWords, FittedError> {
    let format = widest(&prepared.format)?;
    let (mut quadratic, mut plane) = (0, format.depth);
    for (x, y) in window.each() {
        quadratic = bits(quadric.f2.wrapped_at(x, y, WIDE)).max(quadratic);
        if !has_root(quadric, x, y, &format) {
            continue;
        }
        for (index, cut) in quadric.planes.iter().enumerate() {
            let depth = cut.depth.wrapped_at(x, y, WIDE);
            let moved = if index == 0 { reached } else { [0; 2] };
            let moved = moved.map(|by| bits(depth + i128::from(by)));
            plane = plane.max(moved[0]).max(moved[1]);
        }
    }
    let root = (quadratic - prepared.format.guard_quadratic).div_ceil(2);
    let words = prepared.format.widths();
    let words = MachineWords {
        root: root.max(words.root),
        plane,
        ..words
    };
    Format::fitted(&words).map(|_| words)
}

struct Shading {
    /// Towards the source.
    towards: [f64; 3],
    /// What a surface sends back that lies towards it, and anywhere.
    diffuse: f64,
    ambient: f64,
    /// Light of a gradient of length 1.
    scale: f64,
    factor: i64,
    shift: u32,
    colour: [u64; 3],
}

impl Shading {
    fn of(scene: &FramedScene, quadric: &QuadricWords, longest: f64, format: &Format) -> Shading {
        let material = &scene.materials[scene.objects[0].material()];
        let (towards, intensity) = brightest(scene);
        let mean = scene.ambient.into_iter().sum::<f64>() / 3.0;
        let diffuse = BRIGHT * material.diffuse * intensity;
        let scale = diffuse / longest.max(1.0);
        // What a step of the root adds to the light.
        let normal = &quadric.normal;
        let along = dot(towards, normal.k.map(f64::from));
        let places = u32::from(normal.shift) + format.product_fraction() + Format::NORMAL_FRACTION;
        let step = -scale * along / f64::from(places).exp2();
        let (factor, shift) = factor(step);
        let stretch = match factor {
            0 => 1.0,
            factor => factor as f64 / f64::from(shift).exp2() / step,
        };
        let colour = material.colour.map(|level| {
            let factor = level * MOST_FACTOR as f64 / stretch;
            (factor.round() as u64).min(MOST_FACTOR)
        });
        Shading {
            towards,
            diffuse: diffuse * stretch,
            ambient: BRIGHT * material.ambient * mean,
            scale: scale * stretch,
            factor,
            shift,
            colour,
        }
    }

    fn on_plane(&self, normal: [i16; 3]) -> u64 {
        let normal = normal.map(f64::from);
        let across = dot(self.towards, normal) / length(normal).max(1.0);
        let light = self.ambient + self.diffuse * across.max(0.0);
        light.round().min(f64::from((1 << LIGHT) - 1)) as u64
    }

    fn on_quadric(&self, gradient: &[[f64; 3]; 3]) -> TileLight {
        let unit = f64::from(LIGHT_FRACTION).exp2();
        let scale = self.scale * unit / f64::from(Format::NORMAL_FRACTION).exp2();
        let part = |index: usize| scale * dot(self.towards, [0, 1, 2].map(|k| gradient[k][index]));
        let [a, b, c] = [part(0), part(1), part(2) + self.ambient * unit];
        TileLight {
            linear: [a, b, c].map(|word| word.round() as i64),
            factor: self.factor,
            shift: self.shift,
            ambient: self.ambient.round() as u64,
        }
    }
}

/// Towards the brightest source, and how bright it is; without any, the light is that of the viewer.
fn brightest(scene: &FramedScene) -> ([f64; 3], f64) {
    let intensity = |colour: &[f64; 3]| colour.iter().copied().fold(0.0, f64::max);
    let sources = scene.lights.iter().map(|light| {
        let far = match light.is_at_a_point {
            true => length(light.at).max(1.0),
            false => 1.0,
        };
        (light.at.map(|part| part / far), intensity(&light.colour))
    });
    let brighter = |a: &([f64; 3], f64), b: &([f64; 3], f64)| a.1.total_cmp(&b.1);
    sources.max_by(brighter).unwrap_or(([0.0, 0.0, -1.0], 1.0))
}

/// A factor of three bits and a sign, and the places to the right, that come nearest to a step.
pub fn factor(step: f64) -> (i64, u32) {
    let scaled = |shift: u32| step * f64::from(shift).exp2();
    let fits = |shift: &u32| scaled(*shift).abs() < 7.5;
    let shift = (0..MOST_SHIFT).rev().find(fits).unwrap_or(0);
    (scaled(shift).round().clamp(-7.0, 7.0) as i64, shift)
}
