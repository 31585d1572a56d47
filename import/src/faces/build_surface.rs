//! Surfaces from their words.

use super::build::Source;
use super::keys::SurfaceKeys;
use super::surface::Surface;
use super::vector::{Vector, unit};
use crate::ImportError;
use toml::Spanned;

/// Surfaces that are named and not drawn: they are no quadrics.
pub const OTHER_SURFACES: [&str; 6] = [
    "torus",
    "fillet",
    "bspline",
    "extrusion",
    "revolution",
    "other",
];

/// The surface of a face.
pub fn surface(source: &Source, keys: &Spanned<SurfaceKeys>) -> Result<Surface, ImportError> {
    let k = keys.as_ref();
    let kind = k.kind.as_ref().as_str();
    let fields = Fields { source, keys };
    let allowed: &[&str] = match kind {
        "plane" => &["origin", "normal"],
        "cylinder" => &["origin", "axis", "radius"],
        "cone" => &["apex", "axis", "half_angle"],
        "sphere" => &["centre", "radius"],
        "torus" => &["centre", "axis", "major", "minor"],
        other if OTHER_SURFACES.contains(&other) => &[],
        other => {
            return Err(source.error(
                k.kind.span(),
                format!("`{other}` is not a kind of surface"),
                format!(
                    "plane, cylinder, cone, sphere, and as names of what is not drawn {}, are possible",
                    OTHER_SURFACES.join(", ")
                ),
            ));
        }
    };
    fields.refuse_others(allowed)?;
    Ok(match kind {
        "plane" => Surface::Plane {
            origin: fields.point("origin", &k.origin)?,
            normal: fields.direction("normal", &k.normal)?,
        },
        "cylinder" => Surface::Cylinder {
            origin: fields.point("origin", &k.origin)?,
            axis: fields.direction("axis", &k.axis)?,
            radius: fields.length("radius", &k.radius)?,
        },
        "cone" => Surface::Cone {
            apex: fields.point("apex", &k.apex)?,
            axis: fields.direction("axis", &k.axis)?,
            half_angle: fields.half_angle()?,
        },
        "sphere" => Surface::Sphere {
            centre: fields.point("centre", &k.centre)?,
            radius: fields.length("radius", &k.radius)?,
        },
        // A torus whose numbers are not all given is named only.
        "torus"
            if [
                k.major.is_some(),
                k.minor.is_some(),
                k.centre.is_some(),
                k.axis.is_some(),
            ] == [true; 4] =>
        {
            Surface::Torus {
                centre: fields.point("centre", &k.centre)?,
                axis: fields.direction("axis", &k.axis)?,
                major: fields.length("major", &k.major)?,
                minor: fields.length("minor", &k.minor)?,
            }
        }
        other => Surface::Other(other.to_owned()),
    })
}

struct Fields<'a> {
    source: &'a Source<'a>,
    keys: &'a Spanned<SurfaceKeys>,
}

impl Fields<'_> {
    fn refuse_others(&self, allowed: &[&str]) -> Result<(), ImportError> {
        let k = self.keys.as_ref();
        let given = [
            ("origin", k.origin.is_some()),
            ("normal", k.normal.is_some()),
            ("axis", k.axis.is_some()),
            ("apex", k.apex.is_some()),
            ("centre", k.centre.is_some()),
            ("radius", k.radius.is_some()),
            ("half_angle", k.half_angle.is_some()),
            ("major", k.major.is_some()),
            ("minor", k.minor.is_some()),
        ];
        match given.iter().find(|(key, is)| *is && !allowed.contains(key)) {
            None => Ok(()),
            Some((key, _)) => Err(self.source.error(
                self.keys.span(),
                format!("a {} has no `{key}`", k.kind.as_ref()),
                if allowed.is_empty() {
                    "its name alone is possible".to_owned()
                } else {
                    format!("it has {}", allowed.join(", "))
                },
            )),
        }
    }

    fn missing(&self, key: &str) -> ImportError {
        self.source.error(
            self.keys.span(),
            format!("a {} needs `{key}`", self.keys.as_ref().kind.as_ref()),
            "this key is needed",
        )
    }

    fn point(&self, key: &str, value: &Option<Spanned<[f64; 3]>>) -> Result<Vector, ImportError> {
        let value = value.as_ref().ok_or_else(|| self.missing(key))?;
        self.source.check(value.span(), value.as_ref())?;
        Ok(*value.as_ref())
    }

    fn direction(
        &self,
        key: &str,
        value: &Option<Spanned<[f64; 3]>>,
    ) -> Result<Vector, ImportError> {
        let value = value.as_ref().ok_or_else(|| self.missing(key))?;
        direction(self.source, value)
    }

    fn length(&self, key: &str, value: &Option<Spanned<f64>>) -> Result<f64, ImportError> {
        let value = value.as_ref().ok_or_else(|| self.missing(key))?;
        positive(self.source, value)
    }

    fn half_angle(&self) -> Result<f64, ImportError> {
        let value = self.keys.as_ref().half_angle.as_ref();
        let value = value.ok_or_else(|| self.missing("half_angle"))?;
        let degrees = *value.as_ref();
        if !(0.1..=89.9).contains(&degrees) {
            return Err(self.source.error(
                value.span(),
                format!("{degrees} degrees between axis and surface is out of range"),
                "0.1 to 89.9 degrees are possible",
            ));
        }
        Ok(degrees.to_radians())
    }
}

/// A vector of length 1 along a written one.
pub fn direction(source: &Source, value: &Spanned<[f64; 3]>) -> Result<Vector, ImportError> {
    source.check(value.span(), value.as_ref())?;
    let vector = *value.as_ref();
    if super::vector::length(vector) < 1e-9 {
        return Err(source.error(
            value.span(),
            format!("{vector:?} has no direction"),
            "a vector with at least one number other than 0 is needed",
        ));
    }
    Ok(unit(vector))
}

/// A length above 0.
pub fn positive(source: &Source, value: &Spanned<f64>) -> Result<f64, ImportError> {
    source.check(value.span(), &[*value.as_ref()])?;
    if *value.as_ref() < 1e-9 {
        return Err(source.error(
            value.span(),
            format!("{} is not above 0", value.as_ref()),
            "a length above 0 is needed",
        ));
    }
    Ok(*value.as_ref())
}
