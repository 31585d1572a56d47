//! The patch decider in hardware against the sequential algorithm of the source, a chain of cuts, in every order of the
//! planes.

use crate::exhaustive::cut_sequence::permutations;
use crate::exhaustive::cut_single::KINDS;
use crate::request;
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::cut;
use imogene_golden::unit::depth_interval::{Class, Interval, halves};
use imogene_verif::unit::subject;

/// A plane: kind and depth.
type Plane = (i64, i64);

/// What the chain of cuts leaves of both roots, if every order leaves the same.
fn chain(
    near: i64,
    far: i64,
    planes: &[Plane],
    orders: &[Vec<usize>],
    format: &Format,
) -> Interval {
    let start = halves(Class::Patch, near, far, false, format).0;
    let run = |order: &Vec<usize>| {
        order.iter().fold(start, |state, &i| {
            let (kind, zp) = planes[i];
            cut(state, KINDS[kind as usize], zp, 2 + i as u8, true, format)
        })
    };
    let first = run(&orders[0]);
    let case = || format!("roots {near}, {far}, {planes:?}");
    for order in &orders[1..] {
        assert_eq!(run(order), first, "{}, {order:?}", case());
    }
    first
}

/// Two roots and up to four planes on as many levels and one more each side: every configuration there is, with every
/// tie. One a clock.
#[test]
fn decides_as_the_chain_in_every_order_of_up_to_four_planes() {
    let format = Format::new(16).unwrap();
    for planes in 0..=4usize {
        let options = [("planes", planes as u32)];
        let subject = subject(&request("patch_decider", 16, &options)).unwrap();
        let mut hardware = (subject.hardware)(1);
        let orders = permutations(&(0..planes).collect::<Vec<_>>());
        let levels: Vec<i64> = (0..planes as i64 + 2).collect();
        let mut choices: Vec<Plane> = levels.iter().flat_map(|&z| [(1, z), (2, z)]).collect();
        choices.extend([(0, 0), (3, 0), (3, -1)]);
        let mut expected = std::collections::VecDeque::new();
        let mut compared = 0u64;
        for code in 0..choices.len().pow(planes as u32) {
            let drawn: Vec<Plane> = (0..planes)
                .map(|i| choices[code / choices.len().pow(i as u32) % choices.len()])
                .collect();
            for (place, &near) in levels.iter().enumerate() {
                for &far in &levels[place..] {
                    let mut inputs = vec![near, far, 1, 1];
                    inputs.extend(drawn.iter().flat_map(|&(kind, zp)| [kind, zp]));
                    expected.push_back(chain(near, far, &drawn, &orders, &format));
                    let found = crate::clock(hardware.as_mut(), &inputs);
                    if expected.len() == 3 {
                        let face = expected.pop_front().unwrap();
                        let wanted = [face.zf, face.zb, face.nf.into()].map(Some);
                        assert_eq!(found, wanted, "roots and planes before {inputs:?}");
                        compared += 1;
                    }
                }
            }
        }
        let roots = levels.len() * (levels.len() + 1) / 2;
        let configurations = choices.len().pow(planes as u32) * roots;
        assert_eq!(compared, configurations as u64 - 2);
    }
}
