//! Two pictures of the evaluation: duplication over the size of a box, operations of an object there and here.

use super::EvaluateError;
use super::duplication::{Edges, formula, touched};
use super::row::Evaluation;
use crate::kit::plot::{Area, COLOURS, GREY, Outcome, chart, series_labels, svg};
use plotters::coord::ranged1d::SegmentValue;
use plotters::prelude::*;

const SIZE: (u32, u32) = (760, 460);
const THERE: RGBColor = RGBColor(150, 160, 172);
const HERE: RGBColor = COLOURS[0];
const WARM: RGBColor = COLOURS[1];
const SIDE: u64 = 32;
/// Box over zone, and the duplication factor as printed (thesis chapter 5).
const PRINTED: [(f64, f64); 2] = [(0.625, 2.641), (1.25, 5.0)];

/// The duplication factor over the size of a box: by the formula, counted in two ways, and printed.
pub fn duplication_plot() -> Result<String, EvaluateError> {
    let what = "the plot of the duplication cannot be made";
    Ok(svg(what, SIZE, draw_duplication)?)
}

fn draw_duplication(area: &Area) -> Outcome {
    let title = ("Zones that a box touches, mean over all places", 20);
    let mut chart = chart(area, 14, title, [44, 58]).build_cartesian_2d(0.0..1.5, 0.0..6.5)?;
    chart
        .configure_mesh()
        .x_desc("side of the box over side of the zone")
        .y_desc("duplication factor")
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY)
        .draw()?;
    let curve = (0..=150).map(|k| f64::from(k) / 100.0);
    let curve = curve.map(|ratio| (ratio, formula(ratio, 1.0)));
    chart
        .draw_series(LineSeries::new(curve, THERE.stroke_width(3)))?
        .label("the source's formula")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 18, y)], THERE.stroke_width(3)));
    for (edges, colour, label) in [
        (Edges::Anywhere, HERE, "counted: edges anywhere"),
        (Edges::OnPixels, WARM, "counted: whole pixels, zones of 32"),
    ] {
        let mean = |size| touched(size, SIDE, edges).mean;
        let sizes = (2..=3 * SIDE / 2).step_by(2);
        let points = sizes.map(|size| (size as f64 / SIDE as f64, mean(size)));
        chart
            .draw_series(points.map(|at| Circle::new(at, 3, colour.filled())))?
            .label(label)
            .legend(move |(x, y)| Circle::new((x + 9, y), 3, colour.filled()));
    }
    chart
        .draw_series(PRINTED.map(|at| Cross::new(at, 7, BLACK.stroke_width(2))))?
        .label("printed")
        .legend(|(x, y)| Cross::new((x + 9, y), 5, BLACK.stroke_width(2)));
    series_labels(&mut chart)
}

/// Kinds of objects, each with the row of what it takes with its matrices.
const OBJECTS: [[&str; 2]; 3] = [
    ["facet", "facet, expressions, with matrices"],
    ["patch", "patch, four planes, with matrices"],
    ["quadric", "quadric, three planes, with matrices"],
];

/// What a bar is of, and its heights: the source's and ours.
type Bar = (String, [f64; 2]);

/// Operations of an object with its matrices, and for its zones: what the source should print, and ours.
pub fn operations_plot(evaluation: &Evaluation) -> Result<String, EvaluateError> {
    let bar = |label: String, group: &str, name: &str| {
        let row = evaluation.row(group, name)?;
        Some((label, [row.reference()?, row.ours]))
    };
    let whole = OBJECTS.map(|[kind, name]| bar(kind.to_owned(), "quadric", name));
    let in_zones = OBJECTS.map(|[kind, _]| {
        let name = format!("{kind} of 20 x 20 in zones of 32, mean");
        bar(format!("{kind}, zones"), "zones", &name)
    });
    let bars: Vec<Bar> = whole.into_iter().chain(in_zones).flatten().collect();
    let what = "the plot of the operations cannot be made";
    Ok(svg(what, SIZE, |area| draw_operations(area, &bars))?)
}

fn draw_operations(area: &Area, bars: &[Bar]) -> Outcome {
    let most = bars.iter().flat_map(|bar| bar.1).fold(1.0, f64::max);
    let mut chart = chart(area, 14, ("Operations to prepare an object", 20), [44, 58])
        .build_cartesian_2d((0..bars.len() - 1).into_segmented(), 0.0..1.35 * most)?;
    let label = |place: &SegmentValue<usize>| match place {
        SegmentValue::CenterOf(at) => bars.get(*at).map_or("", |bar| &bar.0).to_owned(),
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
    let (narrow, wide) = (12, 12 + 34);
    for (kind, name, colour, left, right) in [
        (0, "the source, its sums corrected", THERE, narrow, wide),
        (1, "counted", HERE, wide, narrow),
    ] {
        let rectangles = bars.iter().enumerate().map(|(index, bar)| {
            let (low, high) = (SegmentValue::Exact(index), SegmentValue::Exact(index + 1));
            let mut bar = Rectangle::new([(low, 0.0), (high, bar.1[kind])], colour.filled());
            bar.set_margin(0, 0, left, right);
            bar
        });
        chart
            .draw_series(rectangles)?
            .label(name)
            .legend(move |(x, y)| Rectangle::new([(x, y - 5), (x + 14, y + 5)], colour.filled()));
    }
    series_labels(&mut chart)
}
