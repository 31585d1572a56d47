//! The words of a face list. `docs/cad-faces.md` is its user's page.

use imogene_scene::Material;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// The version this code reads.
pub const FORMAT_VERSION: i64 = 1;

type Name = Spanned<String>;

/// A face list.
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

/// A face.
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
