//! The comparison as tables of Markdown. Nothing here depends on the machine it runs on.

use super::hardware::{Hardware, TARGET};
use crate::output::joined;
use imogene_files::text::wrapped;
use imogene_studies::primitives::errors::{Bulge, Errors};
use imogene_studies::primitives::speed::{FacetWork, Speed};
use serde::Serialize;
use std::fmt::Write;

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

/// What the source states of a sphere by a paraboloid: percent of the radius, then degrees.
const STATED: [f64; 5] = [29.45, -4.50, 5.08, 1.6, 16.4];

/// The page: what is drawn, then a table for each question.
pub fn markdown(comparison: &Comparison) -> String {
    let radii = comparison.radii_px.iter().map(|r| format!("{r:.1}"));
    let drawn = format!(
        "{}, {} x {}, depth word {}, {:.1} depth words to the pixel; radii {} pixels.",
        comparison.scene,
        comparison.width,
        comparison.height,
        comparison.depth_word,
        comparison.words_per_pixel,
        joined(radii, ", ")
    );
    let mut text = wrapped(&drawn, "") + "\n\n";
    text += "| drawn as | sides around | presence differs | object differs | depth max px | depth rms px | depth max words | depth rms words | normal mean | normal max |\n";
    text += "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for row in &comparison.variants {
        let e = &row.errors;
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {:.2}° | {:.2}° |",
            label(row),
            sides(row),
            e.presence_differs,
            e.object_differs,
            small(e.depth_max_px),
            small(e.depth_rms_px),
            words(e.depth_max_words),
            words(e.depth_rms_words),
            e.normal_mean_deg,
            e.normal_max_deg
        );
    }
    text += &format!(
        "\n| drawn as | processors | PE1 | PE2 | roots | multipliers | LUT4 | flip-flops | logic cells | DSP | clocks of a frame | one processor after the other | over their boxes alone |\n{}\n",
        "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
    );
    for row in &comparison.variants {
        let h = &row.hardware;
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            label(row),
            kinds(row),
            h.census.pe1,
            h.census.pe2,
            h.census.roots,
            h.census.multipliers,
            figure(h.lut),
            figure(h.ff),
            figure(h.cells),
            figure(h.dsp),
            h.frame_clocks,
            h.one_by_one_clocks,
            h.one_by_one_box_clocks
        );
    }
    let _ = writeln!(
        text,
        "\nFigures of {TARGET} from `docs/resources.json`; a dash where a processor is not in it.\n"
    );
    paraboloids(comparison, &mut text);
    facet_work(comparison, &mut text);
    text
}

fn paraboloids(comparison: &Comparison, text: &mut String) {
    *text += "| sphere | radius px | bulges too much, most | least | rms | normal mean | normal max |\n|---|---:|---:|---:|---:|---:|---:|\n";
    let line = |name: &str, radius: String, [most, least, rms, mean, max]: [f64; 5]| {
        format!(
            "| {name} | {radius} | {most:+.2} % R | {least:+.2} % R | {rms:.2} % R | {mean:.1}° | {max:.1}° |\n"
        )
    };
    *text += &line("paraboloid, the source", "-".into(), STATED);
    for row in &comparison.variants {
        for b in &row.bulges {
            let figures = [
                b.most_percent,
                b.least_percent,
                b.rms_percent,
                b.normal_mean_deg,
                b.normal_max_deg,
            ];
            *text += &line(&label(row), format!("{:.1}", b.radius_px), figures);
        }
    }
}

fn facet_work(comparison: &Comparison, text: &mut String) {
    *text += "\n| drawn as | facets | pixels | lines | additions to the pixel | additions to the line | tests to the pixel | multiplications | divisions | additions in all | of the processors over their boxes | over the screen |\n";
    *text += "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for row in &comparison.variants {
        let Some(work) = &row.facet_work else {
            continue;
        };
        let c = &work.contour;
        let to = |sum: u64, count: u64| sum as f64 / count.max(1) as f64;
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {:.1} | {:.1} | {:.1} | {} | {} | {} | {} | {} |",
            label(row),
            c.facets,
            c.pixels,
            c.lines,
            to(c.pixel_additions, c.pixels),
            to(c.line_additions, c.lines),
            to(c.tests, c.pixels),
            c.multiplications,
            c.divisions,
            c.pixel_additions + c.line_additions,
            work.processor_box_additions,
            work.processor_screen_additions
        );
    }
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

fn label(row: &Row) -> String {
    match row.variant.strip_prefix("facets_") {
        Some("fair") => "facets, within half a pixel".into(),
        Some(sides) => format!("{sides} facets"),
        None => row.variant.clone(),
    }
}

fn sides(row: &Row) -> String {
    match joined(row.sides.iter().flatten(), ", ") {
        none if none.is_empty() => "-".into(),
        all => all,
    }
}

fn kinds(row: &Row) -> String {
    let kinds = row.hardware.kinds.iter();
    let kinds = kinds.map(|(kind, number)| format!("{number} {}", kind.replace("_processor", "")));
    let all = joined(kinds, "; ");
    match row.hardware.kinds.len() {
        1 => all,
        _ => format!("{}: {all}", row.hardware.processors),
    }
}

fn figure(value: Option<u64>) -> String {
    value.map_or("-".into(), |v| v.to_string())
}

/// Pixels: three digits after the point, or the power of ten where they would all be zero.
fn small(v: f64) -> String {
    if v == 0.0 || v >= 0.001 {
        format!("{v:.3}")
    } else {
        format!("{v:.1e}")
    }
}

/// Depth words: whole, with a digit after the point where they are few.
fn words(v: f64) -> String {
    if v < 100.0 {
        format!("{v:.2}")
    } else {
        format!("{v:.0}")
    }
}
