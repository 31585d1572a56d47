//! The page of the results: one file with everything in it.

use super::TradeError;
use super::plot::draw;
use super::report::{Entry, FRONTS, Trade};
use super::shrink::{Reducer, exact_png};
use super::speed;
use crate::kit::page::rendered;
use crate::kit::picture::read_png;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use minijinja::context;
use minijinja::value::Serde;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;

const TEMPLATE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/page.css");
const SCRIPT: &str = include_str!("page/page.js");

/// The page of results whose pictures are in `folder`.
pub fn page(trade: &Trade, folder: &Path) -> Result<String, TradeError> {
    let plots = FRONTS.iter().map(|front| draw(trade, front));
    let plots = plots.collect::<Result<Vec<String>, TradeError>>()?;
    let size = (trade.width, trade.height);
    let reducer = Reducer::new(&read(&folder.join(&trade.truth), size)?);
    // In few colours; a map as it is, for it has few.
    let embed = |name: &str, is_map: bool| {
        let path = folder.join(name);
        let rgb = read(&path, size)?;
        let exact = is_map.then(|| exact_png(size, &rgb)).flatten();
        let png = exact.unwrap_or_else(|| reducer.png(size, &rgb));
        let png = png.map_err(|error| TradeError::unreadable(&path, error))?;
        Ok(format!("data:image/png;base64,{}", STANDARD.encode(png)))
    };
    let data = json!({
        "measure": trade.measure,
        "target": trade.target,
        "points": trade.points,
        "pictures": pictures(trade, embed)?,
        "truth": embed(&trade.truth, false)?,
    });
    let values = context! {
        trade => Serde(json!({
            "title": trade.title,
            "scene": trade.scene,
            "width": trade.width,
            "height": trade.height,
            "target": trade.target,
            "version": trade.version,
            "has_cost": trade.measure == "cells",
            "clock_error": trade.clock_error,
            "area_error": trade.area_error,
            "legend": legend(trade),
            "count": trade.points.len(),
            "refused": trade.points.iter().filter(|e| e.point.refused.is_some()).count(),
            "exact": trade.points.iter().filter(|e| e.silhouette_exact).count(),
        })),
        speed => speed::draw(trade)?,
        plots,
        style => STYLE,
        script => SCRIPT,
        data => embedded(&data),
    };
    Ok(rendered("cannot draw the page", TEMPLATE, values)?)
}

/// JSON as the text of a script element: nothing in it ends the element.
fn embedded(data: &Value) -> String {
    data.to_string().replace('<', "\\u003c")
}

fn legend(trade: &Trade) -> Vec<Value> {
    let entry = |(text, [r, g, b]): &(&str, [u8; 3])| json!({ "text": text, "colour": format!("rgb({r},{g},{b})") });
    trade.legend.iter().map(entry).collect()
}

/// Every picture and map once, embedded, under the name of its file.
fn pictures(
    trade: &Trade,
    embed: impl Fn(&str, bool) -> Result<String, TradeError>,
) -> Result<BTreeMap<&str, String>, TradeError> {
    let mut all = BTreeMap::new();
    for Entry { point, .. } in &trade.points {
        for (name, is_map) in [(&point.picture, false), (&point.map, true)] {
            if let Some(name) = name.as_deref().filter(|name| !all.contains_key(name)) {
                all.insert(name, embed(name, is_map)?);
            }
        }
    }
    Ok(all)
}

/// Red, green and blue of a picture of this size.
fn read(path: &Path, size: (u32, u32)) -> Result<Vec<u8>, TradeError> {
    let (info, rgb) = read_png(path).map_err(|error| TradeError::unreadable(path, error))?;
    let wanted = (size.0, size.1, png::ColorType::Rgb);
    if (info.width, info.height, info.color_type) != wanted {
        return Err(TradeError::unreadable(path, "not a picture of this run"));
    }
    Ok(rgb)
}
