//! The page of the results: one file with everything in it.

use super::TradeError;
use super::plot::draw;
use super::report::{FRONTS, Trade};
use super::shrink::{Reducer, exact_png};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use minijinja::{Environment, context};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;

const TEMPLATE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/page.css");
const SCRIPT: &str = include_str!("page/page.js");

/// The page of results whose pictures are in `folder`.
///
/// # Errors
///
/// When a picture cannot be read.
pub fn page(trade: &Trade, folder: &Path) -> Result<String, TradeError> {
    let plots = FRONTS.iter().map(|front| draw(trade, front));
    let plots = plots.collect::<Result<Vec<String>, TradeError>>()?;
    let data = json!({
        "measure": trade.measure,
        "target": trade.target,
        "points": trade.points,
        "pictures": pictures(trade, folder)?,
        "truth": data_uri(&Pictures::new(trade, folder)?.reduced(&trade.truth)?),
    });
    let mut environment = Environment::new();
    let failed = |error: minijinja::Error| TradeError::Draw {
        what: "the page",
        problem: format!("{error:#}"),
    };
    environment
        .add_template("page.html", TEMPLATE)
        .map_err(failed)?;
    let template = environment.get_template("page.html").map_err(failed)?;
    template
        .render(context! {
            trade => minijinja::value::Serde(json!({
                "title": trade.title,
                "scene": trade.scene,
                "width": trade.width,
                "height": trade.height,
                "target": trade.target,
                "version": trade.version,
                "has_cost": trade.measure == "cells",
                "legend": legend(trade),
                "count": trade.points.len(),
                "refused": trade.points.iter().filter(|e| e.point.refused.is_some()).count(),
                "exact": trade.points.iter().filter(|e| e.silhouette_exact).count(),
            })),
            plots,
            style => STYLE,
            script => SCRIPT,
            data => embedded(&data),
        })
        .map_err(failed)
}

/// JSON as the text of a script element: nothing in it ends the element.
fn embedded(data: &Value) -> String {
    data.to_string().replace('<', "\\u003c")
}

fn legend(trade: &Trade) -> Vec<Value> {
    let entry = |(text, [r, g, b]): &(String, [u8; 3])| json!({ "text": text, "colour": format!("rgb({r},{g},{b})") });
    trade.legend.iter().map(entry).collect()
}

/// Every picture and map once, under the name of its file.
fn pictures(trade: &Trade, folder: &Path) -> Result<BTreeMap<String, String>, TradeError> {
    let source = Pictures::new(trade, folder)?;
    let mut all = BTreeMap::new();
    for entry in &trade.points {
        for (name, is_map) in [(&entry.point.picture, false), (&entry.point.map, true)] {
            let Some(name) = name else { continue };
            if all.contains_key(name) {
                continue;
            }
            let png = if is_map {
                source.exact(name)?
            } else {
                source.reduced(name)?
            };
            all.insert(name.clone(), data_uri(&png));
        }
    }
    Ok(all)
}

fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// The pictures of a folder, in few colours.
struct Pictures<'a> {
    folder: &'a Path,
    size: (u32, u32),
    reducer: Reducer,
}

impl Pictures<'_> {
    fn new<'a>(trade: &Trade, folder: &'a Path) -> Result<Pictures<'a>, TradeError> {
        let size = (trade.width, trade.height);
        let truth = read(folder, &trade.truth, size)?;
        Ok(Pictures {
            folder,
            size,
            reducer: Reducer::new(&truth),
        })
    }

    fn reduced(&self, name: &str) -> Result<Vec<u8>, TradeError> {
        let rgb = read(self.folder, name, self.size)?;
        self.encoded(name, self.reducer.png(self.size.0, self.size.1, &rgb))
    }

    /// A map as it is: it has few colours.
    fn exact(&self, name: &str) -> Result<Vec<u8>, TradeError> {
        let rgb = read(self.folder, name, self.size)?;
        let (width, height) = self.size;
        match exact_png(width, height, &rgb) {
            Some(png) => self.encoded(name, png),
            None => self.reduced(name),
        }
    }

    fn encoded(
        &self,
        name: &str,
        png: Result<Vec<u8>, png::EncodingError>,
    ) -> Result<Vec<u8>, TradeError> {
        png.map_err(|error| unreadable(self.folder, name, error))
    }
}

fn unreadable(folder: &Path, name: &str, problem: impl std::fmt::Display) -> TradeError {
    TradeError::Read {
        file: folder.join(name).display().to_string(),
        problem: problem.to_string(),
    }
}

/// Red, green and blue of a picture of this size.
fn read(folder: &Path, name: &str, size: (u32, u32)) -> Result<Vec<u8>, TradeError> {
    let failed = |problem: String| unreadable(folder, name, problem);
    let file = std::fs::File::open(folder.join(name)).map_err(|e| failed(e.to_string()))?;
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().map_err(|e| failed(e.to_string()))?;
    let length = reader
        .output_buffer_size()
        .ok_or_else(|| failed("too large".into()))?;
    let mut rgb = vec![0; length];
    let info = reader
        .next_frame(&mut rgb)
        .map_err(|e| failed(e.to_string()))?;
    let wanted = (size.0, size.1, png::ColorType::Rgb);
    if (info.width, info.height, info.color_type) != wanted {
        return Err(failed("not a picture of this run".into()));
    }
    Ok(rgb)
}
