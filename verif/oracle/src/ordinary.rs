//! Ordinary scenes at random: one to six finite objects of every family, seen from 6 to 12 units away in both
//! projections. In some one of them is of glass, in others two or three balls of glass, each in the next, are among
//! them: of these the order is that of their size.
//!
//! A scene is the text of a scene file, which can be kept. The same seed gives the same text on every computer.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// The text of the scene with this number in the sequence of a seed.
pub fn scene_text(seed: u64, number: u64) -> String {
    let author = |stream| {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(stream);
        Author { random }
    };
    // Another sequence makes the glass, so that the rest is that of a scene without.
    let glass = author(number | 1 << 63).glass();
    author(number).scene(seed, number, &glass)
}

enum Glass {
    None,
    /// The first object.
    First,
    /// Objects besides.
    Balls(String),
}

/// Families that are bounded by two planes across their axis, as many numbers as each takes for its radii.
const ROUND_AN_AXIS: [(&str, usize); 6] = [
    ("cone", 3),
    ("elliptic_cylinder", 2),
    ("hyperboloid_one_sheet", 3),
    ("hyperboloid_two_sheets", 3),
    ("elliptic_paraboloid", 3),
    ("cone", 3),
];
/// Families that need planes to all sides.
const ENDLESS: [(&str, usize); 4] = [
    ("hyperbolic_paraboloid", 3),
    ("hyperbolic_cylinder", 2),
    ("parabolic_cylinder", 2),
    ("quadric", 0),
];

const GLASS: &str =
    "\n[[materials]]\nname = \"glass\"\ncolour = [0.4, 0.8, 0.9]\nopacity = 0.35\nexponent = 60\n";

struct Author {
    random: ChaCha8Rng,
}

impl Author {
    fn scene(&mut self, seed: u64, number: u64, glass: &Glass) -> String {
        let objects = self.random.random_range(1..=6);
        let mut text = format!(
            "format = 1\ntitle = \"ordinary scene {number} of seed {seed}\"\nimage = {{ width = 64, height = 48 }}\n"
        );
        text += &self.camera();
        text += "\n[[lights]]\nkind = \"directional\"\nfrom = [-3, 5, 7]\n";
        text += "\n[[materials]]\nname = \"clay\"\ncolour = [0.8, 0.5, 0.3]\n";
        if !matches!(glass, Glass::None) {
            text += GLASS;
        }
        for index in 0..objects {
            let is_glass = index == 0 && matches!(glass, Glass::First);
            text += &self.object(index, if is_glass { "glass" } else { "clay" });
        }
        if let Glass::Balls(balls) = glass {
            text += balls;
        }
        text
    }

    fn glass(&mut self) -> Glass {
        match self.random.random_range(0..6) {
            0 => Glass::First,
            1 => Glass::Balls(self.balls()),
            _ => Glass::None,
        }
    }

    /// Balls of glass about one point, the smallest or the greatest first.
    fn balls(&mut self) -> String {
        let (at, mut radius) = (self.vector(1.0), self.between(0.8, 1.5));
        let mut balls = vec![];
        for index in 0..self.random.random_range(2..=3) {
            balls.push(format!(
                "\n[[objects]]\nname = \"g{index}\"\nkind = \"sphere\"\nradius = {radius}\nmaterial = \"glass\"\nplace = [{{ translate = {at:?} }}]\n"
            ));
            radius = rounded(radius * self.between(0.4, 0.9));
        }
        if self.one_in(2) {
            balls.reverse();
        }
        balls.concat()
    }

    fn camera(&mut self) -> String {
        let target = self.vector(0.4);
        let distance = self.between(6.0, 12.0);
        let (turn, up) = (self.between(0.0, TAU), self.between(-0.8, 0.8));
        let level = f64::sqrt(1.0 - up * up);
        let towards = [level * turn.cos(), up, level * turn.sin()];
        let eye = [0, 1, 2].map(|k| rounded(target[k] + distance * towards[k]));
        let height = self.between(2.0, 6.0);
        let lens = match self.random.random_range(0..3) {
            0 => format!("field_of_view = {}", self.between(20.0, 50.0)),
            1 => format!("focal = {}", self.between(35.0, 80.0)),
            _ => format!("view_height = {height}"),
        };
        let seen = if self.one_in(2) {
            format!("kind = \"perspective\"\nviewer_distance = {distance}\n{lens}")
        } else {
            let depth = self.between(3.0, 8.0);
            format!("kind = \"orthographic\"\nhalf_depth = {depth}\nview_height = {height}")
        };
        format!("\n[camera]\neye = {eye:?}\ntarget = {target:?}\n{seen}\n")
    }

    fn object(&mut self, index: usize, material: &str) -> String {
        let sort = self.random.random_range(0..8);
        let (shape, mut cuts) = match sort {
            0 | 1 => (self.closed(), vec![]),
            2..=4 => self.round_an_axis(),
            5 | 6 => self.endless(),
            _ => ("kind = \"polyhedron\"".to_owned(), self.walls()),
        };
        if self.one_in(3) {
            let (point, normal) = (self.vector(0.3), self.vector(1.0));
            cuts.push(cut(point, normal));
        }
        let mode = match (sort, self.one_in(2)) {
            (7, _) => "",
            (_, true) => "mode = \"solid\"\n",
            _ if self.one_in(3) => "mode = \"patch\"\nprocessor = \"patch\"\n",
            _ => "mode = \"patch\"\n",
        };
        let place = self.place();
        format!(
            "\n[[objects]]\nname = \"o{index}\"\n{shape}\n{mode}material = \"{material}\"\nplace = [{place}]\ncuts = [{}]\n",
            cuts.join(", ")
        )
    }

    fn closed(&mut self) -> String {
        if self.one_in(2) {
            return format!("kind = \"sphere\"\nradius = {}", self.size());
        }
        format!("kind = \"ellipsoid\"\nradii = {:?}", self.sizes(3))
    }

    fn round_an_axis(&mut self) -> (String, Vec<String>) {
        let (kind, count) = ROUND_AN_AXIS[self.random.random_range(0..ROUND_AN_AXIS.len())];
        let shape = format!("kind = \"{kind}\"\nradii = {:?}", self.sizes(count));
        let (from, to) = (-self.size(), self.size());
        let from = match kind {
            "cone" if self.one_in(2) => 0.0,
            "elliptic_paraboloid" => 0.0,
            _ => from,
        };
        let cuts = [(to, 1.0), (from, -1.0)];
        let cuts = cuts.map(|(y, side)| cut([0.0, y, 0.0], [0.0, side, 0.0]));
        (shape, cuts.to_vec())
    }

    fn endless(&mut self) -> (String, Vec<String>) {
        let (kind, count) = ENDLESS[self.random.random_range(0..ENDLESS.len())];
        let parameters = match count {
            0 => {
                let factors = [(); 10].map(|()| self.between(-1.0, 1.0));
                format!("coefficients = {factors:?}")
            }
            n => format!("radii = {:?}", self.sizes(n)),
        };
        (format!("kind = \"{kind}\"\n{parameters}"), self.walls())
    }

    /// A box of planes.
    fn walls(&mut self) -> Vec<String> {
        let reach = [self.size(), self.size(), self.size()];
        let wall = |axis: usize, side: f64| {
            let at = |length: f64| std::array::from_fn(|k| if k == axis { length } else { 0.0 });
            cut(at(side * reach[axis]), at(side))
        };
        let both = |axis| [wall(axis, 1.0), wall(axis, -1.0)];
        (0..3).flat_map(both).collect()
    }

    fn place(&mut self) -> String {
        let mut steps = vec![];
        if self.one_in(4) {
            let factors = [(); 3].map(|()| self.between(0.6, 1.5));
            steps.push(format!("{{ scale = {factors:?} }}"));
        }
        for _ in 0..self.random.random_range(0..=2) {
            let degrees = if self.one_in(2) {
                f64::from(30 * self.random.random_range(0i32..12))
            } else {
                self.between(-180.0, 180.0)
            };
            let axis = ["\"x\"", "\"y\"", "\"z\"", "[1, 1, 0.5]"][self.random.random_range(0..4)];
            steps.push(format!(
                "{{ rotate = {{ axis = {axis}, degrees = {degrees} }} }}"
            ));
        }
        steps.push(format!("{{ translate = {:?} }}", self.vector(1.5)));
        steps.join(", ")
    }

    /// Half of 0.1 to 3.
    fn size(&mut self) -> f64 {
        self.between(0.05, 1.5)
    }

    fn sizes(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.size()).collect()
    }

    fn vector(&mut self, reach: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.between(-reach, reach))
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        rounded(self.random.random_range(low..high))
    }

    fn one_in(&mut self, count: u32) -> bool {
        self.random.random_range(0..count) == 0
    }
}

fn rounded(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

fn cut(point: [f64; 3], normal: [f64; 3]) -> String {
    format!("{{ point = {point:?}, normal = {normal:?} }}")
}
