//! Clocks of a frame over the size of the zones, as a picture.

use crate::kit::DrawError;
use crate::kit::plot::{Area, COLOURS, GREY, Outcome, chart, series_labels, span, svg};
use imogene_plan::zone::growth::Growth;
use plotters::prelude::*;
use std::collections::BTreeSet;
use std::ops::Range;

/// Draws rows as SVG: a curve for each number of object processors, both axes in powers of two.
pub fn plot(title: &str, rows: &[Growth]) -> Result<String, DrawError> {
    let what = "the plot of the clocks cannot be drawn";
    svg(what, (760, 520), |area| draw(area, title, rows))
}

fn draw(area: &Area, title: &str, rows: &[Growth]) -> Outcome {
    let side = |row: &Growth| f64::from(row.side).log2();
    let clocks = |row: &Growth| (row.clocks.total as f64).log2();
    let wider = |range: Range<f64>, margin: f64| range.start - margin..range.end + margin;
    let counts: BTreeSet<usize> = rows.iter().map(|row| row.object_processors).collect();
    let mut chart = chart(area, 14, (title, 20), [44, 84]).build_cartesian_2d(
        wider(span(rows.iter().map(side)), 0.2),
        wider(span(rows.iter().map(clocks)), 0.3),
    )?;
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
    for (count, colour) in counts.into_iter().zip(COLOURS.into_iter().cycle()) {
        let own = rows.iter().filter(|row| row.object_processors == count);
        let curve: Vec<(f64, f64)> = own.map(|row| (side(row), clocks(row))).collect();
        let dots = curve.clone().into_iter();
        chart
            .draw_series(LineSeries::new(curve, colour.stroke_width(2)))?
            .label(format!("K = {count}"))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
        chart.draw_series(dots.map(|at| Circle::new(at, 3, colour.filled())))?;
    }
    series_labels(&mut chart)
}
