//! Colours of solids and faces (ISO 10303-46).

use imogene_scene::Material;
use std::collections::HashMap;
use step21::{Args, Entity, Exchange, Kind, Result, Value};

/// From red, green and blue, 0 to 1.
pub type Colour = [f64; 3];

/// What a part without a colour has.
const GREY: Colour = [0.62, 0.66, 0.7];
/// Most entities that are looked at for the colour of an item; seven are usual.
const MOST_STEPS: usize = 64;

/// Entities on the way to the colour of a surface.
const ON_THE_WAY: [&str; 10] = [
    "PRESENTATION_STYLE_ASSIGNMENT",
    "PRESENTATION_STYLE_BY_CONTEXT",
    "SURFACE_STYLE_USAGE",
    "SURFACE_SIDE_STYLE",
    "SURFACE_STYLE_FILL_AREA",
    "SURFACE_STYLE_RENDERING",
    "SURFACE_STYLE_RENDERING_WITH_PROPERTIES",
    "FILL_AREA_STYLE",
    "FILL_AREA_STYLE_COLOUR",
    "COLOUR_RGB",
];

const PREDEFINED: [(&str, Colour); 8] = [
    ("red", [1.0, 0.0, 0.0]),
    ("green", [0.0, 1.0, 0.0]),
    ("blue", [0.0, 0.0, 1.0]),
    ("yellow", [1.0, 1.0, 0.0]),
    ("magenta", [1.0, 0.0, 1.0]),
    ("cyan", [0.0, 1.0, 1.0]),
    ("black", [0.0, 0.0, 0.0]),
    ("white", [1.0, 1.0, 1.0]),
];

/// The colours of a file by the number of what has them, and why something has none.
pub fn colours(file: &Exchange) -> (HashMap<u64, Colour>, Vec<String>) {
    let (mut colours, mut problems) = (HashMap::new(), vec![]);
    for item in file.all(&["STYLED_ITEM", "OVER_RIDING_STYLED_ITEM"]) {
        match styled(file, &item) {
            Ok(found) => colours.extend(found),
            Err(error) => problems.push(format!("a colour: {error}")),
        }
    }
    (colours, problems)
}

/// What a style is of, and its colour.
fn styled(file: &Exchange, item: &Args) -> Result<Option<(u64, Colour)>> {
    // A complex one has the name of its item in another record, and its target in this.
    let first = item.first();
    let Some(target) = item.maybe(first + 1)? else {
        return Ok(None);
    };
    let mut steps = MOST_STEPS;
    let colour = first_colour(file, item.entities(first)?, &mut steps)?;
    Ok(colour.map(|colour| (target.id, colour)))
}

/// Lists of styles have several members; the first that leads to a colour is taken.
fn first_colour(file: &Exchange, of: Vec<Entity>, steps: &mut usize) -> Result<Option<Colour>> {
    let mut all = of.into_iter();
    let found = all.find_map(|entity| colour_of(file, entity, steps).transpose());
    found.transpose()
}

/// The first colour of a surface that an entity leads to.
fn colour_of(file: &Exchange, entity: Entity, steps: &mut usize) -> Result<Option<Colour>> {
    if let Some(args) = entity.find(&["DRAUGHTING_PRE_DEFINED_COLOUR"]) {
        let name = args.text(0);
        let known = PREDEFINED.iter().find(|(word, _)| *word == name);
        return Ok(known.map(|(_, colour)| *colour));
    }
    let Some(args) = entity.find(&ON_THE_WAY) else {
        return Ok(None);
    };
    if args.record.name == "COLOUR_RGB" {
        let colour = [args.number(1)?, args.number(2)?, args.number(3)?];
        if colour.iter().any(|share| !(0.0..=1.0).contains(share)) {
            let problem = format!("the colour {colour:?}");
            return Err(args.error(problem, "red, green and blue from 0 to 1 are possible"));
        }
        return Ok(Some(colour));
    }
    if *steps == 0 {
        let problem = "its colour is defined by itself, or by too many others";
        let accepted = format!("at most {MOST_STEPS} steps to a colour are possible");
        return Err(args.error(problem, accepted));
    }
    *steps -= 1;
    let mut named = vec![];
    references(file, &args.record.values, &mut named);
    first_colour(file, named, steps)
}

fn references<'a>(file: &'a Exchange, values: &[Value], found: &mut Vec<Entity<'a>>) {
    for value in values {
        match &value.kind {
            Kind::Reference(id) => found.extend(file.get(*id)),
            Kind::List(values) => references(file, values, found),
            Kind::Typed(typed) => references(file, &typed.values, found),
            _ => {}
        }
    }
}

/// The name of the material of a colour, one for every colour; grey without one.
pub fn material(materials: &mut Vec<Material>, colour: Option<Colour>) -> String {
    let rgb = colour.unwrap_or(GREY);
    let [r, g, b] = rgb.map(|share| (255.0 * share).round() as u8);
    let name = colour.map_or("grey".to_owned(), |_| format!("#{r:02x}{g:02x}{b:02x}"));
    if !materials.iter().any(|m| m.name == name) {
        let shares = [0.15, 0.8, 0.5];
        materials.push(crate::kit::material(name.clone(), rgb, shares, 40));
    }
    name
}
