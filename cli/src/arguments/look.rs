//! Another look at a scene, without editing it.

use super::parse;
use clap::{Args, ValueEnum};
use imogene_scene::{Look, Side};

/// Options of another look at a scene.
#[derive(Clone, Debug, Default, Args)]
pub struct LookOptions {
    /// Look from this side: the eye goes there about the target, as far away as it is.
    #[arg(long = "view", value_enum, value_name = "SIDE")]
    side: Option<SideName>,
    /// Turn what is seen, by degrees about the picture's directions to the right, upwards and, if a third angle is
    /// given, towards the viewer, in this order.
    #[arg(long, value_name = "AX,AY[,AZ]", value_parser = angles, allow_hyphen_values = true)]
    rotate: Option<[f64; 3]>,
    /// Move the eye, without turning it, until all visible objects fill the picture up to 4 %.
    #[arg(long)]
    fit: bool,
    /// Show everything so many times larger.
    #[arg(long, value_name = "FACTOR", value_parser = factor)]
    zoom: Option<f64>,
}

/// Sides; which axis is up is taken from the camera's `up`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SideName {
    /// From +z where y is up, from -y where z is up.
    Front,
    /// From behind.
    Back,
    /// From the left of the front.
    Left,
    /// From the right of the front.
    Right,
    /// From above, the front at the bottom of the picture.
    Top,
    /// From below, the front at the top of the picture.
    Bottom,
    /// From the front, the right and above, at equal angles.
    Iso,
}

impl LookOptions {
    /// What is asked for; nothing for the scene as it is. `lights` says whether they turn with the camera.
    pub fn look(&self, lights: bool) -> Option<Look> {
        let side = self.side.map(|side| match side {
            SideName::Front => Side::Front,
            SideName::Back => Side::Back,
            SideName::Left => Side::Left,
            SideName::Right => Side::Right,
            SideName::Top => Side::Top,
            SideName::Bottom => Side::Bottom,
            SideName::Iso => Side::Iso,
        });
        let look = Look {
            side,
            turn: self.rotate,
            fit: self.fit,
            zoom: self.zoom,
            lights,
        };
        let plain = Look {
            lights,
            ..Look::default()
        };
        (look != plain).then_some(look)
    }
}

fn angles(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse().ok())
        .collect();
    match numbers.as_deref() {
        Some(&[x, y]) => Ok([x, y, 0.0]),
        Some(&[x, y, z]) => Ok([x, y, z]),
        _ => Err("two or three angles in degrees such as 20,-35 are expected".to_owned()),
    }
    .and_then(|angles| match angles.iter().all(|v| v.abs() <= 1e6) {
        true => Ok(angles),
        false => Err("angles up to 1000000 degrees are accepted".to_owned()),
    })
}

fn factor(text: &str) -> Result<f64, String> {
    let expected = "a factor from 0.001 to 1000 is expected";
    parse::value(text, |value| (1e-3..=1e3).contains(value), expected)
}
