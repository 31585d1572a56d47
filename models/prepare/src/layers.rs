//! Transparent objects: the slots that blend them over the others, farthest first (source: Chaillou, IV.3.3).

use super::context::Context;
use super::error::PrepareError;
use super::prepared::PreparedObject;
use imogene_contract::words::MOST_LAYERS;
use imogene_golden::machine::beam;
use imogene_golden::machine::transparency::order;
use imogene_golden::object::slot::Slot;
use imogene_golden::slots::required;
use imogene_scene::FramedScene;
use std::collections::BTreeSet;

/// The slots of the transparent objects, in the order of their blends.
/// Fails when there are too many, when one has more or less than one processor or is in a solid, when a source does not
/// reach everything, or when no order is right at all pixels.
pub(super) fn layers(
    scene: &FramedScene,
    transparent: &BTreeSet<usize>,
    objects: &[PreparedObject],
    context: &Context,
) -> Result<Vec<Slot>, PrepareError> {
    let Some(&first) = transparent.first() else {
        return Ok(vec![]);
    };
    let refused = |object: usize, problem: String| {
        PrepareError::Transparent(objects[object].name().to_owned(), problem)
    };
    if transparent.len() > MOST_LAYERS as usize {
        let count = transparent.len();
        let problem =
            format!("is one of {count} transparent objects; at most {MOST_LAYERS} are possible");
        return Err(refused(first, problem));
    }
    let mut sources = scene.sources.iter();
    if let Some(light) = sources.position(|s| s.shadows || s.cone.is_some()) {
        let problem = format!(
            "is transparent, and lights[{light}] is a spot or has shadows; with transparent objects a light reaches \
             everything: `shadows = false`, and no spots"
        );
        return Err(refused(first, problem));
    }
    let members: Vec<usize> = scene.solids.iter().flat_map(|s| s.tree.objects()).collect();
    let slots = transparent.iter().map(|&object| {
        if members.contains(&object) {
            let problem = "is transparent and belongs to a solid; solids are opaque".to_owned();
            return Err(refused(object, problem));
        }
        let mut words = objects[object].words();
        match (words.pop(), words.len()) {
            (Some(words), 0) if required(&words).is_some() => Ok(Some(Slot {
                object,
                words,
                weight: Some(scene.weight(object)),
            })),
            (None, _) => Ok(None),
            _ => {
                let problem = "is transparent and not drawn by one processor alone; a mesh is opaque, as is what the \
                               viewer nearly lies on";
                Err(refused(object, problem.to_owned()))
            }
        }
    });
    let slots: Vec<Option<Slot>> = slots.collect::<Result<_, _>>()?;
    sorted(slots.into_iter().flatten().collect(), objects, context)
}

/// Farthest first at every pixel.
fn sorted(
    slots: Vec<Slot>,
    objects: &[PreparedObject],
    context: &Context,
) -> Result<Vec<Slot>, PrepareError> {
    let (width, height) = (context.width as usize, context.height as usize);
    let frame = beam::render(&slots, &context.format, width, height, || ());
    let depths: Vec<Vec<i64>> = frame.layers.into_iter().map(|layer| layer.depth).collect();
    let order = order(&depths, context.format.z_max()).map_err(|none| {
        let circle = none.circle.iter();
        let names = circle.map(|&index| format!("'{}'", objects[slots[index].object].name()));
        PrepareError::NoOrder(names.collect::<Vec<_>>().join(", "))
    })?;
    let order = order.into_iter();
    Ok(order.map(|index| slots[index].clone()).collect())
}
