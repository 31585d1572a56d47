//! Recall and precision of the crack detector over its minimum distance, as a picture (Claux 2014, section IV.2.2).

use crate::inject::{Score, Sort};
use plotters::coord::Shift;
use plotters::prelude::*;
use thiserror::Error;

const PANEL: (u32, u32) = (430, 360);
const FONT: &str = "sans-serif";
const GREY: RGBColor = RGBColor(225, 225, 225);
const SORTS: [(Sort, &str, RGBColor); 3] = [
    (
        Sort::Points,
        "points within a surface",
        RGBColor(20, 90, 170),
    ),
    (Sort::Lines, "lines across surfaces", RGBColor(200, 80, 20)),
    (Sort::Joints, "joints of two objects", RGBColor(30, 130, 70)),
];

/// A picture that could not be drawn.
#[derive(Debug, Error)]
#[error("the plot of the cracks cannot be drawn: {0}")]
pub struct PlotError(String);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Outcome = Result<(), Box<dyn std::error::Error>>;

/// A title, and a share of the cracks over the minimum distance.
type Panel = (&'static str, fn(&Score) -> f64);

const PANELS: [Panel; 3] = [
    ("recall: found of those made", Score::recall),
    ("recall of the deep ones", Score::deep_recall),
    ("precision: made of those flagged", Score::precision),
];

/// Draws the scores (SVG).
pub fn plot(scores: &[Score]) -> Result<String, PlotError> {
    let mut text = String::new();
    let drawn = draw(scores, &mut text);
    drawn.map_err(|problem| PlotError(problem.to_string()))?;
    Ok(text)
}

fn draw(scores: &[Score], text: &mut String) -> Outcome {
    let size = (PANEL.0 * PANELS.len() as u32, PANEL.1);
    let area = SVGBackend::with_string(text, size).into_drawing_area();
    area.fill(&WHITE)?;
    let parts = area.split_evenly((1, PANELS.len()));
    for (part, panel) in parts.iter().zip(&PANELS) {
        draw_panel(part, panel, scores)?;
    }
    Ok(area.present()?)
}

fn draw_panel(area: &Area, (title, share): &Panel, scores: &[Score]) -> Outcome {
    let distances = || scores.iter().map(|score| score.min_distance);
    let least = distances().fold(f64::INFINITY, f64::min);
    let most = distances().fold(0.0, f64::max);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(title, (FONT, 17))
        .x_label_area_size(40)
        .y_label_area_size(46)
        .build_cartesian_2d((0.8 * least..1.25 * most).log_scale(), 0.0..1.05)?;
    chart
        .configure_mesh()
        .x_desc("minimum distance, scene units")
        .y_labels(6)
        .y_label_formatter(&|share| format!("{:.0} %", 100.0 * share))
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY)
        .draw()?;
    for (sort, label, colour) in SORTS {
        let of_sort = scores.iter().filter(|score| score.sort == sort);
        let points = of_sort.map(|score| (score.min_distance, share(score)));
        let points: Vec<(f64, f64)> = points.collect();
        chart.draw_series(LineSeries::new(points.clone(), colour.stroke_width(2)))?;
        let dot = |at| Circle::new(at, 3, colour.filled());
        let dots = points.into_iter().map(dot);
        chart
            .draw_series(dots)?
            .label(label)
            .legend(move |(x, y)| Circle::new((x + 9, y), 3, colour.filled()));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerLeft)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .label_font((FONT, 13))
        .draw()?;
    Ok(())
}
