//! A sweep as a picture: bound and observed error over the parameter.
//!
//! Axes are drawn in powers of ten on linear ones, so that they can run towards small values and have a place for the
//! value 0.

use super::measure::Figures;
use super::record::{Axis, Notice, Record, SweepResult};
use crate::kit::DrawError;
use crate::kit::plot::{Area, COLOURS, FONT, GREY, Outcome, chart, span, svg};
use plotters::prelude::*;

const PANEL: (u32, u32) = (470, 430);
const FOOT: u32 = 22;
/// Lines of floating point.
const FLOATS: RGBColor = COLOURS[4];

/// One measure over the parameter.
struct Panel {
    title: &'static str,
    bound: fn(&Figures) -> Option<f64>,
    observed: fn(&Figures) -> Option<f64>,
}

const PANELS: [Panel; 3] = [
    Panel {
        title: "depth error (pixels)",
        bound: |f| Some(f.bounds.depth_px),
        observed: |f| Some(f.observed.depth_px),
    },
    Panel {
        title: "silhouette displacement (pixels)",
        bound: |f| Some(f.bounds.silhouette_px),
        observed: |f| f.observed.silhouette_px,
    },
    Panel {
        title: "normal error (degrees)",
        bound: |f| Some(f.bounds.normal_deg),
        observed: |f| Some(f.observed.normal_deg),
    },
];

/// Draws a sweep as SVG.
pub fn plot(result: &SweepResult) -> Result<String, DrawError> {
    let what = format!("the plot of the sweep `{}` cannot be drawn", result.name);
    let title = match result.depth_word {
        Some(word) => format!("{} (depth word of {word} bits)", result.title),
        None => result.title.to_owned(),
    };
    let legend = legend(result);
    let foot = FOOT * legend.len() as u32 + 16;
    let size = (PANEL.0 * PANELS.len() as u32, PANEL.1 + 40 + foot);
    svg(what, size, |area| {
        let area = area.margin(10, 0, 0, 0).titled(&title, (FONT, 22))?;
        let (panels, below) = area.split_vertically(PANEL.1);
        let parts = panels.split_evenly((1, PANELS.len()));
        for (part, panel) in parts.iter().zip(&PANELS) {
            draw_panel(part, panel, result)?;
        }
        draw_legend(&below, &legend)
    })
}

struct Line {
    colour: RGBColor,
    kind: Kind,
    points: Vec<(f64, f64)>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Bound,
    Observed,
    Single,
    Double,
}

impl Axis {
    /// Place of a value; nothing for 0 on a logarithmic axis.
    fn place(&self, value: f64) -> Option<f64> {
        match (self.logarithmic, self.falling) {
            (false, _) => Some(value),
            (true, _) if value <= 0.0 => None,
            (true, false) => Some(value.log10()),
            (true, true) => Some(-value.log10()),
        }
    }
}

/// `10^exponent` for a whole exponent, nothing for another.
fn power_label(exponent: f64) -> String {
    let whole = exponent.round();
    if (exponent - whole).abs() > 1e-6 {
        String::new()
    } else if (-3.0..=3.0).contains(&whole) {
        format!("{}", 10f64.powi(whole as i32))
    } else {
        format!("1e{whole}")
    }
}

/// Places of all steps, with one for the value 0: a decade beyond the last, or before the first.
struct Places {
    axis: Axis,
    low: f64,
    high: f64,
    zero: Option<f64>,
}

impl Places {
    fn of(result: &SweepResult) -> Places {
        let axis = result.axis;
        let placed = result.records.iter().filter_map(|r| axis.place(r.value));
        let span = span(placed);
        let (low, high) = (span.start, span.end);
        let with_zero = axis.logarithmic && result.records.iter().any(|r| r.value == 0.0);
        let zero = with_zero.then_some(if axis.falling { high + 1.0 } else { low - 1.0 });
        Places {
            axis,
            low: zero.map_or(low, |z| z.min(low)),
            high: zero.map_or(high, |z| z.max(high)),
            zero,
        }
    }

    fn at(&self, value: f64) -> f64 {
        let placed = self.axis.place(value).or(self.zero);
        placed.expect("0 has a place where it occurs")
    }

    fn label(&self, place: f64) -> String {
        match self.zero {
            Some(zero) if (place - zero).abs() < 1e-6 => "0".into(),
            _ if !self.axis.logarithmic => format!("{place:.0}"),
            _ => power_label(if self.axis.falling { -place } else { place }),
        }
    }
}

fn lines(result: &SweepResult, panel: &Panel, places: &Places) -> Vec<Line> {
    let mut lines = vec![];
    for (name, colour) in result.series.iter().zip(COLOURS) {
        let records = result.of_series(name);
        let mut add = |kind, measure: &dyn Fn(&Record) -> Option<f64>| {
            let point = |r: &&Record| {
                let value = measure(r).filter(|v| *v > 0.0 && v.is_finite())?;
                Some((places.at(r.value), value.log10()))
            };
            // A refusal, or a value that a logarithm does not show, breaks the line.
            for run in records.split(|r| point(r).is_none()) {
                lines.push(Line {
                    colour,
                    kind,
                    points: run.iter().filter_map(&point).collect(),
                });
            }
        };
        add(Kind::Bound, &|r| (panel.bound)(r.figures.as_ref()?));
        add(Kind::Observed, &|r| (panel.observed)(r.figures.as_ref()?));
        if panel.title.starts_with("depth") {
            add(Kind::Single, &|r| Some(r.naive?.single.depth_px));
            add(Kind::Double, &|r| Some(r.naive?.double.depth_px));
        }
    }
    lines.retain(|line| !line.points.is_empty());
    lines
}

fn draw_panel(area: &Area<'_>, panel: &Panel, result: &SweepResult) -> Outcome {
    let places = Places::of(result);
    let lines = lines(result, panel, &places);
    let heights = span(lines.iter().flat_map(|l| &l.points).map(|p| p.1));
    let (mut low, mut high) = (heights.start.floor(), heights.end.ceil());
    if low > high {
        (low, high) = (-1.0, 0.0);
    }
    if high - low < 1.0 {
        high = low + 1.0;
    }
    // Room for the marks of refusals.
    let top = high + 0.09 * (high - low);
    let margin = 0.03 * (places.high - places.low);
    let (left, right) = (places.low - margin, places.high + margin);
    let mut chart =
        chart(area, 12, (panel.title, 17), [44, 56]).build_cartesian_2d(left..right, low..top)?;
    let decades = |span: f64| span as usize + 2;
    let columns = if result.axis.logarithmic {
        decades(right - left)
    } else {
        10
    };
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY)
        .x_labels(columns)
        .y_labels(decades(top - low).min(14))
        .x_label_formatter(&|place| places.label(*place))
        .y_label_formatter(&|place| power_label(*place))
        .x_desc(result.axis.label)
        .label_style((FONT, 13))
        .axis_desc_style((FONT, 14))
        .draw()?;
    for line in &lines {
        let (colour, points) = (line.colour, || line.points.iter().copied());
        let dashed = |style| DashedLineSeries::new(points(), 4, 3, style);
        match line.kind {
            Kind::Bound => chart.draw_series(LineSeries::new(points(), colour.stroke_width(2)))?,
            Kind::Observed => chart.draw_series(dashed(colour.stroke_width(1)))?,
            Kind::Single | Kind::Double => chart.draw_series(dashed(FLOATS.stroke_width(1)))?,
        };
        let circles = |size, style| points().map(move |p| Circle::new(p, size, style));
        match line.kind {
            Kind::Bound => chart.draw_series(circles(2, colour.filled()))?,
            Kind::Observed => chart.draw_series(circles(4, colour.stroke_width(1)))?,
            Kind::Single => {
                chart.draw_series(points().map(|p| TriangleMarker::new(p, 5, BLACK.filled())))?
            }
            Kind::Double => chart.draw_series(circles(3, BLACK.filled()))?,
        };
    }
    let row = (top - high) / result.series.len() as f64;
    for (index, (name, colour)) in result.series.iter().zip(COLOURS).enumerate() {
        let height = top - row * (index as f64 + 0.5);
        let records = result.of_series(name);
        let noticed = |by| {
            let of = move |r: &&&Record| r.notice().is_some_and(|n| n.0 == by);
            let found = records.iter().filter(of);
            found.map(|r| (places.at(r.value), height))
        };
        let crosses = noticed(Notice::Refused);
        chart.draw_series(crosses.map(|p| Cross::new(p, 4, colour.stroke_width(2))))?;
        let triangles = noticed(Notice::CheckFails);
        chart.draw_series(triangles.map(|p| TriangleMarker::new(p, 5, colour.filled())))?;
    }
    Ok(())
}

/// What stands below the panels: a series in its colour, or what floating point makes.
type Entry = (String, Option<RGBColor>);

fn legend(result: &SweepResult) -> Vec<Entry> {
    let series = result.series.iter().map(|name| (*name).to_owned());
    let mut entries: Vec<Entry> = series.zip(COLOURS.map(Some)).collect();
    if result.records.iter().any(|r| r.naive.is_some()) {
        let floats = "the same in floating point and scene coordinates: f32 triangles, f64 dots";
        entries.push((floats.into(), None));
    }
    entries[0].0 += ": proven bound (line), observed (circles); at the top: refused (crosses), check fails (triangles)";
    entries
}

fn draw_legend(area: &Area, entries: &[Entry]) -> Outcome {
    for ((text, colour), y) in entries.iter().zip((10..).step_by(FOOT as usize)) {
        if let Some(colour) = colour {
            let line = [(30, y), (60, y)];
            area.draw(&PathElement::new(line, colour.stroke_width(2)))?;
            area.draw(&Circle::new((45, y), 2, colour.filled()))?;
            area.draw(&Circle::new((85, y), 4, colour.stroke_width(1)))?;
            area.draw(&Cross::new((105, y), 4, colour.stroke_width(2)))?;
            area.draw(&TriangleMarker::new((123, y), 5, colour.filled()))?;
        } else {
            area.draw(&TriangleMarker::new((55, y), 5, BLACK.filled()))?;
            area.draw(&Circle::new((85, y), 3, BLACK.filled()))?;
        }
        let font = (FONT, 15).into_font().color(&BLACK);
        area.draw(&Text::new(text.as_str(), (140, y - 8), font))?;
    }
    Ok(())
}
