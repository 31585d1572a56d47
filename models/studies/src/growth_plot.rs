//! Clocks of a frame over the size of the zones, as a picture.

use imogene_plan::zone::growth::Growth;
use plotters::prelude::*;
use thiserror::Error;

const SIZE: (u32, u32) = (760, 520);
const FONT: &str = "sans-serif";
const GREY: RGBColor = RGBColor(225, 225, 225);
const COLOURS: [RGBColor; 5] = [
    RGBColor(20, 90, 170),
    RGBColor(200, 80, 20),
    RGBColor(30, 130, 70),
    RGBColor(130, 60, 150),
    RGBColor(90, 90, 90),
];

/// A picture that could not be drawn.
#[derive(Debug, Error)]
#[error("the plot of the clocks cannot be drawn: {0}")]
pub struct GrowthPlotError(String);

/// Draws rows as SVG: a curve for each number of object processors, both axes in powers of two.
///
/// # Errors
///
/// When the plotting library fails.
pub fn plot(title: &str, rows: &[Growth]) -> Result<String, GrowthPlotError> {
    draw(title, rows).map_err(|problem| GrowthPlotError(problem.to_string()))
}

fn draw(title: &str, rows: &[Growth]) -> Result<String, Box<dyn std::error::Error>> {
    let side = |row: &Growth| f64::from(row.side).log2();
    let clocks = |row: &Growth| (row.clocks.total as f64).log2();
    let range = |of: &dyn Fn(&Growth) -> f64, margin: f64| {
        let values = rows.iter().map(of);
        let least = values.clone().fold(f64::INFINITY, f64::min);
        let most = values.fold(f64::NEG_INFINITY, f64::max);
        least - margin..most + margin
    };
    let mut counts: Vec<usize> = rows.iter().map(|row| row.object_processors).collect();
    counts.sort_unstable();
    counts.dedup();
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&area)
            .margin(14)
            .caption(title, (FONT, 20))
            .x_label_area_size(44)
            .y_label_area_size(84)
            .build_cartesian_2d(range(&side, 0.2), range(&clocks, 0.3))?;
        let power = |value: &f64| format!("{:.0}", value.exp2());
        chart
            .configure_mesh()
            .x_desc("side of a zone (pixels)")
            .y_desc("clocks of a frame")
            .x_label_formatter(&power)
            .y_label_formatter(&power)
            .x_labels(6)
            .light_line_style(TRANSPARENT)
            .bold_line_style(GREY)
            .draw()?;
        for (place, &count) in counts.iter().enumerate() {
            let colour = COLOURS[place % COLOURS.len()];
            let curve: Vec<(f64, f64)> = rows
                .iter()
                .filter(|row| row.object_processors == count)
                .map(|row| (side(row), clocks(row)))
                .collect();
            let dots = curve.clone().into_iter();
            chart
                .draw_series(LineSeries::new(curve, colour.stroke_width(2)))?
                .label(format!("K = {count}"))
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2))
                });
            chart.draw_series(dots.map(|at| Circle::new(at, 3, colour.filled())))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .label_font((FONT, 14))
            .draw()?;
        area.present()?;
    }
    Ok(text)
}
