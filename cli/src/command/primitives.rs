//! `imogene primitives`.

mod hardware;

use crate::arguments::Primitives;
use crate::failure::Result;
use crate::output;
use hardware::{Hardware, TARGET};
use imogene_analysis::metrics::PixelError;
use imogene_golden::format::Format;
use imogene_scene::SceneFile;
use imogene_studies::kit::DrawError;
use imogene_studies::kit::page::{text, with};
use imogene_studies::primitives::errors::{Bulge, Errors, bulge, errors, pixel_errors};
use imogene_studies::primitives::speed::{FacetWork, Speed, facets, measure, work};
use imogene_studies::primitives::{Drawn, Subject, Variant, sheet};
use serde::Serialize;
use serde_json::json;
use std::time::Duration;

/// The scene, compiled in so that the command needs no file.
const SCENE: &str = include_str!("../../../scenes/comparison/three-solids.toml");
/// Facets of this variant are timed.
const TIMED: Variant = Variant::Facets(20);
/// For each of the two programs that are timed.
const TIME: Duration = Duration::from_millis(400);

pub fn run(options: &Primitives, json: bool) -> Result {
    let (width, height) = options.size;
    let file = SceneFile::parse(SCENE, "three-solids.toml")?;
    let format = Format::BASE;
    let subject = Subject::new(&file, (width, height), format)?;
    let bar = output::progress(Variant::ALL.len() as u64, "variants");
    let mut drawn: Vec<(Drawn, Vec<PixelError>)> = vec![];
    for variant in Variant::ALL {
        let one = subject.draw(variant)?;
        let pixels = pixel_errors(&subject, &one.frame);
        drawn.push((one, pixels));
        bar.inc(1);
    }
    bar.finish_and_clear();
    let rows = drawn.iter();
    let rows = rows.map(|(one, pixels)| row(&subject, one, pixels, &format));
    let timed = drawn.iter().find(|(one, _)| one.variant == TIMED);
    let (timed, _) = timed.expect("a variant of the comparison");
    let comparison = Comparison {
        scene: subject.framed.title.clone(),
        width,
        height,
        depth_word: format.depth,
        words_per_pixel: subject.truth.words_per_pixel,
        radii_px: subject.radii.clone(),
        variants: rows.collect::<Result<_, _>>()?,
        speed: measure(&facets(&timed.slots), &format, TIME),
    };
    let text = markdown(&comparison)?;
    if let Some(folder) = &options.out {
        let panels = drawn.iter().map(|(one, pixels)| (one, pixels.as_slice()));
        let panels: Vec<(&Drawn, &[PixelError])> = panels.collect();
        let sheet = sheet(&panels, subject.truth.words_per_pixel);
        let figures = output::json_text(&comparison) + "\n";
        let mut files = output::files();
        let (path, size) = (folder.join("comparison.png"), [sheet.width, sheet.height]);
        output::add_picture(&mut files, &path, size, &sheet.rgb)?;
        files.add_text(&folder.join("comparison.json"), &figures)?;
        files.add_text(&folder.join("comparison.md"), &text)?;
        files.finish()?;
    }
    output::report(json, &comparison, |comparison| {
        output::text(text.trim_end());
        output::text(format!("\n{}", told(&comparison.speed)));
    });
    Ok(())
}

fn row(subject: &Subject, drawn: &Drawn, pixels: &[PixelError], format: &Format) -> Result<Row> {
    let screen = u64::from(subject.framed.width) * u64::from(subject.framed.height);
    let facets = facets(&drawn.slots);
    let objects = 0..subject.radii.len();
    Ok(Row {
        variant: drawn.variant.name(),
        sides: drawn.sides.clone(),
        faces: drawn.faces,
        errors: errors(subject, pixels),
        bulges: objects.filter_map(|o| bulge(subject, pixels, o)).collect(),
        hardware: hardware::of(&drawn.slots, screen)?,
        facet_work: (!facets.is_empty()).then(|| work(&facets, format, screen)),
    })
}

/// All that is measured; the keys are stable.
#[derive(Serialize)]
struct Comparison {
    scene: String,
    width: u32,
    height: u32,
    depth_word: u32,
    words_per_pixel: f64,
    radii_px: Vec<f64>,
    variants: Vec<Row>,
    speed: Speed,
}

/// One variant; the keys are stable.
#[derive(Serialize)]
struct Row {
    variant: String,
    /// Sides around of each object that is a mesh.
    sides: Vec<Option<usize>>,
    /// Faces of the meshes, those turned away as well.
    faces: usize,
    errors: Errors,
    /// Of each sphere.
    bulges: Vec<Bulge>,
    hardware: Hardware,
    /// Of the facets, if there are some.
    facet_work: Option<FacetWork>,
}

/// The page: what is drawn, then a table for each question.
fn markdown(comparison: &Comparison) -> Result<String, DrawError> {
    let template = include_str!("primitives/comparison.md");
    let values = with(comparison, json!({ "target": TARGET }));
    text("cannot tell of it", template, values)
}

/// The timing, which depends on the machine.
fn told(speed: &Speed) -> String {
    format!(
        "Facets of 20 sides around on one thread: {:.1} million pixels a second by contour following, {:.1} by the model of the facet processor, {:.1} times as many; one facet \
         processor that visits the screen boxes is faster from {:.0} MHz on",
        speed.contour_pixels_per_second / 1e6,
        speed.processor_model_pixels_per_second / 1e6,
        speed.ratio,
        speed.break_even_mhz
    )
}
