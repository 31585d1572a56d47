//! The decider of solids.

use super::description::{Description, late, stated};
use crate::stimulus::depth;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::machine::csg::{Primitive, Product, Shown, decide, latency, skew};
use imogene_golden::machine::skew::Skewed;
use proptest::prelude::*;

/// Ports of one object.
const FIELDS: usize = 4;

fn primitive_of(i: &[i64]) -> Primitive {
    Primitive {
        zf: i[0],
        zb: i[1],
        id: i[2] as u8,
        number: i[3] as u8,
    }
}

fn flat(shown: Option<Shown>) -> Vec<Option<i64>> {
    stated(shown.map(|s| [s.depth, s.id.into(), s.number.into(), s.is_back.into()]))
}

pub(super) fn csg_decider(
    format: Format,
    products: usize,
    intersected: usize,
    subtracted: usize,
) -> Description {
    let (all_intersected, all_subtracted) = (products * intersected, products * subtracted);
    Description::new(solids, move || {
        let starts = [
            vec![0; all_intersected],
            vec![skew(intersected); all_subtracted],
        ]
        .concat();
        let mut pixels = Skewed::new(starts);
        let clocks = latency(products, intersected, subtracted) as usize;
        let mut late = late(clocks - pixels.span());
        move |i: &[i64]| {
            let row: Vec<Primitive> = i.chunks(FIELDS).map(primitive_of).collect();
            let shown = pixels.push(row).map(|objects| {
                let (kept, taken) = objects.split_at(all_intersected);
                let product = |g: usize| Product {
                    intersected: kept[g * intersected..][..intersected].to_vec(),
                    subtracted: taken[g * subtracted..][..subtracted].to_vec(),
                };
                let list: Vec<Product> = (0..products).map(product).collect();
                decide(&list, format.z_max())
            });
            flat(late.push(shown).flatten())
        }
    })
}

/// Intervals on few levels, so that ends meet; wide ones for the objects that are intersected, narrow ones for those
/// taken away; some absent, some of any words, which the rule covers too.
fn solids(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let width = subject.inputs[0].width;
    let far = (1i64 << (width - 1)) - 1;
    let one: Vec<_> = subject
        .inputs
        .chunks(FIELDS)
        .map(|ports| {
            let lengths = if ports[0].name.starts_with("intersected") {
                4i64..16
            } else {
                0i64..6
            };
            let on_levels = (-3i64..8, lengths).prop_map(|(zf, length)| [zf, zf + length]);
            let fronts = (-3i64..2, 8i64..12).prop_map(|(zf, zb)| [zf, zb]);
            let sheet = (-3i64..8).prop_map(|z| [z, z]);
            let absent = depth(width).prop_map(move |zb| [far, zb]);
            let open = depth(width).prop_map(move |zf| [zf, far]);
            let ends = (depth(width), depth(width)).prop_map(|(zf, zb)| [zf, zb]);
            let interval = prop_oneof![
                8 => on_levels, 6 => fronts, 1 => sheet, 1 => absent, 1 => open, 1 => ends
            ];
            let id = prop_oneof![0i64..4, 0i64..256];
            (interval, id, 0i64..16).prop_map(|([zf, zb], id, number)| vec![zf, zb, id, number])
        })
        .collect();
    let one = one.prop_map(|objects| objects.concat());
    proptest::collection::vec(one, clocks).boxed()
}
