//! The visibility node and the deciders.

use super::description::{Description, late, stated};
use crate::stimulus::depth;
use crate::subject::{Inputs, Subject};
use imogene_golden::machine::decider::{Visible, decide, latency};
use imogene_golden::machine::skew::Skewed;
use imogene_golden::machine::{card_decider as cards, visibility_chain as chain};
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
fn objects(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let count = subject.inputs.len() / FIELDS;
    let width = subject.inputs[0].width;
    let ids: Vec<i64> = (0..256).collect();
    let scattered = proptest::sample::subsequence(ids, count);
    let neighbours = (0..=256 - count as i64)
        .prop_map(move |first| (first..first + count as i64).collect::<Vec<i64>>());
    let same = (0i64..256).prop_map(move |id| vec![id; count]);
    let few = proptest::collection::vec(0i64..2, count);
    let ids = prop_oneof![scattered, neighbours, same]
        .prop_shuffle()
        .boxed();
    let any = stimulus(ids, depth(width), count, clocks);
    let close = stimulus(few.boxed(), (0i64..2).boxed(), count, clocks);
    prop_oneof![3 => any, 1 => close].boxed()
}

/// Rows of objects with these ids and depths.
fn stimulus(
    ids: BoxedStrategy<Vec<i64>>,
    depth: BoxedStrategy<i64>,
    count: usize,
    clocks: usize,
) -> BoxedStrategy<Vec<Inputs>> {
    let payload = (0i64..16, any::<[i16; 3]>());
    let one =
        (ids, proptest::collection::vec((depth, payload), count)).prop_map(|(ids, fields)| {
            ids.into_iter()
                .zip(fields)
                .flat_map(|(id, (depth, (number, n)))| {
                    let [nx, ny, nz] = n.map(i64::from);
                    [depth, id, number, nx, ny, nz]
                })
                .collect::<Inputs>()
        });
    proptest::collection::vec(one, clocks).boxed()
}

pub(super) fn visibility_node() -> Description {
    Description::new(objects, || {
        |i: &[i64]| stated(Some(flat(decide(&visible(i)))))
    })
}

pub(super) fn decider(inputs: usize) -> Description {
    Description::new(objects, move || {
        // With one input the decider is a wire: the result belongs to the same clock.
        let mut late = late(latency(inputs).max(1) as usize);
        move |i: &[i64]| stated(late.push(decide(&visible(i))).map(flat))
    })
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
