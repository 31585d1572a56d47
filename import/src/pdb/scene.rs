//! The scene of a molecule.

use super::bonds::{self, Bonds};
use super::choose::Chosen;
use super::framing;
use super::options::{Colouring, Options, Style};
use super::structure::{Atom, Structure};
use super::words::{Word, Words};
use crate::error::Result;
use crate::kit::{Names, material, object, short};
use imogene_algebra::vector::{dot, length, minus};
use imogene_scene::{Axis, Cut, Light, Material, Object, Rotation, SceneFile, Shape, Step};
use std::collections::HashMap;

/// Radius of a ball in a ball-and-stick picture, as a share of the van der Waals radius.
pub const BALL: f64 = 0.25;
/// Radius of a stick in angstroms: less than that of the smallest ball.
pub const STICK: f64 = 0.15;
/// Least sine of the angle between a line of sight and the planes that end a stick.
const LEAST_SINE: f64 = 0.1;
/// Colours of chains or models beyond which they repeat; the shading processor holds 256 materials.
const MOST_COLOURS: usize = 240;

pub struct Drawn {
    /// The spheres of all atoms, then the cylinders of bonds; a bond between two colours has two.
    pub scene: SceneFile,
    pub bonds: Bonds,
    /// Least and greatest coordinates of the spheres.
    pub extent: ([f64; 3], [f64; 3]),
}

#[derive(PartialEq, Eq, Hash)]
enum Key {
    Element(&'static str),
    Chain(Word),
    Model(i64),
}

/// Materials by what gives the colour.
struct Materials {
    colouring: Colouring,
    list: Vec<Material>,
    places: HashMap<Key, usize>,
}

impl Materials {
    fn of(&mut self, atom: &Atom, model: i64, words: &Words) -> &Material {
        let key = match self.colouring {
            Colouring::Element => Key::Element(atom.element.symbol),
            Colouring::Chain => Key::Chain(atom.chain),
            Colouring::Model => Key::Model(model),
        };
        let rank = self.places.len() % MOST_COLOURS;
        let place = *self.places.entry(key).or_insert(rank);
        // Beyond the last colour the ranks begin anew, and the list does not grow.
        if place == self.list.len() {
            let name = match self.colouring {
                Colouring::Element if atom.element.symbol == "?" => "unknown element".to_owned(),
                Colouring::Element => atom.element.symbol.to_owned(),
                Colouring::Chain if atom.chain.is_empty() => "chain without name".to_owned(),
                Colouring::Chain => format!("chain {}", words.text(atom.chain)),
                Colouring::Model => format!("model {model}"),
            };
            let colour = match self.colouring {
                Colouring::Element => atom.element.colour(),
                _ => colour_of_rank(place),
            };
            self.list.push(material(name, colour, [0.4, 0.7, 0.35], 40));
        }
        &self.list[place]
    }
}

/// Colours that stay apart however many there are: hues a golden section of the circle apart, in three shades.
fn colour_of_rank(rank: usize) -> [f64; 3] {
    let hue = (0.58 + rank as f64 * 0.618_033_988_75).fract() * 6.0;
    let (saturation, value) = [(0.65, 0.95), (0.45, 0.85), (0.8, 0.7)][rank % 3];
    // The usual change from hue, saturation and value to red, green and blue.
    [5.0, 3.0, 1.0].map(|n| {
        let k = (n + hue) % 6.0;
        let level = value - value * saturation * k.min(4.0 - k).clamp(0.0, 1.0);
        (level * 1e3_f64).round() / 1e3
    })
}

pub fn build(
    structure: &Structure,
    chosen: &[Chosen],
    file: &str,
    options: &Options,
) -> Result<Drawn> {
    let mut names = Names::default();
    let mut materials = Materials {
        colouring: options.colouring,
        list: vec![],
        places: HashMap::new(),
    };
    let (mut objects, mut balls) = (vec![], vec![]);
    for model in chosen {
        let number = (chosen.len() > 1).then_some(model.number);
        for atom in &model.atoms {
            let radius = match options.style {
                Style::SpaceFilling => atom.element.van_der_waals(),
                Style::BallAndStick => short(atom.element.van_der_waals() * BALL),
            };
            let material = materials.of(atom, model.number, &structure.words);
            balls.push((atom.place, radius));
            let name = atom_name(&mut names, atom, &structure.words, number);
            objects.push(Object {
                // The sum turns -0 into 0.
                place: vec![Step::Translate(atom.place.map(|v| v + 0.0))],
                ..object(name, Shape::Sphere { radius }, material.name.clone())
            });
        }
    }
    let (camera, axes) = framing::frame(&balls);
    let (mut sticks, mut all) = (vec![], Bonds::default());
    let with_sticks = match options.style {
        Style::SpaceFilling => &[],
        Style::BallAndStick => chosen,
    };
    let mut rest = &objects[..];
    for model in with_sticks {
        let (balls, others) = rest.split_at(model.atoms.len());
        rest = others;
        let found = bonds::find(&model.atoms, &model.copies, &structure.connections)?;
        for pair in &found.pairs {
            let ends = pair.map(|k| (&model.atoms[k], &balls[k]));
            sticks.extend(cylinders(ends, camera.eye, &mut names));
        }
        all.pairs.extend(found.pairs);
        all.connected += found.connected;
        all.left_out += found.left_out;
    }
    objects.extend(sticks);
    let light = |[right, up, towards]: [f64; 3], colour: [f64; 3], intensity: f64| {
        let from = std::array::from_fn(|k| {
            right * axes[0][k] + up * axes[1][k] + towards * axes[2][k] + 0.0
        });
        Light {
            colour,
            ..Light::directional(from, intensity)
        }
    };
    Ok(Drawn {
        scene: SceneFile {
            background: [0.06, 0.08, 0.13],
            ambient: [0.55, 0.55, 0.6],
            image: framing::IMAGE,
            lights: vec![
                light([-3.0, 5.0, 7.0], [1.0, 0.97, 0.9], 0.9),
                light([6.0, 1.0, 4.0], [0.6, 0.75, 1.0], 0.35),
            ],
            materials: materials.list,
            objects,
            ..SceneFile::new(&title(structure, file), camera)
        },
        bonds: all,
        extent: framing::bounding_box(&balls),
    })
}

fn title(structure: &Structure, file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file).to_owned();
    match (structure.entry.as_str(), structure.title.as_str()) {
        ("", "") => name,
        ("", title) => title.to_owned(),
        (entry, "") => entry.to_owned(),
        (entry, title) => format!("{entry}: {title}"),
    }
}

/// The stick of a bond: one cylinder, or two halves that meet in one plane if its ends have different colours.
fn cylinders(mut ends: [(&Atom, &Object); 2], eye: [f64; 3], names: &mut Names) -> Vec<Object> {
    // The local y axis is turned towards the upper end, which keeps the half turn below well away from the axis itself.
    if ends[1].0.place[1] < ends[0].0.place[1] {
        ends.swap(0, 1);
    }
    let [(low, first), (high, second)] = ends;
    let along = minus(high.place, low.place);
    let length = length(along);
    let normal = normal(along, length, minus(eye, low.place));
    let piece = |name: String, from: f64, to: f64, material: &str| {
        let cut = |y: f64, side: f64| Cut {
            point: [0.0, y, 0.0],
            normal: normal.map(|v| side * v + 0.0),
        };
        let shape = Shape::EllipticCylinder([STICK; 2]);
        Object {
            place: placed(along, length, low.place),
            cuts: vec![cut(from, -1.0), cut(to, 1.0)],
            ..object(name, shape, material.to_owned())
        }
    };
    // Ends lie in the middles of the balls, to a thousandth of the stick's radius.
    let (half, whole) = (short(0.5 * length), short(length));
    if first.material == second.material {
        let name = names.unique(format!("{}-{}", first.name, second.name), numbered);
        return vec![piece(name, 0.0, whole, &first.material)];
    }
    let mut half_name =
        |a: &Object, b: &Object| names.unique(format!("{}>{}", a.name, b.name), numbered);
    let (lower, upper) = (half_name(first, second), half_name(second, first));
    vec![
        piece(lower, 0.0, half, &first.material),
        piece(upper, half, whole, &second.material),
    ]
}

/// Normal of the cuts, in the cylinder's own coordinates: its axis, unless the planes would then nearly hold the line
/// of sight. Such a plane is too steep for its depth word; it is tilted until the line of sight rises from it by
/// [`LEAST_SINE`], which the balls hide at the ends and nobody sees in the middle.
fn normal(along: [f64; 3], length: f64, to_eye: [f64; 3]) -> [f64; 3] {
    let away = self::length(to_eye);
    let (axis, sight) = (along.map(|v| v / length), to_eye.map(|v| v / away));
    let sine = dot(axis, sight);
    if sine.abs() >= LEAST_SINE {
        return [0.0, 1.0, 0.0];
    }
    let tilt = LEAST_SINE * if sine < 0.0 { -1.25 } else { 1.25 };
    let tilted: [f64; 3] = std::array::from_fn(|k| axis[k] + tilt * sight[k]);
    // Half a turn is its own inverse: it takes the direction back to the y axis.
    let line = turn_line(along, length);
    let share = 2.0 * dot(line, tilted) / dot(line, line);
    std::array::from_fn(|k| short(share * line[k] - tilted[k]) + 0.0)
}

/// The line half way between the y axis and a direction, with six digits after the point.
fn turn_line([x, y, z]: [f64; 3], length: f64) -> [f64; 3] {
    [x, y + length, z].map(|v| (v / length * 1e6).round() / 1e6 + 0.0)
}

/// From the y axis to a direction: half a turn about the line between the two, of which sine and cosine are exact. Its
/// six digits are enough: at the far end of a bond that is a millionth of its length.
fn placed(along: [f64; 3], length: f64, origin: [f64; 3]) -> Vec<Step> {
    let line = turn_line(along, length);
    let translate = Step::Translate(origin.map(|v| v + 0.0));
    if line[0] == 0.0 && line[2] == 0.0 {
        return vec![translate];
    }
    let (axis, degrees) = (Axis::Vector(line), 180.0);
    vec![Step::Rotate(Rotation { axis, degrees }), translate]
}

fn numbered(name: &str, count: usize) -> String {
    format!("{name} ({count})")
}

/// `A/17/CA`: chain, residue number, atom; with the alternate behind it if there is one, the model in front if there
/// are several, and the serial number if another atom has the same.
fn atom_name(names: &mut Names, atom: &Atom, words: &Words, model: Option<i64>) -> String {
    let or_dash = |text: String| match text.is_empty() {
        true => "-".to_owned(),
        false => text,
    };
    let text = |word: Word| or_dash(words.text(word).to_owned());
    let mut name = [atom.chain, atom.number, atom.name].map(text).join("/");
    if !atom.alternate.is_empty() {
        name = format!("{name}.{}", words.text(atom.alternate));
    }
    if let Some(model) = model {
        name = format!("{model}/{name}");
    }
    if names.has(&name) {
        name = format!("{name} #{}", or_dash(atom.serial.text(words)));
    }
    names.unique(name, numbered)
}
