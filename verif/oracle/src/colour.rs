//! Colours of surfaces and of what is seen through them, in intervals.
//!
//! Every source adds `I (diffuse colour (N.L) + specular (R.V)^n)` where N, turned to the viewer, is on its side, of
//! which `k / (d + k)` is seen from a distance d where light is halved at k;
//! transparent objects are blended over it from the farthest to the nearest, `t I1 + (1 - t) I2`. An interval holds
//! the colours of all normals that are as near to the true one as the golden normal, at all depths that are as near to
//! the true one as the golden depth: whether a source is on this side of a surface may then remain open, and both are
//! held.

use crate::body::Body;
use crate::camera::{Affine, Sight, point};
use crate::interval::{Interval, about_all, dot};
use crate::trace::material;
use crate::transform::{apply, placement};
use imogene_scene::{Beam, Light, Material, SceneFile};
use num_rational::BigRational;
use num_traits::Zero;

/// A vector in scene coordinates.
type Direction = [Interval; 3];
/// Red, green and blue in levels, 0 to 255.
pub type Levels = [Interval; 3];

/// What a level of the shading processor may be off: half for its rounding, and more than was ever found before it.
const SHADED: f64 = 0.5 + 0.4;
/// What the words of materials and of one source may cost besides.
const WORDS: f64 = 0.1;
/// What a component of the unit vector to the viewer may be off: 2 units of its words.
const VIEW: f64 = 1.0 / (1 << 15) as f64;
/// Half a level for the rounding of a blend.
const BLENDED: f64 = 0.5;
/// What an opacity is off in 255ths.
const WEIGHT: f64 = 0.5 / 255.0;

/// A scene as far as it gives colours.
#[derive(Debug)]
pub struct Colours {
    from: [Direction; 3],
    along: [Direction; 3],
    ambient: [f64; 3],
    /// Distance from the eye at which light is halved.
    half: Option<f64>,
    background: Levels,
    sources: Vec<Source>,
    materials: Vec<Material>,
}

#[derive(Debug)]
struct Source {
    /// Its place; of one that is far away the direction towards it, of length 1.
    at: Direction,
    is_far: bool,
    /// Times its intensity.
    colour: [f64; 3],
}

/// What is seen of one object at a pixel.
pub struct Surface {
    /// Its index.
    pub object: u32,
    /// The parameters of the line of sight that the golden depth may have.
    pub t: Interval,
    /// The true normal, of length 1.
    pub normal: Direction,
    /// The greatest angle of the golden normal with it, in radians.
    pub off: f64,
}

impl Colours {
    /// Of a scene that was read and checked; `None` if a source does not reach everything, or if pixels are not
    /// sampled at their whole places, for which golden normals are of another frame.
    pub fn new(scene: &SceneFile, sight: &Sight) -> Option<Colours> {
        let scene = scene.flattened();
        let sources: Option<Vec<Source>> = scene.lights.iter().map(Source::new).collect();
        let quick = |affine: &Affine| affine.each_ref().map(direction);
        let materials = scene.objects.iter();
        let materials = materials.map(|object| material(&scene, object).clone());
        let level = |v: f64| Interval::point(255.0 * v).widened(0.5);
        (scene.camera.sample_at == [0.0; 2]).then_some(Colours {
            from: quick(&sight.from),
            along: quick(&sight.along),
            ambient: scene.ambient,
            half: scene.attenuation,
            background: scene.background.map(level),
            sources: sources?,
            materials: materials.collect(),
        })
    }

    /// What is seen at a pixel: the background or a surface, and transparent surfaces before it, the farthest first.
    /// `None` if a surface is seen from its edge, so that its side is open.
    pub fn seen(
        &self,
        at: (i64, i64),
        surface: Option<&Surface>,
        before: &[&Surface],
    ) -> Option<Levels> {
        let mut levels = match surface {
            Some(surface) => self.shaded(at, surface)?,
            None => self.background,
        };
        for layer in before {
            let opacity = self.materials[layer.object as usize].opacity;
            let part = Interval::point(opacity).widened(WEIGHT).clamped(0.0, 1.0);
            let front = self.shaded(at, layer)?;
            levels = each(|k| (levels[k] + part * (front[k] - levels[k])).widened(BLENDED));
        }
        Some(levels)
    }

    fn shaded(&self, (x, y): (i64, i64), surface: &Surface) -> Option<Levels> {
        let [x, y] = [x, y].map(|v| Interval::point(v as f64));
        let on = |[a, b, c]: &[Direction; 3]| each(|k| a[k] * x + b[k] * y + c[k]);
        let (from, along) = (on(&self.from), on(&self.along));
        let way = along.map(|v| surface.t * v);
        let place = each(|k| from[k] + way[k]);
        let distance = length(way);
        let part = self.half.map(Interval::point);
        let part = part.map_or(Interval::point(1.0), |half| half / (distance + half));
        let viewer = unit(along.map(|v| -v)).map(|v| v.widened(VIEW));
        let normal = surface.normal.map(|v| v.widened(surface.off));
        let (normal, facing) = match dot(&normal, &viewer) {
            facing if facing.lo > 0.0 => (normal, facing),
            facing if facing.hi < 0.0 => (normal.map(|v| -v), -facing),
            _ => return None,
        };
        let material = &self.materials[surface.object as usize];
        let ambient = |k: usize| material.ambient * self.ambient[k] * material.colour[k];
        let mut sum = each(|k| Interval::point(ambient(k)));
        for source in &self.sources {
            let towards = match source.is_far {
                true => source.at,
                false => unit(each(|k| source.at[k] - place[k])),
            };
            let lambert = dot(&normal, &towards).clamped(-1.0, 1.0);
            if lambert.hi <= 0.0 {
                continue;
            }
            let mirrored = Interval::point(2.0) * lambert * facing - dot(&towards, &viewer);
            let highlight = mirrored.clamped(0.0, 1.0).power(material.exponent);
            let specular = Interval::point(material.specular) * highlight;
            for (k, sum) in sum.iter_mut().enumerate() {
                let diffuse = Interval::point(material.diffuse * material.colour[k]);
                let sent = diffuse * lambert.clamped(0.0, 1.0) + specular;
                let least = if lambert.lo > 0.0 { sent.lo } else { 0.0 };
                let sent = Interval { lo: least, ..sent };
                *sum = *sum + part * Interval::point(source.colour[k]) * sent;
            }
        }
        let reach = SHADED + WORDS * self.sources.len() as f64;
        let levels = sum.map(|v| Interval::point(255.0) * v.clamped(0.0, 1.0));
        Some(levels.map(|v| v.widened(reach).clamped(0.0, 255.0)))
    }
}

impl Source {
    /// `None` if it does not reach everything.
    fn new(light: &Light) -> Option<Source> {
        let (is_far, mut at) = match &light.beam {
            _ if light.shadows => return None,
            Beam::Spot { .. } => return None,
            Beam::Point { position } => (false, point(position)),
            Beam::Directional { from } => (true, point(from)),
        };
        if is_far {
            at[3] = BigRational::zero();
        }
        let at = direction(&apply(&placement(&light.node.place), &at));
        Some(Source {
            at: if is_far { unit(at) } else { at },
            is_far,
            colour: light.colour.map(|v| v * light.intensity),
        })
    }
}

impl Body {
    /// The normal of length 1 of a face, at the parameter of a line of sight; nothing at an apex, at the near end of
    /// the depth and on a facet, whose normals are those of its corners.
    pub fn normal(&self, (x, y): (i64, i64), number: u8, t: Interval) -> Option<Direction> {
        let Body::Cut(body) = self else { return None };
        let [x, y] = [x, y].map(|v| Interval::point(v as f64));
        let on = |[a, b, c]: &[[Interval; 4]; 3], k: usize| a[k] * x + b[k] * y + c[k];
        let at = |k: usize| on(&body.quick.from, k) + t * on(&body.quick.along, k);
        let place: [Interval; 4] = std::array::from_fn(at);
        let gradient: [Interval; 4] = match number.checked_sub(2) {
            None => {
                let form = body.quick.form?;
                form.map(|row| dot(&row, &place))
            }
            Some(plane) => *body.quick.planes.get(usize::from(plane))?,
        };
        let column = |k: usize| body.frame.map(|row| row[k]);
        let normal = unit(each(|k| dot(&column(k), &gradient)));
        normal.iter().all(|v| v.width() < 1.0).then_some(normal)
    }
}

fn each(of: impl Fn(usize) -> Interval) -> [Interval; 3] {
    std::array::from_fn(of)
}

fn length(vector: Direction) -> Interval {
    let [x, y, z] = vector.map(Interval::square);
    (x + y + z).sqrt()
}

fn unit(vector: Direction) -> Direction {
    let length = length(vector);
    vector.map(|v| v / length)
}

fn direction([x, y, z, _]: &[BigRational; 4]) -> Direction {
    about_all(&[x.clone(), y.clone(), z.clone()])
}
