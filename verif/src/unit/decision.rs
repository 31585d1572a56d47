//! The visibility node and the decider.

use super::Late;
use crate::signal::Signal;
use crate::stimulus::depth;
use crate::subject::{GoldenFn, Inputs, Subject};
use imogene_models::machine::decider::{Visible, decide, latency};
use imogene_rtl::machine::{decider as hardware_decider, visibility_node as hardware_node};
use imogene_rtl::step::step;
use imogene_rtl::word::{Int, Word};
use proptest::prelude::*;
use rust_hdl::core::prelude::Block;

/// Ports of one input or output.
const FIELDS: usize = 6;

fn visible_ports(prefix: &str, width: usize) -> Vec<Signal> {
    let name = |field: &str| format!("{prefix}{field}");
    vec![
        Signal::signed(name("depth"), width as u32),
        Signal::unsigned(name("id"), 8),
        Signal::unsigned(name("number"), 4),
        Signal::signed(name("nx"), 16),
        Signal::signed(name("ny"), 16),
        Signal::signed(name("nz"), 16),
    ]
}

fn visible_of(i: &[i64]) -> Visible {
    Visible {
        depth: i[0],
        id: i[1] as u8,
        number: i[2] as u8,
        normal: [3, 4, 5].map(|k| i[k] as i16),
    }
}

fn flat(v: &Visible) -> Vec<Option<i64>> {
    let [nx, ny, nz] = v.normal.map(i64::from);
    [v.depth, v.id.into(), v.number.into(), nx, ny, nz]
        .map(Some)
        .to_vec()
}

/// Inputs with distinct ids in random order and depths that often tie.
fn objects(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let count = subject.inputs.len() / FIELDS;
    let width = subject.inputs[0].width;
    let ids: Vec<i64> = (0..256).collect();
    let payload = (0i64..16, any::<[i16; 3]>());
    let one = (
        proptest::sample::subsequence(ids, count).prop_shuffle(),
        proptest::collection::vec((depth(width), payload), count),
    )
        .prop_map(|(ids, fields)| {
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

pub(super) fn visibility_node<const W: usize>() -> Subject {
    Subject {
        name: "visibility_node".into(),
        inputs: [visible_ports("a_", W), visible_ports("b_", W)].concat(),
        outputs: visible_ports("", W),
        hardware: Box::new(|| {
            let mut unit = Box::new(hardware_node::VisibilityNode::<W>::default());
            unit.connect_all();
            Box::new(move |i: &[i64]| {
                unit.a_depth.next = Int::new(i[0]);
                unit.a_id.next = Word::new(i[1] as u64);
                unit.a_number.next = Word::new(i[2] as u64);
                unit.a_nx.next = Int::new(i[3]);
                unit.a_ny.next = Int::new(i[4]);
                unit.a_nz.next = Int::new(i[5]);
                unit.b_depth.next = Int::new(i[6]);
                unit.b_id.next = Word::new(i[7] as u64);
                unit.b_number.next = Word::new(i[8] as u64);
                unit.b_nx.next = Int::new(i[9]);
                unit.b_ny.next = Int::new(i[10]);
                unit.b_nz.next = Int::new(i[11]);
                step(unit.as_mut());
                vec![
                    unit.depth.val().get(),
                    unit.id.val().get() as i64,
                    unit.number.val().get() as i64,
                    unit.nx.val().get(),
                    unit.ny.val().get(),
                    unit.nz.val().get(),
                ]
            })
        }),
        golden: Box::new(|| {
            Box::new(GoldenFn(|i: &[i64]| {
                flat(&decide(&[visible_of(i), visible_of(&i[FIELDS..])]))
            }))
        }),
        stimulus: objects,
        options: String::new(),
    }
}

pub(super) fn decider<const W: usize>(inputs: usize) -> Subject {
    Subject {
        name: "decider".into(),
        inputs: (0..inputs)
            .flat_map(|m| visible_ports(&format!("input_{m}_"), W))
            .collect(),
        outputs: visible_ports("", W),
        hardware: Box::new(move || {
            let mut unit = Box::new(hardware_decider::Decider::<W>::new(inputs));
            unit.connect_all();
            Box::new(move |i: &[i64]| {
                for m in 0..inputs {
                    let v = &i[FIELDS * m..];
                    unit.input_depth[m].next = Int::new(v[0]);
                    unit.input_id[m].next = Word::new(v[1] as u64);
                    unit.input_number[m].next = Word::new(v[2] as u64);
                    unit.input_nx[m].next = Int::new(v[3]);
                    unit.input_ny[m].next = Int::new(v[4]);
                    unit.input_nz[m].next = Int::new(v[5]);
                }
                step(unit.as_mut());
                vec![
                    unit.depth.val().get(),
                    unit.id.val().get() as i64,
                    unit.number.val().get() as i64,
                    unit.nx.val().get(),
                    unit.ny.val().get(),
                    unit.nz.val().get(),
                ]
            })
        }),
        golden: Box::new(move || {
            // With one input the decider is a wire: the result belongs to the same clock.
            let mut late = Late::new(latency(inputs).max(1) as usize);
            Box::new(GoldenFn(move |i: &[i64]| {
                let list: Vec<Visible> = i.chunks(FIELDS).map(visible_of).collect();
                match late.push(decide(&list)) {
                    Some(v) => flat(&v),
                    None => vec![None; FIELDS],
                }
            }))
        }),
        stimulus: objects,
        options: String::new(),
    }
}
