//! STEP files (ISO 10303-21) with boundary representations of AP203, AP214 and AP242.
//!
//! The structure of the file is read by [`step21`], what its entities mean by the other modules; the result is the
//! model that a face list gives. Lengths become millimetres.

mod assembly;
mod colours;
mod curves;
mod placement;
mod reader;
mod spline;
mod surfaces;
mod topology;
mod units;

use super::model::Model;
use crate::error::{Error, ImportError, Result};
use assembly::Assembly;
use colours::colours;
use placement::Placement;
use reader::{Found, Reader, Summary};
use std::collections::{HashMap, HashSet};
use step21::{Exchange, Kind, Value, decoded};

/// Most files that place each other's parts.
const DEEPEST_FILE: usize = 8;

/// Reads the file of a name that stands beside the first; `None` if there is none.
pub type Beside<'b> = &'b dyn Fn(&str) -> Option<Vec<u8>>;

pub fn build(bytes: &[u8], beside: Beside) -> Result<(Model, Summary)> {
    let mut found = Found::default();
    read(&mut found, bytes, Placement::IN_PLACE, beside, 0)?;
    let (mut model, mut summary) = (found.topology.model, found.summary);
    if model.faces.is_empty() {
        let accepted =
            "a MANIFOLD_SOLID_BREP, BREP_WITH_VOIDS or SHELL_BASED_SURFACE_MODEL is needed";
        return Err(Error::whole(nothing(&summary), accepted));
    }
    summary.placed_faces = model.faces.len();
    if model.title.is_empty() {
        model.title = "A part".into();
    }
    model.z_up = true;
    let model = model.assembled().ok_or_else(|| {
        let accepted = "a box around them of at least a millionth of a millimetre is needed";
        Error::whole("the faces have no size", accepted)
    })?;
    Ok((model, summary))
}

/// Why a file has no face.
fn nothing(summary: &Summary) -> String {
    if !summary.missing.is_empty() {
        return format!("no part is left: {}", summary.missing.join("; "));
    }
    let others: Vec<&str> = summary.left_out.keys().map(String::as_str).collect();
    format!("no shape representation has a face; its items are {others:?}")
}

/// Reads a file that is placed, and those whose parts it places.
fn read(
    found: &mut Found,
    bytes: &[u8],
    base: Placement,
    beside: Beside,
    depth: usize,
) -> Result<()> {
    let exchange = Exchange::parse(bytes)?;
    let assembly = Assembly::read(&exchange);
    let placed = assembly.placed()?;
    let (colours, grey) = colours(&exchange);
    let summary = &mut found.summary;
    if depth == 0 {
        summary.schema = schema(&exchange);
    }
    summary.entities += exchange.instances.len();
    summary.missing.extend(assembly.notes.iter().cloned());
    summary.missing.extend(grey);
    found.topology.next_file();
    let mut reader = Reader {
        found,
        assembly: &assembly,
        colours,
        seen: HashSet::new(),
        placed: HashMap::new(),
    };
    for part in &placed {
        reader.representation(part, base.after(&part.place));
    }
    reader.finish(&exchange);
    let title = &mut found.topology.model.title;
    if let Some(first) = placed.first().filter(|_| title.is_empty()) {
        *title = assembly.name(first.group).to_owned();
    }
    let mut done = HashSet::new();
    for part in placed.iter().filter(|part| done.insert(part.occurrence)) {
        for name in external(&exchange, assembly.product_of(part.group)) {
            let place = base.after(&part.place);
            let Some(bytes) = beside(&name).filter(|_| depth < DEEPEST_FILE) else {
                found.summary.missing.push(format!(
                    "part `{}` is in the file `{name}`, which is not beside this one",
                    assembly.name(part.group)
                ));
                continue;
            };
            let inner = read(found, &bytes, place, beside, depth + 1);
            let Summary { missing, files, .. } = &mut found.summary;
            let inner = inner.map_err(ImportError::of(&name));
            missing.extend(inner.err().map(|error| error.to_string()));
            if !files.contains(&name) {
                files.push(name);
            }
        }
    }
    Ok(())
}

/// The first words of the names of the schemas.
fn schema(file: &Exchange) -> Vec<String> {
    let record = file.header.iter().find(|r| r.name == "FILE_SCHEMA");
    let Some(Kind::List(names)) = record.and_then(|record| Some(&record.values.first()?.kind))
    else {
        return vec![];
    };
    let text = |value: &Value| match value.kind {
        Kind::Text(name) => Some(decoded(name)),
        _ => None,
    };
    let word = |name: String| name.split_whitespace().next().unwrap_or("").to_owned();
    names.iter().filter_map(text).map(word).collect()
}

/// The names of the files that have the shape of a product, without folders.
fn external(file: &Exchange, product: Option<u64>) -> Vec<String> {
    let mut names: Vec<String> = vec![];
    for reference in file.all(&["APPLIED_DOCUMENT_REFERENCE"]) {
        let items = reference.entities(2).unwrap_or_default();
        let own = items.iter().any(|item| Some(item.id) == product);
        let document = reference.entity(0).ok().filter(|_| own);
        let Some(document) = document.and_then(|entity| entity.find(&["DOCUMENT_FILE"])) else {
            continue;
        };
        let mut assigned = file.all(&["APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT"]);
        let assigned = assigned.find(|assigned| {
            let items = assigned.entities(3).unwrap_or_default();
            items.iter().any(|item| item.id == document.entity.id)
        });
        let path = assigned.unwrap_or(document).text(0);
        let name = path.rsplit(['/', '\\']).next().unwrap_or_default();
        if !name.is_empty() && !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    }
    names
}
