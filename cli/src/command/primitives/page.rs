//! The comparison as tables of Markdown. Nothing here depends on the machine it runs on.

use super::hardware::{Hardware, TARGET};
use imogene_studies::kit::DrawError;
use imogene_studies::kit::page::text;
use imogene_studies::primitives::errors::{Bulge, Errors};
use imogene_studies::primitives::speed::{FacetWork, Speed};
use serde::Serialize;

/// All that is measured; the keys are stable.
#[derive(Serialize)]
pub struct Comparison {
    pub scene: String,
    pub width: u32,
    pub height: u32,
    pub depth_word: u32,
    pub words_per_pixel: f64,
    pub radii_px: Vec<f64>,
    pub variants: Vec<Row>,
    pub speed: Speed,
}

/// One variant; the keys are stable.
#[derive(Serialize)]
pub struct Row {
    pub variant: String,
    /// Sides around of each object that is a mesh.
    pub sides: Vec<Option<usize>>,
    /// Faces of the meshes, those turned away as well.
    pub faces: usize,
    pub errors: Errors,
    /// Of each sphere.
    pub bulges: Vec<Bulge>,
    pub hardware: Hardware,
    /// Of the facets, if there are some.
    pub facet_work: Option<FacetWork>,
}

#[derive(Serialize)]
struct Page<'a> {
    #[serde(flatten)]
    comparison: &'a Comparison,
    target: &'static str,
}

/// The page: what is drawn, then a table for each question.
pub fn markdown(comparison: &Comparison) -> Result<String, DrawError> {
    let page = Page {
        comparison,
        target: TARGET,
    };
    text("cannot tell of it", include_str!("comparison.md"), page)
}

/// The timing, which depends on the machine.
pub fn speed(speed: &Speed) -> String {
    format!(
        "Facets of 20 sides around on one thread: {:.1} million pixels a second by contour following, {:.1} by the model of the facet processor, {:.1} times as many; one facet \
         processor that visits the screen boxes is faster from {:.0} MHz on",
        speed.contour_pixels_per_second / 1e6,
        speed.processor_model_pixels_per_second / 1e6,
        speed.ratio,
        speed.break_even_mhz
    )
}
