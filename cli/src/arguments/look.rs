//! Another look at a scene, without editing it.

use super::parse::{self, Choices, choice};
use clap::Args;
use imogene_scene::{Look, Side};

/// Options of another look at a scene.
#[derive(Clone, Debug, Default, Args)]
pub struct LookOptions {
    /// Look from this side: the eye goes there about the target, as far away as it is.
    #[arg(long = "view", value_parser = choice(SIDES), value_name = "SIDE")]
    side: Option<Side>,
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
#[rustfmt::skip]
const SIDES: Choices<Side> = &[
    (Side::Front, "front", "From +z where y is up, from -y where z is up"),
    (Side::Back, "back", "From behind"),
    (Side::Left, "left", "From the left of the front"),
    (Side::Right, "right", "From the right of the front"),
    (Side::Top, "top", "From above, the front at the bottom of the picture"),
    (Side::Bottom, "bottom", "From below, the front at the top of the picture"),
    (Side::Iso, "iso", "From the front, the right and above, at equal angles"),
];

impl LookOptions {
    /// What is asked for; nothing for the scene as it is. `lights` says whether they turn with the camera.
    pub fn look(&self, lights: bool) -> Option<Look> {
        let look = Look {
            side: self.side,
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
    match parse::list::<f64>(text).as_deref() {
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
