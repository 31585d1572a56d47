//! Two pictures of the evaluation: duplication over the size of a box, operations of an object there and here.

use super::duplication::{Edges, formula, touched};
use super::{EvaluateError, Evaluation};
use plotters::coord::ranged1d::SegmentValue;
use plotters::prelude::*;

const SIZE: (u32, u32) = (760, 460);
const FONT: &str = "sans-serif";
const GREY: RGBColor = RGBColor(225, 225, 225);
const THERE: RGBColor = RGBColor(150, 160, 172);
const HERE: RGBColor = RGBColor(20, 90, 170);
const WARM: RGBColor = RGBColor(200, 80, 20);
/// Side of the zones that are counted.
const SIDE: u64 = 32;
/// Box over zone, and the duplication factor as printed (thesis chapter 5).
const PRINTED: [(f64, f64); 2] = [(0.625, 2.641), (1.25, 5.0)];

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn drawn(
    what: &'static str,
    draw: impl FnOnce(&mut String) -> Outcome,
) -> Result<String, EvaluateError> {
    let mut text = String::new();
    draw(&mut text).map_err(|problem| EvaluateError::Draw {
        what,
        problem: problem.to_string(),
    })?;
    Ok(text)
}

/// The duplication factor over the size of a box: the formula, rectangles counted, whole pixels counted, and what is printed.
///
/// # Errors
///
/// When the plotting library fails.
pub fn duplication_plot() -> Result<String, EvaluateError> {
    drawn("the plot of the duplication", draw_duplication)
}

fn draw_duplication(text: &mut String) -> Outcome {
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(14)
        .caption("Zones that a box touches, mean over all places", (FONT, 20))
        .x_label_area_size(44)
        .y_label_area_size(58)
        .build_cartesian_2d(0.0..1.5, 0.0..6.5)?;
    chart
        .configure_mesh()
        .x_desc("side of the box over side of the zone")
        .y_desc("duplication factor")
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY)
        .draw()?;
    let curve = (0..=150).map(|k| f64::from(k) / 100.0);
    chart
        .draw_series(LineSeries::new(
            curve.map(|ratio| (ratio, formula(ratio, 1.0))),
            THERE.stroke_width(3),
        ))?
        .label("the source's formula")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], THERE.stroke_width(3)));
    for (edges, colour, label) in [
        (Edges::Anywhere, HERE, "counted: edges anywhere"),
        (Edges::OnPixels, WARM, "counted: whole pixels, zones of 32"),
    ] {
        let points = (2..=3 * SIDE / 2).step_by(2).map(move |size| {
            let mean = touched(size, SIDE, edges).mean;
            (size as f64 / SIDE as f64, mean)
        });
        chart
            .draw_series(points.map(|at| Circle::new(at, 3, colour.filled())))?
            .label(label)
            .legend(move |(x, y)| Circle::new((x + 9, y), 3, colour.filled()));
    }
    chart
        .draw_series(PRINTED.map(|at| Cross::new(at, 7, BLACK.stroke_width(2))))?
        .label("printed")
        .legend(|(x, y)| Cross::new((x + 9, y), 5, BLACK.stroke_width(2)));
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .label_font((FONT, 14))
        .draw()?;
    area.present()?;
    drop(chart);
    drop(area);
    Ok(())
}

/// Rows of the second picture.
const OBJECTS: [(&str, &str, &str); 6] = [
    ("quadric", "facet, expressions, with matrices", "facet"),
    ("quadric", "patch, four planes, with matrices", "patch"),
    ("quadric", "quadric, three planes, with matrices", "quadric"),
    (
        "zones",
        "facet of 20 x 20 in zones of 32, mean",
        "facet, zones",
    ),
    (
        "zones",
        "patch of 20 x 20 in zones of 32, mean",
        "patch, zones",
    ),
    (
        "zones",
        "quadric of 20 x 20 in zones of 32, mean",
        "quadric, zones",
    ),
];

/// Operations of an object with its matrices, and for its zones: what the source should print, and ours.
///
/// # Errors
///
/// When the plotting library fails.
pub fn operations_plot(evaluation: &Evaluation) -> Result<String, EvaluateError> {
    let bars: Vec<(&str, f64, f64)> = OBJECTS
        .iter()
        .filter_map(|&(group, name, label)| {
            let row = evaluation.row(group, name)?;
            Some((label, row.reference()?, row.ours))
        })
        .collect();
    drawn("the plot of the operations", |text| {
        draw_operations(text, &bars)
    })
}

fn draw_operations(text: &mut String, bars: &[(&str, f64, f64)]) -> Outcome {
    let most = bars.iter().map(|bar| bar.1.max(bar.2)).fold(1.0, f64::max);
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(14)
        .caption("Operations to prepare an object", (FONT, 20))
        .x_label_area_size(44)
        .y_label_area_size(58)
        .build_cartesian_2d((0..bars.len() - 1).into_segmented(), 0.0..1.35 * most)?;
    let label = |place: &SegmentValue<usize>| match place {
        SegmentValue::CenterOf(index) => bars.get(*index).map_or("", |bar| bar.0).to_owned(),
        _ => String::new(),
    };
    chart
        .configure_mesh()
        .disable_x_mesh()
        .x_label_formatter(&label)
        .y_desc("operations, the source's weights")
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY)
        .draw()?;
    type Value = fn(&(&str, f64, f64)) -> f64;
    let kinds: [(&str, RGBColor, u32, Value); 2] = [
        ("the source, its sums corrected", THERE, 0, |bar| bar.1),
        ("counted", HERE, 1, |bar| bar.2),
    ];
    for (name, colour, side, value) in kinds {
        let width = 34;
        let rectangles = bars.iter().enumerate().map(|(index, bar)| {
            let (low, high) = (SegmentValue::Exact(index), SegmentValue::Exact(index + 1));
            let mut bar = Rectangle::new([(low, 0.0), (high, value(bar))], colour.filled());
            let (left, right) = if side == 0 {
                (12, 12 + width)
            } else {
                (12 + width, 12)
            };
            bar.set_margin(0, 0, left, right);
            bar
        });
        chart
            .draw_series(rectangles)?
            .label(name)
            .legend(move |(x, y)| Rectangle::new([(x, y - 5), (x + 14, y + 5)], colour.filled()));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .label_font((FONT, 14))
        .draw()?;
    area.present()?;
    drop(chart);
    drop(area);
    Ok(())
}
