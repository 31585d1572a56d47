//! Plots as SVG, in one look.

use super::DrawError;
use plotters::coord::Shift;
use plotters::coord::ranged1d::Ranged;
use plotters::prelude::*;
use std::ops::Range;

/// The font of all plots.
pub const FONT: &str = "sans-serif";
/// Lines of the mesh.
pub const GREY: RGBColor = RGBColor(225, 225, 225);
/// Colours of curves.
pub const COLOURS: [RGBColor; 5] = [
    RGBColor(20, 90, 170),
    RGBColor(200, 80, 20),
    RGBColor(30, 130, 70),
    RGBColor(130, 60, 150),
    RGBColor(90, 90, 90),
];

/// Whether something was drawn.
pub type Outcome = Result<(), Box<dyn std::error::Error>>;
/// What is drawn on.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A white picture that is drawn on; `what` begins the message if it cannot be.
pub fn svg(
    what: impl Into<String>,
    size: (u32, u32),
    draw: impl FnOnce(&Area) -> Outcome,
) -> Result<String, DrawError> {
    let mut text = String::new();
    let on_white = |area: Area| {
        area.fill(&WHITE)?;
        draw(&area)?;
        Ok(area.present()?)
    };
    let drawn: Outcome = on_white(SVGBackend::with_string(&mut text, size).into_drawing_area());
    drawn.map_err(|problem| DrawError(what.into(), problem.to_string()))?;
    Ok(text)
}

/// A chart on an area: its margin, its title and the height of that, and the room of the labels at the axes.
pub fn chart<'a, 'b>(
    area: &'a Area<'b>,
    margin: u32,
    (title, height): (&str, u32),
    [x, y]: [u32; 2],
) -> ChartBuilder<'a, 'b, SVGBackend<'b>> {
    let mut chart = ChartBuilder::on(area);
    chart.margin(margin).caption(title, (FONT, height));
    chart.x_label_area_size(x).y_label_area_size(y);
    chart
}

/// The names of the series, in the upper left corner.
pub fn series_labels<'a, 'b: 'a, X: Ranged, Y: Ranged>(
    chart: &mut ChartContext<'a, SVGBackend<'b>, Cartesian2d<X, Y>>,
) -> Outcome {
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .label_font((FONT, 14))
        .draw()?;
    Ok(())
}

/// From the least to the greatest value.
pub fn span(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    least..values.fold(f64::NEG_INFINITY, f64::max)
}

/// The same with a little room around them: a share of what is between; from 0 to 1 if there is none.
pub fn roomy(values: impl Iterator<Item = f64> + Clone, share: f64) -> Range<f64> {
    let span = span(values);
    if span.is_empty() && span.start.is_infinite() {
        return 0.0..1.0;
    }
    let room = share * (span.end - span.start).max(0.5);
    span.start - room..span.end + room
}
