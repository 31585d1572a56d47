//! The words of a face list. `docs/cad-faces.md` is its user's page.

use super::vector::{Vector, length, unit};
use imogene_scene::Material;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

pub const FORMAT_VERSION: i64 = 1;

pub type Name = Spanned<String>;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ListKeys {
    pub format: Spanned<i64>,
    pub title: String,
    #[serde(default)]
    pub materials: Vec<Spanned<Material>>,
    #[serde(default)]
    pub vertices: BTreeMap<String, Spanned<[f64; 3]>>,
    #[serde(default)]
    pub edges: Vec<EdgeKeys>,
    #[serde(default)]
    pub faces: Vec<FaceKeys>,
    #[serde(default)]
    pub solids: Vec<SolidKeys>,
}

/// An edge; which keys it has depends on its kind.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EdgeKeys {
    pub name: Name,
    pub kind: Name,
    pub start: Option<Name>,
    pub end: Option<Name>,
    pub centre: Option<Spanned<[f64; 3]>>,
    pub axis: Option<Spanned<[f64; 3]>>,
    pub radius: Option<Spanned<f64>>,
    pub x: Option<Spanned<[f64; 3]>>,
    pub radii: Option<Spanned<[f64; 2]>>,
    pub points: Option<Spanned<Vec<[f64; 3]>>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FaceKeys {
    pub name: Name,
    pub surface: Spanned<SurfaceKeys>,
    #[serde(default)]
    pub loops: Vec<Spanned<Vec<Name>>>,
    #[serde(default)]
    pub reversed: bool,
}

/// A support surface; which keys it has depends on its kind.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SurfaceKeys {
    pub kind: Name,
    pub origin: Option<Spanned<[f64; 3]>>,
    pub normal: Option<Spanned<[f64; 3]>>,
    pub axis: Option<Spanned<[f64; 3]>>,
    pub apex: Option<Spanned<[f64; 3]>>,
    pub centre: Option<Spanned<[f64; 3]>>,
    pub radius: Option<Spanned<f64>>,
    pub half_angle: Option<Spanned<f64>>,
    pub major: Option<Spanned<f64>>,
    pub minor: Option<Spanned<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SolidKeys {
    pub name: Name,
    pub material: Name,
    pub faces: Vec<Name>,
}

impl EdgeKeys {
    /// The keys that depend on the kind, and whether they are given.
    pub fn given(&self) -> [(&'static str, bool); 6] {
        [
            ("centre", self.centre.is_some()),
            ("axis", self.axis.is_some()),
            ("radius", self.radius.is_some()),
            ("x", self.x.is_some()),
            ("radii", self.radii.is_some()),
            ("points", self.points.is_some()),
        ]
    }
}

impl SurfaceKeys {
    fn vectors(&self) -> [(&'static str, Option<&Spanned<[f64; 3]>>); 5] {
        [
            ("origin", self.origin.as_ref()),
            ("normal", self.normal.as_ref()),
            ("axis", self.axis.as_ref()),
            ("apex", self.apex.as_ref()),
            ("centre", self.centre.as_ref()),
        ]
    }

    fn numbers(&self) -> [(&'static str, Option<&Spanned<f64>>); 4] {
        [
            ("radius", self.radius.as_ref()),
            ("half_angle", self.half_angle.as_ref()),
            ("major", self.major.as_ref()),
            ("minor", self.minor.as_ref()),
        ]
    }

    pub fn given(&self) -> Vec<&'static str> {
        let vectors = self.vectors().map(|(key, value)| value.map(|_| key));
        let numbers = self.numbers().map(|(key, value)| value.map(|_| key));
        vectors.into_iter().chain(numbers).flatten().collect()
    }

    pub fn vector(&self, key: &str) -> Option<&Spanned<[f64; 3]>> {
        self.vectors().into_iter().find(|(name, _)| *name == key)?.1
    }

    pub fn number(&self, key: &str) -> Option<&Spanned<f64>> {
        self.numbers().into_iter().find(|(name, _)| *name == key)?.1
    }
}

/// Largest coordinate and radius, scene units: beyond it double precision has no micrometres left in a metre.
pub const MAX_NUMBER: f64 = 1e9;

/// What is wrong with a value of a list, and what would be accepted.
pub type Flaw = Spanned<[String; 2]>;

pub type Checked<T> = Result<T, Flaw>;

pub fn flaw<T>(value: &Spanned<T>, problem: impl ToString, accepted: impl ToString) -> Flaw {
    Flaw::new(value.span(), [problem.to_string(), accepted.to_string()])
}

/// Numbers of a value, which have to be finite and not too large.
pub fn checked<T>(value: &Spanned<T>, numbers: &[f64]) -> Checked<()> {
    let Some(wrong) = numbers.iter().find(|v| v.is_nan() || v.abs() > MAX_NUMBER) else {
        return Ok(());
    };
    let least = -MAX_NUMBER;
    let accepted = format!("finite numbers from {least:e} to {MAX_NUMBER:e} are possible");
    Err(flaw(value, format!("{wrong} is out of range"), accepted))
}

pub fn point(value: &Spanned<Vector>) -> Checked<Vector> {
    checked(value, value.as_ref())?;
    Ok(*value.as_ref())
}

/// A vector of length 1 along a written one.
pub fn direction(value: &Spanned<Vector>) -> Checked<Vector> {
    let vector = point(value)?;
    if length(vector) < 1e-9 {
        let accepted = "a vector with at least one number other than 0 is needed";
        let problem = format!("{vector:?} has no direction");
        return Err(flaw(value, problem, accepted));
    }
    Ok(unit(vector))
}

pub fn lengths<T>(value: &Spanned<T>, lengths: &[f64]) -> Checked<()> {
    for length in lengths {
        checked(value, &[*length])?;
        if *length < 1e-9 {
            let problem = format!("{length} is not above 0");
            return Err(flaw(value, problem, "a length above 0 is needed"));
        }
    }
    Ok(())
}
