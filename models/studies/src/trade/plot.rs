//! The fronts as pictures: area against one error.

use super::TradeError;
use super::report::{Entry, Front, Trade, hardware};
use crate::kit::plot::{Area, FONT, Outcome, chart, roomy, svg};
use plotters::prelude::*;

const SIZE: (u32, u32) = (420, 270);
/// Share of the values that is room around them.
const ROOM: f64 = 0.06;
const EXACT: RGBColor = RGBColor(10, 120, 80);
const OTHER: RGBColor = RGBColor(190, 90, 20);
const FRONT: RGBColor = RGBColor(170, 170, 170);
/// Errors below this are drawn as this.
const LEAST: f64 = 1e-6;
const GRID: RGBColor = RGBColor(230, 230, 230);

/// A point of the picture, and its place.
type Dot<'a> = (&'a Entry, (f64, f64));

/// Draws a front as SVG. The mark of a point is a circle with its name as `data-point`: green if silhouette-exact, else
/// orange; filled if on the front. The first circles are the marks, in the order of the points that have both figures.
pub fn draw(trade: &Trade, front: &Front) -> Result<String, TradeError> {
    let dots = trade.points.iter().filter_map(|entry| {
        let point = &entry.point;
        let error = (front.error)(point.errors.as_ref()?);
        // Its power of ten, or for counts the power of two of one more.
        let place = match front.counts {
            true => (1.0 + error).log2(),
            false => error.max(LEAST).log10(),
        };
        Some((entry, (hardware(point, trade.measure)?, place)))
    });
    let dots: Vec<Dot> = dots.collect();
    let draw = |area: &Area| draw_dots(area, trade, front, &dots);
    let text = svg("cannot draw a plot", SIZE, draw)?;
    let names = dots.iter().map(|(entry, _)| &*entry.point.id);
    Ok(marked(&text, names))
}

/// The plot with the names of points at its first circles.
pub(super) fn marked<'a>(text: &str, mut names: impl Iterator<Item = &'a str>) -> String {
    let mut parts = text.split("<circle ");
    let mut marked = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let id = names.next().map(|id| format!("data-point=\"{id}\" "));
        marked += &format!("<circle {}{part}", id.unwrap_or_default());
    }
    marked
}

/// What the hardware is measured by, as an axis says it.
pub(super) fn hardware_title(trade: &Trade) -> String {
    match trade.measure {
        "cells" => format!("logic cells ({})", trade.target),
        _ => "register bits that toggle per pixel".to_owned(),
    }
}

fn label(front: &Front, place: f64) -> String {
    let value = match front.counts {
        true => place.exp2() - 1.0,
        false => 10f64.powf(place),
    };
    match value {
        v if v >= 10.0 || front.counts => format!("{v:.0}"),
        v if v >= 0.01 => format!("{v:.2}"),
        v => format!("{v:.0e}"),
    }
}

fn draw_dots(area: &Area, trade: &Trade, front: &Front, dots: &[Dot]) -> Outcome {
    let x = roomy(dots.iter().map(|(_, at)| at.0), ROOM);
    let y = roomy(dots.iter().map(|(_, at)| at.1), ROOM);
    let mut chart = chart(area, 10, (front.title, 15), [36, 46]).build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .x_labels(5)
        .y_labels(6)
        .x_label_formatter(&|v| format!("{v:.0}"))
        .y_label_formatter(&|v| label(front, *v))
        .x_desc(hardware_title(trade))
        .label_style((FONT, 12))
        .draw()?;
    let is_on = |entry: &Entry| entry.pareto.contains(&front.name);
    let circle = |(entry, at): &Dot| {
        let colour = [OTHER, EXACT][usize::from(entry.silhouette_exact)];
        let (radius, style) = match is_on(entry) {
            true => (5, colour.filled()),
            false => (3, colour.stroke_width(1)),
        };
        Circle::new(*at, radius, style)
    };
    // From the smallest machine on.
    let line = dots.iter().filter(|dot| is_on(dot.0));
    let mut line: Vec<(f64, f64)> = line.map(|dot| dot.1).collect();
    line.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.total_cmp(&a.1)));
    chart.draw_series(LineSeries::new(line, FRONT))?;
    chart.draw_series(dots.iter().map(circle))?;
    Ok(())
}
