//! The blends of transparent objects.

use super::description::{Description, late, stated};
use crate::stimulus::{depth, each, word};
use crate::subject::{Inputs, Subject};
use imogene_golden::machine::skew::Skewed;
use imogene_golden::machine::transparency::{
    Layer, STAGE_LATENCY, Seen, latency, pipeline, stage, starts,
};
use proptest::prelude::*;

/// Ports of the pixel.
const PIXEL: usize = 4;
/// Ports of a layer.
const LAYER: usize = 5;

fn seen_of(i: &[i64]) -> Seen {
    Seen {
        depth: i[0],
        colour: [1, 2, 3].map(|k| i[k] as u8),
    }
}

fn layer_of(i: &[i64]) -> Layer {
    Layer {
        depth: i[0],
        colour: [1, 2, 3].map(|k| i[k] as u8),
        weight: i[4] as u8,
    }
}

fn flat(seen: Option<Seen>) -> Vec<Option<i64>> {
    stated(seen.map(|seen| {
        let [red, green, blue] = seen.colour.map(i64::from);
        [seen.depth, red, green, blue]
    }))
}

pub(super) fn transparency_stage() -> Description {
    Description::new(blends, || {
        let mut late = late(STAGE_LATENCY as usize);
        move |i: &[i64]| flat(late.push(stage(seen_of(i), layer_of(&i[PIXEL..]))))
    })
}

pub(super) fn transparency_pipeline(layers: usize) -> Description {
    Description::new(blends, move || {
        // The pixel, and behind it the layers.
        let starts = [vec![0], starts(layers)].concat();
        let mut pixels = Skewed::new(starts);
        let mut late = late(latency(layers) as usize - pixels.span());
        move |i: &[i64]| {
            let (pixel, list) = i.split_at(PIXEL);
            let row = std::iter::once(pixel).chain(list.chunks(LAYER));
            let whole = pixels.push(row.map(<[i64]>::to_vec).collect());
            let seen = whole.map(|parts| {
                let layers: Vec<Layer> = parts[1..].iter().map(|i| layer_of(i)).collect();
                pipeline(seen_of(&parts[0]), &layers)
            });
            flat(late.push(seen).flatten())
        }
    })
}

/// Depths that often tie, layers mostly before the surface, components and weights with their ends.
fn blends(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let width = subject.inputs[0].width;
    let far = (1i64 << (width - 1)) - 1;
    let ports = subject.inputs.iter().enumerate();
    let ports = ports.map(|(place, port)| match port.signed {
        false => prop_oneof![1 => Just(0i64), 1 => Just(255), 6 => 0i64..256].boxed(),
        _ if place == 0 => prop_oneof![depth(width), Just(2), Just(far)].boxed(),
        _ => prop_oneof![2 => word(port), 2 => -3i64..4, 1 => Just(far)].boxed(),
    });
    each(ports.collect(), clocks)
}
