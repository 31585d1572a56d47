//! The words of a face list. `docs/cad-faces.md` is its user's page.

use imogene_scene::Material;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// The version this code reads.
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

/// A solid: named faces of one material.
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

    /// The keys that are given.
    pub fn given(&self) -> Vec<&'static str> {
        let vectors = self.vectors().map(|(key, value)| value.map(|_| key));
        let numbers = self.numbers().map(|(key, value)| value.map(|_| key));
        vectors.into_iter().chain(numbers).flatten().collect()
    }

    /// A point or direction by its key.
    pub fn vector(&self, key: &str) -> Option<&Spanned<[f64; 3]>> {
        self.vectors().into_iter().find(|(name, _)| *name == key)?.1
    }

    /// A number by its key.
    pub fn number(&self, key: &str) -> Option<&Spanned<f64>> {
        self.numbers().into_iter().find(|(name, _)| *name == key)?.1
    }
}
