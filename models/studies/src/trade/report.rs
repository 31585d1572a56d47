//! The results of a run: what stands in `trade.json` and `trade.csv`.

use super::point::{Cost, Point};
use super::run::Request;
use imogene_analysis::metrics::{Metrics, map};
use serde::Serialize;
use std::fmt::Write as _;

/// All points; the keys are stable.
#[derive(Clone, Debug, Serialize)]
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
    pub legend: Vec<(String, [u8; 3])>,
    /// What the hardware is measured by in the fronts: `cells`, or `toggles` if no point has a cost.
    pub measure: &'static str,
    /// The points in the order of the design space.
    pub points: Vec<Entry>,
}

/// A point, and on which fronts it is.
#[derive(Clone, Debug, Serialize)]
pub struct Entry {
    /// The point.
    #[serde(flatten)]
    pub point: Point,
    /// True if the picture has no silhouette error.
    pub silhouette_exact: bool,
    /// Fronts on which no other point is as good in both and better in one: `depth`, `silhouette`, `colour`.
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

pub(super) fn assemble(request: &Request, title: &str, truth: String, points: Vec<Point>) -> Trade {
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
            silhouette_exact: point.is_silhouette_exact(),
            pareto: on.map(|(name, _)| *name).collect(),
            point,
        }
    };
    Trade {
        version: request.version.to_owned(),
        scene: request.name.to_owned(),
        title: title.to_owned(),
        width: request.size.0,
        height: request.size.1,
        target: request.target.to_owned(),
        truth,
        legend: map::legend(),
        measure,
        points: points.into_iter().enumerate().map(entry).collect(),
    }
}

/// The places that no other one beats: as good in both, and better in one. Equal places are all on the front.
fn undominated(places: &[Option<(f64, f64)>]) -> Vec<bool> {
    let beaten = |a: (f64, f64)| {
        let better = |b: &(f64, f64)| b.0 <= a.0 && b.1 <= a.1 && *b != a;
        places.iter().flatten().any(better)
    };
    let is_on = |place: &Option<(f64, f64)>| place.is_some_and(|place| !beaten(place));
    places.iter().map(is_on).collect()
}

/// Columns of the table.
const COLUMNS: &str = "id,unit,depth,root,plane,normal,g1,g2,dropped,rows_per_stage,zone,refused,covered,missing,extra,\
wrong_object,wrong_face,cracks,depth_max_words,depth_q999_words,depth_rms_words,depth_max_px,depth_q999_px,depth_rms_px,back_max_words,\
back_q999_words,back_rms_words,back_differs,normal_max_deg,normal_q999_deg,normal_mean_deg,colour_max,colour_q999,colour_same_face_max,\
colour_same_face_q999,latency,clocks_per_frame,toggles,lut,ff,dsp,cells,fmax_mhz,pixels_per_second,pareto,command";

impl Trade {
    /// The points as a table.
    pub fn csv(&self) -> String {
        let mut text = format!("{COLUMNS}\n");
        for entry in &self.points {
            let fields: Vec<String> = fields(entry).iter().map(|f| csv_field(f)).collect();
            let _ = writeln!(text, "{}", fields.join(","));
        }
        text
    }
}

fn fields(entry: &Entry) -> Vec<String> {
    let point = &entry.point;
    let of = |value: Option<String>| value.unwrap_or_default();
    let width = |w: fn(&imogene_contract::MachineWords) -> u32| {
        of(point.format.as_ref().map(|f| w(f).to_string()))
    };
    let error = |e: fn(&Metrics) -> String| of(point.errors.as_ref().map(e));
    let cost = |c: fn(&Cost) -> String| of(point.cost.as_ref().map(c));
    vec![
        point.id.clone(),
        point.unit.clone(),
        point.design.accuracy.depth.to_string(),
        width(|f| f.root),
        width(|f| f.plane),
        point.design.accuracy.normal.to_string(),
        point.design.accuracy.guard_linear.to_string(),
        point.design.accuracy.guard_quadratic.to_string(),
        point.design.accuracy.dropped_rows.to_string(),
        point.design.rows_per_stage.to_string(),
        point.design.accuracy.zone.to_string(),
        of(point.refused.clone()),
        error(|e| e.covered.to_string()),
        error(|e| e.missing.to_string()),
        error(|e| e.extra.to_string()),
        error(|e| e.wrong_object.to_string()),
        error(|e| e.wrong_face.to_string()),
        error(|e| e.cracks.to_string()),
        error(|e| e.depth_words.max.to_string()),
        error(|e| e.depth_words.quantile_999.to_string()),
        error(|e| e.depth_words.rms.to_string()),
        error(|e| e.depth_px.max.to_string()),
        error(|e| e.depth_px.quantile_999.to_string()),
        error(|e| e.depth_px.rms.to_string()),
        error(|e| e.back_words.max.to_string()),
        error(|e| e.back_words.quantile_999.to_string()),
        error(|e| e.back_words.rms.to_string()),
        error(|e| e.back_differs.to_string()),
        error(|e| e.normal_deg.max.to_string()),
        error(|e| e.normal_deg.quantile_999.to_string()),
        error(|e| e.normal_deg.mean.to_string()),
        error(|e| e.colour.max.to_string()),
        error(|e| e.colour.quantile_999.to_string()),
        error(|e| e.colour_same_face.max.to_string()),
        error(|e| e.colour_same_face.quantile_999.to_string()),
        of(point.latency.map(|v| v.to_string())),
        of(point.clocks_per_frame.map(|v| v.to_string())),
        of(point.toggles.as_ref().map(|t| t.total.to_string())),
        cost(|c| c.lut.to_string()),
        cost(|c| c.ff.to_string()),
        cost(|c| c.dsp.to_string()),
        cost(|c| c.cells.to_string()),
        cost(|c| c.fmax_mhz.map_or_else(String::new, |mhz| mhz.to_string())),
        of(point.pixels_per_second.map(|v| v.to_string())),
        entry.pareto.join(" "),
        point.command.clone(),
    ]
}

fn csv_field(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_no_other_point_beats() {
        let places = [
            (1.0, 5.0),
            (2.0, 5.0),
            (2.0, 3.0),
            (3.0, 4.0),
            (2.0, 3.0),
            (9.0, 0.0),
        ];
        let mut places: Vec<Option<(f64, f64)>> = places.into_iter().map(Some).collect();
        places.push(None);
        let wanted = [true, false, true, false, true, true, false];
        assert_eq!(undominated(&places), wanted);
    }

    #[test]
    fn fields_with_commas_are_quoted() {
        assert_eq!(csv_field("a"), "a");
        assert_eq!(csv_field("a,\"b\""), "\"a,\"\"b\"\"\"");
    }
}
