//! The picture of the root networks over the rows of a stage.

use super::rows::{DEVICES, ROOTS, ROWS_PER_STAGE, Section};
use super::{Measured, Table};
use crate::error::SynthError;
use crate::target::Target;
use imogene_contract::Unit;
use plotters::coord::Shift;
use plotters::prelude::*;

const SIZE: (u32, u32) = (960, 720);
const FONT: &str = "sans-serif";

/// A measure of a row.
type Measure = fn(&Measured) -> Option<f64>;

/// The measures that are shown over the rows of a stage, with their titles.
const PANELS: [(&str, Measure); 4] = [
    ("area (logic cells)", |row| Some(row.figures.cells? as f64)),
    ("Fmax (MHz)", |row| row.figures.fmax_mhz),
    ("latency (clocks)", |row| Some(row.latency as f64)),
    ("latency (ns) = clocks / Fmax", |row| {
        Some(row.latency as f64 * 1000.0 / row.figures.fmax_mhz?)
    }),
];

impl Table {
    /// The networks over their rows per stage as an SVG picture; `None` without a clock of each. Fails when it cannot
    /// be drawn.
    pub fn picture(&self) -> Result<Option<String>, SynthError> {
        let lines = |(_, measure)| lines(self, measure);
        let panels: Option<Vec<_>> = PANELS.into_iter().map(lines).collect();
        let Some(panels) = panels else {
            return Ok(None);
        };
        let mut text = String::new();
        let drawn = draw_panels(&mut text, &panels);
        drawn.map_err(|error| SynthError::Picture(error.to_string()))?;
        Ok(Some(text))
    }
}

type Drawn = Result<(), Box<dyn std::error::Error>>;

fn draw_panels(text: &mut String, panels: &[Vec<Line>]) -> Drawn {
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let parts = area.split_evenly((2, 2));
    let panels = PANELS.iter().zip(panels).enumerate();
    for (part, (index, ((title, _), lines))) in parts.iter().zip(panels) {
        draw_panel(part, title, lines, index == 0)?;
    }
    Ok(area.present()?)
}

/// A network on a device: its measures, in the order of the rows per stage.
struct Line {
    root: Unit,
    target: Target,
    values: Vec<f64>,
}

fn lines(table: &Table, measure: Measure) -> Option<Vec<Line>> {
    let line = |(root, target): (Unit, Target)| {
        let value = |rows: &usize| {
            let mut found = table.section(Section::Rows, target);
            let is_meant = |row: &&Measured| {
                row.unit == root.name() && row.parameters["rows-per-stage"] == *rows
            };
            measure(found.find(is_meant)?)
        };
        let values = ROWS_PER_STAGE.iter().map(value).collect::<Option<_>>()?;
        Some(Line {
            root,
            target,
            values,
        })
    };
    let pairs = DEVICES.map(|target| ROOTS.map(|root| (root, target)));
    pairs.into_iter().flatten().map(line).collect()
}

impl Line {
    fn label(&self) -> String {
        let network = match self.root {
            Unit::SquareRootNonRestoring => "non-restoring",
            _ => "restoring",
        };
        format!("{network}, {}", self.target.name())
    }

    fn colour(&self) -> RGBColor {
        match self.target {
            Target::Ice40Hx8k => RGBColor(200, 80, 20),
            _ => RGBColor(20, 90, 170),
        }
    }

    /// The restoring network has filled marks, the other open ones.
    fn mark(&self) -> ShapeStyle {
        match self.root {
            Unit::SquareRootNonRestoring => self.colour().stroke_width(2),
            _ => self.colour().filled(),
        }
    }
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn draw_panel(area: &Area<'_>, title: &str, lines: &[Line], is_first: bool) -> Drawn {
    let values = lines.iter().flat_map(|line| &line.values);
    let top = values.copied().fold(0.0, f64::max) * 1.1;
    let last = ROWS_PER_STAGE.len() as i32 - 1;
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(title, (FONT, 18))
        .x_label_area_size(40)
        .y_label_area_size(50)
        .build_cartesian_2d(0..last, 0.0..top)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(225, 225, 225))
        .x_labels(ROWS_PER_STAGE.len())
        .x_label_formatter(&|place| rows_at(*place))
        .y_label_formatter(&|value| format!("{value:.0}"))
        .x_desc("rows per stage")
        .label_style((FONT, 14))
        .draw()?;
    for line in lines {
        let points: Vec<(i32, f64)> = (0..).zip(line.values.iter().copied()).collect();
        let mark = line.mark();
        chart.draw_series(LineSeries::new(
            points.iter().copied(),
            line.colour().stroke_width(1),
        ))?;
        chart
            .draw_series(points.iter().map(|&point| Circle::new(point, 4, mark)))?
            .label(line.label())
            .legend(move |(x, y)| Circle::new((x + 8, y), 4, mark));
    }
    if is_first {
        // Below the areas, which do not come near 0.
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerLeft)
            .background_style(WHITE)
            .label_font((FONT, 13))
            .draw()?;
    }
    Ok(())
}

/// The rows per stage at a place of the axis, whose marks lie side by side: 24 would be far away from the others.
fn rows_at(place: i32) -> String {
    let place = usize::try_from(place).unwrap_or(usize::MAX);
    let rows = ROWS_PER_STAGE.get(place);
    rows.map_or_else(String::new, ToString::to_string)
}
