//! Speed, area and accuracy in one picture: frames per second over area, a staircase for each class of accuracy.

use super::TradeError;
use super::design::Accuracy;
use super::plot::{hardware_title, marked};
use super::report::{Entry, Trade, hardware};
use crate::kit::plot::{Area, FONT, GREY, Outcome, chart, roomy, svg};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::ops::Range;

const SIZE: (u32, u32) = (930, 520);
/// Share of the values that is room around them.
const ROOM: f64 = 0.05;
const TITLE: &str = "The fastest machines of every area and accuracy";
/// Room on the right, for the names of the classes.
const NAMES: i32 = 260;
const LINE: i32 = 16;
const COLOURS: [RGBColor; 5] = [
    RGBColor(20, 60, 140),
    RGBColor(20, 130, 170),
    RGBColor(40, 140, 70),
    RGBColor(215, 140, 20),
    RGBColor(195, 70, 40),
];
const INK: RGBColor = RGBColor(60, 66, 74);
/// Frames per second of a screen.
const SCREEN: f64 = 60.0;

/// A point of the picture: area, and the power of ten of its frames per second.
struct Dot<'a> {
    entry: &'a Entry,
    class: usize,
    place: (f64, f64),
}

/// A class of accuracy: the points on its front, from the smallest on, and what the fastest one draws.
struct Class {
    class: usize,
    front: Vec<(f64, f64)>,
    names: [String; 2],
}

/// Draws the picture as SVG. The mark of a point is a circle with its name as `data-point`: large if no other point of
/// its class or a better one beats it, and then filled if its clock was placed and routed.
pub fn draw(trade: &Trade) -> Result<String, TradeError> {
    let mut dots: Vec<Dot> = trade.points.iter().filter_map(|e| dot(trade, e)).collect();
    // The front is drawn last, on top of the others.
    dots.sort_by_key(|dot| dot.is_on_front());
    let classes = (0..trade.classes.len()).filter_map(|class| Class::of(trade, class));
    let classes: Vec<Class> = classes.collect();
    let draw = |area: &Area| draw_plane(area, trade, &dots, &classes);
    let text = svg("cannot draw a plot", SIZE, draw)?;
    let names = dots.iter().map(|dot| &*dot.entry.point.id);
    Ok(marked(&text, names))
}

fn dot<'a>(trade: &Trade, entry: &'a Entry) -> Option<Dot<'a>> {
    let area = hardware(&entry.point, trade.measure)?;
    Some(Dot {
        entry,
        class: entry.class?,
        place: (area, entry.point.frames_per_second?.log10()),
    })
}

impl Dot<'_> {
    fn is_on_front(&self) -> bool {
        self.entry.pareto.contains(&"speed")
    }

    /// Object processors of a zone machine, pixels per clock of a beam machine.
    fn processors(&self) -> String {
        let design = self.entry.point.design;
        match (design.zones, design.pixels_per_clock) {
            (Some(zones), _) => zones.processors.to_string(),
            (None, 0 | 1) => "beam".into(),
            (None, lanes) => format!("beam {lanes}x"),
        }
    }

    fn circle(&self) -> Circle<(f64, f64), i32> {
        let colour = COLOURS[self.class];
        let (radius, style) = match (self.is_on_front(), self.entry.point.cost) {
            (false, _) => (2, colour.mix(0.35).filled()),
            (true, Some(cost)) if cost.fmax_mhz.is_some() => (5, colour.filled()),
            (true, _) => (4, colour.stroke_width(2)),
        };
        Circle::new(self.place, radius, style)
    }
}

impl Class {
    /// None if a better class has all of its front.
    fn of(trade: &Trade, class: usize) -> Option<Class> {
        let front = trade.speed_front(class);
        let front = front.iter().map(|&index| &trade.points[index]);
        let own = front.clone().filter(|e| e.class == Some(class));
        let speed = |e: &&Entry| e.point.frames_per_second.unwrap_or_default();
        let fastest = own.max_by(|a, b| speed(a).total_cmp(&speed(b)))?;
        let front = front.filter_map(|entry| Some(dot(trade, entry)?.place));
        let mut front: Vec<(f64, f64)> = front.collect();
        front.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        Some(Class {
            class,
            front,
            names: [
                format!("less than {} % off", trade.classes[class]),
                in_words(&fastest.point.design.accuracy),
            ],
        })
    }

    /// The most frames per second of every area, up to the right edge.
    fn staircase(&self, right: f64) -> Vec<(f64, f64)> {
        let mut steps: Vec<(f64, f64)> = vec![];
        for &(x, y) in &self.front {
            steps.extend(steps.last().map(|&(_, before)| (x, before)));
            steps.push((x, y));
        }
        steps.extend(steps.last().map(|&(_, y)| (right, y)));
        steps
    }
}

fn in_words(accuracy: &Accuracy) -> String {
    let pixels = match (accuracy.undersampling, accuracy.supersampling) {
        (1, 1) if accuracy.interlaced => "every other line".into(),
        (1, 1) => "every pixel once".into(),
        (1, side) => format!("{} samples of every pixel", side * side),
        (side, _) => format!("one pixel in {}", side * side),
    };
    match accuracy.tables() {
        None => pixels,
        Some(form) if form.nearest => format!("{pixels}, by nearest entries"),
        Some(_) => format!("{pixels}, by tables"),
    }
}

/// The plane of area and the power of ten of the frames per second.
type Plane<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

fn draw_plane(area: &Area, trade: &Trade, dots: &[Dot], classes: &[Class]) -> Outcome {
    let x = roomy(dots.iter().map(|dot| dot.place.0), ROOM);
    let y = roomy(dots.iter().map(|dot| dot.place.1), ROOM);
    let mut plane = chart(area, 12, (TITLE, 16), [40, 64])
        .margin_right(NAMES)
        .build_cartesian_2d(x.clone(), y.clone())?;
    plane
        .configure_mesh()
        .disable_y_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GREY)
        .x_labels(6)
        .y_labels(0)
        .x_label_formatter(&|v| format!("{v:.0}"))
        .x_desc(hardware_title(trade))
        .y_desc("frames per second")
        .axis_desc_style((FONT, 14))
        .label_style((FONT, 13))
        .draw()?;
    levels(area, &mut plane, &x, &y)?;
    for class in classes {
        let style = COLOURS[class.class].stroke_width(2);
        plane.draw_series(LineSeries::new(class.staircase(x.end), style))?;
    }
    plane.draw_series(dots.iter().map(Dot::circle))?;
    for dot in dots.iter().filter(|dot| dot.is_on_front()) {
        let (x, y) = plane.backend_coord(&dot.place);
        let style = (FONT, 12).into_font().color(&COLOURS[dot.class]);
        area.draw(&Text::new(dot.processors(), (x + 6, y + 6), style))?;
    }
    let ends = classes.iter().filter_map(|class| {
        let &(_, y) = class.front.last()?;
        Some((plane.backend_coord(&(x.end, y)), class))
    });
    name(area, ends.collect())
}

fn levels(area: &Area, plane: &mut Plane, x: &Range<f64>, y: &Range<f64>) -> Outcome {
    let line = |at: f64| vec![(x.start, at), (x.end, at)];
    let right = |vertical| Pos::new(HPos::Right, vertical);
    for decade in y.start.ceil() as i32..=y.end.floor() as i32 {
        plane.draw_series(LineSeries::new(line(decade.into()), GREY))?;
        let (left, height) = plane.backend_coord(&(x.start, decade.into()));
        let style = (FONT, 13).into_font().color(&INK).pos(right(VPos::Center));
        let text = format!("{}", 10f64.powi(decade));
        area.draw(&Text::new(text, (left - 8, height), style))?;
    }
    let screen = SCREEN.log10();
    if y.contains(&screen) {
        let style = INK.mix(0.6).into();
        plane.draw_series(DashedLineSeries::new(line(screen), 4, 4, style))?;
        let style = (FONT, 12).into_font().color(&INK).pos(right(VPos::Bottom));
        plane.draw_series([Text::new("60: a screen", (x.end, screen), style)])?;
    }
    Ok(())
}

/// Writes the names of the classes beside the ends of their staircases, none over another.
fn name(area: &Area, mut ends: Vec<((i32, i32), &Class)>) -> Outcome {
    ends.sort_by_key(|((_, height), _)| *height);
    let mut least = i32::MIN;
    for ((right, height), class) in ends {
        let height = height.max(least);
        least = height + 2 * LINE + 4;
        for (row, text) in class.names.iter().enumerate() {
            let weight = [FontStyle::Bold, FontStyle::Normal][row];
            let style = (FONT, 13, weight).into_font().color(&COLOURS[class.class]);
            let style = style.pos(Pos::new(HPos::Left, VPos::Center));
            let place = (right + 8, height + LINE * row as i32);
            area.draw(&Text::new(text.clone(), place, style))?;
        }
    }
    Ok(())
}
