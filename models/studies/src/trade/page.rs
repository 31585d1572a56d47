//! The page of the results: one file with everything in it.

use super::TradeError;
use super::plot::draw;
use super::report::{Entry, FRONTS, Trade};
use super::speed;
use crate::kit::page::rendered;
use crate::kit::picture::read_png;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use color_quant::NeuQuant;
use minijinja::context;
use minijinja::value::Serde;
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

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
        Ok::<_, TradeError>(format!("data:image/png;base64,{}", STANDARD.encode(png)))
    };
    // Every picture and map once, under the name of its file.
    let mut pictures = BTreeMap::new();
    for Entry { point, .. } in &trade.points {
        for (name, is_map) in [(&point.picture, false), (&point.map, true)] {
            if let Some(name) = name.as_deref().filter(|name| !pictures.contains_key(name)) {
                pictures.insert(name, embed(name, is_map)?);
            }
        }
    }
    let data = json!({
        "measure": trade.measure,
        "target": trade.target,
        "points": trade.points,
        "pictures": pictures,
        "truth": embed(&trade.truth, false)?,
    });
    let legend = |(text, [r, g, b]): &(&str, [u8; 3])| json!({ "text": text, "colour": format!("rgb({r},{g},{b})") });
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
            "legend": trade.legend.iter().map(legend).collect::<Vec<Value>>(),
            "count": trade.points.len(),
            "refused": trade.points.iter().filter(|e| e.point.refused.is_some()).count(),
            "exact": trade.points.iter().filter(|e| e.silhouette_exact).count(),
        })),
        speed => speed::draw(trade)?,
        plots,
        style => include_str!("page/page.css"),
        script => include_str!("page/page.js"),
        // As the text of a script element: nothing in it ends the element.
        data => data.to_string().replace('<', "\\u003c"),
    };
    let template = include_str!("page/page.html");
    Ok(rendered("cannot draw the page", template, values)?)
}

fn read(path: &Path, size: (u32, u32)) -> Result<Vec<u8>, TradeError> {
    let (info, rgb) = read_png(path).map_err(|error| TradeError::unreadable(path, error))?;
    let wanted = (size.0, size.1, png::ColorType::Rgb);
    if (info.width, info.height, info.color_type) != wanted {
        return Err(TradeError::unreadable(path, "not a picture of this run"));
    }
    Ok(rgb)
}

type Encoded = Result<Vec<u8>, png::EncodingError>;

/// Reduces pictures to one set of colours, chosen for a picture like all of them.
pub struct Reducer {
    network: NeuQuant,
    palette: Vec<u8>,
}

impl Reducer {
    /// Chooses the colours by a picture.
    pub fn new(rgb: &[u8]) -> Reducer {
        let colours = rgb.chunks_exact(3);
        let opaque: Vec<u8> = colours.flat_map(|c| [c[0], c[1], c[2], 255]).collect();
        // Every pixel is looked at, so that small bright spots have their colours.
        let network = NeuQuant::new(1, 256, &opaque);
        let palette = network.color_map_rgb();
        Reducer { network, palette }
    }

    /// A picture in these colours, as PNG.
    pub fn png(&self, size: (u32, u32), rgb: &[u8]) -> Encoded {
        let mut known: HashMap<[u8; 3], u8> = HashMap::new();
        let index = |c: &[u8]| {
            let colour = [c[0], c[1], c[2]];
            let find = || self.network.index_of(&[c[0], c[1], c[2], 255]) as u8;
            *known.entry(colour).or_insert_with(find)
        };
        let indices: Vec<u8> = rgb.chunks_exact(3).map(index).collect();
        encode(size, &self.palette, &indices)
    }
}

/// A picture of at most 256 colours without any change, as PNG; `None` if it has more.
pub fn exact_png(size: (u32, u32), rgb: &[u8]) -> Option<Encoded> {
    let mut known: HashMap<[u8; 3], usize> = HashMap::new();
    let mut palette = vec![];
    let mut indices = Vec::with_capacity(rgb.len() / 3);
    for c in rgb.chunks_exact(3) {
        let next = known.len();
        let index = *known.entry([c[0], c[1], c[2]]).or_insert_with(|| {
            palette.extend_from_slice(c);
            next
        });
        indices.push(u8::try_from(index).ok()?);
    }
    Some(encode(size, &palette, &indices))
}

fn encode((width, height): (u32, u32), palette: &[u8], indices: &[u8]) -> Encoded {
    let mut bytes = vec![];
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(indices)?;
    writer.finish()?;
    Ok(bytes)
}
