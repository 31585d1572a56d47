//! Surfaces from their words.

use super::keys::SurfaceKeys;
use super::source::Source;
use super::surface::{Form, Surface};
use crate::Result;
use toml::Spanned;

/// Surfaces that are named and not drawn: they are no quadrics.
const OTHER_SURFACES: [&str; 6] = [
    "torus",
    "fillet",
    "bspline",
    "extrusion",
    "revolution",
    "other",
];

/// Kinds of surfaces with their keys: a point, a direction if there is one, and sizes.
const KINDS: [(&str, &[&str], &[&str]); 5] = [
    ("plane", &["origin", "normal"], &[]),
    ("cylinder", &["origin", "axis"], &["radius"]),
    ("cone", &["apex", "axis"], &["half_angle"]),
    ("sphere", &["centre"], &["radius"]),
    ("torus", &["centre", "axis"], &["major", "minor"]),
];

/// The surface of a face.
pub fn surface(source: &Source, keys: &Spanned<SurfaceKeys>) -> Result<Surface> {
    let own = keys.as_ref();
    let kind = own.kind.as_ref().as_str();
    let known = KINDS.iter().find(|(name, ..)| *name == kind);
    if known.is_none() && !OTHER_SURFACES.contains(&kind) {
        let others = OTHER_SURFACES.join(", ");
        let problem = format!("`{kind}` is not a kind of surface");
        let accepted = format!(
            "plane, cylinder, cone, sphere, and as names of what is not drawn {others}, are possible"
        );
        return Err(source.error(&own.kind, problem, accepted));
    }
    let (_, vectors, sizes) = *known.unwrap_or(&("", &[], &[]));
    let allowed = [vectors, sizes].concat();
    let given = own.given();
    if let Some(key) = given.iter().find(|key| !allowed.contains(*key)) {
        let accepted = match allowed.join(", ").as_str() {
            "" => "its name alone is possible".to_owned(),
            allowed => format!("it has {allowed}"),
        };
        return Err(source.error(keys, format!("a {kind} has no `{key}`"), accepted));
    }
    // A torus whose numbers are not all given is named only.
    if vectors.is_empty() || (kind == "torus" && given.len() < allowed.len()) {
        return Ok(Surface::other(kind));
    }
    let missing = |key: &str| {
        let problem = format!("a {kind} needs `{key}`");
        source.error(keys, problem, "this key is needed")
    };
    let vector = |key: &str| own.vector(key).ok_or_else(|| missing(key));
    let origin = source.point(vector(vectors[0])?)?;
    let axis = match vectors.get(1) {
        Some(key) => source.direction(vector(key)?)?,
        None => [0.0, 0.0, 1.0],
    };
    let size = |key: &&str| size(source, key, own.number(key).ok_or_else(|| missing(key))?);
    let numbers: Vec<f64> = sizes.iter().map(size).collect::<Result<_>>()?;
    let form = match (kind, &numbers[..]) {
        ("cylinder", [radius]) => Form::Cylinder(*radius),
        ("cone", [angle]) => Form::Cone(*angle),
        ("sphere", [radius]) => Form::Sphere(*radius),
        (_, [major, minor]) => Form::Torus(*major, *minor),
        _ => Form::Plane,
    };
    Ok(Surface::new(origin, axis, form))
}

/// A length above 0, or the angle of a cone in radians.
fn size(source: &Source, key: &str, value: &Spanned<f64>) -> Result<f64> {
    let number = *value.as_ref();
    if key != "half_angle" {
        source.lengths(value, &[number])?;
        return Ok(number);
    }
    if !(0.1..=89.9).contains(&number) {
        let problem = format!("{number} degrees between axis and surface is out of range");
        return Err(source.error(value, problem, "0.1 to 89.9 degrees are possible"));
    }
    Ok(number.to_radians())
}
