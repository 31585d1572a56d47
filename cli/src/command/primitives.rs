//! `imogene primitives`.

mod hardware;
mod page;

use crate::arguments::Primitives;
use crate::failure::Failure;
use crate::output;
use imogene_analysis::metrics::PixelError;
use imogene_golden::format::Format;
use imogene_scene::SceneFile;
use imogene_studies::picture;
use imogene_studies::primitives::errors::{bulge, errors, pixel_errors};
use imogene_studies::primitives::sheet::sheet;
use imogene_studies::primitives::speed::{Speed, facets, measure, work};
use imogene_studies::primitives::{Drawn, Subject, Variant};
use page::{Comparison, Row};
use std::path::Path;
use std::time::Duration;

/// The scene, compiled in so that the command needs no file.
const SCENE: &str = include_str!("../../../scenes/comparison/three-solids.toml");
/// Facets of this variant are timed.
const TIMED: Variant = Variant::Facets(20);
/// For each of the two programs that are timed.
const TIME: Duration = Duration::from_millis(400);

/// Draws the scene in every way, measures, and writes the page, the picture and the figures if there is a folder for
/// them.
pub fn run(options: &Primitives, json: bool) -> Result<(), Failure> {
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
    let variants: Result<Vec<Row>, Failure> = drawn
        .iter()
        .map(|(one, pixels)| row(&subject, one, pixels, &format))
        .collect();
    let comparison = Comparison {
        scene: subject.framed.title.clone(),
        width,
        height,
        depth_word: format.depth,
        words_per_pixel: subject.truth.words_per_pixel,
        radii_px: subject.radii.clone(),
        variants: variants?,
        speed: speed(&drawn, &format),
    };
    let text = page::markdown(&comparison)?;
    if let Some(folder) = &options.out {
        write(folder, &comparison, &text, &subject, &drawn)?;
    }
    output::report(json, &comparison, |comparison| {
        output::text(text.trim_end());
        output::text(format!("\n{}", page::speed(&comparison.speed)));
    });
    Ok(())
}

fn row(
    subject: &Subject,
    drawn: &Drawn,
    pixels: &[PixelError],
    format: &Format,
) -> Result<Row, Failure> {
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

fn speed(drawn: &[(Drawn, Vec<PixelError>)], format: &Format) -> Speed {
    let timed = drawn.iter().find(|(one, _)| one.variant == TIMED);
    let (one, _) = timed.expect("a variant of the comparison");
    measure(&facets(&one.slots), format, TIME)
}

fn write(
    folder: &Path,
    comparison: &Comparison,
    text: &str,
    subject: &Subject,
    drawn: &[(Drawn, Vec<PixelError>)],
) -> Result<(), Failure> {
    let panels: Vec<(&Drawn, &[PixelError])> = drawn
        .iter()
        .map(|(one, pixels)| (one, pixels.as_slice()))
        .collect();
    let sheet = sheet(&panels, subject.truth.words_per_pixel);
    let figures = output::json_text(comparison) + "\n";
    let mut files = output::files();
    files.add(&folder.join("comparison.png"), |out| {
        picture::png(out, sheet.width, sheet.height, &sheet.rgb)
    })?;
    files.add_text(&folder.join("comparison.json"), &figures)?;
    files.add_text(&folder.join("comparison.md"), text)?;
    files.finish()?;
    Ok(())
}
