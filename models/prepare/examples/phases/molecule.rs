//! Scenes of as many atoms as are asked for, as an imported protein has them: space-filling, or balls and sticks.

use imogene_scene::{
    Axis, Camera, Cut, Light, Material, Object, Rotation, SceneFile, Shape, Step, Surface,
};

/// Distance of two neighbours on the lattice that the atoms lie about, in angstroms: a protein without hydrogen.
const SPACING: f64 = 2.57;
/// Radii of carbon, nitrogen, oxygen and sulphur in angstroms.
const RADII: [f64; 4] = [1.7, 1.55, 1.52, 1.8];
/// Radius of a ball over that of the atom, and of a stick.
const BALL: f64 = 0.25;
const STICK: f64 = 0.15;

/// Places and elements of atoms in a globule.
struct Globule {
    places: Vec<[f64; 3]>,
    radius: f64,
}

impl Globule {
    fn of(atoms: usize) -> Globule {
        let radius = SPACING * (0.75 * atoms as f64 / std::f64::consts::PI).cbrt();
        let steps = (radius / SPACING) as i64 + 2;
        let mut state = 1u64;
        // Thousandths between -0.6 and 0.6.
        let mut jitter = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            ((state >> 40) % 1201) as f64 / 1e3 - 0.6
        };
        let mut places = vec![];
        let all = -steps..=steps;
        for (i, j, k) in all.clone().flat_map(|i| {
            let all = all.clone();
            all.clone()
                .flat_map(move |j| all.clone().map(move |k| (i, j, k)))
        }) {
            let place = [i, j, k].map(|n| ((n as f64 * SPACING + jitter()) * 1e3).round() / 1e3);
            if place.iter().map(|v| v * v).sum::<f64>() <= radius * radius {
                places.push(place);
            }
        }
        places.truncate(atoms);
        Globule { places, radius }
    }

    fn camera(&self, towards: [f64; 3]) -> Camera {
        let length = towards.iter().map(|v| v * v).sum::<f64>().sqrt();
        let radius = (self.radius + 2.0).ceil();
        let eye = towards.map(|v| (v / length * 6.0 * radius * 1e4).round() / 1e4);
        Camera::perspective(
            [eye, [0.0; 3], [0.0, 1.0, 0.0]],
            6.0 * radius,
            2.05 * radius,
        )
    }
}

/// A globule of about so many atoms, seen from a direction; with `sticks` as balls and sticks, three halves of a stick
/// to a ball.
pub fn scene(atoms: usize, sticks: bool, towards: [f64; 3]) -> SceneFile {
    let globule = Globule::of(atoms);
    let mut scene = SceneFile::new("globule", globule.camera(towards));
    scene.background = [1.0; 3];
    let light = Light::directional([0.4, 0.5, 1.0], 0.8);
    scene.lights.push(light);
    scene.materials = ["C", "N", "O", "S"].map(material).into();
    for (k, &place) in globule.places.iter().enumerate() {
        let radius = RADII[k % 4] * if sticks { BALL } else { 1.0 };
        let radius = (radius * 1e4).round() / 1e4;
        let step = vec![Step::Translate(place)];
        let name = format!("{} {k}", ["C", "N", "O", "S"][k % 4]);
        scene
            .objects
            .push(object(name, Shape::Sphere { radius }, k % 4, step, vec![]));
    }
    if sticks {
        for (k, pair) in globule.places.windows(2).enumerate() {
            scene.objects.extend(stick(k, pair[0], pair[1]));
        }
    }
    scene
}

/// One stick, or two halves that meet in a plane.
fn stick(k: usize, from: [f64; 3], to: [f64; 3]) -> Vec<Object> {
    let along: [f64; 3] = std::array::from_fn(|axis| to[axis] - from[axis]);
    let length = along.iter().map(|v| v * v).sum::<f64>().sqrt();
    if length > 2.0 * SPACING {
        return vec![];
    }
    let [x, y, z] = along.map(|v| v / length);
    let line = [x, y + 1.0, z].map(|v| (v * 1e6).round() / 1e6);
    let place = vec![
        Step::Rotate(Rotation {
            axis: Axis::Vector(line),
            degrees: 180.0,
        }),
        Step::Translate(from),
    ];
    let cut = |y: f64, side: f64| Cut {
        point: [0.0, (y * 1e4).round() / 1e4, 0.0],
        normal: [0.0, side, 0.0],
    };
    let piece = |name: String, from: f64, to: f64, material: usize| {
        let shape = Shape::EllipticCylinder([STICK; 2]);
        object(
            name,
            shape,
            material,
            place.clone(),
            vec![cut(from, -1.0), cut(to, 1.0)],
        )
    };
    if k.is_multiple_of(2) {
        return vec![piece(format!("stick {k}"), 0.0, length, k % 4)];
    }
    vec![
        piece(format!("half {k}"), 0.0, 0.5 * length, k % 4),
        piece(format!("other half {k}"), 0.5 * length, length, (k + 1) % 4),
    ]
}

fn material(name: &str) -> Material {
    Material {
        name: name.into(),
        colour: [0.6, 0.7, 0.5],
        ambient: 0.4,
        diffuse: 0.7,
        specular: 0.35,
        exponent: 40,
        opacity: 1.0,
    }
}

fn object(name: String, shape: Shape, material: usize, place: Vec<Step>, cuts: Vec<Cut>) -> Object {
    Object {
        name,
        shape,
        processor: None,
        mode: Surface::Solid,
        material: ["C", "N", "O", "S"][material].to_owned(),
        place,
        cuts,
        casts_shadow: true,
        group: None,
        visible: true,
    }
}
