//! The deciders in hardware: every shape, and the same answer from tree, chain and cards whichever input an object
//! comes to.

use super::run;
use super::video::Numbers;
use imogene_contract::{Request, RequestError};
use imogene_golden::machine::card_decider;
use imogene_verif::subject::{Inputs, Subject};
use imogene_verif::unit::subject;

const FIELDS: usize = 6;

fn unit(name: &str, values: &[(&'static str, usize)]) -> Result<Subject, RequestError> {
    let given = values.iter();
    let given = given.map(|(option, value)| (*option, Some(*value as u32)));
    subject(&Request::given(name, 24, &given.collect::<Vec<_>>())?)
}

fn check(name: &str, values: &[(&'static str, usize)], clocks: usize) {
    let unit = unit(name, values).expect("a unit in its legal range");
    run(&unit, 8, clocks);
}

#[test]
fn chains_of_every_length() {
    for objects in [1, 2, 3, 4, 5, 8, 17] {
        let values = [("objects", objects)];
        check("visibility_chain", &values, objects + 30);
    }
}

#[test]
fn cards_of_every_shape() {
    for (objects, cards) in [(1, 1), (1, 5), (4, 1), (3, 2), (2, 3), (4, 4), (3, 7)] {
        let values = [("objects", objects), ("cards", cards)];
        check("card_decider", &values, objects + 30);
    }
}

#[test]
fn shadow_stages_of_every_depth() {
    for objects in [1, 2, 7, 8, 9, 16, 17, 64, 65, 73, 130] {
        let values = [("objects", objects)];
        check("shadow_stage", &values, 40);
    }
}

#[test]
fn too_many_cards_are_refused() {
    let message = |name, objects, cards| match unit(name, &[("objects", objects), ("cards", cards)])
    {
        Ok(_) => panic!("{name} is accepted"),
        Err(error) => error.to_string(),
    };
    let text = message("card_decider", 64, 5);
    assert!(text.contains("320") && text.contains("256"), "{text}");
    let text = message("card_decider", 4, 65);
    assert!(text.contains("cards") && text.contains("64"), "{text}");
    let text = message("decider", 4, 2);
    assert!(text.contains("cards") && text.contains("decider"), "{text}");
}

/// Pixels of 12 objects with few depths: ids, faces and normals tell them apart.
fn pixels(count: usize) -> Vec<Vec<[i64; FIELDS]>> {
    let mut numbers = Numbers(1);
    let mut below = |count| numbers.below(count) as i64;
    let mut object = |id| [below(3), id, below(16), below(999), id, -id];
    let pixels = (0..count).map(|_| (0..12).map(&mut object).collect());
    pixels.collect()
}

/// The last output of every pixel in hardware: `order[i]` is the object on input i.
fn decided(
    subject: &Subject,
    starts: &[usize],
    order: &[usize],
    pixels: &[Vec<[i64; FIELDS]>],
) -> Vec<Vec<Option<i64>>> {
    let mut hardware = (subject.hardware)(1);
    let clocks = pixels.len() + subject.latency;
    let mut found = Vec::new();
    for clock in 0..clocks {
        let input = |i: usize| {
            let pixel = clock.saturating_sub(starts[i]).min(pixels.len() - 1);
            pixels[pixel][order[i]]
        };
        let row: Inputs = (0..12).flat_map(input).collect();
        found.push(crate::clock(hardware.as_mut(), &row));
    }
    found[subject.latency - 1..][..pixels.len()].to_vec()
}

#[test]
fn tree_chain_and_cards_agree_in_any_order() {
    let pixels = pixels(60);
    let nearest = pixels.iter().map(|objects| {
        let nearest = objects.iter().min_by_key(|o| (o[0], o[1]));
        nearest.expect("twelve objects").map(Some).to_vec()
    });
    let expected: Vec<Vec<Option<i64>>> = nearest.collect();
    let ties = pixels.iter().filter(|objects| {
        let least = objects.iter().map(|o| o[0]).min();
        objects.iter().filter(|o| Some(o[0]) == least).count() > 1
    });
    assert!(ties.count() > 50, "most pixels are ties");
    // As many cards of as many processors.
    let units = [
        ("decider", 12, 0),
        ("visibility_chain", 12, 1),
        ("card_decider", 4, 3),
        ("card_decider", 6, 2),
    ];
    for (name, objects, cards) in units {
        let starts = match cards {
            0 => vec![0; 12],
            _ => card_decider::starts(objects, cards),
        };
        let values = [("objects", objects), ("cards", cards)];
        let values = &values[..if name == "card_decider" { 2 } else { 1 }];
        let subject = unit(name, values).expect("a unit in its legal range");
        let mut order: Vec<usize> = (0..12).collect();
        for step in [1, 5, 7, 11] {
            // A permutation, since the step has no factor in common with 12.
            order = (0..12).map(|i| order[(i * step + step) % 12]).collect();
            let found = decided(&subject, &starts, &order, &pixels);
            assert_eq!(found, expected, "{name} {} {order:?}", subject.options);
        }
    }
}

#[test]
fn pipelines_of_every_number_of_layers() {
    for layers in 1..=8 {
        let values = [("layers", layers)];
        check("transparency_pipeline", &values, 60);
    }
}

/// All weights with all components in front, over the ends and two components that differ from clock to clock.
#[test]
fn blends_of_all_weights_and_components() {
    let subject = unit("transparency_stage", &[]).expect("a unit");
    let rows = (0..1i64 << 16).map(|n| {
        let (weight, front) = (n >> 8, n & 255);
        let [some, other] = [n * 37 + n / 251, n * 101 + 7].map(|v| v & 255);
        let (red, green, blue) = ((n & 1) * 255, some, other);
        vec![10, red, green, blue, 9, front, front, front, weight]
    });
    let report = subject.run_each(rows, |_| ());
    assert_eq!((report.mismatches, report.cycles), (0, 1 << 16));
    assert!(report.comparisons > 4 * 65_000);
}

#[test]
fn solids_of_every_shape() {
    for (intersected, subtracted) in [(1, 0), (1, 1), (2, 1), (1, 3), (3, 2), (2, 0), (5, 4)] {
        let values = [("intersected", intersected), ("subtracted", subtracted)];
        check("csg_product", &values, 120);
    }
}

/// Every choice of intervals on a few levels, sheets and absent objects included: all ways in which ends can lie to
/// each other.
#[test]
fn every_front_of_small_products() {
    let far = (1 << 23) - 1;
    for (intersected, subtracted, levels) in [(2, 1, 5), (1, 2, 5), (1, 3, 4)] {
        let values = [("intersected", intersected), ("subtracted", subtracted)];
        let subject = unit("csg_product", &values).expect("a unit in its legal range");
        let mut intervals = vec![[far, 0]];
        for zf in 0..levels {
            intervals.extend((zf..levels).map(|zb| [zf, zb]));
        }
        let choices = intervals.len().pow((intersected + subtracted) as u32);
        let row = |mut choice: usize| {
            let mut row = Inputs::new();
            for object in 0..(intersected + subtracted) as i64 {
                let [zf, zb] = intervals[choice % intervals.len()];
                let is_kept = object < intersected as i64;
                let (face, end) = if is_kept { (zf, zb) } else { (zb, zf) };
                row.extend([face, object % 2, object, object, -object, 0, end]);
                choice /= intervals.len();
            }
            row
        };
        // Each choice for as many clocks as the objects taken away come later.
        let hold = if intersected == 2 { 2 } else { 1 };
        let rows = (0..choices + subject.latency).flat_map(|n| vec![row(n % choices); hold]);
        let report = subject.run_each(rows, |_| ());
        assert_eq!(report.mismatches, 0, "{}", subject.options);
        assert!(report.comparisons >= 6 * choices as u64);
    }
}

/// A stimulus under which nothing were ever taken away would prove little.
#[test]
fn solids_are_seen_from_the_front_from_within_and_not_at_all() {
    let subject = unit("csg_product", &[]).expect("a unit");
    let far = (1 << 23) - 1;
    let mut golden = (subject.golden)();
    let mut seen = [0; 3];
    for mut row in subject.seeded_stimulus(3000, 3) {
        // The id says which of both it is.
        for (object, fields) in row.chunks_mut(7).enumerate() {
            fields[1] = (object >= 2).into();
        }
        match golden(&row)[..] {
            [Some(depth), ..] if depth == far => seen[0] += 1,
            [_, Some(is_back), ..] => seen[1 + is_back as usize] += 1,
            _ => (),
        }
    }
    assert!(seen.iter().all(|&count| count > 300), "{seen:?}");
}
