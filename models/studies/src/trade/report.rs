//! The results of a run: what stands in `trade.json` and `trade.csv`.

use super::point::Point;
use imogene_analysis::metrics::{Metrics, Spread};
use serde::Serialize;
use serde_json::Value;

/// All points; the keys are stable.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Trade {
    /// Version of the program.
    pub version: String,
    /// The scene as the commands name it.
    pub scene: String,
    /// Its title.
    pub title: String,
    /// Pixels per line.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Device of the costs.
    pub target: String,
    /// File of the true picture.
    pub truth: String,
    /// Colours of the error maps: what they mean, and red, green, blue.
    pub legend: Vec<(&'static str, [u8; 3])>,
    /// What the hardware is measured by in the fronts: `cells`, or `toggles` if no point has a cost.
    pub measure: &'static str,
    /// How far estimated clocks are from those that were placed and routed; none without such.
    pub clock_error: Option<EstimateError>,
    /// How far estimated logic cells are from those that were synthesised; none without such.
    pub area_error: Option<EstimateError>,
    /// Classes of accuracy, the best first: least picture errors that are not of them, in percent of the whole scale.
    pub classes: Vec<f64>,
    /// The points in the order of the design space.
    pub points: Vec<Entry>,
}

/// Estimates against what is known.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EstimateError {
    /// Points of which both are there.
    pub points: usize,
    /// Greatest difference, in percent of what is known.
    pub max_percent: f64,
    /// Root of the mean square of the differences.
    pub rms_percent: f64,
}

/// A point, and on which fronts it is.
#[derive(Clone, Debug, Serialize)]
pub struct Entry {
    /// The point.
    #[serde(flatten)]
    pub point: Point,
    /// True if the picture has no silhouette error.
    pub silhouette_exact: bool,
    /// Class of the accuracy of its picture; none beyond the last one.
    pub class: Option<usize>,
    /// Fronts on which no other point is as good in both and better in one: `depth`, `silhouette`, `colour`; and
    /// `speed` for area and frames per second among the points of no worse class.
    pub pareto: Vec<&'static str>,
}

/// An error that is traded for area.
#[derive(Clone, Copy, Debug)]
pub struct Front {
    /// Its name.
    pub name: &'static str,
    /// What it measures.
    pub title: &'static str,
    /// The error of a point.
    pub error: fn(&Metrics) -> f64,
    /// Whether values are whole numbers with a meaning of zero, rather than magnitudes.
    pub counts: bool,
}

/// The three fronts.
pub const FRONTS: [Front; 3] = [
    Front {
        name: "depth",
        title: "greatest depth error (px)",
        error: |e| e.depth_px.max,
        counts: false,
    },
    Front {
        name: "silhouette",
        title: "silhouette errors (pixels)",
        error: |e| e.silhouette as f64,
        counts: true,
    },
    Front {
        name: "colour",
        title: "99.9 % colour error (1/255)",
        error: |e| e.colour.quantile_999,
        counts: true,
    },
];

/// What the hardware of a point is measured by.
pub(super) fn hardware(point: &Point, measure: &str) -> Option<f64> {
    match measure {
        "cells" => point.cost.map(|cost| cost.cells as f64),
        _ => point.toggles.as_ref().map(|toggles| toggles.total),
    }
}

/// The points with their fronts, in place of those of `empty`.
pub(super) fn assemble(empty: Trade, points: Vec<Point>) -> Trade {
    let measure = match points.iter().any(|p| p.cost.is_some()) {
        true => "cells",
        false => "toggles",
    };
    let fronts = FRONTS.map(|front| {
        let place = |p: &Point| Some((hardware(p, measure)?, (front.error)(p.errors.as_ref()?)));
        let places: Vec<Option<(f64, f64)>> = points.iter().map(place).collect();
        (front.name, undominated(&places))
    });
    let entry = |(index, point): (usize, Point)| {
        let on = fronts.iter().filter(|(_, front)| front[index]);
        Entry {
            silhouette_exact: point.errors.as_ref().is_some_and(|e| e.silhouette == 0),
            class: class_of(&point),
            pareto: on.map(|(name, _)| *name).collect(),
            point,
        }
    };
    let clocks = |point: &Point| Some((point.mhz_estimated?, point.cost?.fmax_mhz?));
    let areas = |point: &Point| {
        let [estimated, known] = [point.cost_estimated?, point.cost_synthesised?];
        Some((estimated.cells as f64, known.cells as f64))
    };
    let mut trade = Trade {
        measure,
        clock_error: EstimateError::of(points.iter().map(clocks)),
        area_error: EstimateError::of(points.iter().map(areas)),
        classes: CLASSES.to_vec(),
        points: points.into_iter().enumerate().map(entry).collect(),
        ..empty
    };
    for class in 0..CLASSES.len() {
        for index in trade.speed_front(class) {
            let entry = &mut trade.points[index];
            if entry.class == Some(class) {
                entry.pareto.push("speed");
            }
        }
    }
    trade
}

/// Least picture errors that are not of a class, in percent of the whole scale; what is farther off is of none.
const CLASSES: [f64; 5] = [0.5, 2.0, 4.0, 8.0, 16.0];

fn class_of(point: &Point) -> Option<usize> {
    let error = point.picture_error?;
    CLASSES.iter().position(|limit| error < *limit)
}

impl EstimateError {
    /// Of pairs of an estimate and what is known.
    pub fn of(pairs: impl Iterator<Item = Option<(f64, f64)>>) -> Option<EstimateError> {
        let percent = |(estimated, known): (f64, f64)| 100.0 * (estimated - known).abs() / known;
        let all = Spread::of(pairs.flatten().map(percent).collect());
        (all.count > 0).then_some(EstimateError {
            points: all.count,
            max_percent: all.max,
            rms_percent: all.rms,
        })
    }
}

/// The places that no other one beats: as good in both, and better in one. Equal places are all on the front.
pub fn undominated(places: &[Option<(f64, f64)>]) -> Vec<bool> {
    let beaten = |a: (f64, f64)| {
        let better = |b: &(f64, f64)| b.0 <= a.0 && b.1 <= a.1 && *b != a;
        places.iter().flatten().any(better)
    };
    let is_on = |place: &Option<(f64, f64)>| place.is_some_and(|place| !beaten(place));
    places.iter().map(is_on).collect()
}

/// Columns of the table, each with the place of its figure in the JSON of a point where that is another.
const COLUMNS: &str = "
    id unit depth=design/accuracy/depth root=format/root plane=format/plane
    normal=design/accuracy/normal g1=design/accuracy/guard_linear
    g2=design/accuracy/guard_quadratic dropped=design/accuracy/dropped_rows root_form=design/accuracy/root_form
    table_side=design/accuracy/table_side nearest_entry=design/accuracy/nearest_entry
    supersampling=design/accuracy/supersampling undersampling=design/accuracy/undersampling
    interlaced=design/accuracy/interlaced
    rows_per_stage=design/rows_per_stage pixels_per_clock=design/pixels_per_clock zone=design/zones/side
    processors=design/zones/processors refused
    covered=errors/covered missing=errors/missing extra=errors/extra
    wrong_object=errors/wrong_object wrong_face=errors/wrong_face cracks=errors/cracks
    depth_max_words=errors/depth_words/max depth_q999_words=errors/depth_words/quantile_999
    depth_rms_words=errors/depth_words/rms depth_max_px=errors/depth_px/max
    depth_q999_px=errors/depth_px/quantile_999 depth_rms_px=errors/depth_px/rms
    back_max_words=errors/back_words/max back_q999_words=errors/back_words/quantile_999
    back_rms_words=errors/back_words/rms back_differs=errors/back_differs
    normal_max_deg=errors/normal_deg/max normal_q999_deg=errors/normal_deg/quantile_999
    normal_mean_deg=errors/normal_deg/mean colour_max=errors/colour/max
    colour_q999=errors/colour/quantile_999 colour_same_face_max=errors/colour_same_face/max
    colour_same_face_q999=errors/colour_same_face/quantile_999 picture_error latency
    clocks_per_frame toggles=toggles/total lut=cost/lut ff=cost/ff dsp=cost/dsp bram=cost/bram
    cells=cost/cells is_estimated=cost/is_estimated fmax_mhz=cost/fmax_mhz mhz mhz_estimated frames_per_second pixels_per_second
    pareto command
";

impl Trade {
    /// Points that no other of this class or a better one beats: as small and as fast, and better in one.
    pub fn speed_front(&self, class: usize) -> Vec<usize> {
        let place = |entry: &Entry| {
            let is_in = entry.class.is_some_and(|own| own <= class);
            let speed = entry.point.frames_per_second.filter(|_| is_in)?;
            Some((hardware(&entry.point, self.measure)?, -speed))
        };
        let places: Vec<Option<(f64, f64)>> = self.points.iter().map(place).collect();
        let is_on = undominated(&places);
        (0..is_on.len()).filter(|index| is_on[*index]).collect()
    }

    /// The points as a table.
    pub fn csv(&self) -> String {
        let columns = COLUMNS.split_whitespace();
        let columns = columns.map(|column| column.split_once('=').unwrap_or((column, column)));
        let (head, places): (Vec<&str>, Vec<&str>) = columns.unzip();
        let mut text = head.join(",") + "\n";
        for entry in &self.points {
            let json = serde_json::json!(entry);
            let field = |place: &&str| csv_field(&figure(json.pointer(&format!("/{place}"))));
            let fields: Vec<String> = places.iter().map(field).collect();
            text += &(fields.join(",") + "\n");
        }
        text
    }
}

/// A figure as it is printed; nothing for one that is not there.
fn figure(value: Option<&Value>) -> String {
    match value {
        None | Some(Value::Null) => String::new(),
        Some(Value::String(text)) => text.clone(),
        Some(Value::Array(list)) => {
            let words = list.iter().map(|word| figure(Some(word)));
            words.collect::<Vec<String>>().join(" ")
        }
        Some(Value::Number(number)) if number.is_f64() => {
            number.as_f64().unwrap_or_default().to_string()
        }
        Some(other) => other.to_string(),
    }
}

/// A field of a table, in quotes if it holds a comma, a quote or the end of a line.
pub fn csv_field(text: &str) -> String {
    match text.contains([',', '"', '\n']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}
