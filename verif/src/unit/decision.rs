//! What is seen at a pixel: visibility node, deciders, product of a solid, flags of light sources, blends of glass.

use super::description::{Description, bit, late, stated};
use crate::signal::Signal;
use crate::stimulus::{depth, each, mapped, word};
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_golden::format::Format;
use imogene_golden::machine::csg::{self, Extent, front, skew};
use imogene_golden::machine::decider::{Visible, decide, latency};
use imogene_golden::machine::shadow::{self, ShadowWords, flags};
use imogene_golden::machine::skew::Skewed;
use imogene_golden::machine::transparency::{self, Layer, STAGE_LATENCY, Seen, pipeline, stage};
use imogene_golden::machine::{card_decider as cards, visibility_chain as chain};
use imogene_golden::object::volume::VolumeKind;
use proptest::prelude::*;

/// Ports of one input or output.
const FIELDS: usize = 6;

fn visible(i: &[i64]) -> Vec<Visible> {
    let one = |i: &[i64]| Visible {
        depth: i[0],
        id: i[1] as u8,
        number: i[2] as u8,
        normal: [3, 4, 5].map(|k| i[k] as i16),
    };
    i.chunks(FIELDS).map(one).collect()
}

pub(super) fn flat(v: Visible) -> [i64; FIELDS] {
    let [nx, ny, nz] = v.normal.map(i64::from);
    [v.depth, v.id.into(), v.number.into(), nx, ny, nz]
}

/// Inputs with ids in random order, scattered, neighbours or all the same, and depths that often tie. In some stimuli
/// two depths and two ids are all there is, so that inputs of different clocks tie too.
fn objects(subject: &Subject, clocks: usize) -> Stimuli {
    let count = subject.inputs.len() / FIELDS;
    let width = subject.inputs[0].width;
    let ids: Vec<i64> = (0..256).collect();
    let scattered = proptest::sample::subsequence(ids, count);
    let neighbours = (0..=256 - count as i64)
        .prop_map(move |first| (first..first + count as i64).collect::<Vec<i64>>());
    let same = (0i64..256).prop_map(move |id| vec![id; count]);
    let few = proptest::collection::vec(0i64..2, count);
    let ids = prop_oneof![scattered, neighbours, same].prop_shuffle();
    let rows = |ids: BoxedStrategy<Inputs>, depth: BoxedStrategy<i64>| {
        let payload = (0i64..16, any::<[i16; 3]>());
        let fields = proptest::collection::vec((depth, payload), count);
        let one = mapped((ids, fields), |(ids, fields)| -> Inputs {
            let each = ids.into_iter().zip(fields);
            let each = each.flat_map(|(id, (depth, (number, n)))| {
                let [nx, ny, nz] = n.map(i64::from);
                [depth, id, number, nx, ny, nz]
            });
            each.collect()
        });
        proptest::collection::vec(one, clocks)
    };
    let any = rows(ids.boxed(), depth(width));
    let close = rows(few.boxed(), (0i64..2).boxed());
    prop_oneof![3 => any, 1 => close].boxed()
}

pub(super) fn visibility_node() -> Description {
    decider(2)
}

pub(super) fn decider(inputs: usize) -> Description {
    // With one input the decider is a wire: the result belongs to the same clock.
    let clocks = latency(inputs).max(1);
    Description::pipeline(objects, clocks, |i| flat(decide(&visible(i))))
}

/// A decider whose inputs are taken at their own clocks, `starts`, and that answers `latency` clocks after the first.
fn skewed(starts: Vec<usize>, latency: u32) -> Description {
    Description::new(objects, move || {
        let mut pixels = Skewed::new(starts.clone());
        let mut late = late(latency as usize - pixels.span());
        move |i: &[i64]| {
            let winner = pixels.push(visible(i)).map(|pixel| decide(&pixel));
            stated(late.push(winner).flatten().map(flat))
        }
    })
}

pub(super) fn visibility_chain(inputs: usize) -> Description {
    skewed(chain::starts(inputs), chain::latency(inputs))
}

pub(super) fn card_decider(processors: usize, count: usize) -> Description {
    let starts = cards::starts(processors, count);
    skewed(starts, cards::latency(processors, count))
}

/// Ports of one object: depth, id, number and normal of its face, and the depth of its other end.
const EXTENT: usize = 7;

pub(super) fn csg_product(format: Format, intersected: usize, subtracted: usize) -> Description {
    Description::new(solids, move || {
        let starts = [vec![0; intersected], vec![skew(intersected); subtracted]].concat();
        let mut pixels = Skewed::new(starts);
        let clocks = csg::latency(intersected, subtracted) as usize;
        let mut late = late(clocks - pixels.span());
        move |i: &[i64]| {
            let row: Vec<Vec<i64>> = i.chunks(EXTENT).map(<[i64]>::to_vec).collect();
            let seen = pixels.push(row).map(|objects| {
                let (kept, taken) = objects.split_at(intersected);
                // The face is the front of what is kept and the back of what is taken away.
                let kept = kept.iter().map(|i| Extent { zf: i[0], zb: i[6] });
                let taken = taken.iter().map(|i| Extent { zf: i[6], zb: i[0] });
                let (kept, taken): (Vec<_>, Vec<_>) = (kept.collect(), taken.collect());
                match front(&kept, &taken, format.z_max()) {
                    Some(seen) => [0, 1, 2, 3, 4, 5].map(|k| objects[seen.object][k]),
                    None => [format.z_max(), 0, 0, 0, 0, 0],
                }
            });
            stated(late.push(seen).flatten())
        }
    })
}

/// Intervals on few levels, so that ends meet; wide ones for the objects that are intersected, narrow ones for those
/// taken away; some absent, some of any words, which the rule covers too.
fn solids(subject: &Subject, clocks: usize) -> Stimuli {
    let width = subject.inputs[0].width;
    let far = (1i64 << (width - 1)) - 1;
    let one = |ports: &[Signal]| {
        let is_kept = ports[0].name.starts_with("intersected");
        let lengths = if is_kept { 4i64..16 } else { 0i64..6 };
        let on_levels = (-3i64..8, lengths).prop_map(|(zf, length)| [zf, zf + length]);
        let fronts = (-3i64..2, 8i64..12).prop_map(|(zf, zb)| [zf, zb]);
        let sheet = (-3i64..8).prop_map(|z| [z, z]);
        let absent = depth(width).prop_map(move |zb| [far, zb]);
        let open = depth(width).prop_map(move |zf| [zf, far]);
        let ends = (depth(width), depth(width)).prop_map(|(zf, zb)| [zf, zb]);
        let interval = prop_oneof![
            8 => on_levels, 6 => fronts, 1 => sheet, 1 => absent, 1 => open, 1 => ends
        ];
        let normal = [word(&ports[3]), word(&ports[4]), word(&ports[5])];
        (interval, 0i64..256, 0i64..16, normal).prop_map(
            move |([zf, zb], id, number, [x, y, z])| {
                let [face, end] = if is_kept { [zf, zb] } else { [zb, zf] };
                vec![face, id, number, x, y, z, end]
            },
        )
    };
    let objects: Vec<_> = subject.inputs.chunks(EXTENT).map(one).collect();
    let row = objects.prop_map(|objects| objects.concat());
    proptest::collection::vec(row, clocks).boxed()
}

/// Ports of one volume.
const VOLUME: usize = 4;

pub(super) fn shadow_stage(volumes: usize) -> Description {
    Description::pipeline(answers, shadow::latency(volumes), |i| {
        let volume = |i: &[i64]| {
            let words = ShadowWords {
                kind: [VolumeKind::Shadow, VolumeKind::Light][i[1] as usize],
                source: i[2] as u8,
                enabled: bit(i[3]),
            };
            (words, bit(i[0]))
        };
        let (words, inside): (Vec<_>, Vec<_>) = i[1..].chunks(VOLUME).map(volume).unzip();
        [flags(i[0] as u16, &words, &inside).into()]
    })
}

/// Sources all different, or few, so that volumes meet; answers that mostly leave the flag, or one would hide others.
fn answers(subject: &Subject, clocks: usize) -> Stimuli {
    let count = (subject.inputs.len() - 1) / VOLUME;
    let before = prop_oneof![Just(0xffff), word(&subject.inputs[0])];
    let source = prop_oneof![0i64..16, 0i64..3];
    let takes_away = prop_oneof![6 => Just(0i64), 1 => Just(1)];
    let volume =
        (takes_away, 0i64..=1, source, 0i64..=1).prop_map(|(takes_away, kind, source, enabled)| {
            // A volume that does not count says the opposite: it must not be heard.
            [takes_away ^ kind ^ (1 - enabled), kind, source, enabled]
        });
    let one = (before, proptest::collection::vec(volume, count))
        .prop_map(|(before, volumes)| [vec![before], volumes.concat()].concat());
    proptest::collection::vec(one, clocks).boxed()
}

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

fn flat_colour(seen: Seen) -> [i64; PIXEL] {
    let [red, green, blue] = seen.colour.map(i64::from);
    [seen.depth, red, green, blue]
}

pub(super) fn transparency_stage() -> Description {
    Description::pipeline(blends, STAGE_LATENCY, |i| {
        flat_colour(stage(seen_of(i), layer_of(&i[PIXEL..])))
    })
}

pub(super) fn transparency_pipeline(layers: usize) -> Description {
    Description::new(blends, move || {
        // The pixel, and behind it the layers.
        let starts = [vec![0], transparency::starts(layers)].concat();
        let mut pixels = Skewed::new(starts);
        let mut late = late(transparency::latency(layers) as usize - pixels.span());
        move |i: &[i64]| {
            let (pixel, list) = i.split_at(PIXEL);
            let row = std::iter::once(pixel).chain(list.chunks(LAYER));
            let whole = pixels.push(row.map(<[i64]>::to_vec).collect());
            let seen = whole.map(|parts| {
                let layers: Vec<Layer> = parts[1..].iter().map(|i| layer_of(i)).collect();
                flat_colour(pipeline(seen_of(&parts[0]), &layers))
            });
            stated(late.push(seen).flatten())
        }
    })
}

/// Depths that often tie, layers mostly before the surface, components and weights with their ends.
fn blends(subject: &Subject, clocks: usize) -> Stimuli {
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
